// SPDX-License-Identifier: MIT
#include "croquis/io/character_file.h"

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/bvh.h"
#include "croquis/io/file_name.h"
#include "croquis/io/glb_container.h"
#include "croquis/io/gltf_read.h"
#include "croquis/io/obj.h"

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

}  // namespace croquis
