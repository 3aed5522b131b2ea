// SPDX-License-Identifier: MIT
#include "croquis/io/gltf_build_skin.h"

#include <algorithm>
#include <string>

#include <nlohmann/json.hpp>

namespace croquis {
namespace {

bool is_same(const Skin& a, const Skin& b) {
  return a.joints == b.joints &&
         std::equal(a.inverse_bind.begin(), a.inverse_bind.end(), b.inverse_bind.begin(), b.inverse_bind.end(),
                    [](const Affine& m, const Affine& n) { return m.matrix() == n.matrix(); });
}

}  // namespace

int SkinBuilder::add(const Skin& skin, const std::vector<int>& node_of_joint) {
  for (const auto& [other, index] : skins_) {
    if (is_same(*other, skin)) return index;
  }
  std::vector<int> joints = skin.joints;
  std::vector<Affine> inverse_bind = skin.inverse_bind;
  const Skeleton& skeleton = character_.skeleton;
  for (int i = 0; skins_.empty() && i < skeleton.joint_count(); ++i) {
    if (skeleton.joint(i).helper || std::find(joints.begin(), joints.end(), i) != joints.end()) continue;
    joints.push_back(i);
    inverse_bind.push_back(skeleton.rest_model(i).inverse());
  }
  skins_.emplace_back(&skin, add_palette(joints, inverse_bind, node_of_joint));
  return skins_.back().second;
}

void SkinBuilder::add_bones(const std::vector<int>& node_of_joint) {
  std::vector<int> joints;
  std::vector<Affine> inverse_bind;
  for (int i = 0; i < character_.skeleton.joint_count(); ++i) {
    if (character_.skeleton.joint(i).helper) continue;
    joints.push_back(i);
    inverse_bind.push_back(character_.skeleton.rest_model(i).inverse());
  }
  if (joints.size() > 1) (void)add_palette(joints, inverse_bind, node_of_joint);
}

int SkinBuilder::add_palette(const std::vector<int>& joints, const std::vector<Affine>& inverse_bind,
                             const std::vector<int>& node_of_joint) {
  std::vector<float> numbers;
  for (const Affine& affine : inverse_bind) {
    // A joint scaled to nothing has no inverse: it binds where it stands.
    const Mat4 matrix = affine.matrix().allFinite() ? Mat4(affine.matrix()) : Mat4(Mat4::Identity());
    for (int i = 0; i < 16; ++i) numbers.push_back(static_cast<float>(matrix.data()[i]));
  }
  Json nodes = Json::array();
  for (const int joint : joints) nodes.push_back(node_of_joint[static_cast<std::size_t>(joint)]);
  const int matrices = editor_.add_floats(numbers, "MAT4");
  return editor_.append("skins", {{"inverseBindMatrices", matrices}, {"joints", std::move(nodes)}});
}

void add_skin_attributes(GltfEditor& editor, const Skin& skin, Json& attributes) {
  const auto slots = static_cast<std::size_t>(skin.influences);
  const std::size_t sets = (slots + 3) / 4;
  const auto vertices = static_cast<std::size_t>(skin.vertex_count());
  std::vector<std::vector<std::uint32_t>> joints(sets, std::vector<std::uint32_t>(vertices * 4, 0));
  std::vector<std::vector<float>> weights(sets, std::vector<float>(vertices * 4, 0.0F));
  std::uint32_t largest = 0;
  std::vector<std::pair<std::uint32_t, double>> held;
  for (std::size_t v = 0; v < vertices; ++v) {
    held.clear();
    double sum = 0.0;
    for (std::size_t k = v * slots; k < (v + 1) * slots; ++k) {
      if (!(skin.weights[k] > 0.0F)) continue;
      sum += skin.weights[k];
      const std::uint32_t joint = skin.joint_indices[k];
      const auto same = std::find_if(held.begin(), held.end(), [&](const auto& h) { return h.first == joint; });
      if (same != held.end())
        same->second += skin.weights[k];
      else
        held.emplace_back(joint, skin.weights[k]);
    }
    if (held.empty()) held.emplace_back(0U, sum = 1.0);
    for (std::size_t k = 0; k < held.size(); ++k) {
      joints[k / 4][v * 4 + k % 4] = held[k].first;
      weights[k / 4][v * 4 + k % 4] = static_cast<float>(held[k].second / sum);
      largest = std::max(largest, held[k].first);
    }
  }
  for (std::size_t set = 0; set < sets; ++set) {
    const std::string number = std::to_string(set);
    attributes["JOINTS_" + number] = editor.add_integers(joints[set], "VEC4", largest, ViewTarget::vertices);
    attributes["WEIGHTS_" + number] = editor.add_floats(weights[set], "VEC4", false, ViewTarget::vertices);
  }
}

}  // namespace croquis
