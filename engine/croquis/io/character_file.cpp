// SPDX-License-Identifier: MIT
#include "croquis/io/character_file.h"

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/bvh.h"
#include "croquis/io/file_name.h"
#include "croquis/io/glb_container.h"
#include "croquis/io/gltf_read.h"
#include "croquis/io/gltf_write.h"
#include "croquis/io/obj.h"
#include "croquis/io/project_file.h"
#include "croquis/io/vrm_write.h"

namespace croquis {
namespace {

/// The first characters that are no space or byte order mark.
std::string_view first_word(std::span<const std::byte> bytes) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), std::min<std::size_t>(bytes.size(), 4096));
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  return trim(text);
}

}  // namespace

Character read_character(std::span<const std::byte> bytes, std::string_view file_name,
                         const ResourceReader& resources) {
  if (bytes.empty()) throw_bad_file("byte 0", "the file is empty");
  const std::string_view word = first_word(bytes);
  if (is_project(bytes)) return read_first_actor(bytes, file_name);
  if (is_glb(bytes) || word.starts_with('{')) return read_gltf(bytes, file_name, resources);
  if (to_lower(word.substr(0, 9)) == "hierarchy") return read_bvh(bytes, file_name);
  const std::string format = file_format(file_name);
  if (format == "bvh") return read_bvh(bytes, file_name);
  if (format == "obj") return read_obj(bytes, file_name);
  if (format == "glb" || format == "gltf" || format == "vrm" || format == "vrma" || format == "croquis") {
    return read_gltf(bytes, file_name, resources);
  }
  if (format == "fbx" || word.starts_with("Kaydara FBX")) {
    throw Error(ErrorCode::unsupported, "FBX is not read: convert it to GLB, with Blender for instance");
  }
  throw Error(ErrorCode::unsupported,
              "'" + printable(file_name) +
                  "' is of no kind that is read: wanted .glb, .gltf, .vrm, .vrma, .bvh, .obj or .croquis");
}

WrittenFile write_character(const Character& character, const Pose& pose, std::string_view format,
                            std::string_view file_name, const WriteOptions& options) {
  if (std::ssize(pose.local) != character.skeleton.joint_count()) {
    throw_invalid_argument("write_character: the pose has " + std::to_string(pose.local.size()) +
                           " joints, the skeleton " + std::to_string(character.skeleton.joint_count()));
  }
  for (const Transform& local : pose.local) {
    if (!local.is_finite()) throw_invalid_argument("write_character: the pose holds a number that is not finite");
  }
  const std::string source = character.source != nullptr ? character.source->format : std::string();
  const bool from_gltf = source == "glb" || source == "gltf" || source == "vrm" || source == "vrma";
  if (format == "bvh") return {write_bvh(character, pose, options), {}};
  if (format == "vrma" && source != "vrma") return write_vrma(character, pose);
  if (format == "glb" || format == "gltf" || format == "vrm" || format == "vrma") {
    return from_gltf ? write_gltf_source(character, pose, format, file_name, options)
                     : write_new_gltf(character, pose, format, file_name, options);
  }
  throw Error(ErrorCode::unsupported,
              "'" + printable(format) + "' is no format that is written: wanted glb, gltf, vrm, vrma or bvh");
}

}  // namespace croquis
