// SPDX-License-Identifier: MIT
#include "loa/clips.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "croquis/base/error.h"
#include "croquis/base/random.h"
#include "croquis/io/bvh.h"
#include "croquis/io/disk.h"
#include "croquis/math/rotation.h"

namespace croquis::loa {
namespace {

using enum HumanoidBone;
constexpr int kMostFrames = 400;

Vec3 at(const std::vector<Vec3>& positions, const HumanoidMap& map, HumanoidBone bone) {
  return positions[static_cast<std::size_t>(map.joint(bone))];
}

double body_height(const Character& character, const Pose& pose) {
  const std::vector<Vec3> x = compute_positions(character.skeleton, pose);
  const HumanoidMap& map = character.humanoid;
  double height = (at(x, map, leftUpperLeg) - at(x, map, leftLowerLeg)).norm() +
                  (at(x, map, leftLowerLeg) - at(x, map, leftFoot)).norm();
  const std::vector<int> trunk = character.skeleton.path(map.joint(hips), map.joint(map.has(head) ? head : neck));
  for (std::size_t i = 1; i < trunk.size(); ++i) {
    height += (x[static_cast<std::size_t>(trunk[i])] - x[static_cast<std::size_t>(trunk[i - 1])]).norm();
  }
  return height;
}

/// Turns the whole clip so that people stand along +Y.
void turn_upright(const Character& character, std::vector<Pose>& frames) {
  Vec3 up = Vec3::Zero();
  for (const Pose& frame : frames) {
    const std::vector<Vec3> x = compute_positions(character.skeleton, frame);
    const HumanoidMap& map = character.humanoid;
    up += at(x, map, map.has(head) ? head : neck) - 0.5 * (at(x, map, leftFoot) + at(x, map, rightFoot));
  }
  Eigen::Index axis = 0;
  up.cwiseAbs().maxCoeff(&axis);
  Vec3 file_up = Vec3::Zero();
  file_up[axis] = up[axis] > 0.0 ? 1.0 : -1.0;
  const Quat turn = rotation_between(file_up, Vec3::UnitY());
  for (Pose& frame : frames) {
    frame.local[0].translation = turn * frame.local[0].translation;
    frame.local[0].rotation = turn * frame.local[0].rotation;
  }
}

/// The frame nearest to the component-wise medians of its joints' quaternions.
std::size_t most_neutral(const std::vector<Pose>& frames) {
  const std::size_t joints = frames.front().local.size();
  std::vector<double> distance(frames.size(), 0.0), column(frames.size());
  for (std::size_t j = 1; j < joints; ++j) {
    const Quat& first = frames.front().local[j].rotation;
    for (int axis = 0; axis < 4; ++axis) {
      const auto value = [&](std::size_t f) {
        const Quat& q = frames[f].local[j].rotation;
        return (q.dot(first) < 0.0 ? -1.0 : 1.0) * q.coeffs()[axis];
      };
      for (std::size_t f = 0; f < frames.size(); ++f) column[f] = value(f);
      const auto middle = column.begin() + std::ssize(column) / 2;
      std::nth_element(column.begin(), middle, column.end());
      const double median = *middle;
      for (std::size_t f = 0; f < frames.size(); ++f) distance[f] += (value(f) - median) * (value(f) - median);
    }
  }
  return static_cast<std::size_t>(std::min_element(distance.begin(), distance.end()) - distance.begin());
}

/// Joint positions about the hips, turned to one heading, per height.
std::vector<Vec3> shape_of(const Clip& clip, const Pose& pose) {
  std::vector<Vec3> x = compute_positions(clip.character.skeleton, pose);
  const HumanoidMap& map = clip.character.humanoid;
  const Vec3 line = at(x, map, leftUpperLeg) - at(x, map, rightUpperLeg), origin = at(x, map, hips);
  const Quat turn(Eigen::AngleAxisd(std::atan2(line.z(), line.x()), Vec3::UnitY()));
  for (Vec3& p : x) p = turn * (p - origin) / clip.height;
  return x;
}

void choose_poses(Clip& clip, const std::vector<Pose>& frames, int count, Random& random) {
  std::vector<std::vector<Vec3>> shapes;
  for (const Pose& frame : frames) shapes.push_back(shape_of(clip, frame));
  std::vector<double> nearest(frames.size(), std::numeric_limits<double>::infinity());
  std::size_t next = static_cast<std::size_t>(random.index(static_cast<int>(frames.size())));
  for (int i = 0; i < count && i < static_cast<int>(frames.size()); ++i) {
    clip.poses.push_back(frames[next]);
    for (std::size_t f = 0; f < frames.size(); ++f) {
      double distance = 0.0;
      for (std::size_t j = 0; j < shapes[f].size(); ++j) distance += (shapes[f][j] - shapes[next][j]).squaredNorm();
      nearest[f] = std::min(nearest[f], distance);
    }
    next = static_cast<std::size_t>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
    if (nearest[next] <= 0.0) break;
  }
}

}  // namespace

std::vector<Clip> read_clips(const std::filesystem::path& folder, int poses, std::uint64_t seed,
                             std::vector<std::string>& notes) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".bvh") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Clip> clips;
  Random random(seed);
  for (const auto& file : files) {
    const std::string name = file.stem().string();
    try {
      Character character = read_bvh(read_file(file), name);
      character.humanoid = recognise_humanoid(character.skeleton);
      if (!character.humanoid.is_humanoid()) {
        notes.push_back(name + ": no humanoid");
        continue;
      }
      const int frames = character.clips.empty() ? 0 : character.clips.front().frame_count();
      if (frames < 10) {
        notes.push_back(name + ": fewer than ten frames");
        continue;
      }
      std::vector<Pose> sampled;
      const int step = std::max(1, frames / kMostFrames);
      for (int f = 0; f < frames; f += step) {
        sampled.push_back(sample_pose(character.clips.front(), character.clips.front().frame_time(f), character.start));
      }
      turn_upright(character, sampled);
      Clip clip{name, std::move(character), 0.0, {}, {}};
      clip.neutral = sampled[most_neutral(sampled)];
      clip.height = body_height(clip.character, clip.neutral);
      clips.push_back(std::move(clip));
      choose_poses(clips.back(), sampled, std::max(1, poses), random);
    } catch (const Error& error) {
      notes.push_back(name + ": " + error.what());
    }
  }
  // `poses` is meant for all clips together.
  if (!clips.empty()) {
    const auto each = static_cast<std::size_t>(std::max(1, poses / static_cast<int>(clips.size())));
    for (Clip& clip : clips) {
      if (clip.poses.size() > each) clip.poses.resize(each);
    }
  }
  return clips;
}

Pose place_neutral(const Clip& clip, const Pose& target) {
  const HumanoidMap& map = clip.character.humanoid;
  const std::vector<Vec3> from = compute_positions(clip.character.skeleton, clip.neutral);
  const std::vector<Vec3> to = compute_positions(clip.character.skeleton, target);
  const auto heading = [&](const std::vector<Vec3>& x) {
    const Vec3 line = at(x, map, leftUpperLeg) - at(x, map, rightUpperLeg);
    return std::atan2(-line.z(), line.x());
  };
  const Quat turn(Eigen::AngleAxisd(heading(to) - heading(from), Vec3::UnitY()));
  Pose pose = clip.neutral;
  pose.local[0].rotation = turn * pose.local[0].rotation;
  pose.local[0].translation = turn * (pose.local[0].translation - at(from, map, hips)) + at(to, map, hips);
  return pose;
}

}  // namespace croquis::loa
