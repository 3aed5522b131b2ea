// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/anim/clip.h"
#include "croquis/mesh/mesh.h"
#include "croquis/mesh/skin.h"
#include "croquis/rig/humanoid.h"
#include "croquis/rig/pose.h"
#include "croquis/rig/skeleton.h"

namespace croquis {

using Bytes = std::vector<std::byte>;

/// The file that a character was read from, whole: writing it again changes only what was changed.
struct SourceFile {
  std::string format;                      ///< "glb", "gltf", "vrm", "bvh", "obj"
  std::string name;                        ///< as the reader was told it, for messages
  Bytes bytes;                             ///< of the file itself
  std::map<std::string, Bytes> resources;  ///< uri -> bytes of every file it refers to
};

/// What a picture needs to know of a material; the file's own material stays in the SourceFile.
struct Material {
  Vec4f base_color = Vec4f(0.8F, 0.8F, 0.8F, 1.0F);         ///< linear RGB and alpha
  std::shared_ptr<const Bytes> base_color_image = nullptr;  ///< an encoded PNG or JPEG; multiplies base_color
  bool double_sided = false;
  bool cut_out = false;  ///< texels of alpha below 0.5 are not drawn
};

/// One mesh of a character, either skinned or hung rigidly on a joint.
struct Part {
  std::string name;
  Mesh mesh;
  std::vector<BlendShape> shapes;
  std::vector<float> shape_weights;  ///< one per shape
  std::optional<Skin> skin;
  int joint = 0;                                ///< without a skin: the joint that carries the mesh ...
  Affine joint_from_mesh = Affine::Identity();  ///< ... and where on it
  Material material;
};

/// Who may do what with a character, in the words of its file (VRM meta); shown, never judged.
struct Licence {
  std::string title;
  std::string authors;
  std::string name;                          ///< licence name or URL
  std::map<std::string, std::string> terms;  ///< every other field of the file's meta that is text, number or bool
};

/// A character: a skeleton, the meshes on it, its clips, and the file it came from. Immutable once shared: hold it as
/// std::shared_ptr<const Character>.
struct Character {
  std::string name;
  Skeleton skeleton;
  Pose start;                  ///< how it stands when opened (a file's own pose; else rest)
  HumanoidMap humanoid;        ///< from the file (VRM), else recognised
  Vec3 front = Vec3::UnitZ();  ///< the horizontal direction it faces at rest, unit, model space
  std::vector<Part> parts;
  std::vector<Clip> clips;
  std::optional<Licence> licence;
  std::vector<std::string> oddities;  ///< what is odd about the file, one sentence each
  std::shared_ptr<const SourceFile> source;
  std::vector<int> source_nodes;  ///< joint -> node of a glTF source, or -1; empty for other sources

  /// Throws invalid_argument unless every part, skin, curve and pose fits the skeleton.
  void check() const;
};

/// The box around the joints of a pose that are not helpers, and around the vertices of the posed parts. `positions`
/// are given per part by the caller who has skinned them, or empty: then the joints alone count.
[[nodiscard]] Box bounding_box(const Character& character, const Pose& pose,
                               const std::vector<std::vector<Vec3f>>& positions = {});

}  // namespace croquis
