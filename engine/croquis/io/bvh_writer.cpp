// SPDX-License-Identifier: MIT
//
// A BVH holds, for each joint, a rotation against its parent with all rest rotations zero. With A and A0 the model
// transforms of a joint in the pose and at rest, D = rotation(A A0^-1) is how far it has turned since rest in the
// world's axes; the file's rotation is D_parent^-1 D, and the file's position D_parent^-1 (p - p_parent). Where no
// bone is stretched that position is the rest OFFSET, whatever scales the skeleton itself carries.
#include <algorithm>
#include <cmath>

#include "croquis/base/error.h"
#include "croquis/base/index.h"
#include "croquis/base/text.h"
#include "croquis/io/bvh.h"
#include "croquis/io/bvh_layout.h"
#include "croquis/io/bvh_motion.h"

namespace croquis {
namespace {

/// Where a joint stands and how far it has turned since rest, in the world's axes.
struct Stand {
  Vec3 position = Vec3::Zero();
  Quat turn = Quat::Identity();
};

std::vector<Stand> compute_stands(const Skeleton& skeleton, const Pose& pose) {
  const std::vector<Affine> model = compute_model_transforms(skeleton, pose);
  std::vector<Stand> stands(model.size());
  for (int i = 0; i < skeleton.joint_count(); ++i) {
    const Mat3 rest = skeleton.rest_model(i).linear();
    stands[at(i)].position = model[at(i)].translation();
    if (std::abs(rest.determinant()) > 1e-9 * std::pow(rest.norm(), 3)) {
      Affine turned = Affine::Identity();
      turned.linear() = model[at(i)].linear() * rest.inverse();
      stands[at(i)].turn = rotation_of(turned);
    } else if (i > 0) {
      stands[at(i)].turn = stands[at(skeleton.parent(i))].turn;  // scaled flat: its own turn cannot be told
    }
  }
  return stands;
}

class Writer {
 public:
  Writer(const Character& character, const Pose& pose, const WriteOptions& options)
      : skeleton_(character.skeleton), options_(options), layout_(make_bvh_layout(character)) {
    const std::vector<Stand> stands = compute_stands(skeleton_, pose);
    for (int i = 0; i < std::ssize(layout_.nodes); ++i) {
      const int joint = layout_.joints[at(i)], parent = layout_.nodes[at(i)].parent;
      Transform local;
      if (joint < 0) {
        local.translation = layout_.nodes[at(i)].offset;
      } else {
        const Stand above = parent < 0 ? Stand() : stands[at(layout_.joints[at(parent)])];
        const Stand& here = stands[at(joint)];
        local.translation = above.turn.conjugate() * (here.position - above.position);
        local.rotation = above.turn.conjugate() * here.turn;
      }
      locals_.push_back(local);
    }
  }

  std::string write() {
    for (int i = 0; i < std::ssize(layout_.nodes); ++i) make_room_for_stretch(i);
    const std::string row = motion_row();
    const std::string& end = layout_.new_line;
    std::string text = layout_.hierarchy.empty() ? spell_bvh_hierarchy(layout_) : edited_hierarchy();
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
    text += end + "MOTION" + end + "Frames: 1" + end + "Frame Time: " + layout_.frame_time + end + row + end;
    return text;
  }

 private:
  [[nodiscard]] std::string called(int index) const {
    return "joint '" + printable(skeleton_.reference(layout_.joints[at(index)])) + "'";
  }

  /// Gives position channels to a node that needs them (an End Site another OFFSET), or refuses.
  void make_room_for_stretch(int index) {
    BvhNode& node = layout_.nodes[at(index)];
    const Vec3 moved = locals_[at(index)].translation - node.offset;
    bool stretched = false;
    for (int axis = 0; axis < 3; ++axis) {
      stretched = stretched || (!node.has(axis) && std::abs(moved[axis]) > 1e-6 * skeleton_.extent());
    }
    if (!stretched) return;
    if (!options_.add_positions) {
      throw Error(ErrorCode::unsupported, called(index) + " stands off its bone by " + format_double(moved.norm(), 3) +
                                              ", and its BVH joint has no position channels: position channels may "
                                              "be added (--add-positions)");
    }
    changed_.push_back(index);
    if (node.end_site) {
      node.offset = locals_[at(index)].translation;
      return;
    }
    std::vector<BvhChannel> channels;
    for (int axis = 0; axis < 3; ++axis) {
      if (!node.has(axis)) channels.push_back(axis);
    }
    node.channels.insert(node.channels.begin(), channels.begin(), channels.end());
  }

  std::string motion_row() {
    std::vector<double> row(at(number_channels(layout_)));
    std::vector<bool> has_children(layout_.nodes.size());
    for (const BvhNode& node : layout_.nodes) {
      if (node.parent >= 0) has_children[at(node.parent)] = true;
    }
    for (int i = 0; i < std::ssize(layout_.nodes); ++i) {
      const BvhNode& node = layout_.nodes[at(i)];
      const Quat& wanted = locals_[at(i)].rotation;
      set_bvh_row(node, locals_[at(i)].translation, wanted, layout_.positions_are_added, row);
      const double off = bvh_local_transform(node, row, layout_.positions_are_added).rotation.angularDistance(wanted);
      if (off > 1e-6 && has_children[at(i)]) {
        throw Error(ErrorCode::unsupported, called(i) + " is turned by " + format_double(off / kDegree, 3) +
                                                " degrees about an axis for which its BVH joint has no channel");
      }
    }
    std::vector<std::string> words;
    words.reserve(row.size());
    for (const double value : row) words.push_back(format_double(std::abs(value) < 1e-12 ? 0.0 : value, 10));
    return join(words, " ");
  }

  /// The source's text with the channels and offsets of changed nodes replaced.
  [[nodiscard]] std::string edited_hierarchy() const {
    struct Edit {
      TextRange range;
      std::string text;
    };
    std::vector<Edit> edits;
    for (const int index : changed_) {
      const BvhNode& node = layout_.nodes[at(index)];
      if (node.end_site) {
        edits.push_back({node.offset_text, spell_bvh_vector(node.offset)});
      } else if (node.channels_text.end > 0) {
        edits.push_back({node.channels_text, spell_bvh_channels(node)});
      } else {
        const std::size_t behind = node.offset_text.end;
        edits.push_back({{behind, behind}, layout_.new_line + spell_bvh_channels(node)});
      }
    }
    std::sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) { return a.range.begin < b.range.begin; });
    std::string text;
    std::size_t done = 0;
    for (const Edit& edit : edits) {
      text.append(layout_.hierarchy, done, edit.range.begin - done);
      text += edit.text;
      done = edit.range.end;
    }
    return text.append(layout_.hierarchy, done);
  }

  const Skeleton& skeleton_;
  const WriteOptions& options_;
  BvhLayout layout_;
  std::vector<Transform> locals_;  // of each node, as the file is to hold them
  std::vector<int> changed_;
};

}  // namespace

Bytes write_bvh(const Character& character, const Pose& pose, const WriteOptions& options) {
  if (options.form == PoseForm::baked) {
    throw Error(ErrorCode::unsupported, "a BVH holds no mesh that a pose could be baked into");
  }
  const std::string text = Writer(character, pose, options).write();
  const auto* const begin = reinterpret_cast<const std::byte*>(text.data());
  return {begin, begin + text.size()};
}

}  // namespace croquis
