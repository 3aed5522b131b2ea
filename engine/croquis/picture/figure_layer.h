// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "croquis/picture/canvas.h"
#include "croquis/picture/gl.h"
#include "croquis/picture/scene.h"

namespace croquis {

/// The figures of a scene, lit, on the GPU (or on Mesa's likeness of one): a shadow map from the key light, ambient
/// occlusion from the depths the camera sees, then the picture with four samples a pixel, read back into a canvas.
/// A canvas is a tile of the picture, so that a picture's size is bounded by nothing but memory. Every member needs the
/// context to be current.
class FigureLayer {
 public:
  FigureLayer();
  ~FigureLayer();

  /// Uploads a scene, which has to live until the last `paint`.
  void load(const Scene& scene, const Camera& camera, const Vec3& towards_light);
  /// Paints what the camera sees of the scene over the canvas, which is at most kLargestTile pixels a side, with
  /// `samples_a_side` (1 or 2) times as many pixels on the GPU.
  void paint(Canvas& canvas, int samples_a_side);

  static constexpr int kLargestTile = 1024;

 private:
  struct Targets;
  /// Pixels of the picture.
  struct Region {
    int left = 0, top = 0, right = 0, bottom = 0;  // right and bottom are not in it
    [[nodiscard]] int width() const { return right - left; }
    [[nodiscard]] int height() const { return bottom - top; }
  };
  struct Texture {
    std::shared_ptr<const Bytes> source;  // held, so that no other image can take its address
    GlObject texture;
    bool used = false;
  };
  GLuint texture_of(const SceneDraw& draw);
  void load_geometry();
  void load_textures();
  void draw_parts(const GlObject& program, bool cull, bool translucent);
  void draw_shadow_map();
  void draw_occlusion(const Mat4& clip_from_scene, const Mat4& clip_from_view);
  void draw_figures(const Mat4& clip_from_scene);
  [[nodiscard]] Region find_figures() const;
  void read_back(Canvas& canvas, const Region& region, int samples_a_side) const;

  GlObject normal_program_, occlusion_program_, figure_program_;
  GlObject vertices_, indices_, array_, no_array_;
  GlObject white_, shadow_map_, shadow_framebuffer_;
  std::map<const Bytes*, Texture> textures_;
  std::unique_ptr<Targets> targets_;

  const Scene* scene_ = nullptr;
  Camera camera_;
  Vec3 light_ = Vec3::UnitY();
  Region figures_;  ///< where in the picture the camera sees the scene
  Mat4 shadow_from_scene_ = Mat4::Identity();
};

}  // namespace croquis
