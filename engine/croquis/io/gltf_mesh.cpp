// SPDX-License-Identifier: MIT
// Source: gltf2, sections 3.7 "Concepts" (meshes, skins, morph targets) and 3.11 "Accessor data".
#include "croquis/io/gltf_mesh.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/gltf_accessor.h"
#include "croquis/io/gltf_material.h"
#include "croquis/io/gltf_skin.h"

namespace croquis {
namespace {

constexpr int kTriangles = 4, kTriangleStrip = 5;  // and 6, a fan

int mode_of(const JsonPlace& primitive) { return static_cast<int>(primitive["mode"].integer_or(kTriangles, 0, 6)); }

void refuse_compression(const JsonPlace& primitive, const Accessor& positions) {
  const JsonPlace draco = primitive["extensions"]["KHR_draco_mesh_compression"];
  if (draco.exists() && !positions.place["bufferView"].exists() && !positions.place["sparse"].exists()) {
    throw Error(ErrorCode::unsupported,
                draco.pointer() + ": KHR_draco_mesh_compression is not read: export the file without mesh compression");
  }
}

std::vector<std::uint32_t> make_triangles(const std::vector<std::uint32_t>& corners, int mode) {
  std::vector<std::uint32_t> triangles;
  if (mode == kTriangles) {
    triangles.assign(corners.begin(), corners.begin() + std::ssize(corners) / 3 * 3);
    return triangles;
  }
  for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
    if (mode == kTriangleStrip) {
      const std::size_t odd = i % 2;
      triangles.insert(triangles.end(), {corners[i], corners[i + 1 + odd], corners[i + 2 - odd]});
    } else {
      triangles.insert(triangles.end(), {corners[i + 1], corners[i + 2], corners[0]});
    }
  }
  return triangles;
}

/// Reads the attributes of one primitive for the part's vertices.
class AttributeReader {
 public:
  AttributeReader(const GltfDocument& document, JsonPlace attributes, const std::vector<std::uint32_t>& elements,
                  int count)
      : document_(document), attributes_(std::move(attributes)), elements_(elements), count_(count) {}

  /// One vector per vertex; empty where the attribute is not there.
  template <class Vector>
  std::vector<Vector> read(const std::string& name) const {
    constexpr int kWidth = Vector::RowsAtCompileTime;
    const std::optional<Accessor> accessor = find(name, "VEC" + std::to_string(kWidth));
    if (!accessor) return {};
    const std::vector<float> numbers = read_floats(document_, *accessor);
    document_.budget.take(elements_.size(), sizeof(Vector), accessor->place);
    std::vector<Vector> vectors;
    vectors.reserve(elements_.size());
    for (const std::uint32_t element : elements_) vectors.emplace_back(numbers.data() + std::size_t{element} * kWidth);
    return vectors;
  }

 private:
  std::optional<Accessor> find(const std::string& name, const std::string& type) const {
    const JsonPlace place = attributes_[name];
    if (!place.exists()) return std::nullopt;
    Accessor accessor = find_accessor(document_, place, type);
    if (accessor.count != count_) {
      place.fail("wanted " + std::to_string(count_) + " elements as of POSITION, found " +
                 std::to_string(accessor.count));
    }
    return accessor;
  }

  const GltfDocument& document_;
  JsonPlace attributes_;
  const std::vector<std::uint32_t>& elements_;
  int count_;
};

std::vector<BlendShape> read_shapes(const GltfDocument& document, const JsonPlace& mesh, const JsonPlace& primitive,
                                    const std::vector<std::uint32_t>& elements, int count) {
  std::vector<BlendShape> shapes;
  const JsonPlace targets = primitive["targets"];
  const JsonPlace of_mesh = mesh["extras"].is_object() ? mesh["extras"]["targetNames"] : JsonPlace(nullptr, "");
  const JsonPlace of_primitive = primitive["extras"].is_object() ? primitive["extras"]["targetNames"] : of_mesh;
  const JsonPlace names = of_mesh.is_array() ? of_mesh : of_primitive;
  for (int i = 0; i < targets.size(); ++i) {
    const AttributeReader reader(document, targets[i], elements, count);
    BlendShape shape;
    if (names.is_array() && i < names.size() && names[i].is_text()) shape.name = names[i].text();
    shape.positions = reader.read<Vec3f>("POSITION");
    shape.normals = reader.read<Vec3f>("NORMAL");
    shape.tangents = reader.read<Vec3f>("TANGENT");
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

std::vector<float> read_shape_weights(const JsonPlace& node, const JsonPlace& mesh, std::size_t shapes) {
  std::vector<float> weights(shapes, 0.0F);
  const JsonPlace place = node["weights"].exists() ? node["weights"] : mesh["weights"];
  for (int i = 0; i < place.size() && i < std::ssize(weights); ++i) {
    weights[static_cast<std::size_t>(i)] = static_cast<float>(place[i].number());
    if (!std::isfinite(weights[static_cast<std::size_t>(i)])) place[i].fail("is too large");
  }
  return weights;
}

struct PartReader {
  const GltfDocument& document;
  const GltfNodes& nodes;
  const JointChoice& choice;
  MaterialReader materials;
  SkinReader skins;

  Part read(const PartPlace& where) {
    const JsonPlace node = document.element("nodes", where.node), mesh = document.element("meshes", where.mesh);
    const JsonPlace primitive = mesh["primitives"][where.primitive];
    const Accessor positions = find_accessor(document, primitive["attributes"]["POSITION"], "VEC3");
    refuse_compression(primitive, positions);
    PrimitiveTopology topology = read_topology(document, primitive);
    const AttributeReader reader(document, primitive["attributes"], topology.elements, positions.count);

    Part part;
    part.name = mesh["name"].text_or("");
    if (part.name.empty()) part.name = node["name"].text_or("");
    int uv_set = 0;
    const int material = primitive["material"].index_or_none(document.count("materials"), "material");
    if (material >= 0) part.material = materials.read(material, uv_set);
    part.mesh.positions = reader.read<Vec3f>("POSITION");
    part.mesh.normals = reader.read<Vec3f>("NORMAL");
    part.mesh.tangents = reader.read<Vec4f>("TANGENT");
    part.mesh.uvs = reader.read<Vec2f>("TEXCOORD_" + std::to_string(uv_set));
    part.shapes = read_shapes(document, mesh, primitive, topology.elements, positions.count);
    part.shape_weights = read_shape_weights(node, mesh, part.shapes.size());
    const int skin = nodes[where.node].skin;
    if (skin >= 0) part.skin = skins.read(skin, primitive["attributes"], topology.elements, positions.count);
    if (!part.skin) {
      const JointAbove above = find_joint_above(nodes, choice, where.node);
      part.joint = above.joint;
      part.joint_from_mesh = above.joint_from_node;
    }
    part.mesh.triangles = std::move(topology.triangles);
    return part;
  }
};

void report_skipped(const GltfDocument& document, const GltfNodes& nodes, std::vector<std::string>& oddities) {
  int lines = 0, unseen = 0;
  for (int i = 0; i < nodes.size(); ++i) {
    if (nodes[i].mesh < 0) continue;
    if (!nodes[i].in_scene) ++unseen;
    const JsonPlace primitives = document.element("meshes", nodes[i].mesh)["primitives"];
    for (int p = 0; p < primitives.size(); ++p) {
      if (mode_of(primitives[p]) < kTriangles) ++lines;
    }
  }
  if (lines > 0)
    oddities.push_back(std::to_string(lines) + " of its meshes are points or lines: they are kept, not shown.");
  if (unseen > 0) oddities.push_back(std::to_string(unseen) + " of its meshes are in no scene that is shown.");
}

}  // namespace

std::vector<PartPlace> list_parts(const GltfDocument& document, const GltfNodes& nodes) {
  std::vector<PartPlace> parts;
  for (const int node : nodes.order) {
    const int mesh = nodes[node].mesh;
    if (mesh < 0 || !nodes[node].in_scene) continue;
    const JsonPlace primitives = document.element("meshes", mesh)["primitives"];
    if (!primitives.exists()) primitives.fail("is missing");
    for (int p = 0; p < primitives.size(); ++p) {
      const JsonPlace primitive = primitives[p];
      if (mode_of(primitive) < kTriangles || !primitive["attributes"]["POSITION"].exists()) continue;
      parts.push_back({node, mesh, p});
    }
  }
  return parts;
}

PrimitiveTopology read_topology(const GltfDocument& document, const JsonPlace& primitive) {
  const auto count =
      static_cast<std::size_t>(find_accessor(document, primitive["attributes"]["POSITION"], "VEC3").count);
  document.budget.take(count, 8, primitive);
  PrimitiveTopology topology;
  std::vector<std::uint32_t> corners;
  const JsonPlace indices = primitive["indices"];
  std::vector<std::uint32_t> vertex_of_element(count, 0);
  std::size_t used = count;
  if (indices.exists()) {
    corners = read_integers(document, find_accessor(document, indices, "SCALAR"));
    used = 0;
    for (const std::uint32_t corner : corners) {
      if (corner >= count) {
        indices.fail("vertex " + std::to_string(corner) + " is not there: there are " + std::to_string(count));
      }
      used += vertex_of_element[corner] == 0 ? 1U : 0U;
      vertex_of_element[corner] = 1;
    }
  } else {
    corners.resize(count);
    std::iota(corners.begin(), corners.end(), 0U);
  }
  const bool compact = used * 2 < count;
  for (std::size_t element = 0; element < count; ++element) {
    if (compact && vertex_of_element[element] == 0) continue;
    vertex_of_element[element] = static_cast<std::uint32_t>(topology.elements.size());
    topology.elements.push_back(static_cast<std::uint32_t>(element));
  }
  for (std::uint32_t& corner : corners) corner = vertex_of_element[corner];
  topology.triangles = make_triangles(corners, mode_of(primitive));
  return topology;
}

std::vector<Part> read_parts(const GltfDocument& document, const GltfNodes& nodes, const JointChoice& choice,
                             std::vector<std::string>& oddities) {
  PartReader reader{document, nodes, choice, MaterialReader(document), SkinReader(document, choice)};
  std::vector<Part> parts;
  for (const PartPlace& where : list_parts(document, nodes)) parts.push_back(reader.read(where));
  report_skipped(document, nodes, oddities);
  reader.materials.report(oddities);
  reader.skins.report(oddities);
  return parts;
}

}  // namespace croquis
