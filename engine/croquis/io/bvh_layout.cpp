// SPDX-License-Identifier: MIT
#include "croquis/io/bvh_layout.h"

#include <algorithm>

#include "croquis/base/index.h"
#include "croquis/base/text.h"
#include "croquis/io/bvh_motion.h"
#include "croquis/io/unique_names.h"

namespace croquis {
namespace {

/// The layout of a BVH source; without nodes if the skeleton is no longer the file's.
BvhLayout source_layout(const Character& character) {
  const Bytes& bytes = character.source->bytes;
  BvhText text = parse_bvh(bytes, kBvhTellingFrames);
  const int helpers = character.skeleton.joint_count() - static_cast<int>(text.nodes.size());
  BvhLayout layout;
  if (helpers < 0 || helpers > 1) return layout;
  for (int i = 0; i < std::ssize(text.nodes); ++i) {
    const BvhNode& node = text.nodes[at(i)];
    if (!node.end_site && node.name != character.skeleton.name(i + helpers)) return BvhLayout();
    layout.joints.push_back(i + helpers);
  }
  layout.positions_are_added = bvh_positions_are_added(text);
  layout.hierarchy.assign(reinterpret_cast<const char*>(bytes.data()), text.hierarchy_end);
  layout.new_line = text.new_line;
  if (text.frame_time > 0.0) layout.frame_time = text.frame_time_text;
  layout.nodes = std::move(text.nodes);
  return layout;
}

/// A name as other programs read it: no spaces or braces, and not empty.
std::string plain_name(const std::string& name, int joint) {
  std::string plain;
  for (const char c : name) plain += static_cast<unsigned char>(c) <= ' ' || c == '{' || c == '}' ? '_' : c;
  return plain.empty() ? "joint_" + std::to_string(joint) : plain;
}

/// The joints to write: those that are no mere helpers, and what is needed to hold them together.
std::vector<bool> useful_joints(const Skeleton& skeleton) {
  std::vector<bool> useful(skeleton.joints().size());
  for (int i = skeleton.joint_count() - 1; i >= 0; --i) {
    if (!skeleton.joint(i).helper) useful[at(i)] = true;
    if (useful[at(i)] && i > 0) useful[at(skeleton.parent(i))] = true;
  }
  if (!useful[0]) useful.assign(useful.size(), true);
  return useful;
}

std::vector<int> useful_children(const Skeleton& skeleton, const std::vector<bool>& useful, int joint) {
  std::vector<int> children;
  for (const int child : skeleton.children(joint)) {
    if (useful[at(child)]) children.push_back(child);
  }
  return children;
}

void end_leaf(BvhLayout& layout, int parent, double extent) {
  const Vec3 bone = layout.nodes[at(parent)].parent < 0 ? Vec3::Zero() : layout.nodes[at(parent)].offset;
  BvhNode end{.parent = parent, .end_site = true};
  end.offset = bone.isZero() ? Vec3(0.0, 0.05 * extent, 0.0) : Vec3(0.5 * bone);
  layout.nodes.push_back(std::move(end));
  layout.joints.push_back(-1);
}

BvhLayout made_layout(const Skeleton& skeleton) {
  const std::vector<bool> useful = useful_joints(skeleton);
  int root = 0;
  for (std::vector<int> below = useful_children(skeleton, useful, root);
       skeleton.joint(root).helper && below.size() == 1; below = useful_children(skeleton, useful, root)) {
    root = below.front();
  }
  BvhLayout layout;
  UniqueNames names;
  std::vector<std::pair<int, int>> left{{root, -1}};  // joint and parent node, the next one last
  while (!left.empty()) {
    const auto [joint, parent] = left.back();
    left.pop_back();
    const std::vector<int> children = useful_children(skeleton, useful, joint);
    BvhNode node{.parent = parent};
    node.offset = skeleton.rest_position(joint);
    if (parent >= 0) node.offset -= skeleton.rest_position(layout.joints[at(parent)]);
    const int above = skeleton.parent(joint);
    node.end_site = parent >= 0 && children.empty() && skeleton.name(joint) == skeleton.name(above) + "_end" &&
                    useful_children(skeleton, useful, above).size() == 1;
    if (!node.end_site) {
      node.name = names.next(plain_name(skeleton.name(joint), joint), "_");
      node.channels = {5, 3, 4};
      if (parent < 0) node.channels.insert(node.channels.begin(), {0, 1, 2});
    }
    const int index = static_cast<int>(layout.nodes.size());
    const bool leaf = children.empty() && !node.end_site;
    layout.nodes.push_back(std::move(node));
    layout.joints.push_back(joint);
    if (leaf) end_leaf(layout, index, skeleton.extent());
    for (auto child = children.rbegin(); child != children.rend(); ++child) left.emplace_back(*child, index);
  }
  return layout;
}

}  // namespace

BvhLayout make_bvh_layout(const Character& character) {
  if (character.source && character.source->format == "bvh") {
    BvhLayout layout = source_layout(character);
    if (!layout.nodes.empty()) return layout;
  }
  return made_layout(character.skeleton);
}

int number_channels(BvhLayout& layout) {
  int count = 0;
  for (BvhNode& node : layout.nodes) {
    node.first_channel = count;
    count += static_cast<int>(node.channels.size());
  }
  return count;
}

std::string spell_bvh_channels(const BvhNode& node) {
  std::string text = "CHANNELS " + std::to_string(node.channels.size());
  for (const BvhChannel channel : node.channels) text += " " + std::string(kBvhChannelNames[at(channel)]);
  return text;
}

std::string spell_bvh_vector(const Vec3& vector) {
  return format_double(vector[0]) + " " + format_double(vector[1]) + " " + format_double(vector[2]);
}

std::string spell_bvh_hierarchy(const BvhLayout& layout) {
  constexpr std::size_t kDeepestIndent = 64;  // a chain of many thousand joints stays a file of reasonable size
  std::string text = "HIERARCHY";
  std::vector<int> open;
  const auto line = [&](std::size_t depth, const std::string& words) {
    text += layout.new_line + std::string(std::min(depth, kDeepestIndent), '\t') + words;
  };
  const auto close = [&] {
    open.pop_back();
    line(open.size(), "}");
  };
  for (int i = 0; i < std::ssize(layout.nodes); ++i) {
    const BvhNode& node = layout.nodes[at(i)];
    while (!open.empty() && open.back() != node.parent) close();
    line(open.size(), node.end_site ? "End Site" : (node.parent < 0 ? "ROOT " : "JOINT ") + node.name);
    line(open.size(), "{");
    open.push_back(i);
    line(open.size(), "OFFSET " + spell_bvh_vector(node.offset));
    if (!node.end_site) line(open.size(), spell_bvh_channels(node));
  }
  while (!open.empty()) close();
  return text;
}

}  // namespace croquis
