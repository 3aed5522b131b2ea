// SPDX-License-Identifier: MIT
// Replays what the fuzzers start from and what they have found, and every truncation of it, in ordinary builds.
#include "fuzz/readers.h"
#include "support/data.h"

#include <gtest/gtest.h>

namespace croquis {
namespace {

using Reader = bool (*)(std::span<const std::byte>);

void replay_corpus(const std::string& name, Reader reader) {
  const auto folder = std::filesystem::path(CROQUIS_SOURCE_DIR) / "tests" / "fuzz" / "corpus" / name;
  int read = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().string());
    const std::vector<std::byte> bytes = load_bytes(entry.path());
    EXPECT_NO_THROW(read += reader(bytes) ? 1 : 0);
    constexpr std::size_t kMostCuts = 1000;  // of a long file every n-th
    const std::size_t step = 1 + bytes.size() / kMostCuts;
    for (std::size_t size = 0; size < bytes.size(); size += step) {
      ASSERT_NO_THROW(reader(std::span(bytes).first(size))) << "cut to " << size << " bytes";
    }
  }
  EXPECT_GE(read, 2);  // fuzzing starts from files that are read
}

TEST(FuzzCorpus, Bvh) { replay_corpus("bvh", fuzz_bvh); }
TEST(FuzzCorpus, Camera) { replay_corpus("camera", fuzz_camera); }
TEST(FuzzCorpus, Gltf) { replay_corpus("gltf", fuzz_gltf); }
TEST(FuzzCorpus, Svg) { replay_corpus("svg", fuzz_svg); }

TEST(FuzzCorpus, EveryReaderSurvivesTheMalformedFilesOfEveryFormat) {
  if (!data_folder()) GTEST_SKIP() << "no shared data";
  for (const auto& path : data_files("malformed")) {
    if (path.string().ends_with(".report.json") || std::filesystem::file_size(path) > 1'000'000) continue;
    const std::vector<std::byte> bytes = load_bytes(path);
    for (const Reader reader : {fuzz_bvh, fuzz_camera, fuzz_gltf, fuzz_svg}) EXPECT_NO_THROW(reader(bytes)) << path;
  }
}

}  // namespace
}  // namespace croquis
