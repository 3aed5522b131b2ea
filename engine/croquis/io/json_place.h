// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace croquis {

/// JSON whose members keep the order they had in the file.
using Json = nlohmann::ordered_json;

/// The JSON of a text. Throws bad_file with the byte for what is no JSON, and for what only an attack nests or fills so
/// (more than 256 levels, more than 20,000 members in one object).
[[nodiscard]] std::shared_ptr<const Json> parse_json(std::string_view text);

/// A place in a JSON document that knows its JSON pointer, so that every complaint says where. A member that is not
/// there is a place too (`exists()` is false): size 0, and only the `_or` forms give it a value. Everything that is
/// asked for and is of another type throws bad_file.
class JsonPlace {
 public:
  JsonPlace(const Json* value, std::string pointer) : value_(value), pointer_(std::move(pointer)) {}

  [[nodiscard]] bool exists() const { return value_ != nullptr; }
  [[nodiscard]] const Json& json() const { return *value_; }
  [[nodiscard]] const std::string& pointer() const { return pointer_; }

  [[nodiscard]] bool is_object() const;
  [[nodiscard]] bool is_array() const;
  [[nodiscard]] bool is_text() const;
  [[nodiscard]] JsonPlace operator[](std::string_view key) const;  ///< a member of an object (or of nothing)
  [[nodiscard]] JsonPlace operator[](int index) const;             ///< an element, within size()
  [[nodiscard]] int size() const;                                  ///< elements of an array
  [[nodiscard]] std::vector<std::string> keys() const;             ///< members of an object

  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string text_or(std::string_view fallback) const;
  [[nodiscard]] bool boolean_or(bool fallback) const;
  [[nodiscard]] double number() const;
  [[nodiscard]] double number_or(double fallback) const;
  [[nodiscard]] long long integer(long long least, long long most) const;
  [[nodiscard]] long long integer_or(long long fallback, long long least, long long most) const;
  /// An index into something that has `count` elements; `what` names it ("node").
  [[nodiscard]] int index(int count, std::string_view what) const;
  /// -1 where the member is not there.
  [[nodiscard]] int index_or_none(int count, std::string_view what) const;
  [[nodiscard]] std::vector<double> numbers(int count) const;

  /// Throws bad_file: "/nodes/3/mesh: `text`".
  [[noreturn]] void fail(const std::string& text) const;

 private:
  const Json* value_;
  std::string pointer_;
};

}  // namespace croquis
