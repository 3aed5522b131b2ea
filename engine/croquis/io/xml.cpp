// SPDX-License-Identifier: MIT
#include "croquis/io/xml.h"

#include <algorithm>
#include <charconv>

#include "croquis/base/error.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

constexpr std::size_t kDeepestXml = 256;
constexpr std::size_t kLongestEntity = 1024;
constexpr std::size_t kMostExpanded = 1'000'000;
constexpr std::size_t kMostAttributes = 1024;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool is_name_character(char c) {
  return static_cast<unsigned char>(c) >= 0x80 || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         (c >= '0' && c <= '9') || c == '_' || c == ':' || c == '-' || c == '.';
}

std::string utf8_of(unsigned code) {
  std::string text;
  const auto put = [&](unsigned byte) { text += static_cast<char>(byte); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xc0 | code >> 6), put(0x80 | (code & 0x3f));
  } else if (code < 0x10000) {
    put(0xe0 | code >> 12), put(0x80 | (code >> 6 & 0x3f)), put(0x80 | (code & 0x3f));
  } else {
    put(0xf0 | code >> 18), put(0x80 | (code >> 12 & 0x3f)), put(0x80 | (code >> 6 & 0x3f)), put(0x80 | (code & 0x3f));
  }
  return text;
}

}  // namespace

XmlReader::XmlReader(std::string_view text) : text_(text) {
  if (text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE") || text.substr(0, 4).find('\0') != text.npos) {
    throw Error(ErrorCode::unsupported, "the text is UTF-16 or no text at all; wanted UTF-8");
  }
  if (text.starts_with("\xEF\xBB\xBF")) position_ = 3;
}

void XmlReader::fail(std::string_view text) const { throw_bad_file("line " + std::to_string(line_), text); }

void XmlReader::count_lines() {
  const std::string_view passed = text_.substr(counted_, position_ - counted_);
  line_ += static_cast<int>(std::count(passed.begin(), passed.end(), '\n'));
  counted_ = position_;
}

void XmlReader::skip_to(std::string_view mark, std::string_view what) {
  const std::size_t found = text_.find(mark, position_);
  if (found == std::string_view::npos) fail(std::string(what) + " does not end");
  position_ = found + mark.size();
}

XmlReader::Event XmlReader::next() {
  if (empty_) {
    empty_ = false;
    open_.pop_back();
    return Event::end;
  }
  attributes_.clear();
  for (;;) {
    const std::size_t tag = text_.find('<', position_);
    const std::string_view between = text_.substr(position_, tag - position_);
    if (open_.empty() && !trim(between).empty()) {
      position_ += static_cast<std::size_t>(trim(between).data() - between.data());
      count_lines();
      fail("got '" + printable(trim(between), 20) + "', wanted an XML element");
    }
    position_ = std::min(tag, text_.size());
    count_lines();
    if (tag == std::string_view::npos) {
      if (!open_.empty()) fail("the text ends within <" + printable(open_.back()) + ">");
      if (!rooted_) fail("there is no XML element");
      return Event::done;
    }
    const std::string_view rest = text_.substr(position_);
    if (rest.starts_with("<!--")) {
      position_ += 4;
      skip_to("-->", "a comment");
    } else if (rest.starts_with("<![CDATA[") && !open_.empty()) {
      skip_to("]]>", "a CDATA section");
    } else if (rest.starts_with("<?")) {
      skip_to("?>", "a processing instruction");
    } else if (rest.starts_with("<!DOCTYPE") && !rooted_) {
      skip_declarations();
    } else if (rest.starts_with("</")) {
      return read_end();
    } else {
      return read_start();
    }
  }
}

/// A document type: its name and identifiers say nothing; drawing programs declare entities for their namespaces there.
void XmlReader::skip_declarations() {
  position_ += std::string_view("<!DOCTYPE").size();
  bool inside = false;  // of the brackets
  while (position_ < text_.size()) {
    const char c = text_[position_];
    if (c == '"' || c == '\'') {
      ++position_;
      skip_to(std::string_view(&c, 1), "a quoted text");
    } else if (inside && text_.substr(position_).starts_with("<!--")) {
      skip_to("-->", "a comment");
    } else if (inside && text_.substr(position_).starts_with("<!ENTITY")) {
      declare_entity();
    } else {
      ++position_;
      if (c == '[') inside = true;
      if (c == ']') inside = false;
      if (c == '>' && !inside) return;
    }
  }
  fail("the DOCTYPE does not end");
}

void XmlReader::declare_entity() {
  position_ += std::string_view("<!ENTITY").size();
  skip_spaces();
  if (text_.substr(position_, 1) == "%") fail("the DOCTYPE declares a parameter entity");
  const std::string_view name = read_name();
  skip_spaces();
  if (position_ >= text_.size() || (text_[position_] != '"' && text_[position_] != '\'')) {
    fail("the entity '" + printable(name) + "' is not declared by a quoted text");
  }
  const std::size_t begin = position_ + 1;
  const char quote = text_[position_++];
  skip_to(std::string_view(&quote, 1), "a quoted text");
  const std::string_view value = text_.substr(begin, position_ - 1 - begin);
  if (value.size() > kLongestEntity || value.find_first_of("&<%") != std::string_view::npos) {
    fail("the entity '" + printable(name) + "' is too long or not plain text");
  }
  entities_.try_emplace(std::string(name), value);
  skip_to(">", "an entity");
}

void XmlReader::skip_spaces() {
  while (position_ < text_.size() && is_space(text_[position_])) ++position_;
}

std::string_view XmlReader::read_name() {
  const std::size_t begin = position_;
  while (position_ < text_.size() && is_name_character(text_[position_])) ++position_;
  if (position_ == begin) fail("got '" + printable(text_.substr(position_, 10)) + "', wanted a name");
  return text_.substr(begin, position_ - begin);
}

std::string XmlReader::resolve(std::string_view entity) const {
  constexpr std::pair<std::string_view, char> kKnown[] = {
      {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}};
  for (const auto& [name, character] : kKnown) {
    if (name == entity) return {character};
  }
  if (const auto declared = entities_.find(entity); declared != entities_.end()) return declared->second;
  if (entity.starts_with('#')) {
    const bool hexadecimal = entity.starts_with("#x");
    const std::string_view digits = entity.substr(hexadecimal ? 2 : 1);
    unsigned code = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), code, hexadecimal ? 16 : 10);
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    if (error == std::errc() && end == digits.data() + digits.size() && code > 0 && code < 0x110000 && !surrogate) {
      return utf8_of(code);
    }
  }
  fail("the entity '&" + printable(entity, 20) + ";' is not known");
}

std::string XmlReader::read_value() {
  skip_spaces();
  if (text_.substr(position_, 1) != "=") fail("an attribute without a value");
  ++position_;
  skip_spaces();
  const std::string_view quote = text_.substr(position_, 1);
  if (quote != "\"" && quote != "'") fail("an attribute's value without quotes");
  const std::size_t begin = ++position_;
  skip_to(quote, "an attribute's value");
  std::string_view raw = text_.substr(begin, position_ - 1 - begin);
  if (raw.find('<') != std::string_view::npos) fail("'<' within an attribute's value");
  std::string value;
  for (std::size_t ampersand; (ampersand = raw.find('&')) != std::string_view::npos;) {
    value += raw.substr(0, ampersand);
    const std::size_t end = raw.find(';', ampersand);
    if (end == std::string_view::npos) fail("an '&' that begins no entity");
    const std::string resolved = resolve(raw.substr(ampersand + 1, end - ampersand - 1));
    expanded_ += resolved.size();
    if (expanded_ > kMostExpanded) fail("more than a million bytes of entities");
    value += resolved;
    raw.remove_prefix(end + 1);
  }
  value += raw;
  return value;
}

XmlReader::Event XmlReader::read_start() {
  if (open_.empty() && rooted_) fail("a second root element");
  if (open_.size() == kDeepestXml) fail("elements more than " + std::to_string(kDeepestXml) + " deep");
  ++position_;
  const std::string_view full_name = read_name();
  for (;;) {
    const std::size_t before = position_;
    skip_spaces();
    const std::string_view rest = text_.substr(position_);
    if (rest.starts_with("/>") || rest.starts_with(">")) {
      empty_ = rest.front() == '/';
      position_ += empty_ ? 2 : 1;
      break;
    }
    if (rest.empty()) fail("the text ends within <" + printable(full_name) + ">");
    if (before == position_) fail("attributes without a space between them");
    const std::string_view attribute_name = read_name();
    if (attribute(attribute_name)) fail("the attribute " + printable(attribute_name) + " twice");
    if (attributes_.size() == kMostAttributes) fail("more than " + std::to_string(kMostAttributes) + " attributes");
    attributes_.emplace_back(attribute_name, read_value());
  }
  rooted_ = true;
  open_.push_back(full_name);
  name_ = full_name.substr(full_name.rfind(':') + 1);
  return Event::start;
}

XmlReader::Event XmlReader::read_end() {
  position_ += 2;
  const std::string_view full_name = read_name();
  skip_spaces();
  if (open_.empty() || open_.back() != full_name || text_.substr(position_, 1) != ">") {
    fail("got </" + printable(full_name, 20) + ">, wanted " +
         (open_.empty() ? "no more tags" : "</" + printable(open_.back(), 20) + ">"));
  }
  ++position_;
  open_.pop_back();
  name_ = full_name.substr(full_name.rfind(':') + 1);
  return Event::end;
}

std::optional<std::string_view> XmlReader::attribute(std::string_view name) const {
  for (const auto& [key, value] : attributes_) {
    if (key == name) return std::string_view(value);
  }
  return std::nullopt;
}

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : to_utf8(text)) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else if (c == '\n' || c == '\r' || c == '\t')
      escaped += "&#" + std::to_string(static_cast<int>(c)) + ";";
    else
      escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return escaped;
}

}  // namespace croquis
