// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/io/gltf_document.h"

namespace croquis {

/// What a buffer view is for (glTF's bufferView.target).
enum class ViewTarget { none = 0, vertices = 34962, indices = 34963 };

/// A glTF document being changed or made: its JSON, and data that are only ever appended. What was read keeps its
/// indices, its buffers and its bytes.
class GltfEditor {
 public:
  /// A new document, empty but for its `asset`.
  GltfEditor();
  /// A document that was read; it must outlive the editor.
  explicit GltfEditor(const GltfDocument& document);
  ~GltfEditor();

  [[nodiscard]] Json& json() { return *json_; }
  /// Appends to a root array ("nodes", ...), which is made if it is not there; the index of the new element.
  int append(const char* array, const Json& element);
  /// Notes an extension in extensionsUsed, once.
  void use_extension(std::string_view name);

  /// A buffer view of these bytes, 4-byte aligned.
  int add_view(std::span<const std::byte> bytes, ViewTarget target = ViewTarget::none);
  /// An accessor over data of its own. `width` numbers make an element of `type` ("SCALAR", "VEC3", "MAT4"). `bounds`
  /// says whether min and max are written, as positions and key times want them.
  int add_floats(std::span<const float> numbers, std::string_view type, bool bounds = false,
                 ViewTarget target = ViewTarget::none);
  int add_integers(std::span<const std::uint32_t> numbers, std::string_view type, std::uint32_t largest,
                   ViewTarget target);

  /// The file as "glb" ("vrm" and "vrma" are that too) or "gltf". The container that was read stays as it was, files
  /// beside it included; any other embeds (glb) or splits off (gltf) what it must.
  [[nodiscard]] WrittenFile finish(std::string_view format, std::string_view file_name);

 private:
  int add_accessor(Json accessor, std::span<const std::byte> bytes, ViewTarget target);
  void embed_images();
  [[nodiscard]] Bytes merge_buffers();
  void place_added(int buffer, std::size_t offset);
  void keep_companions(WrittenFile& file) const;
  [[nodiscard]] WrittenFile finish_glb();
  [[nodiscard]] WrittenFile finish_gltf(std::string_view file_name);

  std::unique_ptr<Json> json_;
  const GltfDocument* document_ = nullptr;
  Bytes added_;
  std::vector<int> added_views_;
};

}  // namespace croquis
