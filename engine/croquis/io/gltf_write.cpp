// SPDX-License-Identifier: MIT
#include "croquis/io/gltf_write.h"

#include <algorithm>
#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/gltf_bake.h"
#include "croquis/io/gltf_clip_write.h"
#include "croquis/io/gltf_edit.h"
#include "croquis/io/gltf_mesh.h"
#include "croquis/io/vrm_write.h"

namespace croquis {
namespace {

Json numbers(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Json numbers(const Quat& q) { return {q.x(), q.y(), q.z(), q.w()}; }

/// A matrix node brought into the form that animations and poses want.
void split_matrix(Json& node, const Transform& local) {
  if (!node.contains("matrix")) return;
  node.erase("matrix");
  node["translation"] = numbers(local.translation);
  node["rotation"] = numbers(local.rotation);
  node["scale"] = numbers(local.scale);
}

void set_node(Json& node, const Transform& from, const Transform& to) {
  if (!is_changed(from, to)) return;
  split_matrix(node, from);
  if (is_moved(from.translation, to.translation)) node["translation"] = numbers(to.translation);
  if (is_turned(from.rotation, to.rotation)) node["rotation"] = numbers(to.rotation.normalized());
  if (is_moved(from.scale, to.scale)) node["scale"] = numbers(to.scale);
}

class SourceWriter {
 public:
  SourceWriter(const Character& character, const GltfDocument& document)
      : character_(character), document_(document), nodes_(read_nodes(document)), editor_(document) {
    for (const int node : character.source_nodes) {
      if (node >= nodes_.size())
        throw_invalid_argument("write_character: the character's source has no node " + std::to_string(node));
    }
  }

  GltfEditor& editor() { return editor_; }

  void set_pose(const Pose& pose) {
    for (std::size_t joint = 0; joint < character_.source_nodes.size(); ++joint) {
      const int node = character_.source_nodes[joint];
      if (node < 0) {
        set_root(pose.local[joint]);
      } else {
        set_node(node_json(node), nodes_[node].local, pose.local[joint]);
      }
    }
  }

  /// Clips that the source does not have, and the pose as one more, if given.
  void add_clips(const Pose* pose) {
    std::vector<int> node_of_part;
    for (const PartPlace& part : list_parts(document_, nodes_)) node_of_part.push_back(part.node);
    std::vector<Clip> clips(character_.clips.begin() +
                                std::min<std::ptrdiff_t>(document_.count("animations"), std::ssize(character_.clips)),
                            character_.clips.end());
    if (pose != nullptr) {
      Pose rest = *pose;
      for (std::size_t joint = 0; joint < rest.local.size(); ++joint) {
        const int node = character_.source_nodes[joint];
        rest.local[joint] = node < 0 ? Transform() : nodes_[node].local;
      }
      clips.push_back(make_pose_clip(character_.skeleton, rest, *pose, free_clip_name(character_.clips)));
    }
    std::vector<int> targets = character_.source_nodes;
    for (const Clip& clip : clips) {
      for (const Curve& curve : clip.curves) {
        if (curve.target == CurveTarget::weights) continue;
        int& node = targets[static_cast<std::size_t>(curve.joint)];
        if (node < 0)
          node = make_root({});
        else if (node < nodes_.size())
          split_matrix(node_json(node), nodes_[node].local);
      }
    }
    ClipWriter writer(editor_, targets, node_of_part);
    for (const Clip& clip : clips) writer.add(clip);
  }

  void bake(const std::vector<BakedPart>& baked) { bake_parts(editor_, document_, nodes_, character_, baked); }

  WrittenFile finish(std::string_view format, std::string_view file_name) {
    if (format == "vrm") add_vrm_extension(editor_, character_, character_.source_nodes);
    return editor_.finish(format, file_name);
  }

 private:
  Json& node_json(int node) { return editor_.json()["nodes"][static_cast<std::size_t>(node)]; }

  void set_root(const Transform& root) {
    if (is_changed(Transform(), root)) make_root(root);
  }

  /// A node above all roots of the scene, for the joint that stands above them.
  int make_root(const Transform& root) {
    Json node = {{"name", "scene"}};
    if (!nodes_.scene_roots.empty()) node["children"] = nodes_.scene_roots;
    set_node(node, {}, root);
    const int index = editor_.append("nodes", node);
    if (nodes_.scene >= 0) {
      editor_.json()["scenes"][static_cast<std::size_t>(nodes_.scene)]["nodes"] = Json::array({index});
    }
    return index;
  }

  const Character& character_;
  const GltfDocument& document_;
  GltfNodes nodes_;
  GltfEditor editor_;
};

}  // namespace

WrittenFile write_gltf_source(const Character& character, const Pose& pose, std::string_view format,
                              std::string_view file_name, const WriteOptions& options) {
  const GltfDocument document = open_gltf(character.source);
  try {
    SourceWriter writer(character, document);
    if (options.form == PoseForm::pose) writer.set_pose(pose);
    if (options.form == PoseForm::baked) writer.bake(options.baked);
    writer.add_clips(options.form == PoseForm::clip ? &pose : nullptr);
    return writer.finish(format, file_name);
  } catch (const Json::exception&) {
    // What nothing had to read may be of any type until it has to be written.
    throw_bad_file("/", "a member that has to be written anew is not of the type that glTF gives it");
  }
}

}  // namespace croquis
