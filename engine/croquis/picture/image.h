// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace croquis {

/// 8-bit sRGB with straight (not premultiplied) alpha: four bytes a pixel, row by row from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;

  [[nodiscard]] std::array<std::uint8_t, 4> pixel(int x, int y) const {
    const std::size_t at =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    return {rgba[at], rgba[at + 1], rgba[at + 2], rgba[at + 3]};
  }
};

/// The colour of the paper that pictures and sheets are on, 8-bit sRGB.
inline constexpr std::array<std::uint8_t, 4> kPaper{245, 240, 230, 255};

/// The image as a PNG file (8-bit RGB, or RGBA where something is transparent). Throws invalid_argument for an image
/// without pixels or whose sizes disagree.
[[nodiscard]] std::vector<std::byte> encode_png(const Image& image);

/// A PNG or JPEG file as 8-bit RGBA. Throws Error{bad_file} for anything else, for a damaged file, and for an image of
/// more than 16384 pixels a side.
[[nodiscard]] Image decode_image(std::span<const std::byte> file);

/// A contact sheet: the images in reading order, `columns` a row, each centred in a cell as large as the largest, with
/// `gap` pixels between and around the cells, over `background`. Throws invalid_argument for no image, columns < 1 or
/// gap < 0.
[[nodiscard]] Image compose_sheet(const std::vector<Image>& images, int columns, int gap,
                                  const std::array<std::uint8_t, 4>& background = kPaper);

/// The image at half its size (rounded down, at least 1), each pixel the mean of four in linear light, weighted by
/// alpha.
[[nodiscard]] Image halve(const Image& image);

/// The sRGB transfer curve: 8-bit code to linear light in [0, 1], and back (rounded to the nearest code).
[[nodiscard]] float srgb_to_linear(std::uint8_t code);
[[nodiscard]] std::uint8_t linear_to_srgb(float linear);

}  // namespace croquis
