// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "croquis/io/gltf_document.h"

namespace croquis {

/// What glTF's numbers mean in an accessor's componentType.
enum class ComponentType { int8 = 5120, uint8 = 5121, int16 = 5122, uint16 = 5123, uint32 = 5125, float32 = 5126 };
[[nodiscard]] int byte_size(ComponentType type);

/// An accessor whose numbers are known to lie in its buffers.
struct Accessor {
  JsonPlace place;
  std::string type;  ///< "SCALAR", "VEC3", "MAT4", ...
  int width = 0;     ///< numbers per element
  int count = 0;     ///< elements
  ComponentType component = ComponentType::float32;
  bool normalized = false;
};

/// Checks everything that can be wrong with an accessor short of its values: types, strides, offsets, sizes, the
/// indices of a sparse one. Throws bad_file, or unsupported for data that are compressed.
[[nodiscard]] Accessor find_accessor(const GltfDocument& document, int index);
/// The accessor that `place` names. Throws bad_file unless it has one of the `types` (joined by '|': "VEC3|VEC4").
[[nodiscard]] Accessor find_accessor(const GltfDocument& document, const JsonPlace& place, std::string_view types);

/// width * count numbers; integers are scaled to -1..1 or 0..1 where the accessor is normalised, sparse values put in.
/// Throws bad_file, naming the accessor, for a number that is not finite.
[[nodiscard]] std::vector<float> read_floats(const GltfDocument& document, const Accessor& accessor);
/// The same as they stand in the file; throws bad_file unless the components are unsigned integers.
[[nodiscard]] std::vector<std::uint32_t> read_integers(const GltfDocument& document, const Accessor& accessor);

}  // namespace croquis
