// SPDX-License-Identifier: MIT
#include "cli/commands/pose_report.h"

#include <nlohmann/json.hpp>

#include "croquis/base/text.h"

namespace croquis::cli {
namespace {

using Json = nlohmann::ordered_json;

const char* direction_of(bool forward) { return forward ? "forward" : "backward"; }

Json names_of(const std::vector<int>& joints, const Skeleton& skeleton) {
  Json names = Json::array();
  for (const int joint : joints) names.push_back(skeleton.reference(joint));
  return names;
}

void put(Json& json, const PoseReport& report, std::size_t index, const Skeleton& skeleton) {
  const LineReport& line = report.lines[index];
  json["status"] = line.status;
  json["body_line"] = line.body_line;
  json["direction"] = direction_of(line.forward);
  json["fit"] = {{"mean_px", line.fit.mean_px}, {"max_px", line.fit.max_px}, {"tangent_deg", line.fit.tangent_deg}};
  json["bone_length_drift"] = line.bone_length_drift;
  json["limit_violations"] = names_of(line.limit_violations, skeleton);
  json["limits_widened"] = names_of(line.limits_widened, skeleton);
  json["overlap"] = line.overlap;
  json["solve_ms"] = line.solve_ms;
  json["alternatives"] = Json::array();
  if (index >= report.alternatives.size()) return;
  for (const StrokeReading& reading : report.alternatives[index]) {
    json["alternatives"].push_back({{"label", reading.label},
                                    {"body_line", reading.line.name},
                                    {"direction", direction_of(reading.forward)},
                                    {"depth", reading.settings.depth},
                                    {"cost", reading.cost}});
  }
}

std::string counted(std::size_t count, const char* what) {
  return std::to_string(count) + (count == 1 ? " joint " : " joints ") + what;
}

}  // namespace

std::string to_json(const PoseReport& report, const Skeleton& skeleton) {
  Json json;
  if (report.lines.empty()) {
    json["status"] = "ok";
    for (const char* key : {"body_line", "direction", "fit"}) json[key] = nullptr;
  } else {
    put(json, report, 0, skeleton);
  }
  if (report.lines.size() > 1) {
    for (std::size_t i = 0; i < report.lines.size(); ++i) put(json["lines"].emplace_back(), report, i, skeleton);
  }
  json["notices"] = report.notices;
  json["outputs"] = report.outputs;
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string to_text(const PoseReport& report, const Skeleton& skeleton) {
  std::string text;
  for (std::size_t i = 0; i < report.lines.size(); ++i) {
    const LineReport& line = report.lines[i];
    text += "Posed " + printable(line.body_line) + ", " + direction_of(line.forward) +
            " along the stroke: " + format_double(line.fit.mean_px, 3) + " px from it on average, " +
            format_double(line.fit.max_px, 3) + " px at most, " + format_double(line.fit.tangent_deg, 3) +
            " degrees off its direction\n";
    if (line.status != "ok") text += "Note: " + line.status + "\n";
    if (i >= report.alternatives.size()) continue;
    for (std::size_t k = 0; k < report.alternatives[i].size(); ++k) {
      text += "  or: " + printable(report.alternatives[i][k].label) + "\n";
    }
  }
  if (!report.lines.empty()) {
    const LineReport& last = report.lines.back();
    if (!last.limit_violations.empty()) {
      text += "Note: " + counted(last.limit_violations.size(), "bent beyond the limits: ") +
              printable(skeleton.reference(last.limit_violations.front())) +
              (last.limit_violations.size() > 1 ? ", ..." : "") + "\n";
    }
    if (!last.limits_widened.empty()) {
      text +=
          "Note: " + counted(last.limits_widened.size(), "bent beyond the limits at the start; they go no farther\n");
    }
  }
  for (const std::string& notice : report.notices) text += "Note: " + notice + "\n";
  return text + "Wrote " + join(report.outputs, ", ") + "\n";
}

}  // namespace croquis::cli
