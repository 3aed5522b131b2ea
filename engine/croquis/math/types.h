// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

#include <Eigen/Core>
#include <Eigen/Geometry>

/// The vocabulary of the engine's mathematics. `double` everywhere; the `f` forms are for per-vertex buffers, in the
/// layout that GPUs and files use. Eigen's vectors start uninitialised: write `Vec3 v = Vec3::Zero();`, and never
/// `auto` for an Eigen expression.
namespace croquis {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec4 = Eigen::Vector4d;
using Mat3 = Eigen::Matrix3d;
using Mat4 = Eigen::Matrix4d;
using Quat = Eigen::Quaterniond;
using Affine = Eigen::Affine3d;

using Vec2f = Eigen::Vector2f;
using Vec3f = Eigen::Vector3f;
using Vec4f = Eigen::Matrix<float, 4, 1, Eigen::DontAlign>;

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kDegree = kPi / 180.0;  ///< radians

/// An axis-aligned box; empty until something is put in (`extend`).
using Box = Eigen::AlignedBox3d;

}  // namespace croquis
