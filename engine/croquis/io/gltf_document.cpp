// SPDX-License-Identifier: MIT
// Source: gltf2 (the glTF 2.0 specification), sections 3.2 to 3.6 and 4.
#include "croquis/io/gltf_document.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/uri.h"

namespace croquis {
namespace {

void check_asset(const JsonPlace& root) {
  if (!root.is_object()) throw_bad_file("/", "a glTF is a JSON object");
  const JsonPlace asset = root["asset"];
  if (!asset.exists()) asset.fail("is missing: this is no glTF 2.0");
  const JsonPlace version_place = asset["version"];
  const std::string version = version_place.text();
  const JsonPlace least = asset["minVersion"];
  const std::string needed = least.exists() ? least.text() : version;
  const auto is_version = [](const std::string& text) {
    const std::vector<std::string> parts = split(text, '.');
    return parts.size() == 2 && parse_int(parts[0]).value_or(-1) >= 0 && parse_int(parts[1]).value_or(-1) >= 0;
  };
  if (!is_version(version)) version_place.fail("wanted a version such as \"2.0\"");
  if (!is_version(needed)) least.fail("wanted a version such as \"2.0\"");
  if (split(version, '.')[0] != "2" || split(needed, '.')[0] != "2" || (least.exists() && needed != "2.0")) {
    throw Error(ErrorCode::unsupported,
                "/asset/version: glTF " + printable(least.exists() ? needed : version) + " is not read, only 2.0");
  }
}

/// Geometry that only these can decode.
bool is_geometry_compression(std::string_view extension) {
  return extension == "KHR_draco_mesh_compression" || extension == "EXT_meshopt_compression" ||
         extension == "KHR_meshopt_compression";
}

/// What Croquis knows, or need not know as it is kept as it is and changes no shape.
bool is_known_extension(std::string_view extension) {
  for (const std::string_view prefix : {"KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_", "VRMC_"}) {
    if (extension.starts_with(prefix)) return true;
  }
  return extension == "VRM" || extension == "KHR_mesh_quantization" || extension == "KHR_lights_punctual" ||
         extension == "KHR_xmp_json_ld" || extension == "CROQUIS_project" || is_geometry_compression(extension);
}

void check_extensions(const JsonPlace& root, std::vector<std::string>& oddities) {
  const JsonPlace required = root["extensionsRequired"];
  std::vector<std::string> unknown;
  for (int i = 0; i < required.size(); ++i) {
    const std::string name = required[i].text();
    // Where meshopt is required a fallback may stand in the file all the same: told when its data are asked for.
    if (name == "KHR_draco_mesh_compression") {
      throw Error(ErrorCode::unsupported,
                  required[i].pointer() + ": " + name + " is not read: export the file without mesh compression");
    }
    if (!is_known_extension(name)) unknown.push_back(printable(name));
  }
  if (!unknown.empty()) {
    oddities.push_back("The file requires the extension " + join(unknown, ", ") +
                       ", which Croquis does not know: it is kept, but what is shown may lack something.");
  }
  const JsonPlace used = root["extensionsUsed"];
  std::vector<std::string> kept;
  for (int i = 0; i < used.size(); ++i) {
    const std::string name = used[i].text();
    if (!is_known_extension(name) && std::find(unknown.begin(), unknown.end(), printable(name)) == unknown.end()) {
      kept.push_back(printable(name));
    }
  }
  if (!kept.empty())
    oddities.push_back("The file uses the extension " + join(kept, ", ") + ", which is kept as it is.");
}

/// Fetches a file that the document refers to, once.
void fetch(const JsonPlace& place, const std::string& uri, const ResourceReader& resources, SourceFile& source) {
  if (has_uri_scheme(uri)) place.fail("'" + printable(uri) + "' is no file beside this one");
  const std::string name = decode_percent(uri);
  if (source.resources.count(name) > 0) return;
  if (!resources) place.fail("the file '" + printable(name) + "' is needed too");
  source.resources[name] = resources(name);
}

void fetch_resources(const JsonPlace& root, const ResourceReader& resources, SourceFile& source,
                     std::vector<std::string>& oddities) {
  const JsonPlace buffers = root["buffers"];
  for (int i = 0; i < buffers.size(); ++i) {
    const JsonPlace uri = buffers[i]["uri"];
    if (!uri.exists() || parse_data_uri(uri.text())) continue;
    try {
      fetch(uri, uri.text(), resources, source);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::bad_file) throw;
      uri.fail(error.what());
    }
  }
  const JsonPlace images = root["images"];
  for (int i = 0; i < images.size(); ++i) {
    const JsonPlace uri = images[i]["uri"];
    if (!uri.exists() || parse_data_uri(uri.text())) continue;
    try {
      fetch(uri, uri.text(), resources, source);
    } catch (const Error&) {
      oddities.push_back("The image '" + printable(uri.text()) + "' is not there.");
    }
  }
}

void open_buffer(GltfDocument& document, int index) {
  const JsonPlace buffer = document.element("buffers", index);
  const auto length = static_cast<std::size_t>(buffer["byteLength"].integer(1, std::int64_t{1} << 32));
  const JsonPlace uri_place = buffer["uri"];
  std::span<const std::byte> bytes;
  std::string fault;
  if (uri_place.exists()) {
    const std::string uri = uri_place.text();
    if (const auto data = parse_data_uri(uri)) {
      auto decoded = decode_data_uri(*data);
      if (!decoded) uri_place.fail("broken base64");
      document.embedded.push_back(std::make_shared<const Bytes>(std::move(*decoded)));
      bytes = *document.embedded.back();
    } else {
      bytes = document.source->resources.at(decode_percent(uri));
    }
  } else if (document.is_glb && index == 0 && document.glb.has_binary) {
    bytes = document.glb.binary;
  } else {
    fault = "buffer " + std::to_string(index) + " has no data";
  }
  if (fault.empty() && bytes.size() < length) {
    buffer["byteLength"].fail("wanted " + std::to_string(length) + " bytes, there are " + std::to_string(bytes.size()));
  }
  document.buffers.push_back(fault.empty() ? bytes.first(length) : bytes);
  document.buffer_faults.push_back(fault);
}

GltfDocument open_source(const std::shared_ptr<SourceFile>& source, const ResourceReader& resources) {
  GltfDocument document;
  document.source = source;
  document.is_glb = is_glb(source->bytes);
  std::string_view text(reinterpret_cast<const char*>(source->bytes.data()), source->bytes.size());
  if (document.is_glb) {
    document.glb = parse_glb(source->bytes);
    text = document.glb.json;
  }
  document.json = parse_json(text);
  check_asset(document.root());
  check_extensions(document.root(), document.oddities);
  fetch_resources(document.root(), resources, *source, document.oddities);

  std::uint64_t size = source->bytes.size();
  for (const auto& [uri, bytes] : source->resources) size += bytes.size();
  document.budget = MemoryBudget((std::uint64_t{256} << 20U) + 64 * size);
  const int buffers = document.count("buffers");
  for (int i = 0; i < buffers; ++i) open_buffer(document, i);
  return document;
}

}  // namespace

void MemoryBudget::take(std::uint64_t count, std::uint64_t size, const JsonPlace& place) {
  if (size > 0 && count > left_ / size) place.fail("asks for far more data than the file has");
  left_ -= count * size;
}

std::span<const std::byte> GltfDocument::buffer_view(int index) const {
  const JsonPlace view = element("bufferViews", index);
  const int buffer = view["buffer"].index(static_cast<int>(buffers.size()), "buffer");
  if (const std::string& fault = buffer_faults[static_cast<std::size_t>(buffer)]; !fault.empty()) {
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
      if (view["extensions"][name].exists()) {
        throw Error(ErrorCode::unsupported,
                    view.pointer() + ": " + name + " is not read: export the file without mesh compression");
      }
    }
    view["buffer"].fail(fault);
  }
  const auto bytes = buffers[static_cast<std::size_t>(buffer)];
  const auto size = static_cast<std::int64_t>(bytes.size());
  const std::int64_t offset = view["byteOffset"].integer_or(0, 0, std::int64_t{1} << 40);
  const std::int64_t length = view["byteLength"].integer(1, std::int64_t{1} << 40);
  if (offset > size || length > size - offset) {
    view.fail("wanted bytes " + std::to_string(offset) + " to " + std::to_string(offset + length) + " of buffer " +
              std::to_string(buffer) + ", which has " + std::to_string(size));
  }
  return bytes.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
}

GltfDocument open_gltf(std::span<const std::byte> bytes, std::string_view file_name, const ResourceReader& resources) {
  auto source = std::make_shared<SourceFile>();
  const std::string format = file_format(file_name);
  source->format = format == "vrm" || format == "vrma" ? format : is_glb(bytes) ? "glb" : "gltf";
  source->name = file_name;
  source->bytes.assign(bytes.begin(), bytes.end());
  return open_source(source, resources);
}

GltfDocument open_gltf(const std::shared_ptr<const SourceFile>& source) {
  const auto copy = std::make_shared<SourceFile>(*source);
  return open_source(
      copy, [](std::string_view uri) -> Bytes { throw Error(ErrorCode::io, "'" + printable(uri) + "' is not there"); });
}

std::shared_ptr<const Bytes> read_image(const GltfDocument& document, int image) {
  const JsonPlace place = document.element("images", image);
  const int view = place["bufferView"].index_or_none(document.count("bufferViews"), "buffer view");
  if (view >= 0) {
    const auto bytes = document.buffer_view(view);
    document.budget.take(bytes.size(), 1, place);
    return std::make_shared<const Bytes>(bytes.begin(), bytes.end());
  }
  const std::string uri = place["uri"].text();
  if (const auto data = parse_data_uri(uri)) {
    auto decoded = decode_data_uri(*data);
    return decoded ? std::make_shared<const Bytes>(std::move(*decoded)) : nullptr;
  }
  const auto found = document.source->resources.find(decode_percent(uri));
  if (found == document.source->resources.end()) return nullptr;
  return std::make_shared<const Bytes>(found->second);
}

std::string_view image_media_type(std::span<const std::byte> image) {
  const std::string_view head(reinterpret_cast<const char*>(image.data()), std::min<std::size_t>(image.size(), 16));
  if (head.starts_with("\x89PNG\r\n\x1a\n")) return "image/png";
  if (head.starts_with("\xff\xd8\xff")) return "image/jpeg";
  if (head.starts_with("RIFF") && head.size() >= 12 && head.substr(8, 4) == "WEBP") return "image/webp";
  if (head.starts_with("\xabKTX 20\xbb")) return "image/ktx2";
  return {};
}

}  // namespace croquis
