// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "croquis/math/types.h"

namespace croquis {

using Affine2 = Eigen::Affine2d;

/// Numbers one after the other as SVG writes them: "1.5.5-3e2,4" is 1.5, .5, -300, 4.
class SvgNumbers {
 public:
  /// `place` begins the messages: "line 3: the points of <polyline>".
  SvgNumbers(std::string_view text, std::string place) : text_(text), place_(std::move(place)) {}

  [[nodiscard]] bool at_end();     ///< after spaces and commas
  [[nodiscard]] bool at_number();  ///< a number begins here
  double number();                 ///< throws bad_file if there is none, or one beyond 1e12
  Vec2 point() {
    const double x = number();
    return {x, number()};
  }
  bool flag();              ///< a single 0 or 1, with or without a space behind it
  char letter();            ///< a path command or the next character; '\0' at the end
  std::string_view word();  ///< the letters that stand here: "translate"
  void expect(char character);
  [[noreturn]] void fail(std::string_view text) const;

 private:
  void skip_separators();

  std::string_view text_;
  std::string place_;
  std::size_t position_ = 0;
};

/// An SVG transform list ("translate(1 2) rotate(30)"): outer first, as matrices multiply.
[[nodiscard]] Affine2 parse_svg_transform(std::string_view text, const std::string& place);

/// The subpaths of SVG path data, mapped by `pixels_from_path` and flattened so that no chord is farther than
/// `tolerance` pixels from its curve. A closed subpath ends where it began. Throws Error{bad_file} with the character
/// that is wrong, or if there would be more than four million points.
[[nodiscard]] std::vector<std::vector<Vec2>> flatten_svg_path(std::string_view data, const Affine2& pixels_from_path,
                                                              double tolerance, const std::string& place,
                                                              std::size_t most_points);

}  // namespace croquis
