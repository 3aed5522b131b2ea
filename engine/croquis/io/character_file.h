// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "croquis/project/project.h"

namespace croquis {

/// Gives the bytes of a file that another file refers to (an external buffer or image), by its URI as it stands there,
/// percent-decoded. Throws Error{io} if there is none. Readers never open files themselves.
using ResourceReader = std::function<Bytes(std::string_view uri)>;

/// The formats by extension: glb, gltf, vrm, vrma, bvh, obj, croquis. Lower-cased, without the dot.
[[nodiscard]] std::string file_format(std::string_view file_name);

/// Reads any character file: glTF, GLB, VRM 0.x and 1.0, BVH, OBJ, or a .croquis project (its first character). The
/// format is told by content first, by the name's extension second. Throws Error{bad_file} with the place, or
/// Error{unsupported} that names the feature (Draco, meshopt, ...). Sizes are checked before memory is asked for.
[[nodiscard]] Character read_character(std::span<const std::byte> bytes, std::string_view file_name,
                                       const ResourceReader& resources);

/// How a pose goes into a file.
enum class PoseForm {
  pose,   ///< into the joints' own transforms; clips stay
  clip,   ///< the joints stay as they were; a clip of one frame is added
  baked,  ///< the mesh itself is bent; skins go, joints stay at rest
};

/// A part as PoseForm::baked writes it: the vertices of the posed part in model space, in its order.
struct BakedPart {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;      ///< empty if the mesh has none
  std::vector<Vec4f> tangents;     ///< empty if the mesh has none
  std::vector<BlendShape> shapes;  ///< posed too; empty: the file's own stay as they are
};

struct WriteOptions {
  PoseForm form = PoseForm::pose;
  bool add_positions = false;  ///< BVH: give position channels to joints whose bones were stretched
  /// For PoseForm::baked, one per part (this room does no skinning: skinning/ gives them). Shapes are baked in at their
  /// present weights, which become 0.
  std::vector<BakedPart> baked;
};

/// A written file, and the files beside it that it refers to (a .gltf's buffers and images), by URI.
struct WrittenFile {
  Bytes bytes;
  std::map<std::string, Bytes> companions;
};

/// The character in `pose` as `format` ("glb", "gltf", "vrm", "vrma", "bvh"). A file that was read keeps all that was
/// not changed: JSON members, node indices and names, buffers; what is new is appended. Another container embeds (glb)
/// or splits off (gltf) buffers and images. Clips beyond those of the source are added. "vrma" holds the pose, or the
/// clips if the pose is the start. `file_name` names companions. Throws Error{unsupported} for what the format cannot
/// hold.
[[nodiscard]] WrittenFile write_character(const Character& character, const Pose& pose, std::string_view format,
                                          std::string_view file_name, const WriteOptions& options = {});

/// The project file: a GLB that any viewer opens, with the extension CROQUIS_project.
[[nodiscard]] Bytes write_project(const Project& project);
[[nodiscard]] Project read_project(std::span<const std::byte> bytes, std::string_view file_name);

}  // namespace croquis
