// SPDX-License-Identifier: MIT
// Real files that nobody on this project wrote, beside the checkout (or where CROQUIS_DATA says).
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace croquis {

/// The folder of shared data; nothing where there is none.
inline std::optional<std::filesystem::path> data_folder() {
  const char* chosen = std::getenv("CROQUIS_DATA");
  const std::filesystem::path folder =
      chosen != nullptr ? std::filesystem::path(chosen) : std::filesystem::path(CROQUIS_SOURCE_DIR) / "../shared/data";
  return std::filesystem::is_directory(folder) ? std::optional(folder) : std::nullopt;
}

/// The path of a shared file ("gltf/cesium_man.gltf"); nothing where it is not there: then GTEST_SKIP.
inline std::optional<std::filesystem::path> data_file(const std::string& name) {
  const auto folder = data_folder();
  return folder && std::filesystem::is_regular_file(*folder / name) ? std::optional(*folder / name) : std::nullopt;
}

/// Every regular file under a folder of the shared data, sorted; none where there is no such folder.
inline std::vector<std::filesystem::path> data_files(const std::string& folder_name) {
  std::vector<std::filesystem::path> files;
  const auto folder = data_folder();
  if (!folder || !std::filesystem::is_directory(*folder / folder_name)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(*folder / folder_name)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The bytes of a file; empty where it cannot be read.
inline std::vector<std::byte> load_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

/// Text as the bytes of a file.
inline std::vector<std::byte> bytes_of(std::string_view text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

}  // namespace croquis
