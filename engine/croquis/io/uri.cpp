// SPDX-License-Identifier: MIT
#include "croquis/io/uri.h"

#include <array>
#include <cstdint>

#include "croquis/base/text.h"
#include "croquis/io/ascii.h"

namespace croquis {
namespace {

constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr std::array<signed char, 256> make_base64_values() {
  std::array<signed char, 256> values{};
  for (auto& value : values) value = -1;
  for (std::size_t i = 0; i < kAlphabet.size(); ++i) {
    values[static_cast<unsigned char>(kAlphabet[i])] = static_cast<signed char>(i);
  }
  return values;
}
constexpr std::array<signed char, 256> kBase64Values = make_base64_values();

int hex_value(char c) {
  return c >= '0' && c <= '9'   ? c - '0'
         : c >= 'a' && c <= 'f' ? c - 'a' + 10
         : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                : -1;
}

}  // namespace

std::optional<Bytes> decode_base64(std::string_view text) {
  for (int i = 0; i < 2 && !text.empty() && text.back() == '='; ++i) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  Bytes bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int value = kBase64Values[static_cast<unsigned char>(c)];
    if (value < 0) return std::nullopt;
    bits = (bits << 6) | static_cast<std::uint32_t>(value);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes.push_back(static_cast<std::byte>((bits >> count) & 0xffU));
    }
  }
  return bytes;
}

std::string encode_base64(std::span<const std::byte> bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    const std::size_t group = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k)
      bits = (bits << 8) | (k < group ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= group ? kAlphabet[(bits >> (18 - 6 * k)) & 63U] : '=';
  }
  return text;
}

std::string decode_percent(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() && hex_value(uri[i + 1]) >= 0 && hex_value(uri[i + 2]) >= 0) {
      text += static_cast<char>(hex_value(uri[i + 1]) * 16 + hex_value(uri[i + 2]));
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

std::string encode_percent(std::string_view file_name) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string uri;
  for (const char c : file_name) {
    if (is_letter(c) || is_digit(c) || std::string_view("-_.~/").find(c) != std::string_view::npos) {
      uri += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      uri += {'%', kHex[byte >> 4U], kHex[byte & 15U]};
    }
  }
  return uri;
}

std::optional<DataUri> parse_data_uri(std::string_view uri) {
  if (to_lower(uri.substr(0, 5)) != "data:") return std::nullopt;
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const std::string_view head = uri.substr(5, comma - 5);
  DataUri data;
  data.payload = uri.substr(comma + 1);
  data.media_type = head.substr(0, head.find(';'));
  data.base64 = head.size() >= 7 && to_lower(head.substr(head.size() - 7)) == ";base64";
  return data;
}

std::optional<Bytes> decode_data_uri(const DataUri& uri) {
  if (uri.base64) {
    return uri.payload.find('%') == std::string_view::npos ? decode_base64(uri.payload)
                                                           : decode_base64(decode_percent(uri.payload));
  }
  const std::string text = decode_percent(uri.payload);
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return Bytes(first, first + text.size());
}

bool has_uri_scheme(std::string_view uri) {
  // RFC 3986: a letter, then letters, digits, '+', '-', '.', then ':'.
  std::size_t i = 0;
  while (i < uri.size() &&
         (is_letter(uri[i]) || (i > 0 && (is_digit(uri[i]) || uri[i] == '+' || uri[i] == '-' || uri[i] == '.')))) {
    ++i;
  }
  return i > 0 && i < uri.size() && uri[i] == ':';
}

}  // namespace croquis
