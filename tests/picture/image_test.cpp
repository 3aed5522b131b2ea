// SPDX-License-Identifier: MIT
#include "croquis/picture/image.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/base/random.h"

namespace croquis {
namespace {

Image plain(int width, int height, const std::array<std::uint8_t, 4>& color) {
  Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i) image.rgba.insert(image.rgba.end(), color.begin(), color.end());
  return image;
}

TEST(Image, comes_back_from_png_with_every_bit) {
  Random random(1);
  Image image{37, 23, {}};
  for (int i = 0; i < 37 * 23 * 4; ++i) image.rgba.push_back(static_cast<std::uint8_t>(random.index(256)));
  const std::vector<std::byte> png = encode_png(image);
  EXPECT_EQ(png[1], std::byte{'P'});
  EXPECT_EQ(png[24], std::byte{8});  // bits a channel
  EXPECT_EQ(png[25], std::byte{6});  // RGBA
  const Image back = decode_image(png);
  EXPECT_EQ(back.width, 37);
  EXPECT_EQ(back.height, 23);
  EXPECT_EQ(back.rgba, image.rgba);
}

TEST(Image, is_written_without_alpha_where_nothing_is_transparent) {
  Random random(2);
  Image image{19, 11, {}};
  for (int i = 0; i < 19 * 11 * 4; ++i) {
    image.rgba.push_back(i % 4 == 3 ? std::uint8_t{255} : static_cast<std::uint8_t>(random.index(256)));
  }
  const std::vector<std::byte> png = encode_png(image);
  EXPECT_EQ(png[25], std::byte{2});  // RGB
  EXPECT_EQ(decode_image(png).rgba, image.rgba);
}

TEST(Image, refuses_what_is_no_image_or_only_half_of_one) {
  const std::vector<std::byte> png = encode_png(plain(16, 16, {1, 2, 3, 4}));
  EXPECT_THROW((void)decode_image({}), Error);
  EXPECT_THROW((void)decode_image(std::vector<std::byte>(100, std::byte{'x'})), Error);
  EXPECT_THROW((void)decode_image(std::span(png).first(20)), Error);
  std::vector<std::byte> huge = png;  // a header that promises 2^31 pixels a row
  huge[16] = std::byte{0x7F};
  EXPECT_THROW((void)decode_image(huge), Error);
  EXPECT_THROW((void)encode_png(Image{2, 2, {1, 2, 3}}), Error);
  EXPECT_THROW((void)encode_png(Image{}), Error);
}

TEST(Image, knows_the_srgb_curve_both_ways) {
  for (int code = 0; code < 256; ++code) {
    const auto c = static_cast<std::uint8_t>(code);
    EXPECT_EQ(linear_to_srgb(srgb_to_linear(c)), c);
  }
  EXPECT_NEAR(srgb_to_linear(188), 0.5029F, 1e-4F);  // half the light
  EXPECT_EQ(linear_to_srgb(-1.0F), 0);
  EXPECT_EQ(linear_to_srgb(7.0F), 255);
}

TEST(ContactSheet, centres_images_of_any_size_in_reading_order) {
  const Image red = plain(4, 4, {255, 0, 0, 255}), green = plain(2, 2, {0, 255, 0, 255});
  const Image sheet = compose_sheet({red, green, red}, 2, 3, {9, 9, 9, 255});
  EXPECT_EQ(sheet.width, 2 * 4 + 3 * 3);
  EXPECT_EQ(sheet.height, 2 * 4 + 3 * 3);
  using Pixel = std::array<std::uint8_t, 4>;
  EXPECT_EQ(sheet.pixel(3, 3), (Pixel{255, 0, 0, 255}));
  EXPECT_EQ(sheet.pixel(10, 3), (Pixel{9, 9, 9, 255}));    // beside the small one
  EXPECT_EQ(sheet.pixel(11, 4), (Pixel{0, 255, 0, 255}));  // itself
  EXPECT_EQ(sheet.pixel(3, 10), (Pixel{255, 0, 0, 255}));  // the next row
  EXPECT_EQ(sheet.pixel(12, 12), (Pixel{9, 9, 9, 255}));   // no fourth image
  EXPECT_EQ(compose_sheet({red}, 5, 0).width, 4);          // no empty columns
}

TEST(ContactSheet, lets_the_background_through_transparent_pixels) {
  const Image sheet = compose_sheet({plain(1, 1, {200, 100, 0, 51})}, 1, 0, {0, 0, 100, 255});
  EXPECT_EQ(sheet.pixel(0, 0), (std::array<std::uint8_t, 4>{40, 20, 80, 255}));
  const Image clear = compose_sheet({plain(1, 1, {200, 100, 0, 51})}, 1, 0, {0, 0, 0, 0});
  EXPECT_EQ(clear.pixel(0, 0), (std::array<std::uint8_t, 4>{200, 100, 0, 51}));
}

TEST(ContactSheet, wants_images_and_columns) {
  EXPECT_THROW((void)compose_sheet({}, 2, 0), Error);
  EXPECT_THROW((void)compose_sheet({plain(1, 1, {0, 0, 0, 0})}, 0, 0), Error);
  EXPECT_THROW((void)compose_sheet({plain(1, 1, {0, 0, 0, 0})}, 1, -1), Error);
}

TEST(Halving, averages_light_and_leaves_no_dark_fringe) {
  Image image = plain(4, 2, {0, 0, 0, 255});
  for (const std::size_t pixel : {0U, 1U}) {
    for (std::size_t c = 0; c < 3; ++c) image.rgba[4 * pixel + c] = 255;  // half of the first block is white
  }
  for (std::size_t i = 0; i < 4; ++i) image.rgba[4 * 2 + i] = static_cast<std::uint8_t>(i == 0 ? 255 : 0);  // clear
  const Image half = halve(image);
  EXPECT_EQ(half.width, 2);
  EXPECT_EQ(half.height, 1);
  EXPECT_EQ(half.pixel(0, 0), (std::array<std::uint8_t, 4>{188, 188, 188, 255}));
  EXPECT_EQ(half.pixel(1, 0), (std::array<std::uint8_t, 4>{0, 0, 0, 191}));
  const Image odd = halve(plain(3, 1, {10, 20, 30, 255}));
  EXPECT_EQ(odd.width, 1);
  EXPECT_EQ(odd.height, 1);
  EXPECT_EQ(odd.pixel(0, 0), (std::array<std::uint8_t, 4>{10, 20, 30, 255}));
}

}  // namespace
}  // namespace croquis
