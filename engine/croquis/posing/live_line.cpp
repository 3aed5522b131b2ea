// SPDX-License-Identifier: MIT
#include "croquis/posing/live_line.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "croquis/base/error.h"
#include "croquis/posing/line_descent.h"
#include "croquis/posing/line_scene.h"

namespace croquis {
namespace {

constexpr double kTurnPerPixel = 2.5 * kDegree;
constexpr int kIterations = 10;  // per update: the pen moves little between two
// A stroke takes hold over its first lengths (parts of the line's): what it covers soon, what lies beyond it later. In
// powers of ten, as the data outweigh the inertia of the body a millionfold.
constexpr double kHolds = 0.1, kLeads = 0.5, kPowers = 10.0;

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
    build();
    const std::vector<Vec3> positions = compute_positions(body, start);
    ends[0] = camera.project(positions[static_cast<std::size_t>(line.joints.front())]).value_or(Vec2::Zero());
    ends[1] = camera.project(positions[static_cast<std::size_t>(line.joints.back())]).value_or(Vec2::Zero());
  }

  void build() {
    scene = std::make_unique<LineScene>(*skeleton, humanoid, start, std::vector<LineInput>{{line, any_stroke(camera)}},
                                        camera, options);
    descent.prepare(scene->problem);
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
  bool started = false, forward = true;
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
  if (first) s.current = problem.start_state();
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
  s.energy = s.descent.minimise(problem, s.current, {kIterations, 1e-5, budget / kIterations}).energy;
  s.scene->write_pose(s.current, s.pose);
  return s.pose;
}

const Pose& LiveLine::pose() const { return state_->pose; }
bool LiveLine::forward() const { return state_->forward; }
double LiveLine::energy() const { return state_->energy; }

}  // namespace croquis
