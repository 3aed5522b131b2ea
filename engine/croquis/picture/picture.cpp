// SPDX-License-Identifier: MIT
#include "croquis/picture/picture.h"

#include <algorithm>
#include <cmath>

#include "croquis/picture/canvas.h"
#include "croquis/picture/figure_layer.h"
#include "croquis/picture/ground.h"
#include "croquis/picture/overlay.h"
#include "croquis/picture/scene.h"

namespace croquis {
namespace {

/// A number in [0, 1) for a pixel: the ordered dither of 4 x 4 (bayer1973). Random grain looks no better and makes a
/// PNG twice as large and as slow to write.
float grain_at(int x, int y) {
  constexpr int kOrder[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
  return (static_cast<float>(kOrder[y & 3][x & 3]) + 0.5F) / 16.0F;
}

/// The paper: warm white, a little darker towards the corners, as under a lamp.
void paint_paper(Canvas& canvas, const Camera& camera) {
  const Vec3f paper = make_paint(0xF7F2E8).color;
  const auto width = static_cast<float>(camera.width_px), height = static_cast<float>(camera.height_px);
  for (int y = canvas.top; y < canvas.top + canvas.height; ++y) {
    for (int x = canvas.left; x < canvas.left + canvas.width; ++x) {
      const float u = (static_cast<float>(x) + 0.5F) / width - 0.5F,
                  v = (static_cast<float>(y) + 0.5F) / height - 0.42F;
      const float away = std::min(u * u + v * v, 1.0F);
      Vec4f& pixel = canvas.at(x, y);
      pixel.head<3>() = paper.cwiseProduct(Vec3f(1.0F - 0.20F * away, 1.0F - 0.235F * away, 1.0F - 0.29F * away));
      pixel.w() = 1.0F;
    }
  }
}

/// The ground: the paper, in the light of the lamp, with the shadow of the figures.
void paint_ground(Canvas& canvas, const Scene& scene, const Camera& camera, const GroundShade& shade) {
  const Mat3 ground = ground_from_pixel(scene, camera);
  if (ground.isZero()) return;
  const Vec3f key(0.62F, 0.64F, 0.68F), sky(0.74F, 0.72F, 0.70F);  // what full shade leaves of the paper
  for (int y = canvas.top; y < canvas.top + canvas.height; ++y) {
    for (int x = canvas.left; x < canvas.left + canvas.width; ++x) {
      const Vec3 at = ground * Vec3(x + 0.5, y + 0.5, 1.0);
      if (!(at.z() > 1e-6)) continue;
      const double px = at.x() / at.z(), pz = at.y() / at.z();
      const GroundShade::Value value = shade.at(px, pz);
      Vec4f& pixel = canvas.at(x, y);
      const auto away = static_cast<float>(std::sqrt(px * px + pz * pz));
      const float wash = 1.0F - smooth_step(0.5F, 2.6F, away);
      const Vec3f tint = Vec3f::Ones() - 0.055F * wash * Vec3f(0.8F, 1.0F, 1.35F);
      const Vec3f shadow = Vec3f::Ones() - 0.62F * value.shadow * (Vec3f::Ones() - key);
      const Vec3f contact = Vec3f::Ones() - value.contact * (Vec3f::Ones() - 0.35F * sky);
      pixel.head<3>() = pixel.head<3>().cwiseProduct(tint.cwiseProduct(shadow.cwiseProduct(contact)));
    }
  }
}

/// To 8 bits; opaque pixels get half a step of grain, so that soft gradients show no bands.
void write_pixels(const Canvas& canvas, Image& image) {
  for (int y = 0; y < canvas.height; ++y) {
    std::uint8_t* out =
        image.rgba.data() + 4 * (static_cast<std::ptrdiff_t>(canvas.top + y) * image.width + canvas.left);
    for (int x = 0; x < canvas.width; ++x, out += 4) {
      const Vec4f& pixel = canvas.pixels[static_cast<std::size_t>(y * canvas.width + x)];
      const int alpha = static_cast<int>(std::lround(255.0F * std::min(pixel.w(), 1.0F)));
      if (alpha == 0) continue;
      const float grain = alpha == 255 ? 1.0F + 0.007F * (grain_at(canvas.left + x, canvas.top + y) - 0.5F) : 1.0F;
      for (int c = 0; c < 3; ++c) out[c] = linear_to_srgb(grain * pixel[c] / pixel.w());
      out[3] = static_cast<std::uint8_t>(alpha);
    }
  }
}

}  // namespace

struct PictureRenderer::State {
  GlContext context;
  std::unique_ptr<FigureLayer> figures;

  State() {
    const GlContext::Use use(context);
    figures = std::make_unique<FigureLayer>();
  }
  ~State() {
    const GlContext::Use use(context);
    figures.reset();
  }
};

PictureRenderer::PictureRenderer() : state_(std::make_unique<State>()) {}
PictureRenderer::~PictureRenderer() = default;
PictureRenderer::PictureRenderer(PictureRenderer&&) noexcept = default;
PictureRenderer& PictureRenderer::operator=(PictureRenderer&&) noexcept = default;

Image PictureRenderer::render(const std::vector<PictureActor>& actors, const Camera& camera,
                              const std::vector<Stroke>& strokes, const PictureOptions& options) {
  camera.check();
  const Scene scene = build_scene(actors, options.skinning);
  const Vec3 light = key_light_direction(camera);
  const bool has_ground = options.ground && !options.transparent && !scene.vertices.empty();
  const GroundShade shade(has_ground ? scene : Scene{}, light);

  const GlContext::Use use(state_->context);
  if (!scene.triangles.empty()) state_->figures->load(scene, camera, light);
  Image image{camera.width_px, camera.height_px, {}};
  image.rgba.resize(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  const int samples_a_side = std::max(image.width, image.height) <= 640 ? 2 : 1;
  constexpr int kTile = FigureLayer::kLargestTile;
  for (int top = 0; top < image.height; top += kTile) {
    for (int left = 0; left < image.width; left += kTile) {
      Canvas canvas(left, top, std::min(kTile, image.width - left), std::min(kTile, image.height - top));
      if (!options.transparent) paint_paper(canvas, camera);
      if (has_ground) paint_ground(canvas, scene, camera, shade);
      if (!scene.triangles.empty()) state_->figures->paint(canvas, samples_a_side);
      if (options.skeleton) paint_skeletons(canvas, actors, camera);
      paint_strokes(canvas, strokes, camera);
      write_pixels(canvas, image);
    }
  }
  return image;
}

Image render_picture(const std::vector<PictureActor>& actors, const Camera& camera, const std::vector<Stroke>& strokes,
                     const PictureOptions& options) {
  PictureRenderer renderer;
  return renderer.render(actors, camera, strokes, options);
}

}  // namespace croquis
