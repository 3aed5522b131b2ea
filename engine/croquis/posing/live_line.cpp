// SPDX-License-Identifier: MIT
#include "croquis/posing/live_line.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "croquis/base/error.h"
#include "croquis/posing/line_descent.h"
#include "croquis/posing/line_scene.h"
#include "croquis/posing/line_start.h"
#include "croquis/posing/standing.h"

namespace croquis {
namespace {

constexpr double kTurnPerPixel = 2.5 * kDegree;
constexpr int kIterations = 10;  // per update: the pen moves little between two
// A stroke takes hold over its first lengths (parts of the line's): what it covers soon, what lies beyond it later. In
// powers of ten, as the data outweigh the inertia of the body a millionfold.
constexpr double kHolds = 0.1, kLeads = 0.5, kPowers = 10.0;

// Feet that stand are held a hundred times more softly than pins, which shows no difference but lets a few steps find
// the way, and are let go for good where a line of some length stays this far off for so many updates: a jump.
constexpr double kStands = 0.01, kDrawn = 0.3, kEnds = 1.1, kJumps = 0.08;
constexpr int kPatience = 8;
constexpr double kKneeBend = 0.03;  // radians, of straight knees: hardly to be seen

/// A stroke for a problem that has none yet: some way across the picture.
Polyline2 any_stroke(const Camera& camera) {
  return Polyline2(
      {Vec2(0.4 * camera.width_px, 0.5 * camera.height_px), Vec2(0.6 * camera.width_px, 0.5 * camera.height_px)});
}

}  // namespace

struct LiveLine::State {
  State(const Skeleton& body, const HumanoidMap& map, const Pose& start_pose, const BodyLine& body_line,
        LineInput::Direction wanted, const Camera& view, const LineSolverOptions& given)
      : skeleton(&body),
        humanoid(map),
        start(start_pose),
        line(body_line),
        camera(view),
        options(given),
        direction(wanted),
        pose(start_pose) {
    options.length = LengthPolicy::extend;
    given_pins = options.pins.size();
    const LineInput input{line, any_stroke(camera)};
    for (const PosePin& pin : pin_standing_feet(body, humanoid, start, {input}, options)) options.pins.push_back(pin);
    build();
    const std::vector<Vec3> positions = compute_positions(body, start);
    ends[0] = camera.project(positions[static_cast<std::size_t>(line.joints.front())]).value_or(Vec2::Zero());
    ends[1] = camera.project(positions[static_cast<std::size_t>(line.joints.back())]).value_or(Vec2::Zero());
  }

  void build() {
    scene = std::make_unique<LineScene>(*skeleton, humanoid, start, std::vector<LineInput>{{line, any_stroke(camera)}},
                                        camera, options);
    hold_feet(kStands);
    descent.prepare(scene->problem);
  }

  void hold_feet(double hold) {
    for (std::size_t i = given_pins; i < scene->problem.pins.size(); ++i) scene->problem.pins[i].hold = hold;
  }

  /// Lets standing feet go where what is drawn stays out of reach.
  void leave_floor_for(const LinePath& path) {
    if (jumped || path.curve.length() < kDrawn) return;
    double farthest = 0.0;
    for (std::size_t k = 0; k < path.nodes.size(); ++k) {
      if (!path.hold_last && path.slide_to[k] > kEnds * path.curve.length()) break;
      const Vec2 seen = scene->problem.project(current.position[static_cast<std::size_t>(path.nodes[k])]);
      farthest = std::max(farthest, (path.curve.at(current.along.front()[k]) - seen).norm());
    }
    missed = farthest > kJumps ? missed + 1 : 0;
    jumped = missed >= kPatience;
    if (jumped) hold_feet(0.0);
  }

  /// With the first real points: a stroke that starts at the line's last joint turns the line round.
  void begin(const Vec2& first) {
    forward = direction == LineInput::Direction::automatic ? (first - ends[0]).norm() <= (first - ends[1]).norm()
                                                           : direction == LineInput::Direction::forward;
    started = true;
    if (forward) return;
    std::reverse(line.joints.begin(), line.joints.end());
    build();
  }

  const Skeleton* skeleton;
  HumanoidMap humanoid;
  Pose start;
  BodyLine line;
  Camera camera;
  LineSolverOptions options;
  LineInput::Direction direction;
  std::unique_ptr<LineScene> scene;
  LineDescent descent;
  LineState current;
  Vec2 ends[2];  ///< of the line in the start pose, pixels
  Pose pose;
  bool started = false, forward = true, jumped = false;
  int missed = 0;              ///< updates in a row
  std::size_t given_pins = 0;  ///< pins before those of standing feet
  double energy = 0.0, drawn_px = 0.0;
};

LiveLine::LiveLine(const Skeleton& skeleton, const HumanoidMap& humanoid, const Pose& start, const BodyLine& line,
                   LineInput::Direction direction, const Camera& camera, const LineSolverOptions& options)
    : state_(std::make_unique<State>(skeleton, humanoid, start, line, direction, camera, options)) {}
LiveLine::~LiveLine() = default;
LiveLine::LiveLine(LiveLine&&) noexcept = default;
LiveLine& LiveLine::operator=(LiveLine&&) noexcept = default;

const Pose& LiveLine::update(std::span<const Vec2> points) {
  State& s = *state_;
  bool apart = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) throw_invalid_argument("stroke: point " + std::to_string(i) + " is not finite");
    apart = apart || (points[i] - points[0]).norm() > 1e-6;
  }
  if (!apart) return s.pose;
  const bool first = !s.started;
  if (first) s.begin(points[0]);
  LineProblem& problem = s.scene->problem;
  s.scene->set_stroke(0, points, false);
  if (first) {
    s.current = problem.start_state();
    bend_pinned_hinges(problem, s.current, kKneeBend);
  }
  LinePath& path = problem.paths.front();
  const auto hold = [&](double over) {
    return std::pow(10.0, -kPowers * (1.0 - std::clamp(path.curve.length() / over, 0.0, 1.0)));
  };
  const double drawn = hold(kHolds), beyond = hold(kLeads);
  for (std::size_t k = 0; k < path.importance.size(); ++k) {
    path.importance[k] = path.hold_last || path.slide_to[k] <= path.curve.length() ? drawn : beyond;
  }
  // The pen's way since the last update bounds how far joints may turn: a pen at rest moves nothing.
  double drawn_px = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) drawn_px += (points[i] - points[i - 1]).norm();
  const double budget = kTurnPerPixel * std::abs(drawn_px - s.drawn_px);
  s.drawn_px = drawn_px;
  if (budget <= 0.0) return s.pose;
  s.leave_floor_for(path);
  s.energy = s.descent.minimise(problem, s.current, {kIterations, 1e-5, budget / kIterations}).energy;
  s.scene->write_pose(s.current, s.pose);
  return s.pose;
}

const Pose& LiveLine::pose() const { return state_->pose; }
bool LiveLine::forward() const { return state_->forward; }
double LiveLine::energy() const { return state_->energy; }

}  // namespace croquis
