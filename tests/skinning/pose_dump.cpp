// SPDX-License-Identifier: MIT
// Poses a character at random (the same for the same seed) and prints the pose and the posed vertices as JSON, for
// three_check.mjs to do the same with three.js.
// usage: skinning_pose_dump FILE SEED
#include "support/random_math.h"
#include <cstdio>
#include <iostream>

#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/io/character_file.h"
#include "croquis/io/disk.h"
#include "croquis/skinning/skinning.h"

namespace croquis {
namespace {

using Json = nlohmann::json;

template <typename Vector>
Json numbers(const Vector& v) {
  Json list = Json::array();
  for (int c = 0; c < v.size(); ++c) list.push_back(v[c]);
  return list;
}

// Turns every joint of the file by up to 40 degrees, and scales every fourth one unevenly.
Json pose_at_random(const Character& character, Random& random, Pose& pose) {
  Json nodes = Json::object();
  for (std::size_t joint = 0; joint < pose.local.size(); ++joint) {
    const int node = character.source_nodes[joint];
    if (node < 0) continue;
    Transform& local = pose.local[joint];
    const Vec3 axis = random_vector(random).normalized();
    local.rotation = local.rotation * Quat(Eigen::AngleAxisd(random.uniform(0.0, 40.0) * kDegree, axis));
    if (random.index(4) == 0) local.scale = local.scale.cwiseProduct(Vec3(1.2, 0.9, 1.1));
    nodes[std::to_string(node)] = {{"translation", numbers(local.translation)},
                                   {"rotation", numbers(local.rotation.coeffs())},
                                   {"scale", numbers(local.scale)}};
  }
  return nodes;
}

Json dump(const Character& character, std::uint64_t seed) {
  Random random(seed);
  Pose pose = character.start;
  const Json nodes = pose_at_random(character, random, pose);
  const std::vector<Affine> model = compute_model_transforms(character.skeleton, pose);
  Json parts = Json::array();
  for (const Part& part : character.parts) {
    std::vector<float> weights(part.shapes.size());
    for (float& weight : weights) weight = static_cast<float>(random.uniform(0.0, 1.0));
    const PosedPart posed = pose_part(part, model, weights);
    Json positions = Json::array(), normals = Json::array();
    for (const Vec3f& p : posed.positions) positions.push_back(numbers(p));
    for (const Vec3f& n : posed.normals) normals.push_back(numbers(n));
    parts.push_back({{"name", part.name},
                     {"weights", weights},
                     {"influences", part.skin ? part.skin->influences : 0},
                     {"positions", positions},
                     {"normals", normals}});
  }
  return {{"nodes", nodes}, {"parts", parts}};
}

}  // namespace
}  // namespace croquis

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: skinning_pose_dump FILE SEED\n");
    return 2;
  }
  try {
    const croquis::Bytes bytes = croquis::read_file(argv[1]);
    const croquis::Character character = croquis::read_character(bytes, argv[1], croquis::resources_beside(argv[1]));
    std::cout << croquis::dump(character, std::stoull(argv[2])) << '\n';
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
