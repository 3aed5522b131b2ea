// SPDX-License-Identifier: MIT
#include "croquis/body/armature.h"

#include <algorithm>

#include "croquis/base/error.h"

namespace croquis {

int Armature::add(std::string name, int parent, const Vec3& position) {
  const int index = static_cast<int>(names_.size());
  names_.push_back(std::move(name));
  parents_.push_back(parent);
  positions_.push_back(position);
  mirror_.push_back(index);
  return index;
}

int Armature::add_pair(const std::string& left_name, int parent, const Vec3& position) {
  const std::size_t at = left_name.find("left");
  if (at == std::string::npos) throw_invalid_argument("Armature: '" + left_name + "' has no 'left' to be mirrored");
  std::string right_name = left_name;
  right_name.replace(at, 4, "right");
  const int left = add(left_name, parent, position);
  const int right = add(right_name, parent < 0 ? -1 : mirror_[static_cast<std::size_t>(parent)],
                        Vec3(-position.x(), position.y(), position.z()));
  std::swap(mirror_[static_cast<std::size_t>(left)], mirror_[static_cast<std::size_t>(right)]);
  return left;
}

int Armature::find(std::string_view name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) throw_invalid_argument("Armature: no joint is named '" + std::string(name) + "'");
  return static_cast<int>(found - names_.begin());
}

Skeleton Armature::skeleton() const {
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    Joint joint{names_[i], parents_[i]};
    joint.rest.translation = parents_[i] < 0 ? positions_[i] : Vec3(positions_[i] - position(parents_[i]));
    joints.push_back(joint);
  }
  return Skeleton(std::move(joints));
}

}  // namespace croquis
