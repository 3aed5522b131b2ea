// SPDX-License-Identifier: MIT
#include "croquis/edit/line_setup.h"

#include <algorithm>
#include <cmath>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/edit/line_choice.h"
#include "croquis/posing/extract_line.h"

namespace croquis {
namespace {

Box joint_box(const Skeleton& skeleton, const Pose& pose) {
  Box box;
  for (const Vec3& position : compute_positions(skeleton, pose)) box.extend(position);
  return box;
}

/// How much the body heeds each of `count` points at equal arc lengths: the pen's pressure there, 1 where it is the
/// mean; empty where there was no pen that feels it.
std::vector<double> pressures_of(const Stroke& stroke, int count) {
  const std::vector<StrokeSample>& samples = stroke.samples;
  const auto lighter = [](const StrokeSample& a, const StrokeSample& b) { return a.pressure < b.pressure; };
  const auto [least, most] = std::minmax_element(samples.begin(), samples.end(), lighter);
  if (!stroke.raw_pen || most->pressure - least->pressure < 0.05) return {};
  std::vector<double> arc{0.0};
  double mean = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double step = (samples[i].position - samples[i - 1].position).norm();
    arc.push_back(arc.back() + step);
    mean += 0.5 * step * (samples[i].pressure + samples[i - 1].pressure);
  }
  mean /= arc.back();
  std::vector<double> pressures;
  std::size_t next = 1;
  for (int i = 0; i < count; ++i) {
    const double s = arc.back() * i / (count - 1);
    while (next + 1 < arc.size() && arc[next] < s) ++next;
    const double t = (s - arc[next - 1]) / std::max(arc[next] - arc[next - 1], 1e-9);
    const double pressure = samples[next - 1].pressure + t * (samples[next].pressure - samples[next - 1].pressure);
    pressures.push_back(std::clamp(pressure / mean, 0.1, 4.0));
  }
  return pressures;
}

bool is_cross_line(const BodyLine& line) { return line.name == "shoulders" || line.name == "hips"; }

}  // namespace

void check_limits(const std::string& preset) {
  if (parse_limit_preset(preset)) return;
  throw_invalid_argument("limits '" + printable(preset) + "': wanted anatomical, dancer, cartoon, none");
}

std::vector<JointLimit> limits_of(const TableSettings& settings, const Character& character) {
  check_limits(settings.limits);
  return make_joint_limits(character.skeleton, character.humanoid, *parse_limit_preset(settings.limits));
}

Pin parse_pin(const Actor& actor, std::string_view text) {
  const Skeleton& skeleton = actor.character->skeleton;
  Pin pin;
  const std::size_t equals = text.rfind('=');
  // A name may hold the sign itself.
  const bool placed = equals != std::string_view::npos && skeleton.find(text).empty();
  pin.joint = skeleton.resolve(trim(placed ? text.substr(0, equals) : text));
  if (!placed) {
    pin.position = compute_positions(skeleton, actor.pose)[static_cast<std::size_t>(pin.joint)];
    return pin;
  }
  const std::vector<std::string> numbers = split(text.substr(equals + 1), ',');
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<double> number =
        numbers.size() == 3 ? parse_double(trim(numbers[static_cast<std::size_t>(axis)])) : std::nullopt;
    if (!number || !std::isfinite(*number)) {
      throw_invalid_argument("pin '" + printable(text) + "': wanted JOINT or JOINT=x,y,z");
    }
    pin.position[axis] = *number;
  }
  return pin;
}

double floor_under(const Actor& actor) {
  const Box opened = joint_box(actor.character->skeleton, actor.character->start);
  if (std::abs(opened.min().y()) <= 0.2 * opened.sizes().maxCoeff()) return opened.min().y();
  return joint_box(actor.character->skeleton, actor.pose).min().y();
}

LineSolverOptions make_solver_options(const Project& project, const Actor& actor, const StrokeSettings& settings) {
  LineSolverOptions options = solver_options(settings);
  options.limits = limits_of(project.settings, *actor.character);
  options.iterations = 400;  // of a pose that is kept; the pen is followed in steps of its own
  for (const Pin& pin : actor.pins) options.pins.push_back({pin.joint, pin.position, pin.rotation});
  if (project.settings.floor) options.floor = floor_under(actor);
  options.balance = project.settings.balance;
  return options;
}

LineInput make_line_input(const PlacedStroke& stroke, const BodyLine& line) {
  Polyline2 curve = clean_stroke(stroke.stroke);
  if (stroke.settings.exaggerate != 1.0) curve = exaggerate_line(curve, stroke.settings.exaggerate);
  LineInput input{line, std::move(curve), solver_direction(stroke.settings)};
  input.weight = stroke.settings.weight;
  input.pressure = pressures_of(stroke.stroke, static_cast<int>(input.stroke.points().size()));
  if (is_cross_line(line)) {
    input.importance.assign(line.joints.size(), 0.0);
    input.importance.front() = input.importance.back() = 1.0;
  }
  return input;
}

void settle_direction(LineInput& input, const Skeleton& skeleton, const Pose& pose, const Camera& camera) {
  using enum LineInput::Direction;
  if (input.direction != automatic || input.line.joints.empty()) return;
  const std::vector<Vec3> positions = compute_positions(skeleton, pose);
  const auto first = camera.project(positions[static_cast<std::size_t>(input.line.joints.front())]);
  const auto last = camera.project(positions[static_cast<std::size_t>(input.line.joints.back())]);
  if (!first || !last) return;
  constexpr double kMuch = 0.25;
  const Vec2& pen = input.stroke.points().front();
  const double to_first = (pen - *first).norm(), to_last = (pen - *last).norm();
  if (to_first < kMuch * to_last) input.direction = forward;
  if (to_last < kMuch * to_first) input.direction = backward;
}

}  // namespace croquis
