// SPDX-License-Identifier: MIT
// Passes: shadow map (depth alone) once a picture; then per tile normals and depths, occlusion from those, and the lit
// figures with multisampling. Colours leave the last shader premultiplied in linear light; the sRGB target encodes
// them, so that samples are averaged as light. The picture is drawn upside down, so that rows come back from the top.
#include "croquis/picture/figure_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "croquis/base/error.h"
#include "croquis/picture/image.h"
#include "croquis/picture/shaders.h"

namespace croquis {
namespace {

constexpr int kShadowSize = 1024;
constexpr double kOcclusionRadius = 0.11;  ///< scene units
constexpr int kBorder = 64;                ///< pixels around a tile that its occlusion looks at

GLint uniform(const GlObject& program, const char* name) { return glGetUniformLocation(program.name(), name); }

void set(const GlObject& program, const char* name, const Mat4& value) {
  const Eigen::Matrix4f single = value.cast<float>();
  glUniformMatrix4fv(uniform(program, name), 1, GL_FALSE, single.data());
}

void set(const GlObject& program, const char* name, const Vec3& value) {
  const Vec3f single = value.cast<float>();
  glUniform3fv(uniform(program, name), 1, single.data());
}

void bind(int unit, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

GlObject upload(Image image) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  while (std::max(image.width, image.height) > std::min(largest, 4096)) image = halve(image);
  GlObject texture = make_texture();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  // Levels of our own: each is right in linear light and bleeds no colour of clear texels; Mesa's take longer, too.
  for (GLint level = 0;; ++level) {
    glTexImage2D(GL_TEXTURE_2D, level, GL_SRGB8_ALPHA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.rgba.data());
    if (image.width == 1 && image.height == 1) break;
    image = halve(image);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  return texture;
}

bool is_translucent(const SceneDraw& draw) { return !draw.cut_out && draw.base_color.w() < 0.995F; }

}  // namespace

/// What a tile of one size is drawn into.
struct FigureLayer::Targets {
  int width, height;            // of the occlusion pass: tile and border, in pixels of the picture
  int fine_width, fine_height;  // of the figures
  GlObject normals, depths, normal_framebuffer;
  GlObject occlusion, occlusion_framebuffer;
  GlObject samples, sample_depths, sample_framebuffer;
  GlObject resolved, resolved_framebuffer;

  Targets(int w, int h, int samples_a_side)
      : width(w), height(h), fine_width(w * samples_a_side), fine_height(h * samples_a_side) {
    GLint most = 1;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    const int count = std::min(4, static_cast<int>(most));
    normals = make_target(GL_RGBA8, width, height);
    depths = make_target(GL_DEPTH_COMPONENT24, width, height);
    normal_framebuffer = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, normal_framebuffer.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, normals.name(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths.name(), 0);
    check_framebuffer("normals");
    occlusion = make_target(GL_RG8, width, height, GL_LINEAR);
    occlusion_framebuffer = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, occlusion_framebuffer.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, occlusion.name(), 0);
    check_framebuffer("occlusion");
    samples = make_renderbuffer(GL_SRGB8_ALPHA8, count, fine_width, fine_height);
    sample_depths = make_renderbuffer(GL_DEPTH_COMPONENT24, count, fine_width, fine_height);
    sample_framebuffer = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, sample_framebuffer.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, samples.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, sample_depths.name());
    check_framebuffer("figures");
    resolved = make_target(GL_SRGB8_ALPHA8, fine_width, fine_height);
    resolved_framebuffer = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, resolved_framebuffer.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, resolved.name(), 0);
    check_framebuffer("picture");
  }
};

FigureLayer::FigureLayer()
    : normal_program_(make_program(kFigureVertex, kNormalFragment)),
      occlusion_program_(make_program(kScreenVertex, kOcclusionFragment)),
      figure_program_(make_program(kFigureVertex, kFigureFragment)),
      vertices_(make_buffer()),
      indices_(make_buffer()),
      array_(make_vertex_array()),
      no_array_(make_vertex_array()) {
  white_ = upload(Image{1, 1, {255, 255, 255, 255}});
  shadow_map_ = make_target(GL_DEPTH_COMPONENT24, kShadowSize, kShadowSize);
  shadow_framebuffer_ = make_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, shadow_framebuffer_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, shadow_map_.name(), 0);
  const GLenum none = GL_NONE;
  glDrawBuffers(1, &none);
  check_framebuffer("shadow map");

  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  const auto attribute = [](GLuint index, GLint size, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(SceneVertex), reinterpret_cast<const void*>(offset));
  };
  attribute(0, 3, offsetof(SceneVertex, position));
  attribute(1, 3, offsetof(SceneVertex, normal));
  attribute(2, 2, offsetof(SceneVertex, uv));
  check_gl("setting up");
}

FigureLayer::~FigureLayer() = default;

void FigureLayer::load(const Scene& scene, const Camera& camera, const Vec3& towards_light) {
  scene_ = &scene;
  camera_ = camera;
  light_ = towards_light;
  figures_ = find_figures();
  load_geometry();
  load_textures();
  draw_shadow_map();
}

void FigureLayer::load_geometry() {
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(scene_->vertices.size() * sizeof(SceneVertex)),
               scene_->vertices.data(), GL_STREAM_DRAW);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(scene_->triangles.size() * sizeof(std::uint32_t)),
               scene_->triangles.data(), GL_STREAM_DRAW);
}

void FigureLayer::load_textures() {
  for (auto& entry : textures_) entry.second.used = false;
  for (const SceneDraw& draw : scene_->draws) {
    if (!draw.image) continue;
    Texture& texture = textures_[draw.image.get()];
    texture.used = true;
    if (texture.source) continue;
    texture.source = draw.image;
    try {
      texture.texture = upload(decode_image(*draw.image));
    } catch (const Error& error) {
      if (error.code() != ErrorCode::bad_file) throw;  // an image of a kind we cannot read: the plain colour stands in
    }
  }
  for (auto entry = textures_.begin(); entry != textures_.end();) {
    entry = entry->second.used ? std::next(entry) : textures_.erase(entry);
  }
}

GLuint FigureLayer::texture_of(const SceneDraw& draw) {
  const auto found = textures_.find(draw.image.get());
  return found != textures_.end() && found->second.texture.name() != 0 ? found->second.texture.name() : white_.name();
}

void FigureLayer::draw_parts(const GlObject& program, bool cull, bool translucent) {
  glBindVertexArray(array_.name());
  glFrontFace(GL_CW);  // the picture is drawn upside down
  for (const SceneDraw& draw : scene_->draws) {
    if (is_translucent(draw) != translucent || draw.count == 0) continue;
    if (cull && !draw.double_sided) {
      glEnable(GL_CULL_FACE);
    } else {
      glDisable(GL_CULL_FACE);
    }
    bind(0, texture_of(draw));
    glUniform1f(uniform(program, "alpha"), draw.base_color.w());
    glUniform1f(uniform(program, "cut_below"), draw.cut_out ? 0.5F : 0.0F);
    glUniform4fv(uniform(program, "base_color"), 1, draw.base_color.data());
    glDrawElements(GL_TRIANGLES, draw.count, GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(static_cast<std::size_t>(draw.first) * sizeof(std::uint32_t)));
  }
  glDisable(GL_CULL_FACE);
}

void FigureLayer::draw_shadow_map() {
  Mat3 light_axes;  // rows: right, up, towards the light
  light_axes.row(2) = light_;
  light_axes.row(0) = light_.unitOrthogonal();
  light_axes.row(1) = light_.cross(Vec3(light_axes.row(0)));
  Box box;
  for (const SceneVertex& vertex : scene_->vertices) box.extend(Vec3(light_axes * vertex.position.cast<double>()));
  const Vec3 half = 0.5 * box.sizes() + Vec3::Constant(0.02);
  shadow_from_scene_.setIdentity();
  for (int axis = 0; axis < 3; ++axis) {
    const double sign = axis == 2 ? -1.0 : 1.0;  // nearer the light is nearer in depth
    shadow_from_scene_.row(axis).head<3>() = sign / half[axis] * light_axes.row(axis);
    shadow_from_scene_(axis, 3) = -sign * box.center()[axis] / half[axis];
  }
  glBindFramebuffer(GL_FRAMEBUFFER, shadow_framebuffer_.name());
  glViewport(0, 0, kShadowSize, kShadowSize);
  glEnable(GL_DEPTH_TEST);
  glClear(GL_DEPTH_BUFFER_BIT);
  glUseProgram(normal_program_.name());
  set(normal_program_, "clip_from_scene", shadow_from_scene_);
  draw_parts(normal_program_, false, false);
}

void FigureLayer::draw_occlusion(const Mat4& clip_from_scene, const Mat4& clip_from_view) {
  glViewport(0, 0, targets_->width, targets_->height);
  glBindFramebuffer(GL_FRAMEBUFFER, targets_->normal_framebuffer.name());
  glEnable(GL_DEPTH_TEST);
  glClearColor(0.5F, 0.5F, 1.0F, 0.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glUseProgram(normal_program_.name());
  set(normal_program_, "clip_from_scene", clip_from_scene);
  const Eigen::Matrix3f turn = camera_.view_from_world().linear().cast<float>();
  glUniformMatrix3fv(uniform(normal_program_, "view_from_scene"), 1, GL_FALSE, turn.data());
  draw_parts(normal_program_, true, false);

  glBindFramebuffer(GL_FRAMEBUFFER, targets_->occlusion_framebuffer.name());
  glDisable(GL_DEPTH_TEST);
  glUseProgram(occlusion_program_.name());
  bind(0, targets_->depths.name());
  bind(1, targets_->normals.name());
  glUniform1i(uniform(occlusion_program_, "depths"), 0);
  glUniform1i(uniform(occlusion_program_, "normals"), 1);
  set(occlusion_program_, "view_from_clip", Mat4(clip_from_view.inverse()));
  glUniform1f(uniform(occlusion_program_, "radius"), static_cast<float>(kOcclusionRadius));
  const bool perspective = camera_.projection == Camera::Projection::perspective;
  const double half_height =
      perspective ? std::tan(0.5 * camera_.fov_degrees * kDegree) : 0.5 * camera_.height / scene_->radius;
  const auto pixels = static_cast<float>(kOcclusionRadius * 0.5 * camera_.height_px / half_height);
  glUniform2f(uniform(occlusion_program_, "radius_px"), perspective ? 0.0F : pixels, perspective ? pixels : 0.0F);
  glBindVertexArray(no_array_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void FigureLayer::draw_figures(const Mat4& clip_from_scene) {
  glBindFramebuffer(GL_FRAMEBUFFER, targets_->sample_framebuffer.name());
  glViewport(0, 0, targets_->fine_width, targets_->fine_height);
  glEnable(GL_DEPTH_TEST);
  glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const GlObject& program = figure_program_;
  glUseProgram(program.name());
  set(program, "clip_from_scene", clip_from_scene);
  set(program, "shadow_from_scene", shadow_from_scene_);
  set(program, "light", light_);
  const Affine view = camera_.view_from_world();
  set(program, "up_view", Vec3(view.linear().row(1)));
  const bool perspective = camera_.projection == Camera::Projection::perspective;
  const Vec3f eye = (perspective ? scene_->from_world(camera_.position) : Vec3(-camera_.forward())).cast<float>();
  glUniform4f(uniform(program, "eye"), eye.x(), eye.y(), eye.z(), perspective ? 1.0F : 0.0F);
  glUniform2f(uniform(program, "occlusion_scale"), 1.0F / static_cast<float>(targets_->fine_width),
              1.0F / static_cast<float>(targets_->fine_height));
  bind(1, targets_->occlusion.name());
  bind(2, shadow_map_.name());
  glUniform1i(uniform(program, "image"), 0);
  glUniform1i(uniform(program, "occlusion"), 1);
  glUniform1i(uniform(program, "shadow"), 2);
  glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);  // for cut-outs; opaque parts have alpha 1
  draw_parts(program, true, false);
  glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  draw_parts(program, true, true);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void FigureLayer::read_back(Canvas& canvas, const Region& region, int samples_a_side) const {
  const int width = targets_->fine_width, height = targets_->fine_height;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, targets_->sample_framebuffer.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, targets_->resolved_framebuffer.name());
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, targets_->resolved_framebuffer.name());
  const int fine = samples_a_side;
  const int border_x = (targets_->width - region.width()) / 2 * fine,
            border_y = (targets_->height - region.height()) / 2 * fine;
  const int row = region.width() * fine;
  std::vector<std::uint8_t> codes(4 * static_cast<std::size_t>(row) * static_cast<std::size_t>(region.height() * fine));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(border_x, border_y, row, region.height() * fine, GL_RGBA, GL_UNSIGNED_BYTE, codes.data());
  check_gl("drawing the figures");
  const float share = 1.0F / static_cast<float>(fine * fine);
  for (int y = 0; y < region.height(); ++y) {
    for (int x = 0; x < region.width(); ++x) {
      Vec4f sum = Vec4f::Zero();
      for (int k = 0; k < fine * fine; ++k) {
        const std::size_t at = 4 * static_cast<std::size_t>((y * fine + k / fine) * row + x * fine + k % fine);
        if (codes[at + 3] == 0) continue;
        sum += Vec4f(srgb_to_linear(codes[at]), srgb_to_linear(codes[at + 1]), srgb_to_linear(codes[at + 2]),
                     static_cast<float>(codes[at + 3]) / 255.0F);
      }
      if (sum.w() <= 0.0F) continue;
      sum *= share;
      Vec4f& pixel = canvas.at(region.left + x, region.top + y);
      pixel = sum + (1.0F - sum.w()) * pixel;
    }
  }
}

/// The picture's pixels that the scene is seen in, rounded out.
FigureLayer::Region FigureLayer::find_figures() const {
  const Region whole{0, 0, camera_.width_px, camera_.height_px};
  Eigen::AlignedBox2d box;
  for (const SceneVertex& vertex : scene_->vertices) {
    const Vec3 at = scene_->centre + scene_->radius * vertex.position.cast<double>();
    const std::optional<Vec2> seen = camera_.project(at);
    if (!seen) return whole;  // behind the camera
    box.extend(*seen);
  }
  const auto out = [](double low, double high, int most, int& first, int& last) {
    constexpr int kStep = 64;  // few sizes, so that targets can be kept; of the occlusion's pattern a multiple
    const double limit = most;
    first = static_cast<int>(std::clamp(low - 1.0, 0.0, limit)) / kStep * kStep;
    last = std::min((static_cast<int>(std::clamp(high + 2.0, 0.0, limit)) + kStep - 1) / kStep * kStep, most);
  };
  Region region;
  out(box.min().x(), box.max().x(), whole.right, region.left, region.right);
  out(box.min().y(), box.max().y(), whole.bottom, region.top, region.bottom);
  return region;
}

void FigureLayer::paint(Canvas& canvas, int samples_a_side) {
  const Region region{std::max(figures_.left, canvas.left), std::max(figures_.top, canvas.top),
                      std::min(figures_.right, canvas.left + canvas.width),
                      std::min(figures_.bottom, canvas.top + canvas.height)};
  if (region.width() <= 0 || region.height() <= 0) return;
  const bool whole = region.width() == figures_.width() && region.height() == figures_.height();
  const int border = whole ? 0 : kBorder;
  const int width = region.width() + 2 * border, height = region.height() + 2 * border;
  if (!targets_ || targets_->width != width || targets_->height != height ||
      targets_->fine_width != width * samples_a_side) {
    targets_.reset();
    targets_ = std::make_unique<Targets>(width, height, samples_a_side);
  }
  // The tile's part of the picture's clip space, upside down.
  const double x0 = region.left - border, y0 = region.top - border;
  Mat4 tile_from_clip = Mat4::Identity();
  tile_from_clip(0, 0) = static_cast<double>(camera_.width_px) / width;
  tile_from_clip(0, 3) = (camera_.width_px - 2.0 * x0) / width - 1.0;
  tile_from_clip(1, 1) = -static_cast<double>(camera_.height_px) / height;
  tile_from_clip(1, 3) = (camera_.height_px - 2.0 * y0) / height - 1.0;
  const Affine view_world = camera_.view_from_world();
  Affine view_from_scene = view_world * scene_->world_from_scene();  // then back to scene units
  view_from_scene = Eigen::Scaling(1.0 / scene_->radius) * view_from_scene;
  Mat4 clip_from_view = camera_.clip_from_view(scene_->centre, 1.001 * scene_->radius);
  clip_from_view = tile_from_clip * clip_from_view * Affine(Eigen::Scaling(scene_->radius)).matrix();
  const Mat4 clip_from_scene = clip_from_view * view_from_scene.matrix();
  draw_occlusion(clip_from_scene, clip_from_view);
  draw_figures(clip_from_scene);
  read_back(canvas, region, samples_a_side);
}

}  // namespace croquis
