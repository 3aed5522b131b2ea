// SPDX-License-Identifier: MIT
#include "croquis/io/gltf_read.h"

#include <cmath>
#include <set>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/file_name.h"
#include "croquis/io/gltf_animation.h"
#include "croquis/io/gltf_mesh.h"
#include "croquis/io/gltf_nodes.h"
#include "croquis/io/gltf_skeleton.h"
#include "croquis/io/vrm.h"
#include "croquis/io/words.h"

namespace croquis {
namespace {

void report_nodes(const GltfNodes& nodes, const JointChoice& choice, std::vector<std::string>& oddities) {
  int sheared = 0, scaled = 0, mirrored = 0;
  for (const int node : choice.node_of_joint) {
    if (node < 0) continue;
    const Vec3& scale = nodes[node].local.scale;
    if (nodes[node].shear > 1e-4) ++sheared;
    if ((scale - Vec3::Ones()).cwiseAbs().maxCoeff() > 1e-3) ++scaled;
    if (scale.prod() < 0.0) ++mirrored;
  }
  if (sheared > 0)
    oddities.push_back(count_of(sheared, "joint") + (sheared == 1 ? " is" : " are") +
                       " sheared, which their pose cannot hold.");
  if (scaled > 0) oddities.push_back(count_of(scaled, "joint") + (scaled == 1 ? " is" : " are") + " scaled.");
  if (mirrored > 0)
    oddities.push_back(count_of(mirrored, "joint") + (mirrored == 1 ? " is" : " are") +
                       " mirrored by a negative scale.");
}

void report_names(const Skeleton& skeleton, std::vector<std::string>& oddities) {
  int unnamed = 0;
  std::set<std::string> seen, twice;
  for (const Joint& joint : skeleton.joints()) {
    if (joint.name.empty())
      ++unnamed;
    else if (!seen.insert(joint.name).second)
      twice.insert(joint.name);
  }
  if (unnamed > 0) oddities.push_back(count_of(unnamed, "joint") + (unnamed == 1 ? " has" : " have") + " no name.");
  if (!twice.empty()) {
    oddities.push_back(count_of(std::ssize(twice), "joint name") + (twice.size() == 1 ? " stands" : " stand") +
                       " more than once, such as '" + printable(*twice.begin()) + "'.");
  }
}

/// In the bind pose model_from_joint * joint_from_mesh is one and the same matrix for all joints of a skin.
void report_bind_pose(const Character& character, std::vector<std::string>& oddities) {
  std::set<int> away;
  std::set<std::vector<int>> seen;
  for (const Part& part : character.parts) {
    if (!part.skin || !seen.insert(part.skin->joints).second) continue;
    const auto bound = [&](std::size_t i) {
      return Mat4((character.skeleton.rest_model(part.skin->joints[i]) * part.skin->inverse_bind[i]).matrix());
    };
    const Mat4 first = bound(0);
    const double size = std::max(first.cwiseAbs().maxCoeff(), 1e-12);
    for (std::size_t i = 1; i < part.skin->joints.size(); ++i) {
      if ((bound(i) - first).cwiseAbs().maxCoeff() > 1e-3 * size) away.insert(part.skin->joints[i]);
    }
  }
  if (!away.empty()) {
    oddities.push_back("It does not stand as it was bound: " + count_of(std::ssize(away), "joint") +
                       (away.size() == 1 ? " rests" : " rest") + " elsewhere than in the bind pose.");
  }
}

void report_size(const Skeleton& skeleton, std::vector<std::string>& oddities) {
  const double extent = skeleton.extent();
  if (skeleton.joint_count() > 1 && extent > 20.0) {
    oddities.push_back("It measures " + format_double(extent, 3) + " metres: its unit may be the centimetre.");
  } else if (skeleton.joint_count() > 1 && extent < 0.05) {
    oddities.push_back("It measures " + format_double(extent, 3) + " metres only.");
  }
}

HumanoidMap make_humanoid(const VrmInfo& vrm, const JointChoice& choice) {
  HumanoidMap humanoid;
  for (const auto& [bone, node] : vrm.bones) {
    humanoid.set(bone, choice.joint_of_node[static_cast<std::size_t>(node)], 1.0);
  }
  return humanoid;
}

Vec3 find_front(const Character& character, VrmKind kind) {
  if (kind == VrmKind::vrm0) return -Vec3::UnitZ();
  if (kind == VrmKind::vrm1 || !character.humanoid.is_humanoid()) return Vec3::UnitZ();
  return compute_facing(character.humanoid, compute_positions(character.skeleton, character.start));
}

Character read_opened(const GltfDocument& document, std::string_view file_name) {
  std::vector<std::string> oddities = document.oddities;
  const GltfNodes nodes = read_nodes(document);
  const VrmInfo vrm = read_vrm(document, oddities);
  std::vector<int> humanoid_nodes;
  for (const auto& [bone, node] : vrm.bones) humanoid_nodes.push_back(node);
  const JointChoice choice = choose_joints(document, nodes, humanoid_nodes);
  const std::vector<PartPlace> places = list_parts(document, nodes);

  Character character{.name = file_stem(file_name), .skeleton = make_skeleton(document, nodes, choice)};
  character.start = rest_pose(character.skeleton);
  character.parts = read_parts(document, nodes, choice, oddities);
  character.clips = read_clips(document, choice, places, oddities);
  character.humanoid = vrm.bones.empty() ? recognise_humanoid(character.skeleton) : make_humanoid(vrm, choice);
  character.front = find_front(character, vrm.kind);
  character.licence = vrm.licence;
  character.source_nodes = choice.node_of_joint;
  character.source = document.source;

  if (nodes.size() == 0) oddities.emplace_back("The file has no nodes.");
  report_nodes(nodes, choice, oddities);
  report_names(character.skeleton, oddities);
  report_bind_pose(character, oddities);
  report_size(character.skeleton, oddities);
  character.oddities = std::move(oddities);
  try {
    character.check();
  } catch (const Error& error) {
    throw_bad_file("/", error.what());
  }
  return character;
}

}  // namespace

Character read_gltf(std::span<const std::byte> bytes, std::string_view file_name, const ResourceReader& resources) {
  return read_opened(open_gltf(bytes, file_name, resources), file_name);
}

}  // namespace croquis
