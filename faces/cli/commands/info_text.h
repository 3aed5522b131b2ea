// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "croquis/project/project.h"

namespace croquis::cli {

/// All that is to be said of a file, as `croquis info --json` gives it.
[[nodiscard]] nlohmann::ordered_json describe(const std::string& file, const Project& project);

/// The same for people.
[[nodiscard]] std::string to_text(const nlohmann::ordered_json& description);

}  // namespace croquis::cli
