// SPDX-License-Identifier: MIT
// What every built-in body must keep: a closed surface, sound weights, and its volume when it bends.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "croquis/math/rotation.h"
#include "croquis/project/character.h"

namespace croquis {

struct MeshFacts {
  int loose_edges = 0;  ///< edges that do not have exactly two triangles turning the same way
  int euler = 0;        ///< vertices - edges + triangles: 2 per closed piece without handles
  double smallest_angle_degrees = 180.0;
  int odd_normals = 0;  ///< triangle corners whose normal is over 80 degrees from the triangle's
};

inline MeshFacts examine(const Mesh& mesh) {
  MeshFacts facts;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    Vec3 corner[3];
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t a = mesh.triangles[t + c], b = mesh.triangles[t + (c + 1) % 3];
      ++edges[{a, b}];
      corner[c] = mesh.positions[a].cast<double>();
    }
    const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3 u = (corner[(c + 1) % 3] - corner[c]).normalized(), v = (corner[(c + 2) % 3] - corner[c]).normalized();
      const double angle = std::acos(std::clamp(u.dot(v), -1.0, 1.0)) / kDegree;
      facts.smallest_angle_degrees = std::min(facts.smallest_angle_degrees, angle);
      if (normal.dot(mesh.normals[mesh.triangles[t + c]].cast<double>()) < 0.17) ++facts.odd_normals;
    }
  }
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end() || back->second != 1) ++facts.loose_edges;
  }
  facts.euler = mesh.vertex_count() - static_cast<int>(edges.size()) / 2 + mesh.triangle_count();
  return facts;
}

/// Turns a joint by degrees about an axis of model space, as seen at rest.
inline void turn(const Character& character, Pose& pose, const std::string& joint, const Vec3& axis, double degrees) {
  Transform& local = pose.local[static_cast<std::size_t>(character.skeleton.resolve(joint))];
  local.rotation = Quat(Eigen::AngleAxisd(degrees * kDegree, axis.normalized())) * local.rotation;
}

/// Linear blend skinning by the textbook.
inline std::vector<Vec3f> skin_linearly(const Character& character, const Part& part, const Pose& pose) {
  const std::vector<Affine> model = compute_model_transforms(character.skeleton, pose);
  const Skin& skin = *part.skin;
  const auto slots = static_cast<std::size_t>(skin.influences);
  std::vector<Vec3f> result;
  for (std::size_t v = 0; v < part.mesh.positions.size(); ++v) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = v * slots; k < (v + 1) * slots; ++k) {
      const std::size_t entry = skin.joint_indices[k];
      const Affine bone = model[static_cast<std::size_t>(skin.joints[entry])] * skin.inverse_bind[entry];
      sum += static_cast<double>(skin.weights[k]) * (bone * part.mesh.positions[v].cast<double>());
    }
    result.emplace_back(sum.cast<float>());
  }
  return result;
}

/// The volume of the piece of a body within `radius` of a point at rest, its cut faces closed by fans, in the positions
/// given.
inline double volume_around(const Mesh& mesh, const std::vector<Vec3f>& positions, const Vec3& center, double radius) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> open;
  const auto near = [&](std::uint32_t v) { return (mesh.positions[v].cast<double>() - center).norm() < radius; };
  double six_volumes = 0.0;
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) { six_volumes += a.dot(b.cross(c)); };
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const std::uint32_t* v = &mesh.triangles[t];
    if (!near(v[0]) || !near(v[1]) || !near(v[2])) continue;
    add(positions[v[0]].cast<double>(), positions[v[1]].cast<double>(), positions[v[2]].cast<double>());
    for (int c = 0; c < 3; ++c) {
      if (open.erase({v[(c + 1) % 3], v[c]}) == 0) open[{v[c], v[(c + 1) % 3]}] = true;
    }
  }
  std::map<std::uint32_t, std::vector<std::uint32_t>> follows;
  for (const auto& [edge, unused] : open) follows[edge.first].push_back(edge.second);
  while (!follows.empty()) {  // each rim is closed by a fan around its middle
    std::vector<std::uint32_t> rim{follows.begin()->first};
    while (true) {
      const auto next = follows.find(rim.back());
      if (next == follows.end()) break;
      rim.push_back(next->second.back());
      next->second.pop_back();
      if (next->second.empty()) follows.erase(next);
    }
    Vec3 middle = Vec3::Zero();
    for (std::size_t i = 0; i + 1 < rim.size(); ++i) middle += positions[rim[i]].cast<double>();
    middle /= static_cast<double>(rim.size() - 1);
    for (std::size_t i = 0; i + 1 < rim.size(); ++i) {
      add(middle, positions[rim[i + 1]].cast<double>(), positions[rim[i]].cast<double>());
    }
  }
  return six_volumes / 6.0;
}

}  // namespace croquis
