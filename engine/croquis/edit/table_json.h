// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "croquis/body/body.h"
#include "croquis/edit/stroke_commands.h"
#include "croquis/project/project.h"

namespace croquis {

/// The arguments of a command, read one by one; each reader throws bad_file with the JSON pointer and what was wanted.
class TableArguments {
 public:
  explicit TableArguments(std::string_view json);

  [[nodiscard]] bool has(const char* name) const;
  [[nodiscard]] double number(const char* name) const;
  [[nodiscard]] int integer(const char* name) const;
  [[nodiscard]] bool flag(const char* name) const;
  [[nodiscard]] std::string text(const char* name) const;
  [[nodiscard]] std::vector<int> integers(const char* name) const;
  [[nodiscard]] Vec3 point(const char* name) const;
  [[nodiscard]] Quat rotation(const char* name) const;
  [[nodiscard]] std::vector<StrokeSample> samples(const char* name) const;
  [[nodiscard]] Camera camera(const char* name) const;
  /// `base` with the fields that are there.
  [[nodiscard]] StrokeSettings stroke_settings(const char* name, const StrokeSettings& base) const;
  [[nodiscard]] TableSettings table_settings(const char* name, const TableSettings& base) const;
  /// Empty if it is not there.
  [[nodiscard]] std::map<std::string, double> numbers_by_name(const char* name) const;

 private:
  [[nodiscard]] const nlohmann::ordered_json& at(const char* name) const;
  nlohmann::ordered_json json_;
};

/// The settings of a stroke drawn now, where the person has said nothing.
[[nodiscard]] StrokeSettings default_stroke_settings(const Project& project);

/// Throws invalid_argument for a name that is no proportion.
[[nodiscard]] Proportions read_proportions(const std::map<std::string, double>& by_name);

/// What a screen needs to know of a project; no vertex, no pose.
[[nodiscard]] nlohmann::ordered_json describe_project(const Project& project);

/// What a screen shows of a solved line.
[[nodiscard]] nlohmann::ordered_json describe_line(const DrawnStroke& drawn);

}  // namespace croquis
