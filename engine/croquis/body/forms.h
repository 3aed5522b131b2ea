// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/body/implicit_surface.h"

namespace croquis {

/// What a form needs beside its shape, so that a body can be written down as a list of masses.
struct FormTraits {
  std::vector<int> joints;
  double blend = 0.0;
  double detail = 0.012;
  double softness = 0.9;
  double gap = 0.0;
  double last_softness = 0.0;
};

[[nodiscard]] inline Form make_form(std::variant<Loft, Ellipsoid> shape, const FormTraits& traits) {
  return {std::move(shape), traits.blend,  false,           traits.detail,
          traits.gap,       traits.joints, traits.softness, traits.last_softness};
}

[[nodiscard]] inline Form make_carving(std::variant<Loft, Ellipsoid> shape, const FormTraits& traits) {
  return {std::move(shape), traits.blend,        true, traits.detail, traits.gap, traits.joints,
          traits.softness,  traits.last_softness};
}

/// The rotation by angles about X, then Y, then Z, in degrees.
[[nodiscard]] inline Mat3 turned(double x_degrees, double y_degrees, double z_degrees) {
  return (Eigen::AngleAxisd(z_degrees * kDegree, Vec3::UnitZ()) *
          Eigen::AngleAxisd(y_degrees * kDegree, Vec3::UnitY()) * Eigen::AngleAxisd(x_degrees * kDegree, Vec3::UnitX()))
      .toRotationMatrix();
}

}  // namespace croquis
