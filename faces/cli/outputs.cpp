// SPDX-License-Identifier: MIT
#include "cli/outputs.h"

#include <algorithm>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/disk.h"

namespace croquis::cli {

namespace fs = std::filesystem;

void Outputs::announce(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  std::error_code ignored;
  if (!folder.empty() && !fs::is_directory(folder, ignored)) {
    throw Error(ErrorCode::io, path + ": there is no folder " + folder.string());
  }
  if (fs::is_directory(path, ignored)) throw Error(ErrorCode::io, path + ": this is a folder");
  const auto same = [&](const std::string& other) {
    return fs::path(path).lexically_normal() == fs::path(other).lexically_normal();
  };
  if (std::any_of(announced_.begin(), announced_.end(), same)) {
    throw_invalid_argument(path + ": two outputs have the same name");
  }
  announced_.push_back(path);
}

void Outputs::add(const std::string& path, Bytes bytes) { files_.emplace_back(path, std::move(bytes)); }

void Outputs::add(const std::string& path, WrittenFile file) {
  for (auto& [uri, bytes] : file.companions) {
    files_.emplace_back(fs::path(path).parent_path() / fs::path(uri), std::move(bytes));
  }
  files_.emplace_back(path, std::move(file.bytes));
}

void Outputs::write() const {
  for (const auto& [path, bytes] : files_) write_file(path, bytes);
}

std::string output_format(const std::string& path, const std::vector<std::string>& wanted) {
  if (path.empty()) throw_invalid_argument("an output has an empty name");
  std::string format = file_format(path);
  if (std::find(wanted.begin(), wanted.end(), format) == wanted.end()) {
    throw_invalid_argument(path + ": wanted a name that ends in ." + join(wanted, ", ."));
  }
  return format;
}

const std::vector<std::string>& character_formats() {
  static const std::vector<std::string> formats{"glb", "gltf", "vrm", "bvh", "croquis"};
  return formats;
}

}  // namespace croquis::cli
