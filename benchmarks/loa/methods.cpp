// SPDX-License-Identifier: MIT
#include "loa/methods.h"

#include "croquis/posing/line_matching.h"
#include "croquis/posing/line_solver.h"

namespace croquis::loa {
namespace {

Method matching(MatchMethod method, bool direction_known) {
  return {
      std::string(to_string(method)), [=](const Draw& draw) {
        MatchOptions options;
        options.method = method;
        options.root = RootMode::tangent;
        options.direction = direction_known ? DirectionRule::forward : DirectionRule::scalar_product;
        return match_line(draw.clip->character.skeleton, draw.start, draw.line, draw.stroke, draw.camera, options).pose;
      }};
}

LineSolverResult solve(const Draw& draw, bool direction_known, const LineSolverOptions& options) {
  LineInput input{draw.line, draw.stroke};
  if (direction_known) input.direction = LineInput::Direction::forward;
  return solve_lines(draw.clip->character.skeleton, draw.clip->character.humanoid, draw.start, {input}, draw.camera,
                     options);
}

}  // namespace

std::vector<Method> all_methods(bool direction_known) {
  std::vector<Method> methods;
  methods.push_back({"start", [](const Draw& draw) { return draw.start; }});
  for (const auto method :
       {MatchMethod::near, MatchMethod::curvilinear, MatchMethod::rotation_index, MatchMethod::rotation}) {
    methods.push_back(matching(method, direction_known));
  }
  methods.push_back({"line", [=](const Draw& draw) {
                       LineSolverOptions options;
                       options.move_body = true;
                       return solve(draw, direction_known, options).pose;
                     }});
  return methods;
}

}  // namespace croquis::loa
