// SPDX-License-Identifier: MIT
// Files that tests write, kept for the Khronos validator where CROQUIS_WRITE_TO names a folder.
#pragma once

#include "support/data.h"
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "croquis/base/error.h"
#include "croquis/io/character_file.h"
#include "croquis/io/disk.h"

namespace croquis {

/// Every good glTF and VRM of the shared data.
inline std::vector<std::filesystem::path> good_gltf_files() {
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"gltf", "vrm"}) {
    for (const auto& path : data_files(folder)) {
      const std::string format = file_format(path.string());
      const bool is_gltf = format == "gltf" || format == "glb" || format == "vrm" || format == "vrma";
      if (is_gltf && path.string().find("DRACO") == std::string::npos) files.push_back(path);
    }
  }
  return files;
}

inline Character read_from(const std::filesystem::path& path) {
  return read_character(load_bytes(path), path.string(), resources_beside(path));
}

/// Reads a file that was written, with its companions.
inline Character read_back(const WrittenFile& file, const std::string& name) {
  return read_character(file.bytes, name, [&](std::string_view uri) {
    const auto found = file.companions.find(std::string(uri));
    if (found == file.companions.end()) throw Error(ErrorCode::io, std::string(uri) + " is not there");
    return found->second;
  });
}

/// Keeps a written file and notes which file its errors are to be held against ("" for none).
inline void keep_for_validator(const WrittenFile& file, const std::string& name, const std::string& source) {
  const char* folder = std::getenv("CROQUIS_WRITE_TO");
  if (folder == nullptr) return;
  const std::filesystem::path path = std::filesystem::path(folder) / name;
  std::filesystem::create_directories(path.parent_path());
  write_file(path, file.bytes);
  for (const auto& [uri, bytes] : file.companions) {
    std::filesystem::create_directories((path.parent_path() / uri).parent_path());
    write_file(path.parent_path() / uri, bytes);
  }
  std::ofstream(std::filesystem::path(folder) / "list.txt", std::ios::app) << path.string() << "\t" << source << "\n";
}

}  // namespace croquis
