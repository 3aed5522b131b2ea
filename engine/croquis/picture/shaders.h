// SPDX-License-Identifier: MIT
#pragma once

namespace croquis {

/// The shaders of FigureLayer, GLSL ES 3.00 without the head that make_program adds. All positions are in scene space.

inline constexpr const char* kFigureVertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
uniform mat4 clip_from_scene;
centroid out vec3 at;
centroid out vec3 facing;
centroid out vec2 texel;
void main() {
  at = position;
  facing = normal;
  texel = uv;
  gl_Position = clip_from_scene * vec4(position, 1.0);
}
)";

/// For the shadow map (depth alone) and for the occlusion pass: the normal seen from the camera.
inline constexpr const char* kNormalFragment = R"(
uniform sampler2D image;
uniform float alpha;      // of the material
uniform float cut_below;  // alpha under which nothing is there; 0 keeps all
uniform mat3 view_from_scene;
centroid in vec3 at;
centroid in vec3 facing;
centroid in vec2 texel;
out vec4 result;
void main() {
  if (cut_below > 0.0 && texture(image, texel).a * alpha < cut_below) discard;
  vec3 n = view_from_scene * facing;
  float l = length(n);
  n = l > 1e-6 ? n / l : vec3(0.0, 0.0, 1.0);
  if (!gl_FrontFacing) n = -n;
  result = vec4(0.5 + 0.5 * n, 1.0);
}
)";

inline constexpr const char* kScreenVertex = R"(
out vec2 place;
void main() {
  place = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
  gl_Position = vec4(2.0 * place - 1.0, 0.0, 1.0);
}
)";

/// Ambient occlusion in screen space: how much of the hemisphere over a point its surroundings on the screen hide. The
/// obscurance of mcguire2012, (1 - d^2 / r^2)^2 cos(angle) summed over a spiral of samples, turned from pixel to pixel
/// in a 4 x 4 pattern that the reader averages away.
inline constexpr const char* kOcclusionFragment = R"(
uniform sampler2D depths;
uniform sampler2D normals;
uniform mat4 view_from_clip;
uniform float radius;     // of what can occlude, view units
uniform vec2 radius_px;   // the same on the screen: x + y / depth
in vec2 place;
out vec4 result;
const int kTaps = 14;
vec3 view_at(ivec2 pixel, vec2 size) {
  float depth = texelFetch(depths, pixel, 0).r;
  vec4 v = view_from_clip * vec4(2.0 * (vec2(pixel) + 0.5) / size - 1.0, 2.0 * depth - 1.0, 1.0);
  return v.xyz / v.w;
}
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 most = textureSize(depths, 0) - 1;
  vec2 size = vec2(textureSize(depths, 0));
  result = vec4(0.0);
  if (texelFetch(depths, pixel, 0).r >= 1.0) return;
  vec3 p = view_at(pixel, size);
  vec3 n = normalize(texelFetch(normals, pixel, 0).xyz * 2.0 - 1.0);
  ivec2 cell = pixel & 3;
  float turn = 6.2831853 * (float((cell.x * 4 + cell.y * 7 + cell.x * cell.y * 5) & 15) / 16.0);
  float reach = min(radius_px.x + radius_px.y / max(-p.z, 1e-3), 96.0);
  float sum = 0.0;
  for (int i = 0; i < kTaps; ++i) {
    float part = (float(i) + 0.5) / float(kTaps);
    float angle = turn + part * 6.2831853 * 5.0;
    vec2 offset = reach * part * vec2(cos(angle), sin(angle));
    ivec2 other = pixel + ivec2(round(offset));
    if (other == pixel || any(lessThan(other, ivec2(0))) || any(greaterThan(other, most))) continue;
    vec3 v = view_at(other, size) - p;
    float vv = dot(v, v);
    float vn = dot(v, n) - 0.02 * radius;
    float f = max(radius * radius - vv, 0.0) / (radius * radius);
    sum += f * f * max(vn / (sqrt(vv) + 0.02 * radius), 0.0);
  }
  float open = clamp(1.0 - 2.2 * sum / float(kTaps), 0.0, 1.0);
  result = vec4(open, 1.0, 0.0, 1.0);
}
)";

/// The light: a warm key from the upper left with a soft shadow, the sky above and warm light back from the paper, both
/// where they are not occluded, a rim that lifts the outline off the paper, and a touch of gloss.
inline constexpr const char* kFigureFragment = R"(
uniform sampler2D image;
uniform sampler2D occlusion;
uniform highp sampler2D shadow;
uniform vec4 base_color;
uniform float cut_below;
uniform vec4 eye;      // scene space; w = 0: the direction towards a camera without perspective
uniform vec3 light;    // towards the key light
uniform vec3 up_view;  // the camera's up
uniform mat4 shadow_from_scene;
uniform vec2 occlusion_scale;  // gl_FragCoord to texture coordinates
centroid in vec3 at;
centroid in vec3 facing;
centroid in vec2 texel;
out vec4 result;
// The part of a square of 4 x 4 texels that is not nearer to the light, its rim weighted so that it slides smoothly.
float key_arrives(vec3 n, bool turned_away) {
  vec3 s = (shadow_from_scene * vec4(at + n * 0.012 + light * 0.006, 1.0)).xyz * 0.5 + 0.5;
  vec2 texel_at = s.xy * vec2(textureSize(shadow, 0)) - 0.5;
  ivec2 corner = ivec2(floor(texel_at)) - 1;
  vec2 part = fract(texel_at);
  vec4 across = vec4(1.0 - part.x, 1.0, 1.0, part.x);
  vec4 down = vec4(1.0 - part.y, 1.0, 1.0, part.y);
  float sum = 0.0;
  int rows = turned_away ? 0 : 4;  // software drivers skip loops, not branches
  for (int y = 0; y < rows; ++y) {
    vec4 depth = vec4(texelFetch(shadow, corner + ivec2(0, y), 0).r, texelFetch(shadow, corner + ivec2(1, y), 0).r,
                      texelFetch(shadow, corner + ivec2(2, y), 0).r, texelFetch(shadow, corner + ivec2(3, y), 0).r);
    sum += down[y] * dot(across, step(s.z, depth));
  }
  return sum / 9.0;
}
void main() {
  vec4 color = texture(image, texel) * base_color;
  if (cut_below > 0.0) {
    color.a = clamp((color.a - cut_below) / max(fwidth(color.a), 1e-4) + 0.5, 0.0, 1.0);
    if (color.a <= 0.0) discard;
  } else {
    color.a = base_color.a;
  }
  float l = length(facing);
  vec3 n = l > 1e-6 ? facing / l : vec3(0.0, 1.0, 0.0);
  if (!gl_FrontFacing) n = -n;
  vec3 v = normalize(eye.xyz - eye.w * at);
  vec2 o = gl_FragCoord.xy * occlusion_scale;
  vec2 d = 1.0 / vec2(textureSize(occlusion, 0));
  vec2 open = texture(occlusion, o + d * vec2(-1.5, -1.5)).xy + texture(occlusion, o + d * vec2(0.5, -1.5)).xy +
              texture(occlusion, o + d * vec2(-1.5, 0.5)).xy + texture(occlusion, o + d * vec2(0.5, 0.5)).xy;
  float ambient = open.y > 0.01 ? open.x / open.y : 1.0;

  float lambert = dot(n, light);
  float key = max((lambert + 0.18) / 1.18, 0.0);
  key *= key_arrives(n, key <= 0.0);
  vec3 sky = mix(vec3(0.40, 0.33, 0.27), vec3(0.50, 0.56, 0.66), 0.5 + 0.5 * n.y);
  vec3 lit = vec3(1.02, 0.93, 0.80) * key * (0.55 + 0.45 * ambient) + sky * (0.72 * ambient * (0.35 + 0.65 * ambient));
  float edge = pow(clamp(1.0 - dot(n, v), 0.0, 1.0), 3.5);
  float rim = edge * (0.35 + 0.65 * clamp(dot(n, up_view) + 0.2, 0.0, 1.0)) * ambient;
  vec3 halfway = normalize(light + v);
  float gloss = 0.05 * pow(max(dot(n, halfway), 0.0), 24.0) * step(0.0, lambert) * key;
  vec3 c = color.rgb * lit + rim * (0.10 + 0.45 * color.rgb) * vec3(0.95, 0.98, 1.05) + gloss;
  c = mix(c, 1.0 - exp(-1.35 * c), smoothstep(0.45, 1.1, c));  // a shoulder in place of a hard white
  result = vec4(clamp(c, 0.0, 1.0) * color.a, color.a);
}
)";

}  // namespace croquis
