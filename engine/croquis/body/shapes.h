// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/math/types.h"

namespace croquis {

/// What an implicit shape says at a point: an estimate of the signed distance to its surface (negative inside, exact to
/// first order at the surface, metres) and the outward direction, about a unit vector.
struct ShapeSample {
  double distance = 0.0;
  Vec3 direction = Vec3::UnitY();
};

/// A sphere that holds a shape.
struct Ball {
  Vec3 center = Vec3::Zero();
  double radius = -1.0;  ///< negative: empty

  void include(const Ball& other);
};

/// One cross-section of a Loft, in metres: how far the outline reaches from the axis to each side.
struct Section {
  Vec3 center;
  double side_plus = 0.0;    ///< along the loft's `side`
  double side_minus = 0.0;   ///< against it
  double front_plus = 0.0;   ///< along the loft's `front`
  double front_minus = 0.0;  ///< against it
  double square = 0.0;       ///< 0: an ellipse; 1: a rounded box (exponent 4)

  [[nodiscard]] double mean_radius() const { return 0.25 * (side_plus + side_minus + front_plus + front_minus); }
};

/// Round, elliptic, and lopsided sections.
[[nodiscard]] Section round_section(const Vec3& center, double radius);
[[nodiscard]] Section oval_section(const Vec3& center, double side, double front, double square = 0.0);
[[nodiscard]] Section oval_section(const Vec3& center, double side, double front_plus, double front_minus,
                                   double square);

/// A solid swept along a polyline of cross-sections, as a draughtsman lofts a hull: the outline runs through the
/// sections as a smooth cubic, the ends are closed by half-ellipsoids.
class Loft {
 public:
  /// At least two sections at different places. `side` may nowhere run along the axis, which may bend, but not by more
  /// than its radius allows; each section turns it to be orthogonal to the axis exactly. `front` says which way the
  /// other direction points at the first section. `cap_*` is how far the rounded ends reach beyond the first and the
  /// last section; negative: the section's mean radius.
  Loft(std::vector<Section> sections, const Vec3& side, const Vec3& front, double cap_start = -1.0,
       double cap_end = -1.0);

  [[nodiscard]] ShapeSample sample(const Vec3& point) const;
  [[nodiscard]] const Ball& ball() const { return ball_; }
  [[nodiscard]] Box box() const;
  /// The thinnest of its sections, to the thinnest side.
  [[nodiscard]] double least_radius() const;
  /// The mean radius of the section nearest to a point.
  [[nodiscard]] double radius_near(const Vec3& point) const;

 private:
  struct Piece {  // between two sections; radii are cubics in the local parameter, 0..1
    Vec3 start, along;
    double inverse_length2 = 0.0;
    Vec3 normal[2];  // of the planes of its two sections, along the axis
    Vec3 side[2], front[2];
    Vec4 radius[4];  // coefficients of s^0..s^3 for side+, side-, front+, front-
    double square[2] = {0.0, 0.0};
  };
  struct Nearest {
    const Piece* piece = nullptr;
    double s = 0.0;  ///< on the piece, 0..1: where the plane through the point lies between those of its sections
  };
  [[nodiscard]] Nearest nearest(const Vec3& point) const;

  std::vector<Section> sections_;
  std::vector<Piece> pieces_;
  // What is asked of every piece, for all at once: starts, directions (by x, y, z) and inverse squared lengths.
  Eigen::Array<double, Eigen::Dynamic, 7> axes_;
  double cap_[2];
  Ball ball_;
};

/// An ellipsoid with its own axes: columns of `axes` are orthonormal, `radii` along them.
class Ellipsoid {
 public:
  Ellipsoid(const Vec3& center, const Vec3& radii, const Mat3& axes = Mat3::Identity());

  [[nodiscard]] ShapeSample sample(const Vec3& point) const;
  [[nodiscard]] const Ball& ball() const { return ball_; }
  [[nodiscard]] Box box() const;
  [[nodiscard]] double radius() const { return radii_.mean(); }
  [[nodiscard]] double least_radius() const { return radii_.minCoeff(); }

 private:
  Vec3 center_, radii_;
  Mat3 axes_;
  Ball ball_;
};

}  // namespace croquis
