// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace croquis {

/// The number that the whole of `text` spells ("1", "-.5", "1e-3"), whatever the locale; nothing for anything else.
/// "nan" and "inf" are not numbers here.
[[nodiscard]] std::optional<double> parse_double(std::string_view text);
[[nodiscard]] std::optional<int> parse_int(std::string_view text);

/// The shortest text with at most `digits` significant digits (17 are enough to read back the same number).
[[nodiscard]] std::string format_double(double value, int digits = 9);

[[nodiscard]] std::string to_lower(std::string_view text);  // ASCII only; other bytes stay
[[nodiscard]] std::string_view trim(std::string_view text);
[[nodiscard]] std::vector<std::string> split(std::string_view text, char separator);
[[nodiscard]] std::string join(const std::vector<std::string>& parts, std::string_view separator);

/// `text` fit for one line of a message: control characters and broken UTF-8 as \xNN, cut to `longest` bytes.
[[nodiscard]] std::string printable(std::string_view text, int longest = 80);

/// `text` with each byte that is no part of valid UTF-8 taken as Latin-1; valid text stays as it is.
[[nodiscard]] std::string to_utf8(std::string_view text);

/// The candidate closest to `word` by edit distance, if close enough to be worth suggesting; else empty.
[[nodiscard]] std::string closest_word(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace croquis
