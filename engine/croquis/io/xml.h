// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace croquis {

/// Reads the elements of an XML text one after the other; text between them is passed over. Strict where it matters
/// (tags must match, attributes must be quoted and not stand twice, entities must be known), and bounded: at most 256
/// elements deep, and entities that a document declares expand once, never within each other.
class XmlReader {
 public:
  /// The text must outlive the reader. Throws Error{unsupported} for UTF-16.
  explicit XmlReader(std::string_view text);

  enum class Event { start, end, done };

  /// Goes to the next tag. An element without content gives `start` and then `end`. Throws Error{bad_file} with the
  /// line.
  Event next();

  /// The element's name without its namespace prefix: "path" for <svg:path>.
  [[nodiscard]] std::string_view name() const { return name_; }
  /// The line on which the last tag begins, from 1.
  [[nodiscard]] int line() const { return line_; }
  /// The value of an attribute (its full name, with prefix) of the element that has just started, entities resolved;
  /// the view holds until next().
  [[nodiscard]] std::optional<std::string_view> attribute(std::string_view name) const;

 private:
  [[noreturn]] void fail(std::string_view text) const;
  void skip_to(std::string_view mark, std::string_view what);
  void count_lines();
  void skip_declarations();
  void declare_entity();
  void skip_spaces();
  std::string_view read_name();
  std::string read_value();
  std::string resolve(std::string_view entity) const;
  Event read_start();
  Event read_end();

  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t counted_ = 0;  // up to here the lines are counted
  int line_ = 1;
  std::string_view name_;
  std::vector<std::pair<std::string_view, std::string>> attributes_;
  std::vector<std::string_view> open_;  // full names
  std::map<std::string, std::string, std::less<>> entities_;
  std::size_t expanded_ = 0;  // bytes that entities have grown to
  bool empty_ = false;        // the element that has just started has its end with it
  bool rooted_ = false;       // a root element has been met
};

/// `text` fit to stand in a quoted attribute: markup and control characters escaped or, where XML has no way to say
/// them, replaced by a space.
[[nodiscard]] std::string xml_escaped(std::string_view text);

}  // namespace croquis
