// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "croquis/io/character_file.h"
#include "croquis/picture/picture.h"

namespace croquis::cli {

/// Files that a command will write: told early (so that a path that cannot be written is found before any work is
/// done), filled when there is something to say, written together when everything has succeeded.
class Outputs {
 public:
  /// Throws invalid_argument if the folder is not there or the path is a folder, or if it was announced before.
  void announce(const std::string& path);
  void add(const std::string& path, Bytes bytes);
  void add(const std::string& path, WrittenFile file);
  /// Companions first, so that a file whose companions are missing is never left.
  void write() const;
  [[nodiscard]] const std::vector<std::string>& paths() const { return announced_; }

 private:
  std::vector<std::string> announced_;
  std::vector<std::pair<std::filesystem::path, Bytes>> files_;
};

/// The format of an output by its extension; throws invalid_argument unless it is one of `wanted`.
[[nodiscard]] std::string output_format(const std::string& path, const std::vector<std::string>& wanted);

/// The formats that characters are written in.
[[nodiscard]] const std::vector<std::string>& character_formats();

}  // namespace croquis::cli
