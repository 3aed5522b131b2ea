// SPDX-License-Identifier: MIT
#include "croquis/io/gltf_read.h"

#include "support/data.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/io/disk.h"

namespace croquis {
namespace {

Character read(const std::filesystem::path& path) {
  return read_character(load_bytes(path), path.string(), resources_beside(path));
}

TEST(GltfRead, EveryGoodFileIsReadWhole) {
  int count = 0;
  for (const char* folder : {"gltf", "vrm"}) {
    for (const auto& path : data_files(folder)) {
      const std::string format = file_format(path.string());
      if (format != "gltf" && format != "glb" && format != "vrm" && format != "vrma") continue;
      if (path.string().find("DRACO") != std::string::npos) continue;
      SCOPED_TRACE(path.string());
      try {
        const Character character = read(path);
        if (std::getenv("CROQUIS_VERBOSE") != nullptr) {
          std::cout << path.filename().string() << ": " << character.skeleton.joint_count() << " joints, "
                    << character.parts.size() << " parts, " << character.clips.size() << " clips\n";
          for (const auto& oddity : character.oddities) std::cout << "    " << oddity << "\n";
        }
      } catch (const Error& error) {
        ADD_FAILURE() << error.what();
      }
      ++count;
    }
  }
  if (count == 0) GTEST_SKIP() << "no shared data";
  EXPECT_GT(count, 60);
}

}  // namespace
}  // namespace croquis
