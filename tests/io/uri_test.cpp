// SPDX-License-Identifier: MIT
#include "croquis/io/uri.h"

#include "support/data.h"

#include <gtest/gtest.h>

#include "croquis/base/random.h"

namespace croquis {
namespace {

TEST(Uri, Base64FollowsTheExamplesOfTheRfc) {
  const std::vector<std::pair<std::string, std::string>> examples = {
      {"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}, {"foobar", "Zm9vYmFy"}};
  for (const auto& [plain, encoded] : examples) {
    EXPECT_EQ(encode_base64(bytes_of(plain)), encoded);
    EXPECT_EQ(decode_base64(encoded), bytes_of(plain));
  }
  EXPECT_EQ(decode_base64("Zg"), bytes_of("f")) << "padding may be left out";
  EXPECT_FALSE(decode_base64("Zm9v*"));
  EXPECT_FALSE(decode_base64("Zm9vY"));
}

TEST(Uri, Base64OfAnyBytesComesBack) {
  Random random(1);
  for (int length = 0; length < 50; ++length) {
    Bytes bytes;
    for (int i = 0; i < length; ++i) bytes.push_back(static_cast<std::byte>(random.index(256)));
    EXPECT_EQ(decode_base64(encode_base64(bytes)), bytes);
  }
}

TEST(Uri, PercentEncodingComesBack) {
  EXPECT_EQ(decode_percent("My%20file%2Epng"), "My file.png");
  EXPECT_EQ(decode_percent("100%"), "100%");
  EXPECT_EQ(encode_percent("a b/ü.bin"), "a%20b/%C3%BC.bin");
  EXPECT_EQ(decode_percent(encode_percent("a b/ü.bin")), "a b/ü.bin");
}

TEST(Uri, DataUrisAreTakenApart) {
  const auto uri = parse_data_uri("data:image/png;base64,Zm9v");
  ASSERT_TRUE(uri);
  EXPECT_EQ(uri->media_type, "image/png");
  EXPECT_EQ(decode_data_uri(*uri), bytes_of("foo"));
  EXPECT_EQ(decode_data_uri(*parse_data_uri("data:,a%20b")), bytes_of("a b"));
  EXPECT_FALSE(parse_data_uri("picture.png"));
  EXPECT_FALSE(decode_data_uri(*parse_data_uri("data:;base64,!!!!")));
}

TEST(Uri, SchemesAreSeenButNotInPaths) {
  EXPECT_TRUE(has_uri_scheme("http://example.org/a.bin"));
  EXPECT_TRUE(has_uri_scheme("file:///a.bin"));
  EXPECT_FALSE(has_uri_scheme("textures/a.png"));
  EXPECT_FALSE(has_uri_scheme("a b:c.png"));
}

}  // namespace
}  // namespace croquis
