// SPDX-License-Identifier: MIT
#include "croquis/picture/scene.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "croquis/base/error.h"

namespace croquis {
namespace {

/// Where bones stand in for a body: warm clay.
const Vec4f kClay(0.56F, 0.38F, 0.27F, 1.0F);

/// A part as it is to be drawn, in world space, double until it is moved to the origin.
struct Gathered {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;
  const std::vector<Vec2f>* uvs = nullptr;
  const std::vector<std::uint32_t>* triangles = nullptr;
  Material material;
};

/// True where the triangles turn their backs outward: a mirrored joint reverses the order of their corners.
bool is_inside_out(const Gathered& part) {
  double agreement = 0.0;
  const std::vector<std::uint32_t>& t = *part.triangles;
  for (std::size_t i = 0; i + 2 < t.size(); i += 3) {
    const Vec3f& a = part.positions[t[i]];
    const Vec3f face = (part.positions[t[i + 1]] - a).cross(part.positions[t[i + 2]] - a);
    agreement += static_cast<double>(face.dot(part.normals[t[i]] + part.normals[t[i + 1]] + part.normals[t[i + 2]]));
  }
  return agreement < 0.0;
}

void append(Scene& scene, const Gathered& part) {
  const auto first_vertex = static_cast<std::uint32_t>(scene.vertices.size());
  const Vec3f centre = scene.centre.cast<float>();
  const auto scale = static_cast<float>(1.0 / scene.radius);
  const bool has_uvs = part.uvs->size() == part.positions.size();
  for (std::size_t v = 0; v < part.positions.size(); ++v) {
    scene.vertices.push_back(
        {(part.positions[v] - centre) * scale, part.normals[v], has_uvs ? (*part.uvs)[v] : Vec2f(Vec2f::Zero())});
  }
  SceneDraw draw;
  draw.first = static_cast<int>(scene.triangles.size());
  draw.count = static_cast<int>(part.triangles->size());
  draw.base_color = part.material.base_color;
  if (has_uvs) draw.image = part.material.base_color_image;
  draw.double_sided = part.material.double_sided;
  draw.cut_out = part.material.cut_out;
  scene.draws.push_back(draw);
  const std::vector<std::uint32_t>& t = *part.triangles;
  const bool flip = is_inside_out(part);
  for (std::size_t i = 0; i + 2 < t.size(); i += 3) {
    const std::uint32_t second = t[flip ? i + 2 : i + 1], third = t[flip ? i + 1 : i + 2];
    for (const std::uint32_t v : {t[i], second, third}) scene.triangles.push_back(first_vertex + v);
  }
}

void check_actor(const PictureActor& actor) {
  if (actor.character == nullptr || actor.pose == nullptr) {
    throw_invalid_argument("render_picture: an actor wants a character and a pose");
  }
  const int joints = actor.character->skeleton.joint_count();
  if (std::ssize(actor.pose->local) != joints) {
    throw_invalid_argument("render_picture: the pose has " + std::to_string(actor.pose->local.size()) +
                           " joints, the skeleton " + std::to_string(joints));
  }
  for (std::size_t j = 0; j < actor.pose->local.size(); ++j) {
    if (actor.pose->local[j].is_finite()) continue;
    throw_invalid_argument("render_picture: the pose of joint " +
                           actor.character->skeleton.reference(static_cast<int>(j)) + " is not finite");
  }
}

/// The height of the floor in world space. A character that stands on y = 0 when it is opened may jump off it, but
/// never through it; any other stands on its lowest point.
double floor_height(const std::vector<PictureActor>& actors, const Box& box) {
  double lowest = box.min().y();
  for (const PictureActor& actor : actors) {
    Box standing;
    for (const Vec3& joint : compute_positions(actor.character->skeleton, actor.character->start))
      standing.extend(joint);
    const double reach = 0.2 * standing.sizes().maxCoeff();
    if (std::abs(standing.min().y()) <= reach) lowest = std::min(lowest, 0.0);
  }
  return lowest;
}

}  // namespace

Scene build_scene(const std::vector<PictureActor>& actors, SkinningMethod skinning) {
  const std::vector<Vec2f> no_uvs;
  std::vector<Gathered> gathered;
  std::vector<Mesh> bone_meshes(actors.size());
  for (std::size_t a = 0; a < actors.size(); ++a) {
    check_actor(actors[a]);
    const Character& character = *actors[a].character;
    int triangles = 0;
    for (const Part& part : character.parts) triangles += part.mesh.triangle_count();
    if (triangles == 0) {
      bone_meshes[a] = build_bone_mesh(character, *actors[a].pose);
      Material clay;
      clay.base_color = kClay;
      const Mesh& mesh = bone_meshes[a];
      if (!mesh.positions.empty()) gathered.push_back({mesh.positions, mesh.normals, &no_uvs, &mesh.triangles, clay});
      continue;
    }
    std::vector<PosedPart> posed = pose_character(character, *actors[a].pose, skinning);
    for (std::size_t p = 0; p < posed.size(); ++p) {
      const Mesh& mesh = character.parts[p].mesh;
      if (mesh.triangles.empty()) continue;
      if (posed[p].normals.size() != posed[p].positions.size()) {
        posed[p].normals = compute_normals(posed[p].positions, mesh.triangles);
      }
      gathered.push_back({std::move(posed[p].positions), std::move(posed[p].normals), &mesh.uvs, &mesh.triangles,
                          character.parts[p].material});
    }
  }

  Box box;
  for (const Gathered& part : gathered) {
    for (const std::uint32_t v : *part.triangles) box.extend(Vec3(part.positions[v].cast<double>()));
  }
  Scene scene;
  if (box.isEmpty()) return scene;
  if (!box.min().allFinite() || !box.max().allFinite()) {
    throw_invalid_argument("render_picture: the pose moves vertices beyond all measure");
  }
  scene.centre = box.center();
  scene.radius = std::max(0.5 * box.sizes().norm(), 1e-12);
  scene.floor = (floor_height(actors, box) - scene.centre.y()) / scene.radius;
  for (const Gathered& part : gathered) append(scene, part);
  return scene;
}

}  // namespace croquis
