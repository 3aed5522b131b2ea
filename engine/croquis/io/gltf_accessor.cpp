// SPDX-License-Identifier: MIT
// Source: gltf2, section 3.6.2 "Accessors".
#include "croquis/io/gltf_accessor.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF's numbers are little-endian");

constexpr std::array<std::pair<std::string_view, int>, 7> kWidths = {
    {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};

ComponentType component_type(const JsonPlace& place) {
  switch (place.integer(0, 65535)) {
    case 5120:
      return ComponentType::int8;
    case 5121:
      return ComponentType::uint8;
    case 5122:
      return ComponentType::int16;
    case 5123:
      return ComponentType::uint16;
    case 5125:
      return ComponentType::uint32;
    case 5126:
      return ComponentType::float32;
    default:
      place.fail("wanted 5120, 5121, 5122, 5123, 5125 or 5126");
  }
}

bool is_integer(ComponentType type) { return type != ComponentType::float32; }

/// Elements of `element_bytes` bytes, `stride` bytes apart.
struct Layout {
  std::span<const std::byte> bytes;
  std::size_t stride = 0;
};

/// The layout of `count` elements that start at an offset in a buffer view. Throws bad_file unless all lie in it.
Layout find_layout(const GltfDocument& document, const JsonPlace& place, std::int64_t count, std::int64_t element_bytes,
                   bool may_stride) {
  const int view = place["bufferView"].index(document.count("bufferViews"), "buffer view");
  const auto bytes = document.buffer_view(view);
  const JsonPlace stride_place = document.element("bufferViews", view)["byteStride"];
  std::int64_t stride = element_bytes;
  if (may_stride && stride_place.exists()) {
    stride = stride_place.integer(1, 65535);
    if (stride < element_bytes) {
      stride_place.fail("elements of " + std::to_string(element_bytes) + " bytes cannot stand " +
                        std::to_string(stride) + " bytes apart");
    }
  }
  const std::int64_t offset = place["byteOffset"].integer_or(0, 0, std::int64_t{1} << 40);
  const auto size = static_cast<std::int64_t>(bytes.size());
  // count < 2^31 and stride < 2^16: no overflow.
  if (offset > size || (count - 1) * stride + element_bytes > size - offset) {
    place.fail("wanted " + std::to_string(count) + " elements of " + std::to_string(element_bytes) + " bytes in the " +
               std::to_string(std::max<std::int64_t>(size - offset, 0)) + " bytes that are left of buffer view " +
               std::to_string(view));
  }
  return {bytes.subspan(static_cast<std::size_t>(offset)), static_cast<std::size_t>(stride)};
}

double component_at(const std::byte* at, ComponentType type) {
  const auto load = [at](auto value) {
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
  };
  switch (type) {
    case ComponentType::int8:
      return load(std::int8_t{});
    case ComponentType::uint8:
      return load(std::uint8_t{});
    case ComponentType::int16:
      return load(std::int16_t{});
    case ComponentType::uint16:
      return load(std::uint16_t{});
    case ComponentType::uint32:
      return load(std::uint32_t{});
    case ComponentType::float32:
      return load(float{});
  }
  return 0.0;
}

/// What a normalised integer is divided by.
double full_scale(ComponentType type) {
  switch (type) {
    case ComponentType::int8:
      return 127.0;
    case ComponentType::uint8:
      return 255.0;
    case ComponentType::int16:
      return 32767.0;
    case ComponentType::uint16:
      return 65535.0;
    case ComponentType::uint32:
      return 4294967295.0;
    case ComponentType::float32:
      break;
  }
  return 1.0;
}

/// Hands each element's bytes to `put(element index, bytes)`, the sparse ones after the others.
void for_each_element(const GltfDocument& document, const Accessor& accessor,
                      const std::function<void(std::size_t, const std::byte*)>& put) {
  const std::int64_t element_bytes = std::int64_t{accessor.width} * byte_size(accessor.component);
  if (accessor.place["bufferView"].exists()) {
    const Layout layout = find_layout(document, accessor.place, accessor.count, element_bytes, true);
    for (std::size_t i = 0; i < static_cast<std::size_t>(accessor.count); ++i) {
      put(i, layout.bytes.data() + i * layout.stride);
    }
  }
  const JsonPlace sparse = accessor.place["sparse"];
  if (!sparse.exists()) return;
  const auto count = sparse["count"].integer(1, accessor.count);
  const JsonPlace indices = sparse["indices"];
  const ComponentType type = component_type(indices["componentType"]);
  if (type != ComponentType::uint8 && type != ComponentType::uint16 && type != ComponentType::uint32) {
    indices["componentType"].fail("wanted 5121, 5123 or 5125");
  }
  const Layout index_layout = find_layout(document, indices, count, byte_size(type), false);
  const Layout value_layout = find_layout(document, sparse["values"], count, element_bytes, false);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const double index = component_at(index_layout.bytes.data() + i * index_layout.stride, type);
    if (index >= accessor.count) indices.fail("element " + format_double(index, 17) + " is not there");
    put(static_cast<std::size_t>(index), value_layout.bytes.data() + i * value_layout.stride);
  }
}

}  // namespace

int byte_size(ComponentType type) {
  switch (type) {
    case ComponentType::int8:
    case ComponentType::uint8:
      return 1;
    case ComponentType::int16:
    case ComponentType::uint16:
      return 2;
    case ComponentType::uint32:
    case ComponentType::float32:
      break;
  }
  return 4;
}

Accessor find_accessor(const GltfDocument& document, int index) {
  Accessor accessor{.place = document.element("accessors", index)};
  const JsonPlace& place = accessor.place;
  accessor.type = place["type"].text();
  const auto width =
      std::find_if(kWidths.begin(), kWidths.end(), [&](const auto& w) { return w.first == accessor.type; });
  if (width == kWidths.end()) place["type"].fail("wanted SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4");
  accessor.width = width->second;
  accessor.component = component_type(place["componentType"]);
  if (accessor.type.starts_with("MAT") && is_integer(accessor.component)) {
    place["componentType"].fail("a matrix of integers is not read");
  }
  accessor.count = static_cast<int>(place["count"].integer(1, 2147483647));
  accessor.normalized = place["normalized"].boolean_or(false);
  if (place["bufferView"].exists()) {
    (void)find_layout(document, place, accessor.count, std::int64_t{accessor.width} * byte_size(accessor.component),
                      true);
  }
  return accessor;
}

Accessor find_accessor(const GltfDocument& document, const JsonPlace& place, std::string_view types) {
  Accessor accessor = find_accessor(document, place.index(document.count("accessors"), "accessor"));
  const std::vector<std::string> wanted = split(types, '|');
  if (std::find(wanted.begin(), wanted.end(), accessor.type) == wanted.end()) {
    accessor.place["type"].fail("wanted " + join(wanted, " or ") + " for " + place.pointer() + ", found " +
                                accessor.type);
  }
  return accessor;
}

std::vector<float> read_floats(const GltfDocument& document, const Accessor& accessor) {
  const auto width = static_cast<std::size_t>(accessor.width);
  document.budget.take(static_cast<std::uint64_t>(accessor.count), width * sizeof(float), accessor.place);
  std::vector<float> numbers(static_cast<std::size_t>(accessor.count) * width, 0.0F);
  if (!is_integer(accessor.component)) {
    for_each_element(document, accessor, [&](std::size_t element, const std::byte* bytes) {
      std::memcpy(numbers.data() + element * width, bytes, width * sizeof(float));
    });
  } else {
    const auto step = static_cast<std::size_t>(byte_size(accessor.component));
    const double scale = accessor.normalized ? full_scale(accessor.component) : 1.0;
    for_each_element(document, accessor, [&](std::size_t element, const std::byte* bytes) {
      for (std::size_t k = 0; k < width; ++k) {
        const double value = component_at(bytes + k * step, accessor.component) / scale;
        // -128/127 means -1 (gltf2, 3.11).
        numbers[element * width + k] = static_cast<float>(accessor.normalized ? std::max(value, -1.0) : value);
      }
    });
  }
  const auto bad = std::find_if(numbers.begin(), numbers.end(), [](float value) { return !std::isfinite(value); });
  if (bad != numbers.end()) {
    accessor.place.fail("element " + std::to_string(static_cast<std::size_t>(bad - numbers.begin()) / width) +
                        " holds a number that is not finite");
  }
  return numbers;
}

std::vector<std::uint32_t> read_integers(const GltfDocument& document, const Accessor& accessor) {
  if (accessor.component != ComponentType::uint8 && accessor.component != ComponentType::uint16 &&
      accessor.component != ComponentType::uint32) {
    accessor.place["componentType"].fail("wanted unsigned integers: 5121, 5123 or 5125");
  }
  const auto width = static_cast<std::size_t>(accessor.width);
  const auto step = static_cast<std::size_t>(byte_size(accessor.component));
  document.budget.take(static_cast<std::uint64_t>(accessor.count), width * sizeof(std::uint32_t), accessor.place);
  std::vector<std::uint32_t> numbers(static_cast<std::size_t>(accessor.count) * width, 0);
  for_each_element(document, accessor, [&](std::size_t element, const std::byte* bytes) {
    for (std::size_t k = 0; k < width; ++k) {
      numbers[element * width + k] = static_cast<std::uint32_t>(component_at(bytes + k * step, accessor.component));
    }
  });
  return numbers;
}

}  // namespace croquis
