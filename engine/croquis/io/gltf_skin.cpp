// SPDX-License-Identifier: MIT
// Source: gltf2, section 3.7.3 "Skins".
#include "croquis/io/gltf_skin.h"

#include <cmath>

#include "croquis/base/text.h"
#include "croquis/io/gltf_accessor.h"

namespace croquis {
namespace {

constexpr int kMostSets = 4;             // JOINTS_0 ... JOINTS_3: sixteen influences
constexpr double kSumTolerance = 0.005;  // what 8-bit weights may miss 1 by

std::vector<Affine> read_inverse_bind(const GltfDocument& document, int skin, std::size_t joints) {
  std::vector<Affine> matrices(joints, Affine::Identity());
  const JsonPlace place = document.element("skins", skin)["inverseBindMatrices"];
  if (!place.exists()) return matrices;
  const Accessor accessor = find_accessor(document, place, "MAT4");
  if (static_cast<std::size_t>(accessor.count) < joints) {
    place.fail("wanted " + std::to_string(joints) + " matrices, one per joint, found " +
               std::to_string(accessor.count));
  }
  const std::vector<float> numbers = read_floats(document, accessor);
  for (std::size_t i = 0; i < joints; ++i) {
    matrices[i].matrix() = Eigen::Map<const Eigen::Matrix4f>(numbers.data() + 16 * i).cast<double>();
    matrices[i].makeAffine();  // the last row is 0 0 0 1 whatever the file says
  }
  return matrices;
}

/// The joints and weights of one primitive, slot by slot, as they stand in the file.
struct RawSet {
  Accessor joints_accessor, weights_accessor;
  std::vector<std::uint32_t> joints;
  std::vector<float> weights;
};

std::vector<RawSet> read_sets(const GltfDocument& document, const JsonPlace& attributes, int count) {
  std::vector<RawSet> sets;
  for (int k = 0; k < kMostSets; ++k) {
    const JsonPlace joints = attributes["JOINTS_" + std::to_string(k)];
    const JsonPlace weights = attributes["WEIGHTS_" + std::to_string(k)];
    if (!joints.exists() && !weights.exists()) break;
    RawSet set{find_accessor(document, joints, "VEC4"), find_accessor(document, weights, "VEC4"), {}, {}};
    for (const Accessor& accessor : {set.joints_accessor, set.weights_accessor}) {
      if (accessor.count == count) continue;
      accessor.place.fail("wanted " + std::to_string(count) + " elements as of POSITION, found " +
                          std::to_string(accessor.count));
    }
    set.joints = read_integers(document, set.joints_accessor);
    set.weights = read_floats(document, set.weights_accessor);
    sets.push_back(std::move(set));
  }
  return sets;
}

}  // namespace

const SkinReader::Palette& SkinReader::palette(int skin) {
  const auto found = palettes_.find(skin);
  if (found != palettes_.end()) return found->second;
  Palette palette;
  for (const int node : read_skin_joints(document_, skin)) {
    palette.joints.push_back(choice_.joint_of_node[static_cast<std::size_t>(node)]);
  }
  palette.inverse_bind = read_inverse_bind(document_, skin, palette.joints.size());
  return palettes_[skin] = std::move(palette);
}

std::optional<Skin> SkinReader::read(int index, const JsonPlace& attributes, const std::vector<std::uint32_t>& elements,
                                     int count) {
  const std::vector<RawSet> sets = read_sets(document_, attributes, count);
  if (sets.empty()) return std::nullopt;
  const Palette& joints = palette(index);
  Skin skin;
  skin.joints = joints.joints;
  skin.inverse_bind = joints.inverse_bind;
  skin.influences = 4 * static_cast<int>(sets.size());
  document_.budget.take(elements.size(), static_cast<std::uint64_t>(skin.influences) * 6, attributes);
  document_.budget.take(joints.joints.size(), sizeof(Affine), attributes);
  skin.joint_indices.reserve(elements.size() * static_cast<std::size_t>(skin.influences));
  skin.weights.reserve(elements.size() * static_cast<std::size_t>(skin.influences));
  for (const std::uint32_t element : elements) {
    const std::size_t first = skin.weights.size();
    double sum = 0.0;
    for (const RawSet& set : sets) {
      for (std::size_t slot = 4 * std::size_t{element}; slot < 4 * std::size_t{element} + 4; ++slot) {
        const float weight = set.weights[slot];
        const std::uint32_t joint = set.joints[slot];
        if (weight < 0.0F || weight > 1e6F) {
          set.weights_accessor.place.fail("vertex " + std::to_string(element) + " has the weight " +
                                          format_double(weight));
        }
        if (weight > 0.0F && joint >= joints.joints.size()) {
          set.joints_accessor.place.fail("vertex " + std::to_string(element) + " hangs on joint " +
                                         std::to_string(joint) + " of a skin that has " +
                                         std::to_string(joints.joints.size()));
        }
        skin.weights.push_back(weight);
        skin.joint_indices.push_back(weight > 0.0F ? static_cast<std::uint16_t>(joint) : std::uint16_t{0});
        sum += weight;
      }
    }
    if (sum == 0.0)
      ++without_weight_;
    else if (std::abs(sum - 1.0) > kSumTolerance)
      ++not_normalised_;
    // Down to 1 in double before the rounding of the common pass, which then changes nothing but the order.
    for (std::size_t i = first; sum > 0.0 && i < skin.weights.size(); ++i) {
      skin.weights[i] = static_cast<float>(skin.weights[i] / sum);
    }
  }
  normalise_weights(skin);
  return skin;
}

void SkinReader::report(std::vector<std::string>& oddities) const {
  if (not_normalised_ > 0) {
    oddities.push_back("The weights of " + std::to_string(not_normalised_) +
                       " vertices do not sum to 1; they are taken as if they did.");
  }
  if (without_weight_ > 0) {
    oddities.push_back(std::to_string(without_weight_) +
                       " vertices hang on no joint; they follow the first one of their skin.");
  }
}

}  // namespace croquis
