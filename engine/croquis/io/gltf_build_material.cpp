// SPDX-License-Identifier: MIT
#include "croquis/io/gltf_build_material.h"

#include <nlohmann/json.hpp>

namespace croquis {

int MaterialBuilder::add(const Material& material) {
  for (const auto& [other, index] : materials_) {
    if (other.base_color == material.base_color && other.base_color_image == material.base_color_image &&
        other.double_sided == material.double_sided && other.cut_out == material.cut_out) {
      return index;
    }
  }
  const Vec4f& c = material.base_color;
  Json colours = {{"baseColorFactor", {c[0], c[1], c[2], c[3]}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.9}};
  if (material.base_color_image != nullptr) {
    const int texture = add_texture(material.base_color_image);
    if (texture >= 0) colours["baseColorTexture"] = Json::object({{"index", texture}});
  }
  Json json = Json::object({{"pbrMetallicRoughness", std::move(colours)}});
  if (material.double_sided) json["doubleSided"] = true;
  if (material.cut_out) json["alphaMode"] = "MASK";
  materials_.emplace_back(material, editor_.append("materials", json));
  return materials_.back().second;
}

int MaterialBuilder::add_texture(const std::shared_ptr<const Bytes>& image) {
  const auto found = textures_.find(image);
  if (found != textures_.end()) return found->second;
  const std::string_view type = image_media_type(*image);
  if (type != "image/png" && type != "image/jpeg") return -1;
  const int source = editor_.append("images", {{"bufferView", editor_.add_view(*image)}, {"mimeType", type}});
  return textures_[image] = editor_.append("textures", Json::object({{"source", source}}));
}

}  // namespace croquis
