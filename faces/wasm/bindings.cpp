// SPDX-License-Identifier: MIT
// The drawing table for JavaScript. Every function that can fail answers JSON: its result, or {"error": {"code",
// "message"}}; a C++ exception never leaves this file. Buffers are views of engine memory that live until the next
// call: copy them.
#include <string>
#include <vector>

#include <emscripten/bind.h>
#include <emscripten/val.h>
#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/edit/screen_form.h"
#include "croquis/edit/table.h"

namespace {

using croquis::Part;
using emscripten::typed_memory_view;
using emscripten::val;

std::string failure(std::string_view code, const char* message) {
  const nlohmann::json error{{"error", {{"code", code}, {"message", message}}}};
  return error.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

template <class Action>
std::string guarded(Action action) {
  try {
    return action();
  } catch (const croquis::Error& error) {
    return failure(to_string(error.code()), error.what());
  } catch (const std::bad_alloc&) {
    return failure("internal", "out of memory: the file is too large for this browser tab");
  } catch (const std::exception& error) {
    return failure("internal", error.what());
  }
}

croquis::Bytes bytes_of(const val& array) {
  croquis::Bytes bytes(array["length"].as<std::size_t>());
  val(typed_memory_view(bytes.size(), reinterpret_cast<unsigned char*>(bytes.data()))).call<void>("set", array);
  return bytes;
}

class BoundTable {
 public:
  std::string execute(const std::string& command, const val& file) {
    return guarded([&] { return table_.execute(command, bytes_of(file)); });
  }
  std::string preview(const std::string& command) {
    return guarded([&] { return table_.preview(command); });
  }
  std::string cancel_preview() {
    return guarded([&] { return table_.cancel_preview(); });
  }
  std::string undo() {
    return guarded([&] { return table_.undo(); });
  }
  std::string redo() {
    return guarded([&] { return table_.redo(); });
  }
  std::string restore(const val& file) {
    return guarded([&] { return table_.restore(bytes_of(file)); });
  }
  std::string query(const std::string& name, const std::string& arguments) {
    return guarded([&] { return table_.query(name, arguments); });
  }
  std::string prepare_export(const std::string& format, int actor, const std::string& options) {
    return guarded([&] {
      exported_ = table_.export_file(format, actor, options);
      return std::string("{}");
    });
  }
  val exported() const {
    return val(typed_memory_view(exported_.size(), reinterpret_cast<const unsigned char*>(exported_.data())));
  }

  /// Forgets everything, history too.
  void begin() { table_ = croquis::Table(); }

  val palette(int actor, bool dual) {
    return shown(croquis::make_screen_palette(table_.shown_actor(actor), method(dual)));
  }
  val joint_positions(int actor) { return shown(croquis::make_screen_joints(table_.shown_actor(actor))); }
  val vertices(int actor, int part, bool dual) {
    return shown(croquis::make_screen_vertices(table_.shown_actor(actor), part, method(dual)));
  }

  std::string part_info(int actor, int part) {
    return guarded([&] {
      const Part& chosen = part_of(actor, part);
      nlohmann::json shapes = nlohmann::json::array();
      for (const float weight : chosen.shape_weights) shapes.push_back({{"weight", weight}});
      return nlohmann::json{{"influences", chosen.skin ? chosen.skin->influences : 1},
                            {"shapes", shapes},
                            {"has_image", chosen.material.base_color_image != nullptr}}
          .dump();
    });
  }

  /// One buffer of a part by its name; `shape` counts blend shapes, -1 for the mesh itself.
  val buffer(int actor, int part, const std::string& what, int shape) {
    const Part& chosen = part_of(actor, part);
    if (what == "triangles") return val(typed_memory_view(chosen.mesh.triangles.size(), chosen.mesh.triangles.data()));
    if (what == "joint_indices") {
      indices_ = chosen.skin ? chosen.skin->joint_indices : std::vector<std::uint16_t>(chosen.mesh.positions.size(), 0);
      return val(typed_memory_view(indices_.size(), indices_.data()));
    }
    if (what == "weights") {
      return shown(chosen.skin ? chosen.skin->weights : std::vector<float>(chosen.mesh.positions.size(), 1.0F));
    }
    if (what == "image") {
      const croquis::Bytes& image = *chosen.material.base_color_image;
      return val(typed_memory_view(image.size(), reinterpret_cast<const unsigned char*>(image.data())));
    }
    if (what == "uvs") return floats(chosen.mesh.uvs);
    if (what == "positions") return floats(chosen.mesh.positions);
    if (what == "normals") return floats(chosen.mesh.normals);
    const croquis::BlendShape& target = chosen.shapes.at(static_cast<std::size_t>(shape));
    return floats(what == "shape_positions" ? target.positions : target.normals);
  }

 private:
  const Part& part_of(int actor, int part) const {
    return table_.shown_actor(actor).character->parts.at(static_cast<std::size_t>(part));
  }
  val shown(std::vector<float> numbers) {
    numbers_ = std::move(numbers);
    return val(typed_memory_view(numbers_.size(), numbers_.data()));
  }
  static croquis::SkinningMethod method(bool dual) {
    return dual ? croquis::SkinningMethod::dual_quaternion : croquis::SkinningMethod::linear;
  }
  template <class Vector>
  static val floats(const std::vector<Vector>& vectors) {
    const auto* first = reinterpret_cast<const float*>(vectors.data());
    return val(typed_memory_view(vectors.size() * Vector::RowsAtCompileTime, first));
  }

  croquis::Table table_;
  croquis::Bytes exported_;
  std::vector<float> numbers_;
  std::vector<std::uint16_t> indices_;
};

}  // namespace

EMSCRIPTEN_BINDINGS(croquis) {
  emscripten::class_<BoundTable>("Table")
      .constructor<>()
      .function("begin", &BoundTable::begin)
      .function("execute", &BoundTable::execute)
      .function("preview", &BoundTable::preview)
      .function("cancelPreview", &BoundTable::cancel_preview)
      .function("undo", &BoundTable::undo)
      .function("redo", &BoundTable::redo)
      .function("restore", &BoundTable::restore)
      .function("query", &BoundTable::query)
      .function("prepareExport", &BoundTable::prepare_export)
      .function("exported", &BoundTable::exported)
      .function("palette", &BoundTable::palette)
      .function("jointPositions", &BoundTable::joint_positions)
      .function("vertices", &BoundTable::vertices)
      .function("partInfo", &BoundTable::part_info)
      .function("buffer", &BoundTable::buffer);
}
