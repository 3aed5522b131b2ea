// SPDX-License-Identifier: MIT
#include "croquis/io/disk.h"

#include "support/data.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

namespace fs = std::filesystem;

class Disk : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("croquis_disk_" + std::to_string(std::rand()) + "_" +
                                          testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  fs::path folder;
};

TEST_F(Disk, GivesBackWhatWasWritten) {
  const Bytes bytes = bytes_of(std::string("a\0b\n", 4));
  write_file(folder / "a.bin", bytes);
  EXPECT_EQ(read_file(folder / "a.bin"), bytes);
  write_file(folder / "a.bin", {});
  EXPECT_TRUE(read_file(folder / "a.bin").empty());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1) << "no temporary file is left";
}

TEST_F(Disk, NamesTheFileThatCannotBeRead) {
  fs::create_directories(folder / "sub");
  for (const char* name : {"absent.glb", "sub"}) {
    try {
      (void)read_file(folder / name);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::io);
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
    }
  }
}

TEST_F(Disk, AFailedWriteLeavesNothingBehind) {
  EXPECT_THROW(write_file(folder / "absent" / "a.bin", {}), Error);
  fs::create_directories(folder / "sub");
  EXPECT_THROW(write_file(folder / "sub", bytes_of("x")), Error);
  EXPECT_TRUE(fs::is_directory(folder / "sub"));
}

TEST_F(Disk, ResourcesComeFromTheFolderOfTheFileAndNowhereElse) {
  fs::create_directories(folder / "in" / "textures");
  write_file(folder / "secret.txt", bytes_of("secret"));
  write_file(folder / "in" / "textures" / "a.png", bytes_of("png"));
  const ResourceReader reader = resources_beside(folder / "in" / "a.gltf");
  EXPECT_EQ(reader("textures/a.png"), bytes_of("png"));
  EXPECT_EQ(reader("textures/../textures/a.png"), bytes_of("png"));
  for (const std::string uri : {"../secret.txt", "textures/../../secret.txt", "/etc/passwd", ""}) {
    EXPECT_THROW((void)reader(uri), Error) << uri;
  }
}

}  // namespace
}  // namespace croquis
