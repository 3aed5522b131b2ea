// SPDX-License-Identifier: MIT
// The light of the drawing table, the same as in the pictures that the program renders: a warm key with a soft shadow,
// the sky above and warm light back from the paper, a rim that lifts the outline off the paper, a touch of gloss.
import * as THREE from 'three';
import type { PartInfo } from '../engine/protocol';

/** How much of a square of 4 x 4 texels the key light reaches; its rim is weighted so that it slides smoothly. */
const KEY_ARRIVES = /* glsl */ `
  float croquisKeyArrives() {
    #if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
      if (!receiveShadow) return 1.0;
      vec3 s = vDirectionalShadowCoord[0].xyz / vDirectionalShadowCoord[0].w;
      if (any(lessThan(s, vec3(0.0))) || any(greaterThan(s, vec3(1.0)))) return 1.0;
      vec2 at = s.xy * directionalLightShadows[0].shadowMapSize - 0.5;
      ivec2 corner = ivec2(floor(at)) - 1;
      vec2 part = fract(at);
      vec4 across = vec4(1.0 - part.x, 1.0, 1.0, part.x);
      vec4 down = vec4(1.0 - part.y, 1.0, 1.0, part.y);
      float sum = 0.0;
      for (int y = 0; y < 4; ++y) {
        vec4 depth = vec4(texelFetch(directionalShadowMap[0], corner + ivec2(0, y), 0).r,
                          texelFetch(directionalShadowMap[0], corner + ivec2(1, y), 0).r,
                          texelFetch(directionalShadowMap[0], corner + ivec2(2, y), 0).r,
                          texelFetch(directionalShadowMap[0], corner + ivec2(3, y), 0).r);
        sum += down[y] * dot(across, step(s.z + directionalLightShadows[0].shadowBias, depth));
      }
      return sum / 9.0;
    #else
      return 1.0;
    #endif
  }`;

const LIT = /* glsl */ `
  {
    vec3 n = normal;
    vec3 v = isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(vViewPosition);
    vec3 light = directionalLights[0].direction;
    float lambert = dot(n, light);
    float key = max((lambert + 0.18) / 1.18, 0.0);
    if (key > 0.0) key *= croquisKeyArrives();
    float up = inverseTransformDirection(n, viewMatrix).y;
    vec3 sky = mix(vec3(0.40, 0.33, 0.27), vec3(0.50, 0.56, 0.66), 0.5 + 0.5 * up);
    vec3 lit = vec3(1.02, 0.93, 0.80) * key * 0.97 + sky * 0.66;
    float rim = pow(clamp(1.0 - dot(n, v), 0.0, 1.0), 3.5) * (0.35 + 0.65 * clamp(n.y + 0.2, 0.0, 1.0));
    float gloss = 0.05 * pow(max(dot(n, normalize(light + v)), 0.0), 24.0) * step(0.0, lambert) * key;
    vec3 c = diffuseColor.rgb * lit + rim * (0.10 + 0.45 * diffuseColor.rgb) * vec3(0.95, 0.98, 1.05) + gloss;
    c = mix(c, 1.0 - exp(-1.35 * c), smoothstep(0.45, 1.1, c)); // a shoulder in place of a hard white
    gl_FragColor = vec4(clamp(c, 0.0, 1.0), diffuseColor.a);
  }`;

const UNUSED = /#include <(lights_lambert_fragment|lights_fragment_begin|lights_fragment_maps|lights_fragment_end|envmap_fragment)>/g;

/** Puts the table's light into a Lambert material's shader. */
export function lightAsOnPaper(shader: { fragmentShader: string }): void {
  shader.fragmentShader = shader.fragmentShader
    .replace(UNUSED, '')
    .replace('#include <clipping_planes_pars_fragment>', `#include <clipping_planes_pars_fragment>\n${KEY_ARRIVES}`)
    .replace('#include <opaque_fragment>', LIT);
}

export function clayMaterial(info: PartInfo): THREE.MeshLambertMaterial {
  const [r, g, b, a] = info.base_color;
  const material = new THREE.MeshLambertMaterial();
  material.color.setRGB(r, g, b, THREE.LinearSRGBColorSpace);
  material.side = info.double_sided ? THREE.DoubleSide : THREE.FrontSide;
  if (info.cut_out) material.alphaTest = 0.5;
  else if (a < 1) Object.assign(material, { transparent: true, opacity: a });
  return material;
}
