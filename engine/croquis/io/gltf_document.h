// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/io/character_file.h"
#include "croquis/io/glb_container.h"
#include "croquis/io/json_place.h"

namespace croquis {

/// How much memory a reader may still ask for: a file of a few bytes cannot ask for gigabytes.
class MemoryBudget {
 public:
  explicit MemoryBudget(std::uint64_t bytes) : left_(bytes) {}
  /// Throws bad_file at `place` if `count` times `size` bytes are more than is left.
  void take(std::uint64_t count, std::uint64_t size, const JsonPlace& place);

 private:
  std::uint64_t left_;
};

/// A glTF 2.0 file opened: its JSON, its source, and the bytes of its buffers. Movable, not copyable; everything in it
/// lives as long as it does.
struct GltfDocument {
  std::shared_ptr<const SourceFile> source;
  std::shared_ptr<const Json> json;
  GlbContainer glb;  ///< of a GLB: views into the source's bytes
  bool is_glb = false;
  std::vector<std::span<const std::byte>> buffers;     ///< empty where a buffer has no data (see buffer_fault)
  std::vector<std::string> buffer_faults;              ///< why a buffer has none; empty where it has
  std::vector<std::shared_ptr<const Bytes>> embedded;  ///< decoded data URIs, which `buffers` point into
  std::vector<std::string> oddities;                   ///< met while opening
  mutable MemoryBudget budget{0};

  [[nodiscard]] JsonPlace root() const { return {json.get(), ""}; }
  [[nodiscard]] JsonPlace element(std::string_view array, int index) const { return root()[array][index]; }
  [[nodiscard]] int count(std::string_view array) const { return root()[array].size(); }
  /// The bytes of a buffer view. Throws bad_file if it does not lie in its buffer, unsupported if it is compressed and
  /// has no fallback.
  [[nodiscard]] std::span<const std::byte> buffer_view(int index) const;
};

/// Opens a .gltf, .glb, .vrm or .vrma and fetches all that it refers to. Throws bad_file or unsupported; an image that
/// is not there is only an oddity.
[[nodiscard]] GltfDocument open_gltf(std::span<const std::byte> bytes, std::string_view file_name,
                                     const ResourceReader& resources);
/// The same from a source that was read before.
[[nodiscard]] GltfDocument open_gltf(const std::shared_ptr<const SourceFile>& source);

/// The encoded bytes of an image: from its buffer view, data URI or file. Null if they are not there.
[[nodiscard]] std::shared_ptr<const Bytes> read_image(const GltfDocument& document, int image);

/// "image/png", "image/jpeg", "image/webp", "image/ktx2" by the first bytes; empty for anything else.
[[nodiscard]] std::string_view image_media_type(std::span<const std::byte> image);

}  // namespace croquis
