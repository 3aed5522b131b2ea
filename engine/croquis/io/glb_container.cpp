// SPDX-License-Identifier: MIT
#include "croquis/io/glb_container.h"

#include <string>

#include "croquis/base/error.h"

namespace croquis {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67;  // "glTF"
constexpr std::uint32_t kJson = 0x4E4F534A;
constexpr std::uint32_t kBin = 0x004E4942;

std::uint32_t read_u32(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::to_integer<std::uint32_t>(bytes[at + i]) << (8 * i);
  return value;
}

void append_u32(Bytes& bytes, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::byte>((value >> (8 * i)) & 0xffU));
}

void append_chunk(Bytes& file, std::uint32_t type, std::span<const std::byte> bytes, std::byte padding) {
  const std::size_t padded = (bytes.size() + 3) / 4 * 4;
  append_u32(file, static_cast<std::uint32_t>(padded));
  append_u32(file, type);
  file.insert(file.end(), bytes.begin(), bytes.end());
  file.resize(file.size() + padded - bytes.size(), padding);
}

std::string byte_place(std::size_t at) { return "byte " + std::to_string(at); }

}  // namespace

bool is_glb(std::span<const std::byte> bytes) { return bytes.size() >= 4 && read_u32(bytes, 0) == kMagic; }

GlbContainer parse_glb(std::span<const std::byte> bytes) {
  if (!is_glb(bytes)) throw_bad_file("byte 0", "not a GLB: it does not start with 'glTF'");
  if (bytes.size() < 12) throw_bad_file(byte_place(bytes.size()), "the file ends inside the header of the GLB");
  const std::uint32_t version = read_u32(bytes, 4);
  if (version == 1) throw Error(ErrorCode::unsupported, "byte 4: binary glTF 1.0 is not read, only 2.0");
  if (version != 2) throw_bad_file("byte 4", "wanted GLB version 2, found " + std::to_string(version));
  const std::size_t length = read_u32(bytes, 8);
  if (length > bytes.size()) {
    throw_bad_file(byte_place(bytes.size()), "the file ends too early: its header announces " + std::to_string(length) +
                                                 " bytes, it has " + std::to_string(bytes.size()));
  }
  GlbContainer glb;
  bool has_json = false;
  for (std::size_t at = 12; at < length;) {
    if (length - at < 8) throw_bad_file(byte_place(at), "the GLB ends inside a chunk's header");
    const std::size_t size = read_u32(bytes, at);
    const std::uint32_t type = read_u32(bytes, at + 4);
    if (size > length - at - 8) {
      throw_bad_file(byte_place(at), "a chunk of " + std::to_string(size) + " bytes does not fit into the GLB");
    }
    const auto chunk = bytes.subspan(at + 8, size);
    if (!has_json) {
      if (type != kJson) throw_bad_file(byte_place(at), "wanted the JSON chunk first");
      glb.json = {reinterpret_cast<const char*>(chunk.data()), chunk.size()};
      has_json = true;
    } else if (type == kJson || (type == kBin && glb.has_binary)) {
      throw_bad_file(byte_place(at), "a second JSON or BIN chunk");
    } else if (type == kBin) {
      if (!glb.others.empty()) throw_bad_file(byte_place(at), "wanted the BIN chunk right after the JSON chunk");
      glb.binary = chunk;
      glb.has_binary = true;
    } else {
      glb.others.push_back({type, chunk});
    }
    at += 8 + size;
  }
  if (!has_json) throw_bad_file("byte 12", "a GLB without a JSON chunk");
  return glb;
}

Bytes make_glb(std::string_view json, std::span<const std::byte> binary, std::span<const GlbChunk> others) {
  std::uint64_t total = 12 + 8 + json.size() + 3 + (binary.empty() ? 0 : 8 + binary.size() + 3);
  for (const GlbChunk& chunk : others) total += 8 + chunk.bytes.size() + 3;
  if (total > 0xffffffffU) throw Error(ErrorCode::unsupported, "a GLB cannot be larger than 4 GiB");

  Bytes file;
  file.reserve(static_cast<std::size_t>(total));
  append_u32(file, kMagic);
  append_u32(file, 2);
  append_u32(file, 0);
  append_chunk(file, kJson, std::as_bytes(std::span<const char>(json)), std::byte{' '});
  if (!binary.empty()) append_chunk(file, kBin, binary, std::byte{0});
  for (const GlbChunk& chunk : others) append_chunk(file, chunk.type, chunk.bytes, std::byte{0});
  for (std::size_t i = 0; i < 4; ++i) file[8 + i] = static_cast<std::byte>((file.size() >> (8 * i)) & 0xffU);
  return file;
}

}  // namespace croquis
