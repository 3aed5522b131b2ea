// SPDX-License-Identifier: MIT
#include "croquis/io/camera_json.h"

#include "support/data.h"
#include "support/random_math.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

const char* const kOrthographic =
    R"({"projection":"orthographic","height":2.5,"position":[0,1,5],"target":[0,1,0],"up":[0,1,0],"width":800,"height_px":600})";

std::string error_of(const std::string& text) {
  try {
    (void)read_camera(bytes_of(text));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_file) << text;
    return error.what();
  }
  ADD_FAILURE() << "no error for " << text;
  return {};
}

TEST(CameraJson, ReadsBothProjections) {
  const Camera camera = read_camera(bytes_of(kOrthographic));
  EXPECT_EQ(camera.projection, Camera::Projection::orthographic);
  EXPECT_EQ(camera.height, 2.5);
  EXPECT_EQ(camera.position, Vec3(0, 1, 5));
  EXPECT_EQ(camera.width_px, 800);
  EXPECT_EQ(camera.height_px, 600);
  const Camera other =
      read_camera(bytes_of(R"({"projection":"perspective","fov_degrees":27,"position":[0,0,9],"target":[0,0,0]})"));
  EXPECT_EQ(other.projection, Camera::Projection::perspective);
  EXPECT_EQ(other.fov_degrees, 27.0);
  EXPECT_EQ(other.up, Vec3::UnitY());
  EXPECT_EQ(other.width_px, 1024);
}

TEST(CameraJson, GivesBackExactlyWhatWasWritten) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    Camera camera;
    camera.projection = i % 2 == 0 ? Camera::Projection::perspective : Camera::Projection::orthographic;
    camera.position = random_vector(random);
    camera.target = random_vector(random);
    camera.up = random_vector(random);
    if (i % 2 == 0)
      camera.fov_degrees = random.uniform(1, 179);
    else
      camera.height = random.uniform(0.1, 100);
    camera.width_px = 1 + random.index(4096);
    const Camera again = read_camera(bytes_of(write_camera(camera)));
    EXPECT_EQ(again.projection, camera.projection);
    EXPECT_EQ(again.position, camera.position);
    EXPECT_EQ(again.target, camera.target);
    EXPECT_EQ(again.up, camera.up);
    EXPECT_EQ(again.fov_degrees, camera.fov_degrees);
    EXPECT_EQ(again.height, camera.height);
    EXPECT_EQ(again.width_px, camera.width_px);
  }
}

TEST(CameraJson, SaysWhereAndWhatWasWanted) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = kOrthographic;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_EQ(error_of(with("orthographic", "fisheye")),
            "/projection: 'fisheye' is neither 'perspective' nor 'orthographic'");
  EXPECT_EQ(error_of(with("\"target\"", "\"traget\"")),
            "/traget: is no field of an orthographic camera; did you mean 'target'?");
  EXPECT_EQ(error_of(with("\"height\"", "\"fov_degrees\"")).substr(0, 60),
            "/fov_degrees: is no field of an orthographic camera; it has ");
  EXPECT_EQ(error_of(with("2.5", "\"2.5\"")), "/height: wanted a number");
  EXPECT_EQ(error_of(with("[0,1,5]", "[0,1]")), "/position: wanted 3 numbers, found 2");
  EXPECT_EQ(error_of(with("\"height\":2.5,", "")), "/height: is missing");
  EXPECT_NE(error_of(with("2.5", "-2.5")).find("height"), std::string::npos);
  EXPECT_NE(error_of(with("[0,1,5]", "[0,1,0]")).find("target"), std::string::npos);
  EXPECT_NE(error_of(with("800", "100000")).find("/width"), std::string::npos);
  EXPECT_NE(error_of(with("800", "8e99")).find("/width"), std::string::npos);
  EXPECT_NE(error_of(with("[0,1,5]", "[0,1,1e999]")), "");
  EXPECT_NE(error_of("[]"), "");
  EXPECT_NE(error_of(""), "");
}

TEST(CameraJson, EveryTruncationIsAnError) {
  const std::string text = kOrthographic;
  for (std::size_t length = 0; length < text.size(); ++length) EXPECT_NE(error_of(text.substr(0, length)), "");
}

}  // namespace
}  // namespace croquis
