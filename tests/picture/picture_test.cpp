// SPDX-License-Identifier: MIT
#include "croquis/picture/picture.h"

#include "support/test_rigs.h"
#include <cmath>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/math/rotation.h"

// Mesa and LLVM keep what they make until the process ends.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libLLVM\nleak:libEGL\nleak:libGL\nleak:swrast_dri\nleak:libgallium\nleak:libdrm\n";
}

namespace croquis {
namespace {

Mesh box_mesh(const Vec3& half) {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Vec3 normal = sign * Vec3::Unit(axis);
      const Vec3 u = Vec3::Unit((axis + 1) % 3), v = normal.cross(u);
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const auto& [a, b] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
        mesh.positions.push_back(Vec3(half.cwiseProduct(normal + a * u + b * v)).cast<float>());
        mesh.normals.push_back(normal.cast<float>());
      }
      for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.triangles.push_back(first + i);
    }
  }
  return mesh;
}

/// A square in the plane z = 0 that faces +Z, the image's top-left corner at its upper left.
Mesh card_mesh(double half) {
  Mesh mesh;
  const auto h = static_cast<float>(half);
  mesh.positions = {Vec3f(-h, -h, 0), Vec3f(h, -h, 0), Vec3f(h, h, 0), Vec3f(-h, h, 0)};
  mesh.normals.assign(4, Vec3f::UnitZ());
  mesh.uvs = {Vec2f(0, 1), Vec2f(1, 1), Vec2f(1, 0), Vec2f(0, 0)};
  mesh.triangles = {0, 1, 2, 0, 2, 3};
  return mesh;
}

Mesh ball_mesh(double radius, const Vec3& centre) {
  Mesh mesh;
  constexpr int kRings = 24, kAround = 48;
  for (int j = 0; j <= kRings; ++j) {
    for (int i = 0; i < kAround; ++i) {
      const double t = kPi * j / kRings, p = 2.0 * kPi * i / kAround;
      const Vec3 n(std::sin(t) * std::cos(p), std::cos(t), std::sin(t) * std::sin(p));
      mesh.positions.push_back(Vec3(centre + radius * n).cast<float>());
      mesh.normals.push_back(n.cast<float>());
    }
  }
  for (std::uint32_t j = 0; j < kRings; ++j) {
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const std::uint32_t a = j * kAround + i, b = j * kAround + (i + 1) % kAround;
      for (const std::uint32_t v : {a, b, a + kAround, b, b + kAround, a + kAround}) mesh.triangles.push_back(v);
    }
  }
  return mesh;
}

Character statue(std::vector<Mesh> meshes, const Material& material = {}) {
  Skeleton skeleton({Joint{.name = "root"}});
  Character character{.name = "statue", .skeleton = skeleton, .start = rest_pose(skeleton)};
  for (Mesh& mesh : meshes) {
    Part part;
    part.mesh = std::move(mesh);
    part.material = material;
    character.parts.push_back(std::move(part));
  }
  return character;
}

Character humanoid_without_body() {
  Skeleton skeleton = make_test_humanoid();
  Character character{.name = "bones", .skeleton = skeleton, .start = rest_pose(skeleton)};
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    if (const auto bone = parse_humanoid_bone(skeleton.name(j))) character.humanoid.set(*bone, j, 1.0);
  }
  return character;
}

Camera front_camera(int width, int height, double view_height, const Vec3& target = Vec3::Zero()) {
  Camera camera;
  camera.target = target;
  camera.position = target + Vec3(0, 0, 10);
  camera.height = view_height;
  camera.width_px = width;
  camera.height_px = height;
  return camera;
}

int luminance(const Image& image, int x, int y) {
  const auto p = image.pixel(x, y);
  return (2 * p[0] + 5 * p[1] + p[2]) / 8;
}

/// One renderer for all tests: making one costs a third of a second.
class Picture : public testing::Test {
 protected:
  static void SetUpTestSuite() { renderer_ = std::make_unique<PictureRenderer>(); }
  static void TearDownTestSuite() { renderer_.reset(); }

  static Image draw(const Character& character, const Camera& camera, const PictureOptions& options = {},
                    const std::vector<Stroke>& strokes = {}) {
    return renderer_->render({{&character, &character.start}}, camera, strokes, options);
  }
  static inline std::unique_ptr<PictureRenderer> renderer_;
  static inline const PictureOptions kClear{.transparent = true};
};

TEST_F(Picture, covers_exactly_the_pixels_that_the_camera_projects_onto) {
  const Character box = statue({box_mesh(Vec3(0.5, 1.0, 0.25))});
  const Image image = draw(box, front_camera(120, 160, 4.0, Vec3(0.1, 0.2, 0)), kClear);
  ASSERT_EQ(image.width, 120);
  ASSERT_EQ(image.height, 160);
  // 40 pixels a unit: the box is [36, 76] x [48, 128].
  for (int y = 0; y < 160; ++y) {
    for (int x = 0; x < 120; ++x) {
      const bool inside = x >= 36 && x < 76 && y >= 48 && y < 128;
      ASSERT_EQ(image.pixel(x, y)[3], inside ? 255 : 0) << x << ", " << y;
    }
  }
}

TEST_F(Picture, puts_a_ball_where_the_perspective_camera_has_it) {
  Camera camera = front_camera(200, 150, 1.0);
  camera.projection = Camera::Projection::perspective;
  camera.position = Vec3(1.0, 2.5, 6.0);
  const Vec3 centre(0.7, 0.4, -0.3);
  const Image image = draw(statue({ball_mesh(0.12, centre)}), camera, kClear);
  Vec2 sum = Vec2::Zero();
  double weight = 0.0;
  for (int y = 0; y < 150; ++y) {
    for (int x = 0; x < 200; ++x) {
      const double alpha = image.pixel(x, y)[3] / 255.0;
      sum += alpha * Vec2(x + 0.5, y + 0.5);
      weight += alpha;
    }
  }
  ASSERT_GT(weight, 0.0);
  EXPECT_LT((sum / weight - *camera.project(centre)).norm(), 0.2);
  const double radius = 0.12 / camera.units_per_pixel(centre);
  EXPECT_NEAR(weight, kPi * radius * radius, 0.03 * weight);
}

TEST_F(Picture, is_not_flat) {
  const Image image = draw(statue({ball_mesh(0.8, Vec3::Zero())}), front_camera(128, 128, 2.0), kClear);
  int darkest = 255, brightest = 0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      if (image.pixel(x, y)[3] < 255) continue;
      darkest = std::min(darkest, luminance(image, x, y));
      brightest = std::max(brightest, luminance(image, x, y));
    }
  }
  EXPECT_GT(brightest, darkest + 70);
  EXPECT_GT(luminance(image, 45, 40), luminance(image, 85, 95) + 40);  // light from the upper left
}

TEST_F(Picture, has_straight_alpha_without_dark_fringes) {
  Material white;
  white.base_color = Vec4f::Ones();
  const Image image = draw(statue({ball_mesh(0.8, Vec3::Zero())}, white), front_camera(200, 200, 2.0), kClear);
  int edges = 0;
  for (int y = 20; y < 70; ++y) {  // the lit upper left outline
    for (int x = 20; x < 70; ++x) {
      const auto p = image.pixel(x, y);
      if (p[3] == 0) {
        ASSERT_EQ(p, (std::array<std::uint8_t, 4>{0, 0, 0, 0}));
      }
      if (p[3] == 0 || p[3] == 255) continue;
      ++edges;
      EXPECT_GT(p[1], 150) << x << ", " << y;
    }
  }
  EXPECT_GT(edges, 20);
  for (const int x : {0, 199}) {
    for (const int y : {0, 199}) EXPECT_EQ(image.pixel(x, y)[3], 0);
  }
}

TEST_F(Picture, is_the_same_twice_and_from_another_renderer) {
  const Character bones = humanoid_without_body();
  const Camera camera = front_camera(90, 120, 2.2, Vec3(0, 0.9, 0));
  const PictureOptions options{.skeleton = true};
  const Image first = draw(bones, camera, options);
  const Image other = draw(statue({box_mesh(Vec3::Ones())}), front_camera(64, 64, 4.0));
  EXPECT_EQ(draw(bones, camera, options).rgba, first.rgba);
  EXPECT_EQ(render_picture({{&bones, &bones.start}}, camera, {}, options).rgba, first.rgba);
  EXPECT_NE(other.rgba, first.rgba);
}

TEST_F(Picture, looks_the_same_of_a_doll_and_of_a_giant) {
  std::vector<Image> images;
  for (const double size : {0.004, 1.0, 700.0}) {
    const Character box =
        statue({box_mesh(size * Vec3(0.5, 1.0, 0.25)), ball_mesh(0.3 * size, size * Vec3(0.6, 0, 0.4))});
    Camera camera = front_camera(100, 100, 4.0 * size);
    camera.position = size * Vec3(4, 3, 6);
    images.push_back(draw(box, camera));
  }
  for (const Image& image : {images[0], images[2]}) {
    int different = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) different += std::abs(image.rgba[i] - images[1].rgba[i]) > 4;
    EXPECT_LT(different, 60);  // of 40000: edges fall either way
  }
}

TEST_F(Picture, mirrors_with_its_scene) {
  const auto scene = [](double side) {
    return statue({box_mesh(Vec3(0.2, 0.9, 0.2)), ball_mesh(0.3, Vec3(0.5 * side, 0.5, 0.2))});
  };
  Camera camera = front_camera(101, 101, 3.0);
  camera.position = Vec3(3, 2, 6);
  const Image right = draw(scene(1.0), camera, kClear);
  camera.position.x() = -3;
  const Image left = draw(scene(-1.0), camera, kClear);
  int different = 0;
  for (int y = 0; y < 101; ++y) {
    for (int x = 0; x < 101; ++x) different += std::abs(right.pixel(x, y)[3] - left.pixel(100 - x, y)[3]) > 40;
  }
  EXPECT_LT(different, 25);
}

TEST_F(Picture, darkens_the_ground_under_the_figure_only_if_there_is_ground) {
  Mesh box = box_mesh(Vec3(0.3, 0.5, 0.3));
  for (Vec3f& p : box.positions) p.y() += 0.5F;
  const Character character = statue({box});
  Camera camera = front_camera(160, 160, 3.0, Vec3(0, 0.5, 0));
  camera.position = Vec3(0, 3, 6);
  const Image with = draw(character, camera);
  const Image without = draw(character, camera, {.ground = false});
  const Vec2 beside = *camera.project(Vec3(0.34, 0, 0.1));
  const int x = static_cast<int>(beside.x()), y = static_cast<int>(beside.y());
  EXPECT_LT(luminance(with, x, y), luminance(without, x, y) - 20);
  EXPECT_GT(luminance(without, x, y), 215);
  EXPECT_GT(luminance(with, 2, 2), 215);  // far away the paper is clean
  EXPECT_EQ(with.pixel(2, 2)[3], 255);
  const Vec2 inside = *camera.project(Vec3(0.0, 0.5, 0.3));
  EXPECT_EQ(with.pixel(static_cast<int>(inside.x()), static_cast<int>(inside.y())),
            without.pixel(static_cast<int>(inside.x()), static_cast<int>(inside.y())));
}

TEST_F(Picture, never_hides_the_figure_behind_the_ground) {
  Mesh sunk = box_mesh(Vec3(0.3, 0.8, 0.3));  // half of it below y = 0, where the skeleton stands
  const Character character = statue({sunk});
  for (const Vec3& position : {Vec3(0, 8, 0.001), Vec3(0, 0, 8), Vec3(0, 4, 6), Vec3(0, -4, 6)}) {
    Camera camera = front_camera(64, 64, 2.5);
    camera.position = position;
    const Image seen = draw(character, camera), alone = draw(character, camera, kClear);
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        if (alone.pixel(x, y)[3] < 255) continue;
        ASSERT_NEAR(luminance(seen, x, y), luminance(alone, x, y), 3) << position.transpose();
      }
    }
  }
}

TEST_F(Picture, lets_one_part_shade_another) {
  Mesh floor = box_mesh(Vec3(1.0, 0.05, 1.0));
  Mesh lid = box_mesh(Vec3(0.3, 0.02, 0.3));
  Camera camera = front_camera(128, 128, 3.0);
  camera.position = Vec3(0, 6, 6);
  const Character bare = statue({floor});
  for (Vec3f& p : lid.positions) p.y() += 0.5F;
  const Character shaded = statue({floor, lid});
  const Image open = draw(bare, camera, kClear), shadow = draw(shaded, camera, kClear);
  int darker = 0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) darker += luminance(shadow, x, y) < luminance(open, x, y) - 25;
  }
  EXPECT_GT(darker, 150);
}

TEST_F(Picture, shows_the_image_of_a_material_the_right_way_round) {
  const Image picture{2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255}};
  Material material;
  material.base_color = Vec4f::Ones();
  material.base_color_image = std::make_shared<Bytes>(encode_png(picture));
  const Image image = draw(statue({card_mesh(1.0)}, material), front_camera(80, 80, 2.0), kClear);
  const auto strongest = [&](int x, int y) {
    const auto p = image.pixel(x, y);
    return std::max_element(p.begin(), p.begin() + 3) - p.begin();
  };
  EXPECT_EQ(strongest(20, 20), 0);
  EXPECT_EQ(strongest(60, 20), 1);
  EXPECT_EQ(strongest(20, 60), 2);
  const auto white = image.pixel(60, 60);
  EXPECT_NEAR(white[0], white[2], 40);
}

TEST_F(Picture, cuts_out_what_the_image_leaves_clear) {
  const Image picture{2, 1, {255, 255, 255, 255, 255, 255, 255, 0}};
  Material material;
  material.cut_out = true;
  material.base_color_image = std::make_shared<Bytes>(encode_png(picture));
  const Camera camera = front_camera(80, 80, 2.0);
  const Image cut = draw(statue({card_mesh(0.9)}, material), camera, kClear);
  EXPECT_EQ(cut.pixel(20, 40)[3], 255);
  EXPECT_EQ(cut.pixel(60, 40)[3], 0);
  material.cut_out = false;
  EXPECT_EQ(draw(statue({card_mesh(0.9)}, material), camera, kClear).pixel(60, 40)[3], 255);
}

TEST_F(Picture, draws_the_plain_colour_where_an_image_cannot_be_read) {
  Material material;
  material.base_color = Vec4f(0.8F, 0.02F, 0.02F, 1.0F);
  material.base_color_image = std::make_shared<Bytes>(Bytes(64, std::byte{7}));
  const auto p = draw(statue({card_mesh(0.9)}, material), front_camera(40, 40, 2.0), kClear).pixel(20, 20);
  EXPECT_GT(p[0], 3 * p[1]);
}

TEST_F(Picture, shows_the_back_of_a_card_only_if_it_is_double_sided) {
  Camera behind = front_camera(40, 40, 2.0);
  behind.position = Vec3(0, 0, -10);
  Material material;
  EXPECT_EQ(draw(statue({card_mesh(0.9)}, material), behind, kClear).pixel(20, 20)[3], 0);
  material.double_sided = true;
  EXPECT_EQ(draw(statue({card_mesh(0.9)}, material), behind, kClear).pixel(20, 20)[3], 255);
}

TEST_F(Picture, lets_the_paper_through_a_translucent_part) {
  Material glass;
  glass.base_color = Vec4f(0.1F, 0.1F, 0.9F, 0.5F);
  const auto p = draw(statue({card_mesh(0.9)}, glass), front_camera(40, 40, 2.0), kClear).pixel(20, 20);
  EXPECT_NEAR(p[3], 128, 2);
  EXPECT_GT(p[2], 120);  // straight alpha: the colour itself
}

TEST_F(Picture, draws_ink_where_the_stroke_runs_and_nowhere_else) {
  const Character box = statue({box_mesh(Vec3(0.5, 1.0, 0.25))});
  const Camera camera = front_camera(160, 160, 4.0);
  Stroke stroke;
  for (int i = 0; i <= 10; ++i) stroke.samples.push_back({Vec2(20 + 12 * i, 80), 0.1 * i, 0.6});
  for (const bool transparent : {false, true}) {
    const PictureOptions options{.transparent = transparent};
    const Image plain = draw(box, camera, options), inked = draw(box, camera, options, {stroke});
    for (int x = 40; x < 120; x += 7) {
      const auto p = inked.pixel(x, 80);
      EXPECT_GT(p[0], p[2] + 40) << x;  // sanguine
      EXPECT_LT(luminance(inked, x, 80), 110);
      EXPECT_GE(p[3], 230);
    }
    for (int y = 0; y < 160; ++y) {
      for (int x = 0; x < 160; ++x) {
        if (std::abs(y - 80) > 8) {
          ASSERT_EQ(inked.pixel(x, y), plain.pixel(x, y));
        }
      }
    }
  }
}

TEST_F(Picture, gives_a_body_to_bones_without_one) {
  const Character bones = humanoid_without_body();
  const Camera camera = front_camera(200, 200, 2.2, Vec3(0, 0.9, 0));
  const Image image = draw(bones, camera, kClear);
  const std::vector<Vec3> positions = compute_positions(bones.skeleton, bones.start);
  for (int j = 1; j < bones.skeleton.joint_count(); ++j) {
    const Vec3 middle =
        0.5 * (positions[static_cast<std::size_t>(j)] + positions[static_cast<std::size_t>(bones.skeleton.parent(j))]);
    const Vec2 p = *camera.project(middle);
    EXPECT_EQ(image.pixel(static_cast<int>(p.x()), static_cast<int>(p.y()))[3], 255) << bones.skeleton.name(j);
  }
  EXPECT_EQ(image.pixel(3, 3)[3], 0);
  EXPECT_EQ(image.pixel(100, 180)[3], 0);  // between the feet
}

TEST_F(Picture, colours_the_sides_of_the_skeleton_and_draws_it_over_the_body) {
  Character bones = humanoid_without_body();
  Part wall;  // a wall in front of everything
  wall.mesh = card_mesh(1.5);
  for (Vec3f& p : wall.mesh.positions) p += Vec3f(0, 0.9F, 1.0F);
  bones.parts.push_back(wall);
  const Camera camera = front_camera(400, 400, 2.2, Vec3(0, 0.9, 0));
  const Image plain = draw(bones, camera, kClear);
  const Image drawn = draw(bones, camera, {.skeleton = true, .transparent = true});
  const auto balance = [&](double side) {  // red against blue over an upper arm
    const Vec2 p = *camera.project(Vec3(0.27 * side, 1.36, -0.02));
    int sum = 0;
    for (int dy = -3; dy <= 3; ++dy) {
      for (int dx = -3; dx <= 3; ++dx) {
        const int x = static_cast<int>(p.x()) + dx, y = static_cast<int>(p.y()) + dy;
        const auto a = drawn.pixel(x, y), b = plain.pixel(x, y);
        sum += (a[0] - a[2]) - (b[0] - b[2]);
      }
    }
    return sum;
  };
  EXPECT_LT(balance(1.0), -500);  // its left is blue
  EXPECT_GT(balance(-1.0), 500);  // its right is red
  EXPECT_EQ(drawn.pixel(30, 30), plain.pixel(30, 30));
}

TEST_F(Picture, leaves_out_the_bones_of_helpers) {
  Skeleton skeleton({Joint{.name = "scene", .helper = true},
                     Joint{.name = "hips", .parent = 0, .rest = {.translation = Vec3(0, 1, 0)}},
                     Joint{.name = "spine", .parent = 1, .rest = {.translation = Vec3(0, 0.5, 0)}}});
  const Character character{.name = "c", .skeleton = skeleton, .start = rest_pose(skeleton)};
  const Image image =
      draw(character, front_camera(100, 100, 2.0, Vec3(0, 0.8, 0)), {.skeleton = true, .transparent = true});
  EXPECT_GT(image.pixel(50, 30)[3], 200);  // between hips and spine
  EXPECT_EQ(image.pixel(50, 65)[3], 0);    // between the scene and the hips
}

TEST_F(Picture, is_seamless_where_its_tiles_meet) {
  const Character ball = statue({ball_mesh(0.1, Vec3::Zero())});
  const Camera camera = front_camera(2048, 96, 0.3);
  const Image image = draw(ball, camera);
  for (int y = 30; y < 66; ++y) {
    const int step = luminance(image, 1023, y) - luminance(image, 1022, y);
    EXPECT_NEAR(luminance(image, 1024, y) - luminance(image, 1023, y), step, 5) << y;
  }
  for (int x = 1000; x < 1048; ++x) EXPECT_LT(luminance(image, x, 48), 225);
}

TEST_F(Picture, of_nobody_is_clean_paper) {
  const Image image = renderer_->render({}, front_camera(32, 24, 2.0));
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 32; ++x) {
      EXPECT_GT(luminance(image, x, y), 200);
      EXPECT_EQ(image.pixel(x, y)[3], 255);
    }
  }
}

TEST_F(Picture, refuses_actors_that_cannot_be_drawn) {
  const Character box = statue({box_mesh(Vec3::Ones())});
  const Camera camera = front_camera(16, 16, 2.0);
  const Pose none;
  Pose broken = box.start;
  broken.local[0].translation.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)renderer_->render({{nullptr, &box.start}}, camera), Error);
  EXPECT_THROW((void)renderer_->render({{&box, nullptr}}, camera), Error);
  EXPECT_THROW((void)renderer_->render({{&box, &none}}, camera), Error);
  EXPECT_THROW((void)renderer_->render({{&box, &broken}}, camera), Error);
  Camera blind = camera;
  blind.width_px = 0;
  EXPECT_THROW((void)draw(box, blind), Error);
  EXPECT_EQ(draw(box, camera).width, 16);  // and goes on
}

TEST(PictureDeathTest, says_what_is_missing_where_there_is_no_egl) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto try_without_driver = [] {
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere.json", 1);
    try {
      const PictureRenderer renderer;
    } catch (const Error& error) {
      std::fprintf(stderr, "%s: %s\n", std::string(to_string(error.code())).c_str(), error.what());
      std::_Exit(3);
    }
    std::_Exit(0);
  };
  EXPECT_EXIT(try_without_driver(), testing::ExitedWithCode(3), "internal: no picture can be drawn here: EGL");
}

}  // namespace
}  // namespace croquis
