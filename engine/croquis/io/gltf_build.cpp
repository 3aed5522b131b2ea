// SPDX-License-Identifier: MIT
// Source: gltf2, sections 3.5 to 3.9.
#include "croquis/io/gltf_build.h"

#include <algorithm>
#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/io/gltf_bake.h"
#include "croquis/io/gltf_build_material.h"
#include "croquis/io/gltf_build_skin.h"
#include "croquis/io/gltf_clip_write.h"
#include "croquis/io/gltf_vertices.h"
#include "croquis/io/gltf_write.h"
#include "croquis/io/vrm_write.h"

namespace croquis {
namespace {

Json make_node(const std::string& name, const Transform& local) {
  Json node = Json::object();
  if (!name.empty()) node["name"] = name;
  const Vec3 &t = local.translation, &s = local.scale;
  const Quat q = local.rotation.normalized();
  if (is_moved(Vec3::Zero(), t)) node["translation"] = {t.x(), t.y(), t.z()};
  if (is_turned(Quat::Identity(), q)) node["rotation"] = {q.x(), q.y(), q.z(), q.w()};
  if (is_moved(Vec3::Ones(), s)) node["scale"] = {s.x(), s.y(), s.z()};
  return node;
}

/// A node for an affine map, as a matrix where translation, rotation and scale cannot hold it.
Json make_node(const std::string& name, const Affine& affine) {
  double shear = 0.0;
  const Transform local = decompose(affine, &shear);
  Json node = make_node(name, shear < 1e-9 ? local : Transform());
  if (shear >= 1e-9) node["matrix"] = std::vector<double>(affine.matrix().data(), affine.matrix().data() + 16);
  return node;
}

class Builder {
 public:
  Builder(GltfEditor& editor, const Character& character)
      : editor_(editor), character_(character), materials_(editor), skins_(editor, character) {}

  BuiltCharacter build(const Pose& pose, const std::vector<BakedPart>* baked) {
    for (int i = 0; i < character_.skeleton.joint_count(); ++i) {
      built_.node_of_joint.push_back(
          editor_.append("nodes", make_node(character_.skeleton.name(i), pose.local[static_cast<std::size_t>(i)])));
      const int parent = character_.skeleton.parent(i);
      if (parent >= 0) add_child(parent, built_.node_of_joint.back());
    }
    built_.scene_roots.push_back(built_.node_of_joint[0]);
    for (std::size_t i = 0; i < character_.parts.size(); ++i) {
      add_part(character_.parts[i], baked != nullptr ? &(*baked)[i] : nullptr);
    }
    if (!skins_.any()) skins_.add_bones(built_.node_of_joint);
    return std::move(built_);
  }

 private:
  void add_child(int joint, int node) {
    Json& parent =
        editor_.json()["nodes"][static_cast<std::size_t>(built_.node_of_joint[static_cast<std::size_t>(joint)])];
    if (!parent.contains("children")) parent["children"] = Json::array();
    parent["children"].push_back(node);
  }

  void add_part(const Part& part, const BakedPart* baked) {
    if (part.mesh.triangles.empty()) {
      built_.node_of_part.push_back(-1);
      return;
    }
    const int mesh = add_mesh(part, baked);
    const bool rigid = !part.skin && baked == nullptr;
    Json node = rigid ? make_node(part.name, part.joint_from_mesh) : make_node(part.name, Transform());
    node["mesh"] = mesh;
    if (part.skin && baked == nullptr) node["skin"] = skins_.add(*part.skin, built_.node_of_joint);
    const int index = editor_.append("nodes", node);
    built_.node_of_part.push_back(index);
    if (rigid)
      add_child(part.joint, index);
    else
      built_.scene_roots.push_back(index);
  }

  int add_mesh(const Part& part, const BakedPart* baked) {
    const VertexSpace same(Affine::Identity());
    const auto& normals = baked != nullptr ? baked->normals : part.mesh.normals;
    const auto& tangents = baked != nullptr ? baked->tangents : part.mesh.tangents;
    Json attributes = Json::object();
    attributes["POSITION"] = add_vectors(editor_, baked != nullptr ? baked->positions : part.mesh.positions, true);
    if (!normals.empty()) attributes["NORMAL"] = add_vectors(editor_, same.normals(normals), false);
    if (!normals.empty() && !tangents.empty())
      attributes["TANGENT"] = add_vectors(editor_, same.tangents(tangents), false);
    if (!part.mesh.uvs.empty()) attributes["TEXCOORD_0"] = add_vectors(editor_, part.mesh.uvs, false);
    if (part.skin && baked == nullptr) add_skin_attributes(editor_, *part.skin, attributes);

    Json primitive = Json::object();
    primitive["attributes"] = std::move(attributes);
    primitive["indices"] = editor_.add_integers(
        part.mesh.triangles, "SCALAR", static_cast<std::uint32_t>(part.mesh.positions.size()), ViewTarget::indices);
    primitive["material"] = materials_.add(part.material);
    Json mesh = Json::object();
    if (!part.name.empty()) mesh["name"] = part.name;
    add_shapes(part, baked, mesh, primitive);
    mesh["primitives"] = Json::array({std::move(primitive)});
    return editor_.append("meshes", mesh);
  }

  void add_shapes(const Part& part, const BakedPart* baked, Json& mesh, Json& primitive) {
    if (part.shapes.empty()) return;
    Json targets = Json::array(), names = Json::array(), weights = Json::array();
    const std::vector<Vec3f> zeros(part.mesh.positions.size(), Vec3f::Zero());
    const bool posed = baked != nullptr && !baked->shapes.empty();
    for (std::size_t i = 0; i < part.shapes.size(); ++i) {
      const BlendShape& shape = posed ? baked->shapes[i] : part.shapes[i];
      Json target = Json::object();
      target["POSITION"] = add_vectors(editor_, shape.positions.empty() ? zeros : shape.positions, true);
      if (!shape.normals.empty() && !part.mesh.normals.empty())
        target["NORMAL"] = add_vectors(editor_, shape.normals, false);
      targets.push_back(std::move(target));
      names.push_back(part.shapes[i].name);
      weights.push_back(baked != nullptr ? 0.0F : part.shape_weights[i]);
    }
    primitive["targets"] = std::move(targets);
    mesh["weights"] = std::move(weights);
    mesh["extras"] = Json::object({{"targetNames", std::move(names)}});
  }

  GltfEditor& editor_;
  const Character& character_;
  MaterialBuilder materials_;
  SkinBuilder skins_;
  BuiltCharacter built_;
};

}  // namespace

BuiltCharacter build_character(GltfEditor& editor, const Character& character, const Pose& pose,
                               const std::vector<BakedPart>* baked) {
  if (baked != nullptr) check_baked(character, *baked);
  return Builder(editor, character).build(pose, baked);
}

WrittenFile write_new_gltf(const Character& character, const Pose& pose, std::string_view format,
                           std::string_view file_name, const WriteOptions& options) {
  GltfEditor editor;
  const bool in_joints = options.form == PoseForm::pose;
  const BuiltCharacter built = build_character(editor, character, in_joints ? pose : character.start,
                                               options.form == PoseForm::baked ? &options.baked : nullptr);
  editor.json()["scenes"] = Json::array({Json::object({{"nodes", built.scene_roots}})});
  editor.json()["scene"] = 0;
  if (character.licence && !character.licence->name.empty()) {
    editor.json()["asset"]["copyright"] = character.licence->name;
  }
  ClipWriter clips(editor, built.node_of_joint, built.node_of_part);
  for (const Clip& clip : character.clips) clips.add(clip);
  if (options.form == PoseForm::clip) {
    clips.add(make_pose_clip(character.skeleton, character.start, pose, free_clip_name(character.clips)));
  }
  if (format == "vrm") add_vrm_extension(editor, character, built.node_of_joint);
  return editor.finish(format, file_name);
}

}  // namespace croquis
