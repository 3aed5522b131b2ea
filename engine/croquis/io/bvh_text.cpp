// SPDX-License-Identifier: MIT
#include "croquis/io/bvh_text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

constexpr int kMostNodes = 65536;
constexpr double kLargestNumber = 1e12;  // sums of such numbers along a skeleton stay finite

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// The words of the file with their lines. A brace is a word of its own only where words of the hierarchy are read.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {
    if (text.starts_with("\xEF\xBB\xBF")) position_ = 3;  // a byte order mark
  }

  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] std::string place() const { return "line " + std::to_string(line_); }

  /// The next word; empty at the end of the file. `line()` is then the word's line.
  std::string_view next() {
    skip_spaces();
    const std::size_t begin = position_;
    if (position_ < text_.size() && is_brace(text_[position_])) {
      ++position_;
    } else {
      while (position_ < text_.size() && !is_blank(text_[position_]) && !is_brace(text_[position_])) ++position_;
    }
    word_begin_ = begin;
    return text_.substr(begin, position_ - begin);
  }
  [[nodiscard]] std::size_t word_begin() const { return word_begin_; }
  std::string_view peek() {
    const Words before = *this;
    const std::string_view word = next();
    *this = before;
    return word;
  }

  /// "Frame Time" of "Frame Time : 0.1": what stands on the next line that is not empty, up to its colon, which is
  /// passed.
  std::string_view label() {
    skip_spaces();
    const std::size_t begin = position_;
    while (position_ < text_.size() && !is_line_end(text_[position_]) && text_[position_] != ':') ++position_;
    const std::string_view label = trim(text_.substr(begin, position_ - begin));
    if (position_ < text_.size() && text_[position_] == ':') ++position_;
    return label;
  }
  /// What is left of this line, trimmed.
  std::string_view rest_of_line() {
    const std::size_t begin = position_;
    while (position_ < text_.size() && !is_line_end(text_[position_])) ++position_;
    return trim(text_.substr(begin, position_ - begin));
  }
  /// A joint's name: what is left of the line, up to a brace that opens the joint there.
  std::string_view name() {
    const std::size_t begin = position_;
    while (position_ < text_.size() && !is_line_end(text_[position_])) {
      const bool opens = text_[position_] == '{' && position_ > 0 && is_blank(text_[position_ - 1]) &&
                         (position_ + 1 == text_.size() || is_blank(text_[position_ + 1]));
      if (opens) break;
      ++position_;
    }
    return trim(text_.substr(begin, position_ - begin));
  }

 private:
  static bool is_brace(char c) { return c == '{' || c == '}'; }
  void skip_spaces() {
    for (; position_ < text_.size() && is_blank(text_[position_]); ++position_) {
      const char c = text_[position_];
      const bool before_newline = position_ + 1 < text_.size() && text_[position_ + 1] == '\n';
      if (c == '\n' || (c == '\r' && !before_newline)) ++line_;
    }
  }

  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t word_begin_ = 0;
  int line_ = 1;
};

std::string shown(std::string_view word) {
  return word.empty() ? "the end of the file" : "'" + printable(word, 40) + "'";
}

class Parser {
 public:
  Parser(std::string_view text, int most_frames) : text_(text), words_(text), most_frames_(most_frames) {}

  BvhText parse() {
    if (const std::size_t end = text_.find_first_of("\r\n"); end != std::string_view::npos) {
      file_.new_line = text_.substr(end, 2) == "\r\n" ? "\r\n" : text_.substr(end, 1);
    }
    expect("HIERARCHY");
    hierarchy();
    motion();
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail(const std::string& text) const { throw_bad_file(words_.place(), text); }

  /// A word that stands where it should.
  void expect(std::string_view wanted) {
    const std::string_view word = words_.next();
    if (to_lower(word) != to_lower(wanted)) fail("got " + shown(word) + ", wanted " + std::string(wanted));
  }

  [[nodiscard]] double number(std::string_view word, std::string_view what) const {
    const auto value = parse_double(word);
    if (!value) fail("got " + shown(word) + ", wanted a number for " + std::string(what));
    if (std::abs(*value) > kLargestNumber) fail(shown(word) + " is too large for " + std::string(what));
    return *value;
  }

  void hierarchy() {
    std::vector<int> open;  // the nodes whose braces are open, innermost last; no recursion, so any depth will do
    for (;;) {
      if (open.empty()) {
        file_.hierarchy_end = words_.position();
        const std::string next = to_lower(words_.peek());
        if (next != "root" && !file_.nodes.empty()) return;
      }
      const std::string_view word = words_.next();
      const std::string keyword = to_lower(word);
      if (keyword == "root" || (keyword == "joint" && !open.empty())) {
        if (keyword == "root" && !open.empty()) fail("a ROOT within a joint");
        open.push_back(add_node(open.empty() ? -1 : open.back(), false));
      } else if ((keyword == "end" || keyword == "endsite") && !open.empty()) {
        open.push_back(add_node(open.back(), true));
      } else if (keyword == "offset" && !open.empty()) {
        offset(open.back());
      } else if (keyword == "channels" && !open.empty()) {
        channels(open.back());
      } else if (keyword == "}" && !open.empty()) {
        close(open.back());
        open.pop_back();
      } else {
        fail("got " + shown(word) + ", wanted " +
             (open.empty() ? "ROOT"
                           : "OFFSET, CHANNELS, JOINT, End Site or the closing brace of " + called(open.back())));
      }
    }
  }

  int add_node(int parent, bool end_site) {
    if (std::ssize(file_.nodes) == kMostNodes) fail("more than " + std::to_string(kMostNodes) + " joints");
    if (parent >= 0 && node(parent).end_site) fail("a joint within an End Site");
    BvhNode added;
    added.line = words_.line();
    added.parent = parent;
    added.end_site = end_site;
    const std::string_view name = words_.name();
    if (!end_site) added.name = to_utf8(name);
    if (!end_site && added.name != name && !std::exchange(odd_name_, true)) {
      file_.oddities.push_back("line " + std::to_string(added.line) + ": the name '" + printable(name) +
                               "' is not UTF-8; its bytes are taken as Latin-1");
    }
    file_.nodes.push_back(std::move(added));
    has_offset_.push_back(false);
    expect("{");
    return static_cast<int>(file_.nodes.size()) - 1;
  }

  void offset(int index) {
    if (has_offset_[static_cast<std::size_t>(index)]) fail("a second OFFSET of " + called(index));
    has_offset_[static_cast<std::size_t>(index)] = true;
    for (int axis = 0; axis < 3; ++axis) {
      node(index).offset[axis] = number(words_.next(), "OFFSET");
      if (axis == 0) node(index).offset_text.begin = words_.word_begin();
    }
    node(index).offset_text.end = words_.position();
  }

  void channels(int index) {
    BvhNode& owner = node(index);
    if (index + 1 != std::ssize(file_.nodes)) fail("CHANNELS of " + called(index) + " behind the joints within it");
    if (owner.channels_text.end != 0) fail("a second CHANNELS of " + called(index));
    owner.channels_text.begin = words_.word_begin();
    const std::string_view word = words_.next();
    const auto count = parse_int(word);
    if (!count || *count < 0 || *count > 6) fail("got " + shown(word) + ", wanted a number of channels from 0 to 6");
    if (*count > 0 && owner.end_site) fail("channels on an End Site");
    owner.first_channel = file_.channel_count;
    for (int i = 0; i < *count; ++i) {
      const std::string_view spelled = words_.next();
      const auto match = [&](std::string_view known) { return to_lower(known) == to_lower(spelled); };
      const auto* const found = std::find_if(kBvhChannelNames.begin(), kBvhChannelNames.end(), match);
      if (found == kBvhChannelNames.end()) {
        fail("got " + shown(spelled) + ", wanted a channel such as Xposition or Zrotation");
      }
      const auto channel = static_cast<BvhChannel>(found - kBvhChannelNames.begin());
      if (owner.has(channel)) fail("the channel " + std::string(*found) + " twice on " + called(index));
      owner.channels.push_back(channel);
    }
    owner.channels_text.end = words_.position();
    file_.channel_count += *count;
  }

  void close(int index) {
    if (!has_offset_[static_cast<std::size_t>(index)])
      fail("the block of " + called(index) + " ends without an OFFSET");
  }

  void motion() {
    const std::string_view word = words_.peek();
    if (word.empty()) {
      file_.oddities.emplace_back("the file has no MOTION");
      return;
    }
    expect("MOTION");
    const int announced = announced_frames();
    header("Frame Time");
    const std::string_view time = words_.rest_of_line();
    const auto seconds = parse_double(time);
    if (!seconds || std::abs(*seconds) > kLargestNumber) fail("got " + shown(time) + ", wanted the seconds of a frame");
    file_.frame_time = *seconds;
    file_.frame_time_text = time;
    rows(announced);
    if (file_.frame_count != std::min(announced, most_frames_)) {
      file_.oddities.push_back(std::to_string(announced) + " frames are announced, " +
                               std::to_string(file_.frame_count) + " are there");
    }
  }

  void header(std::string_view wanted) {
    const std::string_view label = words_.label();
    if (join(split(to_lower(label), ' '), "") != join(split(to_lower(wanted), ' '), ""))
      fail("got " + shown(label) + ", wanted '" + std::string(wanted) + ":'");
  }

  int announced_frames() {
    header("Frames");
    const std::string_view word = words_.rest_of_line();
    const auto count = parse_int(word);
    if (!count || *count < 0) fail("got " + shown(word) + ", wanted the number of frames");
    return *count;
  }

  void rows(int announced) {
    const auto width = static_cast<std::size_t>(file_.channel_count);
    const auto most_values = std::uint64_t{width} * static_cast<std::uint64_t>(most_frames_);
    std::vector<double>& values = file_.values;
    // A number and the space after it take two bytes at least: an announced size is not trusted beyond that.
    values.reserve(
        static_cast<std::size_t>(std::min({std::uint64_t{width} * static_cast<std::uint64_t>(announced), most_values,
                                           std::uint64_t{text_.size() - words_.position()} / 2 + 1})));
    int ragged_line = 0, line = 0;
    std::size_t ragged_begin = 0, line_begin = 0;
    const auto end_line = [&] {
      const std::size_t count = values.size() - line_begin;
      if (count != 0 && count != width && ragged_line == 0) {
        ragged_line = line;
        ragged_begin = line_begin;
      }
      line_begin = values.size();
    };
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
      const double value = number(word, "a channel of the motion");
      if (words_.line() != line) end_line();
      line = words_.line();
      values.push_back(value);
      if (values.size() >= most_values) break;
    }
    end_line();
    if (width == 0 && !values.empty())
      throw_bad_file("line " + std::to_string(line), "motion values, but no joint has channels");
    if (width == 0) return;
    if (values.size() % width != 0) drop_ragged_end(announced, ragged_line, ragged_begin);
    file_.frame_count = static_cast<int>(values.size() / width);
  }

  void drop_ragged_end(int announced, int line, std::size_t begin) {
    const auto width = static_cast<std::size_t>(file_.channel_count);
    const std::string place = "line " + std::to_string(line);
    const std::string text = "the row that begins here is not a multiple of the " + std::to_string(width) + " channels";
    if (begin % width != 0 || begin / width < static_cast<std::size_t>(announced)) throw_bad_file(place, text);
    file_.oddities.push_back(place + ": " + text + "; it stands after the announced frames and is left out");
    file_.values.resize(begin);
  }

  BvhNode& node(int index) { return file_.nodes[static_cast<std::size_t>(index)]; }
  std::string called(int index) {
    const BvhNode& it = node(index);
    return it.end_site ? "the End Site of line " + std::to_string(it.line) : "joint '" + printable(it.name) + "'";
  }

  std::string_view text_;
  Words words_;
  int most_frames_;
  BvhText file_;
  std::vector<bool> has_offset_;
  bool odd_name_ = false;  // one is enough to tell of
};

}  // namespace

bool BvhNode::has(BvhChannel channel) const {
  return std::find(channels.begin(), channels.end(), channel) != channels.end();
}

BvhText parse_bvh(std::span<const std::byte> bytes, int most_frames) {
  return Parser({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, most_frames).parse();
}

}  // namespace croquis
