// SPDX-License-Identifier: MIT
// Source: gltf2, section 3.11 "Animations" and appendix C.
#include "croquis/io/gltf_animation.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

#include "croquis/io/gltf_accessor.h"

namespace croquis {
namespace {

struct ClipReader {
  const GltfDocument& document;
  const JointChoice& choice;
  const std::vector<PartPlace>& parts;
  std::map<int, std::vector<double>> times_of_accessor = {};
  int out_of_order = 0;
  int unknown_paths = 0;

  const std::vector<double>& times(const JsonPlace& place) {
    const int index = place.index(document.count("accessors"), "accessor");
    const auto found = times_of_accessor.find(index);
    if (found != times_of_accessor.end()) return found->second;
    const std::vector<float> numbers = read_floats(document, find_accessor(document, place, "SCALAR"));
    return times_of_accessor[index] = {numbers.begin(), numbers.end()};
  }

  static Interpolation interpolation(const JsonPlace& place) {
    const std::string name = place.text_or("LINEAR");
    if (name == "STEP") return Interpolation::step;
    if (name == "CUBICSPLINE") return Interpolation::cubic_spline;
    if (name != "LINEAR") place.fail("wanted STEP, LINEAR or CUBICSPLINE");
    return Interpolation::linear;
  }

  /// The curve of a channel but for what it moves; nothing if its times do not increase.
  std::optional<Curve> read_curve(const JsonPlace& sampler, CurveTarget target) {
    Curve curve;
    curve.target = target;
    curve.interpolation = interpolation(sampler["interpolation"]);
    curve.times = times(sampler["input"]);
    if (std::adjacent_find(curve.times.begin(), curve.times.end(), std::greater_equal<>()) != curve.times.end()) {
      ++out_of_order;
      return std::nullopt;
    }
    const char* type = target == CurveTarget::rotation ? "VEC4" : target == CurveTarget::weights ? "SCALAR" : "VEC3";
    const Accessor output = find_accessor(document, sampler["output"], type);
    const std::vector<float> numbers = read_floats(document, output);
    const std::size_t keys = curve.times.size() * (curve.interpolation == Interpolation::cubic_spline ? 3 : 1);
    const std::size_t width =
        target == CurveTarget::weights ? numbers.size() / keys : static_cast<std::size_t>(output.width);
    if (width == 0 || numbers.size() != keys * width) {
      output.place.fail("wanted " + std::to_string(keys) + " elements for " + std::to_string(curve.times.size()) +
                        " keys, found " + std::to_string(output.count));
    }
    document.budget.take(numbers.size() + curve.times.size(), sizeof(double), output.place);
    curve.width = static_cast<int>(width);
    curve.values.assign(numbers.begin(), numbers.end());
    return curve;
  }

  void read_channel(const JsonPlace& animation, const JsonPlace& channel, Clip& clip) {
    const JsonPlace samplers = animation["samplers"];
    const JsonPlace sampler = samplers[channel["sampler"].index(samplers.size(), "sampler")];
    const int node = channel["target"]["node"].index_or_none(document.count("nodes"), "node");
    const std::string path = channel["target"]["path"].text();
    if (path == "weights") {
      std::vector<int> moved;
      for (int i = 0; i < std::ssize(parts); ++i) {
        if (parts[static_cast<std::size_t>(i)].node == node) moved.push_back(i);
      }
      if (node < 0 || moved.empty()) return;
      if (auto curve = read_curve(sampler, CurveTarget::weights)) {
        for (const int part : moved) {
          curve->joint = part;
          clip.curves.push_back(*curve);
        }
      }
      return;
    }
    const CurveTarget target = path == "translation" ? CurveTarget::translation
                               : path == "scale"     ? CurveTarget::scale
                                                     : CurveTarget::rotation;
    if (target == CurveTarget::rotation && path != "rotation") {
      ++unknown_paths;
      return;
    }
    const int joint = node < 0 ? -1 : choice.joint_of_node[static_cast<std::size_t>(node)];
    if (joint < 0) return;
    if (auto curve = read_curve(sampler, target)) {
      curve->joint = joint;
      clip.curves.push_back(std::move(*curve));
    }
  }
};

}  // namespace

std::vector<Clip> read_clips(const GltfDocument& document, const JointChoice& choice,
                             const std::vector<PartPlace>& parts, std::vector<std::string>& oddities) {
  ClipReader reader{document, choice, parts};
  std::vector<Clip> clips;
  for (int i = 0; i < document.count("animations"); ++i) {
    const JsonPlace animation = document.element("animations", i);
    Clip clip;
    clip.name = animation["name"].text_or("");
    const JsonPlace channels = animation["channels"];
    for (int c = 0; c < channels.size(); ++c) reader.read_channel(animation, channels[c], clip);
    clips.push_back(std::move(clip));
  }
  if (reader.out_of_order > 0) {
    oddities.push_back(std::to_string(reader.out_of_order) +
                       " animation channels have times that do not increase: they are kept, not played.");
  }
  if (reader.unknown_paths > 0) {
    oddities.push_back(std::to_string(reader.unknown_paths) +
                       " animation channels move something else than joints and shapes.");
  }
  return clips;
}

}  // namespace croquis
