// SPDX-License-Identifier: MIT
// The diffusion is one implicit Euler step of the heat equation (crane2013 uses it so); unlike bone heat (baran2007) it
// starts from weights that already know the anatomy, so that it need only round them off.
#include "croquis/body/weights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/SparseCholesky>

#include "croquis/base/error.h"

namespace croquis {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

double radius_of(const Form& form, const Vec3& point) {
  if (const auto* loft = std::get_if<Loft>(&form.shape)) return loft->radius_near(point);
  return std::get<Ellipsoid>(form.shape).radius();
}

/// C2 step from 0 at x = -1 to 1 at x = 1.
double smooth_step(double x) {
  const double t = std::clamp(0.5 * (x + 1.0), 0.0, 1.0);
  return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

/// Adds to `weights` (one per joint) what a form's chain of joints has in a point.
void add_chain(const Form& form, const Armature& armature, const Vec3& point, double share,
               Eigen::Ref<Eigen::VectorXd> weights) {
  double rest = share;
  for (std::size_t i = 0; i + 1 < form.joints.size(); ++i) {
    const Vec3& before = armature.position(form.joints[i]);
    const Vec3& joint = armature.position(form.joints[i + 1]);
    Vec3 normal = (joint - before).normalized();
    if (i + 2 < form.joints.size()) normal += (armature.position(form.joints[i + 2]) - joint).normalized();
    const bool is_last = i + 2 == form.joints.size();
    const double softness = is_last && form.last_softness > 0.0 ? form.last_softness : form.softness;
    const double width = softness * radius_of(form, joint);
    const double beyond = smooth_step((point - joint).dot(normal.normalized()) / width);
    weights[form.joints[i]] += rest * (1.0 - beyond);
    rest *= beyond;
  }
  weights[form.joints.back()] += rest;
}

struct Start {
  Eigen::MatrixXd weights;    // [vertex, joint]
  Eigen::VectorXd diffusion;  // t per vertex
};

/// Column of a joint or of its mirror image: of a mirrored body only the left and the middle joints are worked out.
bool is_mirrored_later(const std::vector<int>& image, const Armature& armature, Eigen::Index joint) {
  return !image.empty() && armature.mirror()[static_cast<std::size_t>(joint)] < joint;
}

Start start_weights(const ImplicitSurface& surface, const Armature& armature, const Triangulation& mesh,
                    const std::vector<int>& image, double spread) {
  const auto vertices = static_cast<Eigen::Index>(mesh.positions.size());
  const auto joints = static_cast<Eigen::Index>(armature.mirror().size());
  Start start{Eigen::MatrixXd::Zero(vertices, joints), Eigen::VectorXd::Zero(vertices)};
  Eigen::VectorXd weights(joints), mirrored(joints);
  for (Eigen::Index v = 0; v < vertices; ++v) {
    const Vec3& point = mesh.positions[static_cast<std::size_t>(v)];
    const Eigen::Index other = image.empty() ? v : image[static_cast<std::size_t>(v)];
    if (other < v) continue;  // done with its image
    weights.setZero();
    double radius = 0.0;
    for (const auto& [form, share] : surface.shares(point)) {
      add_chain(*form, armature, point, share, weights);
      radius += share * radius_of(*form, point);
    }
    if (!image.empty() && other == v) {
      mirrored = weights(armature.mirror());
      weights = 0.5 * (weights + mirrored);
    }
    for (Eigen::Index j = 0; j < joints; ++j) {
      if (weights[j] == 0.0) continue;
      start.weights(v, j) = weights[j];
      if (other != v) start.weights(other, armature.mirror()[static_cast<std::size_t>(j)]) = weights[j];
    }
    start.diffusion[v] = start.diffusion[other] = std::max(spread * spread * radius * radius, 1e-12);
  }
  return start;
}

/// Cotangent Laplacian (positive semi-definite, negative cotangents left out) and vertex areas.
Sparse build_laplacian(const Triangulation& mesh, Eigen::VectorXd& areas) {
  const auto count = static_cast<Eigen::Index>(mesh.positions.size());
  areas = Eigen::VectorXd::Constant(count, 1e-12);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(mesh.triangles.size() * 12);
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const int a = triangle[c], i = triangle[(c + 1) % 3], j = triangle[(c + 2) % 3];
      const Vec3& apex = mesh.positions[static_cast<std::size_t>(a)];
      const Vec3 to_i = mesh.positions[static_cast<std::size_t>(i)] - apex;
      const Vec3 to_j = mesh.positions[static_cast<std::size_t>(j)] - apex;
      const double twice_area = to_i.cross(to_j).norm();
      const double weight = 0.5 * std::max(to_i.dot(to_j), 0.0) / std::max(twice_area, 1e-14);
      entries.emplace_back(i, i, weight);
      entries.emplace_back(j, j, weight);
      entries.emplace_back(i, j, -weight);
      entries.emplace_back(j, i, -weight);
      areas[a] += twice_area / 6.0;
    }
  }
  Sparse laplacian(count, count);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

void diffuse(const Triangulation& mesh, const Armature& armature, const std::vector<int>& image, Start& start) {
  Eigen::VectorXd areas;
  Sparse system = build_laplacian(mesh, areas);
  const Eigen::VectorXd mass = areas.cwiseQuotient(start.diffusion);
  system += Sparse(mass.asDiagonal());
  const Eigen::SimplicialLDLT<Sparse> solver(system);
  if (solver.info() != Eigen::Success) throw Error(ErrorCode::internal, "compute_weights: the diffusion has no factor");
  for (Eigen::Index j = 0; j < start.weights.cols(); ++j) {
    if (is_mirrored_later(image, armature, j)) {
      start.weights.col(j) = start.weights.col(armature.mirror()[static_cast<std::size_t>(j)])(image);
      continue;
    }
    const Eigen::VectorXd given = mass.cwiseProduct(start.weights.col(j));
    if (given.isZero(0.0)) continue;
    start.weights.col(j) = solver.solve(given);
  }
}

}  // namespace

Skin compute_weights(const ImplicitSurface& surface, const Armature& armature, const Triangulation& mesh,
                     const std::vector<int>& image, const WeightOptions& options) {
  Start start = start_weights(surface, armature, mesh, image, options.spread);
  diffuse(mesh, armature, image, start);
  Skin skin;
  const Skeleton skeleton = armature.skeleton();
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    skin.joints.push_back(j);
    skin.inverse_bind.push_back(skeleton.rest_model(j).inverse());
  }
  // The four largest of each vertex, largest first; a joint at a time, as the matrix lies in memory.
  using Influence = std::pair<double, int>;
  std::vector<std::array<Influence, 4>> largest(mesh.positions.size());
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    for (Eigen::Index v = 0; v < start.weights.rows(); ++v) {
      if (start.weights(v, j) <= 0.004) continue;
      Influence one{start.weights(v, j), j};
      for (Influence& kept : largest[static_cast<std::size_t>(v)]) {
        if (one.first > kept.first) std::swap(one, kept);
      }
    }
  }
  for (const auto& vertex : largest) {
    for (const auto& [weight, joint] : vertex) {
      skin.joint_indices.push_back(static_cast<std::uint16_t>(joint));
      skin.weights.push_back(static_cast<float>(weight));
    }
  }
  normalise_weights(skin);
  return skin;
}

}  // namespace croquis
