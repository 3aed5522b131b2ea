// SPDX-License-Identifier: MIT
// Source: gltf2, section 3.9 "Materials".
#include "croquis/io/gltf_material.h"

#include <algorithm>

#include "croquis/base/text.h"

namespace croquis {

Material MaterialReader::read(int index, int& uv_set) {
  const JsonPlace place = document_.element("materials", index);
  if (!place.is_object()) place.fail("wanted an object");
  Material material;
  // The old specular-glossiness workflow calls its base colour diffuse.
  const JsonPlace old = place["extensions"]["KHR_materials_pbrSpecularGlossiness"];
  const bool is_old = old.exists() && !place["pbrMetallicRoughness"].exists();
  const JsonPlace colours = is_old ? old : place["pbrMetallicRoughness"];
  const JsonPlace factor = colours[is_old ? "diffuseFactor" : "baseColorFactor"];
  material.base_color = Vec4f(1.0F, 1.0F, 1.0F, 1.0F);
  if (factor.exists()) {
    const std::vector<double> rgba = factor.numbers(4);
    for (int i = 0; i < 4; ++i)
      material.base_color[i] = static_cast<float>(std::clamp(rgba[static_cast<std::size_t>(i)], 0.0, 1.0));
  }
  const JsonPlace texture = colours[is_old ? "diffuseTexture" : "baseColorTexture"];
  if (texture.exists()) {
    uv_set = static_cast<int>(texture["texCoord"].integer_or(0, 0, 1000));
    material.base_color_image = image_of_texture(texture["index"].index(document_.count("textures"), "texture"));
  }
  material.double_sided = place["doubleSided"].boolean_or(false);
  // A picture without sorting shows blended surfaces best as cut out: hair and lashes are drawn on clear planes.
  const std::string mode = place["alphaMode"].text_or("OPAQUE");
  material.cut_out = mode == "MASK" || mode == "BLEND";
  return material;
}

std::shared_ptr<const Bytes> MaterialReader::image_of_texture(int texture) {
  const JsonPlace place = document_.element("textures", texture);
  int image = place["source"].index_or_none(document_.count("images"), "image");
  if (image < 0) {
    for (const char* extension : {"EXT_texture_webp", "KHR_texture_basisu", "EXT_texture_avif"}) {
      const JsonPlace other = place["extensions"][extension]["source"];
      if (other.exists()) unreadable_.insert(std::string(extension));
    }
    return nullptr;
  }
  const auto found = images_.find(image);
  if (found != images_.end()) return found->second;
  std::shared_ptr<const Bytes> bytes = read_image(document_, image);
  if (bytes) {
    const std::string_view type = image_media_type(*bytes);
    if (type != "image/png" && type != "image/jpeg") {
      unreadable_.insert(type.empty() ? "an unknown kind of image" : std::string(type));
      bytes = nullptr;
    }
  }
  return images_[image] = bytes;
}

void MaterialReader::report(std::vector<std::string>& oddities) const {
  if (unreadable_.empty()) return;
  oddities.push_back("Some textures are " + join({unreadable_.begin(), unreadable_.end()}, ", ") +
                     ": they are kept, but pictures show them without.");
}

}  // namespace croquis
