// SPDX-License-Identifier: MIT
#include "croquis/io/glb_container.h"

#include "support/data.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

TEST(GlbContainer, GivesBackWhatWasPutInPaddedToFourBytes) {
  const Bytes binary = bytes_of("12345"), other = bytes_of("xy");
  const std::vector<GlbChunk> others = {{0x12345678, other}};
  const Bytes file = make_glb("{\"a\":1}", binary, others);
  EXPECT_EQ(file.size() % 4, 0U);
  const GlbContainer glb = parse_glb(file);
  EXPECT_EQ(glb.json, "{\"a\":1} ");
  ASSERT_EQ(glb.binary.size(), 8U);
  EXPECT_EQ(Bytes(glb.binary.begin(), glb.binary.begin() + 5), binary);
  ASSERT_EQ(glb.others.size(), 1U);
  EXPECT_EQ(glb.others[0].type, 0x12345678U);
}

TEST(GlbContainer, LeavesTheBinChunkOutWhereThereIsNoData) {
  EXPECT_EQ(make_glb("{} ", {}).size(), 24U);
  EXPECT_FALSE(parse_glb(make_glb("{}", {})).has_binary);
}

TEST(GlbContainer, RefusesEveryTruncation) {
  const Bytes file = make_glb("{\"a\":1}", bytes_of("12345678"));
  for (std::size_t size = 0; size < file.size(); ++size) {
    EXPECT_THROW((void)parse_glb(std::span(file).first(size)), Error) << size;
  }
}

TEST(GlbContainer, RefusesVersionOneByName) {
  Bytes file = make_glb("{}", {});
  file[4] = std::byte{1};
  try {
    (void)parse_glb(file);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::unsupported);
  }
}

}  // namespace
}  // namespace croquis
