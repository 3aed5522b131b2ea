// SPDX-License-Identifier: MIT
#include "croquis/edit/line_choice.h"

#include <cmath>
#include <initializer_list>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

std::string joint_word(const Skeleton& skeleton, int joint) {
  const std::string reference = skeleton.reference(joint);
  const bool plain = reference.find(',') == std::string::npos && trim(reference) == reference;
  return plain ? reference : "#" + std::to_string(joint);
}

/// The value that stands beside `word`, or an error that says which words there are.
template <class Value>
Value look_up(std::string_view what, std::string_view word,
              std::initializer_list<std::pair<std::string_view, Value>> words) {
  std::vector<std::string> names;
  for (const auto& [name, value] : words) {
    if (name == word) return value;
    names.emplace_back(name);
  }
  throw_invalid_argument(std::string(what) + " '" + printable(word) + "': wanted " + join(names, ", "));
}

bool is_path(const Skeleton& skeleton, const std::vector<int>& joints) {
  if (joints.size() < 2) return false;
  try {
    (void)make_body_line(skeleton, joints);
    return true;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

std::vector<int> parse_joint_list(const Skeleton& skeleton, std::string_view list) {
  std::vector<int> joints;
  for (const std::string& entry : split(list, ',')) {
    // A name may begin or end with a space: as it stands first, without the spaces of "A, B" second.
    const bool as_it_stands = !skeleton.find(entry).empty();
    joints.push_back(skeleton.resolve(as_it_stands ? std::string_view(entry) : trim(entry)));
  }
  return joints;
}

std::string format_joint_list(const Skeleton& skeleton, const std::vector<int>& joints) {
  std::vector<std::string> words;
  for (const int joint : joints) words.push_back(joint_word(skeleton, joint));
  return join(words, ",");
}

LineChoice choose_line(const Character& character, const StrokeSettings& settings) {
  const Skeleton& skeleton = character.skeleton;
  if (!settings.body_line.empty() && !settings.joints.empty()) {
    throw_invalid_argument("a stroke is for a body line or for joints, not for both");
  }
  BodyLine line;
  if (!settings.joints.empty()) {
    const std::string name = format_joint_list(skeleton, settings.joints);
    if (!is_path(skeleton, settings.joints)) {
      // Not `return {{name, {}}, segments_of_selection(...)}`: g++ 12 destroys the name twice when that call throws.
      LineChoice choice;
      choice.segments = segments_of_selection(skeleton, settings.joints);
      choice.line.name = name;
      return choice;
    }
    line = make_body_line(skeleton, settings.joints);
    line.name = name;
  } else if (!settings.body_line.empty()) {
    line = find_body_line(skeleton, character.humanoid, settings.body_line);
  } else {
    std::vector<BodyLine> lines = standard_body_lines(skeleton, character.humanoid);
    if (lines.empty()) throw_invalid_argument("the skeleton has no bone to pose: it needs a joint below another");
    line = std::move(lines.front());
  }
  std::vector<SkeletonSegment> segments = segments_of_line(skeleton, line);
  return {std::move(line), std::move(segments)};
}

bool is_line_method(const StrokeSettings& settings) { return settings.method == "line"; }

MatchOptions match_options(const StrokeSettings& settings) {
  MatchOptions options;
  const std::optional<MatchMethod> method = parse_match_method(settings.method);
  if (!method) {
    throw_invalid_argument("method '" + printable(settings.method) +
                           "': wanted line, rotation, rotation-index, near, curvilinear");
  }
  options.method = *method;
  options.root = look_up<RootMode>("root", settings.root,
                                   {{"auto", RootMode::lock},
                                    {"lock", RootMode::lock},
                                    {"tangent", RootMode::tangent},
                                    {"free", RootMode::tangent}});
  options.plane =
      look_up<DrawingPlane>("plane", settings.plane, {{"free", DrawingPlane::free}, {"ground", DrawingPlane::ground}});
  options.direction = look_up<DirectionRule>("direction", settings.direction,
                                             {{"auto", DirectionRule::scalar_product},
                                              {"forward", DirectionRule::forward},
                                              {"backward", DirectionRule::backward},
                                              {"length", DirectionRule::length}});
  return options;
}

LineSolverOptions solver_options(const StrokeSettings& settings) {
  LineSolverOptions options;
  options.lock_root =
      look_up<bool>("root", settings.root, {{"auto", false}, {"lock", true}, {"tangent", false}, {"free", false}});
  options.length = look_up<LengthPolicy>("length", settings.length,
                                         {{"fit", LengthPolicy::fit},
                                          {"scale", LengthPolicy::scale},
                                          {"trim", LengthPolicy::trim},
                                          {"extend", LengthPolicy::extend}});
  options.move_body = look_up<bool>("move", settings.move, {{"line", false}, {"body", true}});
  return options;
}

LineInput::Direction solver_direction(const StrokeSettings& settings) {
  using enum LineInput::Direction;
  return look_up<LineInput::Direction>("direction", settings.direction,
                                       {{"auto", automatic}, {"forward", forward}, {"backward", backward}});
}

void check_words(const StrokeSettings& settings) {
  if (!is_line_method(settings)) {
    (void)match_options(settings);
    return;
  }
  (void)solver_options(settings);
  (void)solver_direction(settings);
  (void)look_up<int>("plane", settings.plane, {{"free", 0}, {"ground", 1}});
  const auto want = [](const char* what, double value, bool holds, const char* range) {
    if (!holds) throw_invalid_argument(std::string(what) + " " + format_double(value) + ": wanted " + range);
  };
  want("exaggerate", settings.exaggerate, settings.exaggerate >= 0.0 && settings.exaggerate <= 2.0, "0 to 2");
  want("weight", settings.weight, settings.weight > 0.0 && std::isfinite(settings.weight), "more than 0");
}

}  // namespace croquis
