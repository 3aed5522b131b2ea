// SPDX-License-Identifier: MIT
#include "croquis/io/gltf_edit.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/io/file_name.h"
#include "croquis/io/gltf_accessor.h"
#include "croquis/io/uri.h"

namespace croquis {
namespace {

void pad_to_four(Bytes& bytes) { bytes.resize((bytes.size() + 3) / 4 * 4, std::byte{0}); }

void append_bytes(Bytes& to, std::span<const std::byte> bytes) { to.insert(to.end(), bytes.begin(), bytes.end()); }

/// Names may hold any bytes; what is no UTF-8 is replaced.
std::string to_text(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

Bytes to_bytes(const std::string& text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

std::string make_data_uri(std::span<const std::byte> bytes) {
  return "data:application/octet-stream;base64," + encode_base64(bytes);
}

/// A name that no file beside the document has yet.
std::string free_name(const std::string& stem, const std::map<std::string, Bytes>& taken) {
  std::string name = stem + ".bin";
  for (int i = 2; taken.count(name) > 0; ++i) name = stem + "_" + std::to_string(i) + ".bin";
  return name;
}

int width_of(std::string_view type) {
  return type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
}

/// The places of a buffer view that name a buffer: the view itself, and its compressed form.
std::vector<Json*> buffer_references(Json& view) {
  std::vector<Json*> references = {&view};
  if (!view.contains("extensions") || !view["extensions"].is_object()) return references;
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    Json& extensions = view["extensions"];
    if (extensions.contains(name) && extensions[name].is_object()) references.push_back(&extensions[name]);
  }
  return references;
}

/// Room for every member that glTF has at the top, so that adding one does not move the others: whoever builds an
/// element holds references into it while its accessors and views are appended.
void keep_in_place(Json& document) {
  Json::object_t& members = document.get_ref<Json::object_t&>();
  members.reserve(members.size() + 32);
}

}  // namespace

GltfEditor::GltfEditor() : json_(std::make_unique<Json>(Json::object())) {
  keep_in_place(*json_);
  (*json_)["asset"] = {{"version", "2.0"}, {"generator", "Croquis"}};
}

GltfEditor::GltfEditor(const GltfDocument& document)
    : json_(std::make_unique<Json>(*document.json)), document_(&document) {
  keep_in_place(*json_);
}

GltfEditor::~GltfEditor() = default;

int GltfEditor::append(const char* array, const Json& element) {
  Json& elements = (*json_)[array];
  if (elements.is_null()) elements = Json::array();
  elements.push_back(element);
  return static_cast<int>(elements.size()) - 1;
}

void GltfEditor::use_extension(std::string_view name) {
  Json& used = (*json_)["extensionsUsed"];
  if (used.is_null()) used = Json::array();
  if (std::find(used.begin(), used.end(), name) == used.end()) used.push_back(name);
}

int GltfEditor::add_view(std::span<const std::byte> bytes, ViewTarget target) {
  pad_to_four(added_);
  Json view = {{"buffer", 0}, {"byteOffset", added_.size()}, {"byteLength", bytes.size()}};
  if (target != ViewTarget::none) view["target"] = static_cast<int>(target);
  append_bytes(added_, bytes);
  added_views_.push_back(append("bufferViews", view));
  return added_views_.back();
}

int GltfEditor::add_accessor(Json accessor, std::span<const std::byte> bytes, ViewTarget target) {
  accessor["bufferView"] = add_view(bytes, target);
  return append("accessors", accessor);
}

int GltfEditor::add_floats(std::span<const float> numbers, std::string_view type, bool bounds, ViewTarget target) {
  const auto width = static_cast<std::size_t>(width_of(type));
  Json accessor = {
      {"componentType", static_cast<int>(ComponentType::float32)}, {"count", numbers.size() / width}, {"type", type}};
  if (bounds && !numbers.empty()) {
    std::vector<float> least(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(width)), most = least;
    for (std::size_t i = width; i < numbers.size(); ++i) {
      least[i % width] = std::min(least[i % width], numbers[i]);
      most[i % width] = std::max(most[i % width], numbers[i]);
    }
    accessor["min"] = std::vector<double>(least.begin(), least.end());
    accessor["max"] = std::vector<double>(most.begin(), most.end());
  }
  return add_accessor(std::move(accessor), std::as_bytes(numbers), target);
}

int GltfEditor::add_integers(std::span<const std::uint32_t> numbers, std::string_view type, std::uint32_t largest,
                             ViewTarget target) {
  // Indices of one byte are slow on GPUs, and the largest value of each type is kept free (primitive restart).
  const ComponentType component = largest < 255 && target != ViewTarget::indices ? ComponentType::uint8
                                  : largest < 65535                              ? ComponentType::uint16
                                                                                 : ComponentType::uint32;
  const auto size = static_cast<std::size_t>(byte_size(component));
  Bytes bytes(numbers.size() * size);
  for (std::size_t i = 0; i < numbers.size(); ++i) std::memcpy(bytes.data() + i * size, &numbers[i], size);
  Json accessor = {{"componentType", static_cast<int>(component)},
                   {"count", numbers.size() / static_cast<std::size_t>(width_of(type))},
                   {"type", type}};
  return add_accessor(std::move(accessor), bytes, target);
}

WrittenFile GltfEditor::finish(std::string_view format, std::string_view file_name) {
  return format == "gltf" ? finish_gltf(file_name) : finish_glb();
}

void GltfEditor::place_added(int buffer, std::size_t offset) {
  for (const int index : added_views_) {
    Json& view = (*json_)["bufferViews"][static_cast<std::size_t>(index)];
    view["buffer"] = buffer;
    view["byteOffset"] = view["byteOffset"].get<std::size_t>() + offset;
  }
}

void GltfEditor::keep_companions(WrittenFile& file) const {
  if (document_ != nullptr) file.companions = document_->source->resources;
}

/// Every image that is not in a buffer view yet is brought into one; what is not there stays named.
void GltfEditor::embed_images() {
  for (int i = 0; i < document_->count("images"); ++i) {
    Json& image = (*json_)["images"][static_cast<std::size_t>(i)];
    if (!image.is_object() || !image.contains("uri") || !image["uri"].is_string()) continue;
    const std::shared_ptr<const Bytes> bytes = read_image(*document_, i);
    if (bytes == nullptr || bytes->empty()) continue;
    std::string type(image_media_type(*bytes));
    if (type.empty() && image.contains("mimeType") && image["mimeType"].is_string()) type = image["mimeType"];
    if (type.empty()) continue;
    image.erase("uri");
    image["mimeType"] = type;
    image["bufferView"] = add_view(*bytes);
  }
}

/// All buffers brought into one, the binary chunk: it is buffer 0, and keeps what else stood in the file's buffer 0.
/// Later buffers that carry more than their bytes (extras, extensions) stay buffers of their own, and so do those whose
/// bytes are not there. Empty if there is nothing to bring together.
Bytes GltfEditor::merge_buffers() {
  struct Moved {
    int buffer = 0;
    std::size_t offset = 0;
  };
  const std::size_t count = document_->buffers.size();
  std::vector<bool> merges(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Json& buffer = (*json_)["buffers"][i];
    const bool is_plain = i == 0 || (!buffer.contains("extras") && !buffer.contains("extensions"));
    merges[i] = is_plain && document_->buffer_faults[i].empty();
  }
  const bool has_chunk = std::find(merges.begin(), merges.end(), true) != merges.end();
  Bytes merged;
  std::vector<Moved> moved;
  Json kept = has_chunk ? Json::array({Json::object()}) : Json::array();
  for (std::size_t i = 0; i < count; ++i) {
    Json buffer = (*json_)["buffers"][i];
    const bool has_data = document_->buffer_faults[i].empty();
    if (merges[i]) {
      pad_to_four(merged);
      moved.push_back({0, merged.size()});
      append_bytes(merged, document_->buffers[i]);
      buffer.erase("uri");
      if (i == 0) kept[0] = std::move(buffer);
    } else {
      if (has_data) buffer["uri"] = make_data_uri(document_->buffers[i]);
      moved.push_back({static_cast<int>(kept.size()), 0});
      kept.push_back(std::move(buffer));
    }
  }
  for (int i = 0; i < document_->count("bufferViews"); ++i) {
    for (Json* place : buffer_references((*json_)["bufferViews"][static_cast<std::size_t>(i)])) {
      const JsonPlace reference(place, "");
      if (!reference.is_object() || !reference["buffer"].exists()) continue;
      const Json& number = (*place)["buffer"];
      if (!number.is_number_integer() || number < 0 || number >= moved.size()) continue;
      const Moved to = moved[number.get<std::size_t>()];
      (*place)["buffer"] = to.buffer;
      if (to.offset > 0) (*place)["byteOffset"] = place->value("byteOffset", std::size_t{0}) + to.offset;
    }
  }
  (*json_)["buffers"] = std::move(kept);
  return merged;
}

WrittenFile GltfEditor::finish_glb() {
  WrittenFile file;
  Bytes binary;
  const bool was_gltf = document_ != nullptr && !document_->is_glb;
  const bool had_chunk = document_ != nullptr && document_->is_glb && document_->glb.has_binary &&
                         !document_->buffers.empty() && !(*json_)["buffers"][0].contains("uri");
  if (was_gltf) {
    embed_images();
    if (!document_->buffers.empty()) binary = merge_buffers();
  } else {
    keep_companions(file);
    if (had_chunk) binary.assign(document_->buffers[0].begin(), document_->buffers[0].end());
  }
  if (!added_.empty()) {
    Json& buffers = (*json_)["buffers"];
    if (buffers.is_null()) buffers = Json::array();
    if (buffers.empty()) buffers.push_back(Json::object());
    const bool foreign =
        document_ != nullptr && !document_->buffers.empty() && (was_gltf ? binary.empty() : !had_chunk);
    if (foreign) {  // the first buffer lies outside, or is not there: the chunk cannot come before it
      buffers.push_back({{"byteLength", added_.size()}, {"uri", make_data_uri(added_)}});
      place_added(static_cast<int>(buffers.size()) - 1, 0);
    } else {
      pad_to_four(binary);
      place_added(0, binary.size());
      append_bytes(binary, added_);
    }
  }
  if (!binary.empty()) (*json_)["buffers"][0]["byteLength"] = binary.size();
  const std::span<const GlbChunk> others =
      document_ != nullptr ? std::span<const GlbChunk>(document_->glb.others) : std::span<const GlbChunk>();
  file.bytes = make_glb(to_text(*json_, -1), binary, others);
  return file;
}

WrittenFile GltfEditor::finish_gltf(std::string_view file_name) {
  WrittenFile file;
  keep_companions(file);
  const bool has_chunk = document_ != nullptr && document_->is_glb && document_->glb.has_binary &&
                         !document_->buffers.empty() && !(*json_)["buffers"][0].contains("uri");
  const bool was_gltf = document_ != nullptr && !document_->is_glb;
  Bytes binary;
  if (has_chunk) binary.assign(document_->buffers[0].begin(), document_->buffers[0].end());
  if (has_chunk || !added_.empty()) {
    Json& buffers = (*json_)["buffers"];
    if (buffers.is_null()) buffers = Json::array();
    const std::size_t index = has_chunk ? 0 : buffers.size();
    if (!has_chunk) buffers.push_back(Json::object());
    if (!added_.empty()) pad_to_four(binary);
    place_added(static_cast<int>(index), binary.size());
    append_bytes(binary, added_);
    buffers[index]["byteLength"] = binary.size();
    if (was_gltf && document_->source->resources.empty()) {
      buffers[index]["uri"] = make_data_uri(binary);  // a file that was whole in itself stays so
    } else {
      const std::string name = free_name(file_stem(file_name), file.companions);
      buffers[index]["uri"] = encode_percent(name);
      file.companions[name] = std::move(binary);
    }
  }
  file.bytes = to_bytes(to_text(*json_, 2) + "\n");
  return file;
}

}  // namespace croquis
