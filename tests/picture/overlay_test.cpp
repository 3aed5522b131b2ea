// SPDX-License-Identifier: MIT
#include "croquis/picture/overlay.h"

#include <cmath>

#include <gtest/gtest.h>

namespace croquis {
namespace {

double painted_area(const Canvas& canvas) {
  double sum = 0.0;
  for (const Vec4f& pixel : canvas.pixels) sum += static_cast<double>(pixel.w());
  return sum;
}

Stroke straight_stroke(double pressure_from, double pressure_to, int count = 21) {
  Stroke stroke;
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    stroke.samples.push_back({Vec2(10 + 180 * t, 50), t, pressure_from + t * (pressure_to - pressure_from)});
  }
  return stroke;
}

TEST(Canvas, covers_the_area_of_a_disc) {
  Canvas canvas(0, 0, 64, 64);
  const std::array<Disc, 1> disc{{{Vec2(31.3, 32.8), 11.0}}};
  paint_sweep(canvas, disc, make_paint(0x000000));
  EXPECT_NEAR(painted_area(canvas), kPi * 121.0, 1.0);
}

TEST(Canvas, covers_the_hull_of_two_discs) {
  Canvas canvas(0, 0, 128, 64);
  const double r1 = 14.0, r2 = 5.0, d = 60.0;
  const std::array<Disc, 2> path{{{Vec2(30, 32), r1}, {Vec2(30 + d, 32), r2}}};
  paint_sweep(canvas, path, make_paint(0x000000));
  const double lean = std::asin((r1 - r2) / d);  // of the two common tangents
  const double area = r1 * r1 * (0.5 * kPi + lean) + r2 * r2 * (0.5 * kPi - lean) + (r1 + r2) * d * std::cos(lean);
  EXPECT_NEAR(painted_area(canvas), area, 0.01 * area);
}

TEST(Canvas, is_no_darker_where_a_path_crosses_itself) {
  Canvas canvas(0, 0, 64, 64);
  const std::array<Disc, 4> path{{{Vec2(5, 32), 4}, {Vec2(60, 32), 4}, {Vec2(32, 60), 4}, {Vec2(32, 5), 4}}};
  paint_sweep(canvas, path, make_paint(0xFFFFFF, 0.5F));
  EXPECT_FLOAT_EQ(canvas.at(32, 32).w(), 0.5F);
  EXPECT_FLOAT_EQ(canvas.at(20, 32).w(), 0.5F);
  EXPECT_FLOAT_EQ(canvas.at(32, 32).x(), 0.5F);  // premultiplied
}

TEST(Canvas, gives_the_same_pixels_in_tiles) {
  const std::array<Disc, 3> path{{{Vec2(4, 5), 3}, {Vec2(40, 30), 6}, {Vec2(10, 50), 1}}};
  const std::array<Vec2, 3> triangle{Vec2(8, 8), Vec2(50, 20), Vec2(20, 55)};
  const auto paint = [&](Canvas& canvas) {
    paint_sweep(canvas, path, make_paint(0x336699, 0.7F));
    paint_polygon(canvas, triangle, make_paint(0xFF0000, 0.4F), make_paint(0x00FF00), 2.0);
  };
  Canvas whole(0, 0, 64, 64), tile(17, 23, 20, 30);
  paint(whole);
  paint(tile);
  for (int y = 23; y < 53; ++y) {
    for (int x = 17; x < 37; ++x) ASSERT_EQ(tile.at(x, y), whole.at(x, y)) << x << ", " << y;
  }
}

TEST(Canvas, fills_a_polygon_that_is_not_convex) {
  Canvas canvas(0, 0, 64, 64);
  const std::array<Vec2, 6> corner{Vec2(10, 10), Vec2(50, 10), Vec2(50, 20), Vec2(20, 20), Vec2(20, 50), Vec2(10, 50)};
  paint_polygon(canvas, corner, make_paint(0x000000), make_paint(0, 0.0F), 0.0);
  EXPECT_NEAR(painted_area(canvas), 400.0 + 300.0, 1.0);
  EXPECT_EQ(canvas.at(40, 40).w(), 0.0F);
  EXPECT_EQ(canvas.at(15, 40).w(), 1.0F);
}

TEST(Ink, grows_thicker_under_pressure) {
  const std::vector<Disc> path = make_ink_path(straight_stroke(0.1, 0.9), 4.0);
  const auto at = [&](double x) {
    double radius = 0.0;
    for (const Disc& disc : path) {
      if (disc.centre.x() <= x) radius = disc.radius;
    }
    return radius;
  };
  EXPECT_GT(at(130), 1.3 * at(70));
}

TEST(Ink, tapers_towards_both_ends) {
  const std::vector<Disc> path = make_ink_path(straight_stroke(0.5, 0.5), 4.0);
  EXPECT_EQ(path.front().centre, Vec2(10, 50));
  EXPECT_EQ(path.back().centre, Vec2(190, 50));
  const double middle = path[path.size() / 2].radius;
  EXPECT_NEAR(middle, 4.0, 1e-9);
  EXPECT_LT(path.front().radius, 0.7 * middle);
  EXPECT_LT(path.back().radius, 0.4 * middle);
}

TEST(Ink, runs_through_every_sample_and_keeps_the_corners_of_a_drawn_path) {
  Stroke stroke;
  for (const Vec2& p : {Vec2(10, 10), Vec2(60, 10), Vec2(60, 60), Vec2(61, 90)})
    stroke.samples.push_back({p, 0.0, 0.5});
  for (const bool raw : {false, true}) {
    stroke.raw_pen = raw;
    const std::vector<Disc> path = make_ink_path(stroke, 3.0);
    for (const StrokeSample& sample : stroke.samples) {
      double nearest = 1e9;
      for (const Disc& disc : path) nearest = std::min(nearest, (disc.centre - sample.position).norm());
      EXPECT_LT(nearest, 1e-9) << raw;
    }
    double highest = 1e9;
    for (const Disc& disc : path) highest = std::min(highest, disc.centre.y());
    if (raw) {
      EXPECT_LT(highest, 10.0 - 1e-3);  // a curve
    } else {
      EXPECT_DOUBLE_EQ(highest, 10.0);  // straight
    }
  }
}

TEST(Ink, takes_strokes_of_nothing_and_of_one_point) {
  EXPECT_TRUE(make_ink_path(Stroke{}, 3.0).empty());
  Stroke dot;
  dot.samples.assign(5, {Vec2(7, 7), 0.0, 0.5});
  const std::vector<Disc> path = make_ink_path(dot, 3.0);
  ASSERT_EQ(path.size(), 1U);
  EXPECT_NEAR(path[0].radius, 3.0, 1e-9);
}

}  // namespace
}  // namespace croquis
