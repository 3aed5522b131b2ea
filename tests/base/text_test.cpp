// SPDX-License-Identifier: MIT
#include "croquis/base/text.h"

#include <gtest/gtest.h>

namespace croquis {
namespace {

TEST(Text, ParsesTheNumbersThatFilesHold) {
  EXPECT_EQ(parse_double("1"), 1.0);
  EXPECT_EQ(parse_double("-.5"), -0.5);
  EXPECT_EQ(parse_double("+2.e-3"), 2e-3);
  EXPECT_EQ(parse_int("-12"), -12);
}

TEST(Text, RefusesWhatIsNoNumber) {
  for (const char* text : {"", " ", "1 ", "nan", "inf", "0x10", "1e", "1e999", "--1", "1,5"}) {
    EXPECT_FALSE(parse_double(text)) << '"' << text << '"';
  }
  EXPECT_FALSE(parse_int("1.5"));
  EXPECT_FALSE(parse_int("99999999999"));
}

TEST(Text, SeventeenDigitsReadBackTheSameNumber) {
  for (const double value : {0.1, -1.0 / 3.0, 6.02214076e23, 5e-324}) {
    EXPECT_EQ(parse_double(format_double(value, 17)), value);
  }
  EXPECT_EQ(format_double(-0.0), "0");
}

TEST(Text, PrintableKeepsUtf8AndEscapesTheRest) {
  EXPECT_EQ(printable("tête 頭"), "tête 頭");
  EXPECT_EQ(printable("a\nb"), "a\\x0ab");
  EXPECT_EQ(printable("\xff\xc3"), "\\xff\\xc3");
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a surrogate is no character
  EXPECT_EQ(printable("abcdef", 3), "abc...");
}

TEST(Text, BytesThatAreNoUtf8AreTakenAsLatin1) {
  EXPECT_EQ(to_utf8("t\xeate"), "tête");
  EXPECT_EQ(to_utf8("tête 頭"), "tête 頭");
  EXPECT_EQ(to_utf8("\xe9\xa0"), "\xc3\xa9\xc2\xa0");  // a character cut short
}

TEST(Text, SuggestsOnlyNearWords) {
  EXPECT_EQ(closest_word("LeftArn", {"LeftArm", "RightArm"}), "LeftArm");
  EXPECT_EQ(closest_word("xyz", {"LeftArm"}), "");
}

TEST(Text, SplitTrimJoin) {
  EXPECT_EQ(split("a,,b", ','), (std::vector<std::string>{"a", "", "b"}));
  EXPECT_EQ(trim("\t a b \r\n"), "a b");
  EXPECT_EQ(join({"a", "b"}, ", "), "a, b");
}

}  // namespace
}  // namespace croquis
