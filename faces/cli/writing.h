// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "croquis/io/character_file.h"

namespace croquis::cli {

/// The project as a file: all of it as "croquis", its first actor as he stands in any other format.
[[nodiscard]] WrittenFile to_file(const Project& project, const std::string& format, const std::string& file_name,
                                  const WriteOptions& options);

/// What somebody should know who opens a posed file elsewhere, one sentence each.
[[nodiscard]] std::vector<std::string> notices_for(const Character& character, const std::string& format,
                                                   PoseForm form);

}  // namespace croquis::cli
