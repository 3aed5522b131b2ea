// SPDX-License-Identifier: MIT
#include "croquis/io/gltf_bake.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/io/gltf_accessor.h"
#include "croquis/io/gltf_mesh.h"
#include "croquis/io/gltf_vertices.h"

namespace croquis {
namespace {

/// model_from_node of every node, as the file has it.
std::vector<Affine> model_from_nodes(const GltfNodes& nodes) {
  std::vector<Affine> model(static_cast<std::size_t>(nodes.size()), Affine::Identity());
  for (const int node : nodes.order) {
    const int parent = nodes[node].parent;
    model[static_cast<std::size_t>(node)] =
        parent < 0 ? nodes[node].matrix : Affine(model[static_cast<std::size_t>(parent)] * nodes[node].matrix);
  }
  return model;
}

class Baker {
 public:
  Baker(GltfEditor& editor, const GltfDocument& document, const GltfNodes& nodes)
      : editor_(editor), document_(document), model_(model_from_nodes(nodes)) {
    for (int i = 0; i < nodes.size(); ++i) {
      if (nodes[i].mesh >= 0) ++users_[nodes[i].mesh];
    }
  }

  void bake(const PartPlace& where, const BakedPart& part) {
    const Affine& model = model_[static_cast<std::size_t>(where.node)];
    if (!(std::abs(model.linear().determinant()) > 1e-30)) {
      throw Error(ErrorCode::unsupported, "/nodes/" + std::to_string(where.node) +
                                              ": it is scaled to nothing, so no mesh can be baked under it");
    }
    const JsonPlace source = document_.element("meshes", where.mesh)["primitives"][where.primitive];
    // A primitive that uses a part of a shared accessor gets an accessor of its own: the others keep theirs.
    const PrimitiveTopology topology = read_topology(document_, source);
    const auto count =
        static_cast<std::size_t>(find_accessor(document_, source["attributes"]["POSITION"], "VEC3").count);
    const Spread spread{topology.elements, count};

    Json& primitive = mesh_of(where)["primitives"][static_cast<std::size_t>(where.primitive)];
    Json& attributes = primitive["attributes"];
    const VertexSpace space(model.inverse());
    attributes["POSITION"] = add(spread.all(space.points(part.positions)), true);
    if (!part.normals.empty()) attributes["NORMAL"] = add(spread.all(space.normals(part.normals)), false);
    if (!part.tangents.empty()) attributes["TANGENT"] = add(spread.all(space.tangents(part.tangents)), false);
    for (int k = 0; attributes.contains("JOINTS_" + std::to_string(k)); ++k) {
      attributes.erase("JOINTS_" + std::to_string(k));
      attributes.erase("WEIGHTS_" + std::to_string(k));
    }
    for (std::size_t i = 0; i < part.shapes.size(); ++i) {
      Json& target = primitive["targets"][i];
      const BlendShape& shape = part.shapes[i];
      if (target.contains("POSITION")) target["POSITION"] = add(spread.all(space.vectors(shape.positions)), true);
      if (target.contains("NORMAL")) target["NORMAL"] = add(spread.all(space.vectors(shape.normals)), false);
      if (target.contains("TANGENT")) target["TANGENT"] = add(spread.all(space.vectors(shape.tangents)), false);
    }
  }

  void clear_nodes() {
    for (const int node : baked_nodes_) {
      Json& json = node_json(node);
      json.erase("skin");
      if (json.contains("weights")) json["weights"] = std::vector<double>(json["weights"].size(), 0.0);
      Json& mesh = editor_.json()["meshes"][json["mesh"].get<std::size_t>()];
      if (mesh.contains("weights")) mesh["weights"] = std::vector<double>(mesh["weights"].size(), 0.0);
    }
  }

 private:
  /// The part's vertices put where its accessor elements were; elements that no triangle uses repeat the first.
  struct Spread {
    const std::vector<std::uint32_t>& elements;
    std::size_t count;

    template <class Vector>
    std::vector<Vector> all(const std::vector<Vector>& vertices) const {
      if (vertices.empty()) return std::vector<Vector>(count, Vector::Zero());
      std::vector<Vector> spread(count, vertices.front());
      for (std::size_t i = 0; i < vertices.size(); ++i) spread[elements[i]] = vertices[i];
      return spread;
    }
  };

  template <class Vector>
  int add(const std::vector<Vector>& vectors, bool bounds) {
    return add_vectors(editor_, vectors, bounds);
  }

  Json& node_json(int node) { return editor_.json()["nodes"][static_cast<std::size_t>(node)]; }

  /// The mesh of a node, copied first if others show it too.
  Json& mesh_of(const PartPlace& where) {
    if (baked_nodes_.insert(where.node).second && users_[where.mesh] > 1) {
      --users_[where.mesh];
      const Json copy = document_.element("meshes", where.mesh).json();
      node_json(where.node)["mesh"] = editor_.append("meshes", copy);
    }
    return editor_.json()["meshes"][node_json(where.node)["mesh"].get<std::size_t>()];
  }

  GltfEditor& editor_;
  const GltfDocument& document_;
  std::vector<Affine> model_;
  std::map<int, int> users_;  ///< mesh -> nodes that show it
  std::set<int> baked_nodes_;
};

}  // namespace

void check_baked(const Character& character, const std::vector<BakedPart>& baked) {
  if (baked.size() != character.parts.size()) {
    throw_invalid_argument("write_character: wanted " + std::to_string(character.parts.size()) + " baked parts, got " +
                           std::to_string(baked.size()));
  }
  for (std::size_t i = 0; i < baked.size(); ++i) {
    const Part& part = character.parts[i];
    const std::size_t count = part.mesh.positions.size();
    const auto fits = [&](std::size_t size, bool wanted) { return size == (wanted ? count : 0); };
    if (baked[i].positions.size() != count || !fits(baked[i].normals.size(), !part.mesh.normals.empty()) ||
        !fits(baked[i].tangents.size(), !part.mesh.tangents.empty()) ||
        (!baked[i].shapes.empty() && baked[i].shapes.size() != part.shapes.size())) {
      throw_invalid_argument("write_character: baked part " + std::to_string(i) + " does not fit its mesh");
    }
  }
}

void bake_parts(GltfEditor& editor, const GltfDocument& document, const GltfNodes& nodes, const Character& character,
                const std::vector<BakedPart>& baked) {
  check_baked(character, baked);
  const std::vector<PartPlace> places = list_parts(document, nodes);
  if (places.size() != baked.size()) throw_invalid_argument("write_character: the parts are not those of the source");
  Baker baker(editor, document, nodes);
  for (std::size_t i = 0; i < places.size(); ++i) baker.bake(places[i], baked[i]);
  baker.clear_nodes();
}

}  // namespace croquis
