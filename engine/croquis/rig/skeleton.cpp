// SPDX-License-Identifier: MIT
#include "croquis/rig/skeleton.h"

#include <algorithm>

#include "croquis/base/error.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

void check(const std::vector<Joint>& joints) {
  if (joints.empty()) throw_invalid_argument("Skeleton: got no joint, wanted at least one");
  for (int i = 0; i < std::ssize(joints); ++i) {
    const Joint& joint = joints[static_cast<std::size_t>(i)];
    const auto fail = [&](const std::string& text) {
      throw_invalid_argument("Skeleton: joint #" + std::to_string(i) + " (" + printable(joint.name) + ") " + text);
    };
    if (i == 0 && joint.parent != -1) fail("is the first and must have no parent");
    if (i > 0 && (joint.parent < 0 || joint.parent >= i)) {
      fail("has parent " + std::to_string(joint.parent) + ", wanted an earlier joint");
    }
    if (!joint.rest.is_finite()) fail("has a rest transform that is not finite");
  }
}

}  // namespace

Skeleton::Skeleton(std::vector<Joint> joints) : joints_(std::move(joints)) {
  check(joints_);
  children_.resize(joints_.size());
  rest_model_.reserve(joints_.size());
  Box box;
  for (int i = 0; i < joint_count(); ++i) {
    Joint& joint = joints_[static_cast<std::size_t>(i)];
    joint.rest.rotation.normalize();
    const Affine local = joint.rest.to_affine();
    rest_model_.push_back(i == 0 ? local : rest_model_[static_cast<std::size_t>(joint.parent)] * local);
    if (i > 0) children_[static_cast<std::size_t>(joint.parent)].push_back(i);
    if (!joint.helper) box.extend(rest_position(i));
  }
  const double diagonal = box.isEmpty() ? 0.0 : box.sizes().norm();
  if (diagonal > 0.0) extent_ = diagonal;
}

bool Skeleton::is_ancestor(int ancestor, int joint) const {
  while (joint > ancestor) joint = parent(joint);
  return joint == ancestor;
}

std::vector<int> Skeleton::path(int from, int to) const {
  std::vector<int> climb{from}, descent{to};
  while (climb.back() != descent.back()) {
    std::vector<int>& later = climb.back() > descent.back() ? climb : descent;
    later.push_back(parent(later.back()));
  }
  climb.insert(climb.end(), descent.rbegin() + 1, descent.rend());
  return climb;
}

std::vector<int> Skeleton::find(std::string_view name) const {
  std::vector<int> found;
  for (int i = 0; i < joint_count(); ++i) {
    if (this->name(i) == name) found.push_back(i);
  }
  return found;
}

int Skeleton::resolve(std::string_view reference) const {
  const std::vector<int> found = find(reference);
  if (found.size() == 1) return found.front();
  const std::string shown = "'" + printable(reference) + "'";
  if (found.size() > 1) {
    std::vector<std::string> indices;
    for (const int i : found) indices.push_back("#" + std::to_string(i));
    throw_invalid_argument("joint " + shown + " is the name of " + std::to_string(found.size()) +
                           " joints; say which by its index: " + join(indices, ", "));
  }
  if (reference.starts_with('#')) {
    const auto index = parse_int(reference.substr(1));
    if (index && *index >= 0 && *index < joint_count()) return *index;
    throw_invalid_argument("joint " + shown + ": wanted an index from #0 to #" + std::to_string(joint_count() - 1));
  }
  std::vector<std::string> names;
  for (const Joint& joint : joints_) names.push_back(joint.name);
  const std::string near = closest_word(reference, names);
  throw_invalid_argument("no joint is named " + shown +
                         (near.empty() ? std::string() : "; did you mean '" + printable(near) + "'?"));
}

std::string Skeleton::reference(int index) const {
  const bool plain = !name(index).empty() && find(name(index)).size() == 1;
  return plain ? name(index) : "#" + std::to_string(index);
}

}  // namespace croquis
