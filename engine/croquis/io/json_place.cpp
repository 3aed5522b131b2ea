// SPDX-License-Identifier: MIT
#include "croquis/io/json_place.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

constexpr int kDeepestJson = 256;
constexpr int kMostMembers = 20000;

/// Nesting and members per object, counted before anything is built: printing recurses, and looking a member up is
/// linear in the ordered form.
void check_measure(std::string_view text) {
  std::vector<int> members;  // colons per open bracket
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        in_string = false;
      continue;
    }
    switch (c) {
      case '"':
        in_string = true;
        break;
      case '{':
      case '[':
        if (std::ssize(members) >= kDeepestJson) throw_bad_file("byte " + std::to_string(i), "nested too deep");
        members.push_back(0);
        break;
      case '}':
      case ']':
        if (!members.empty()) members.pop_back();
        break;
      case ':':
        if (!members.empty() && ++members.back() > kMostMembers) {
          throw_bad_file("byte " + std::to_string(i),
                         "more than " + std::to_string(kMostMembers) + " members in one object");
        }
        break;
      default:
        break;
    }
  }
}

/// A key as it stands in a JSON pointer (RFC 6901).
std::string pointer_token(std::string_view key) {
  std::string token;
  for (const char c : printable(key)) {
    if (c == '~')
      token += "~0";
    else if (c == '/')
      token += "~1";
    else
      token += c;
  }
  return token;
}

}  // namespace

std::shared_ptr<const Json> parse_json(std::string_view text) {
  check_measure(text);
  try {
    return std::make_shared<const Json>(Json::parse(text.begin(), text.end()));
  } catch (const Json::parse_error& error) {
    throw_bad_file("byte " + std::to_string(error.byte), "not valid JSON");
  } catch (const Json::exception&) {
    throw_bad_file("byte 0", "not valid JSON: a number is out of range");
  }
}

bool JsonPlace::is_object() const { return exists() && value_->is_object(); }
bool JsonPlace::is_array() const { return exists() && value_->is_array(); }
bool JsonPlace::is_text() const { return exists() && value_->is_string(); }

JsonPlace JsonPlace::operator[](std::string_view key) const {
  std::string pointer = pointer_ + "/" + pointer_token(key);
  if (!exists()) return {nullptr, std::move(pointer)};
  if (!value_->is_object()) fail("wanted an object");
  const auto found = value_->find(std::string(key));
  return {found == value_->end() ? nullptr : &*found, std::move(pointer)};
}

JsonPlace JsonPlace::operator[](int index) const {
  if (index < 0 || index >= size()) fail("has no element " + std::to_string(index));
  return {&(*value_)[static_cast<std::size_t>(index)], pointer_ + "/" + std::to_string(index)};
}

int JsonPlace::size() const {
  if (!exists()) return 0;
  if (!value_->is_array()) fail("wanted an array");
  if (value_->size() > 100'000'000) fail("too many elements");
  return static_cast<int>(value_->size());
}

std::vector<std::string> JsonPlace::keys() const {
  std::vector<std::string> keys;
  if (!exists()) return keys;
  if (!value_->is_object()) fail("wanted an object");
  for (const auto& [key, value] : value_->items()) keys.push_back(key);
  return keys;
}

std::string JsonPlace::text() const {
  if (!exists()) fail("is missing");
  if (!value_->is_string()) fail("wanted a string");
  return value_->get<std::string>();
}

std::string JsonPlace::text_or(std::string_view fallback) const { return exists() ? text() : std::string(fallback); }

bool JsonPlace::boolean_or(bool fallback) const {
  if (!exists()) return fallback;
  if (!value_->is_boolean()) fail("wanted true or false");
  return value_->get<bool>();
}

double JsonPlace::number() const {
  if (!exists()) fail("is missing");
  if (!value_->is_number()) fail("wanted a number");
  const auto number = value_->get<double>();
  if (!std::isfinite(number)) fail("wanted a finite number");
  return number;
}

double JsonPlace::number_or(double fallback) const { return exists() ? number() : fallback; }

long long JsonPlace::integer(long long least, long long most) const {
  const double value = number();
  if (value != std::floor(value) || value < static_cast<double>(least) || value > static_cast<double>(most)) {
    fail("wanted a whole number from " + std::to_string(least) + " to " + std::to_string(most) + ", found " +
         format_double(value));
  }
  return static_cast<long long>(value);
}

long long JsonPlace::integer_or(long long fallback, long long least, long long most) const {
  return exists() ? integer(least, most) : fallback;
}

int JsonPlace::index(int count, std::string_view what) const {
  const double value = number();
  if (value != std::floor(value) || value < 0 || value >= count) {
    fail(std::string(what) + " " + format_double(value) +
         " is not there: " + (count == 0 ? "there is none" : "they run from 0 to " + std::to_string(count - 1)));
  }
  return static_cast<int>(value);
}

int JsonPlace::index_or_none(int count, std::string_view what) const { return exists() ? index(count, what) : -1; }

std::vector<double> JsonPlace::numbers(int count) const {
  if (!exists()) fail("is missing");
  if (size() != count) fail("wanted " + std::to_string(count) + " numbers, found " + std::to_string(size()));
  std::vector<double> numbers(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) numbers[static_cast<std::size_t>(i)] = (*this)[i].number();
  return numbers;
}

void JsonPlace::fail(const std::string& text) const { throw_bad_file(pointer_.empty() ? "/" : pointer_, text); }

}  // namespace croquis
