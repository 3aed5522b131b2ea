// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "croquis/project/character.h"

namespace croquis {

/// The bytes that base64 text stands for (RFC 4648, padding optional); nothing if it is not base64.
[[nodiscard]] std::optional<Bytes> decode_base64(std::string_view text);
[[nodiscard]] std::string encode_base64(std::span<const std::byte> bytes);

/// "%20" and its like turned into the bytes they stand for; a lone '%' stays.
[[nodiscard]] std::string decode_percent(std::string_view uri);
/// The inverse, for a file name that becomes a relative URI.
[[nodiscard]] std::string encode_percent(std::string_view file_name);

/// "data:image/png;base64,..." taken apart; nothing for any other URI. The payload is not decoded yet.
struct DataUri {
  std::string_view media_type;
  std::string_view payload;
  bool base64 = false;
};
[[nodiscard]] std::optional<DataUri> parse_data_uri(std::string_view uri);
/// Base64 or percent-encoded payload; nothing if the base64 is broken.
[[nodiscard]] std::optional<Bytes> decode_data_uri(const DataUri& uri);

/// True for "http://...", "file:...": a URI that is no relative path.
[[nodiscard]] bool has_uri_scheme(std::string_view uri);

}  // namespace croquis
