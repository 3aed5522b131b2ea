// SPDX-License-Identifier: MIT
#include "croquis/io/camera_json.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/json_place.h"

namespace croquis {
namespace {

Vec3 read_vector(const JsonPlace& place) {
  const std::vector<double> numbers = place.numbers(3);
  return {numbers[0], numbers[1], numbers[2]};
}

Json to_json(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

/// The fields that a camera of this projection may have.
std::vector<std::string> known_fields(Camera::Projection projection) {
  const char* const size = projection == Camera::Projection::perspective ? "fov_degrees" : "height";
  return {"projection", "position", "target", "up", size, "width", "height_px"};
}

void check_fields(const JsonPlace& file, Camera::Projection projection) {
  const std::vector<std::string> known = known_fields(projection);
  const std::string shown = projection == Camera::Projection::perspective ? "a perspective" : "an orthographic";
  for (const std::string& key : file.keys()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string near = closest_word(key, known);
    file[key].fail("is no field of " + shown + " camera; " +
                   (near.empty() ? "it has " + join(known, ", ") : "did you mean '" + near + "'?"));
  }
}

}  // namespace

Camera read_camera(std::span<const std::byte> bytes) {
  const auto json = parse_json({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  const JsonPlace file(json.get(), "");
  const std::string projection = file["projection"].text();
  if (projection != "perspective" && projection != "orthographic") {
    file["projection"].fail("'" + printable(projection) + "' is neither 'perspective' nor 'orthographic'");
  }
  Camera camera;
  camera.projection = projection == "perspective" ? Camera::Projection::perspective : Camera::Projection::orthographic;
  check_fields(file, camera.projection);
  camera.position = read_vector(file["position"]);
  camera.target = read_vector(file["target"]);
  if (file["up"].exists()) camera.up = read_vector(file["up"]);
  if (camera.projection == Camera::Projection::perspective)
    camera.fov_degrees = file["fov_degrees"].number();
  else
    camera.height = file["height"].number();
  constexpr int kMostPixels = 16384;
  camera.width_px = static_cast<int>(file["width"].integer_or(camera.width_px, 1, kMostPixels));
  camera.height_px = static_cast<int>(file["height_px"].integer_or(camera.height_px, 1, kMostPixels));
  try {
    camera.check();
  } catch (const Error& error) {
    throw Error(ErrorCode::bad_file, error.what());  // it names the field; but the fault is the file's
  }
  return camera;
}

std::string write_camera(const Camera& camera) {
  camera.check();
  const bool perspective = camera.projection == Camera::Projection::perspective;
  Json json;
  json["projection"] = perspective ? "perspective" : "orthographic";
  if (perspective)
    json["fov_degrees"] = camera.fov_degrees;
  else
    json["height"] = camera.height;
  json["position"] = to_json(camera.position);
  json["target"] = to_json(camera.target);
  json["up"] = to_json(camera.up);
  json["width"] = camera.width_px;
  json["height_px"] = camera.height_px;
  return json.dump() + "\n";
}

}  // namespace croquis
