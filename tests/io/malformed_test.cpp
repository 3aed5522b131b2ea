// SPDX-License-Identifier: MIT
// Broken files end in an Error or in a valid character, in bounded time and memory.
#include "support/data.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/io/character_file.h"
#include "croquis/io/disk.h"

namespace croquis {
namespace {

/// "ok", or the error's text; fails the test on any other end.
std::string outcome(const Bytes& bytes, const std::string& name, const ResourceReader& resources) {
  try {
    read_character(bytes, name, resources).check();
    return "ok";
  } catch (const Error& error) {
    EXPECT_TRUE(error.code() == ErrorCode::bad_file || error.code() == ErrorCode::unsupported)
        << name << ": " << to_string(error.code()) << ": " << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << name;
    return error.what();
  }
}

TEST(Malformed, EveryBrokenFileIsSurvived) {
  const auto files = data_files("malformed");
  if (files.empty()) GTEST_SKIP() << "no shared data";
  int read = 0;
  for (const auto& path : files) {
    const std::string format = file_format(path.string());
    if (format != "gltf" && format != "glb" && format != "vrm" && format != "obj") continue;
    const std::string result = outcome(load_bytes(path), path.string(), resources_beside(path));
    if (std::getenv("CROQUIS_VERBOSE") != nullptr) std::cout << path.string() << ": " << result << "\n";
    if (path.filename().string().starts_with("valid")) {
      EXPECT_EQ(result, "ok") << path;
    }
    ++read;
  }
  EXPECT_GT(read, 200);
}

TEST(Malformed, EveryTruncationOfAGlbIsAnError) {
  const auto path = data_file("vrm/addon_simple_morph.vrm");
  if (!path) GTEST_SKIP() << "no shared data";
  const Bytes bytes = load_bytes(*path);
  ASSERT_EQ(outcome(bytes, "a.vrm", nullptr), "ok");
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ASSERT_NE(outcome(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)), "a.vrm", nullptr), "ok")
        << size;
  }
}

TEST(Malformed, EveryTruncationOfAGltfIsAnError) {
  const auto path = data_file("gltf/simple_skin.gltf");
  if (!path) GTEST_SKIP() << "no shared data";
  Bytes bytes = load_bytes(*path);
  while (!bytes.empty() && bytes.back() != std::byte{'}'}) bytes.pop_back();
  ASSERT_EQ(outcome(bytes, "a.gltf", nullptr), "ok");
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ASSERT_NE(outcome(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)), "a.gltf", nullptr),
              "ok");
  }
}

}  // namespace
}  // namespace croquis
