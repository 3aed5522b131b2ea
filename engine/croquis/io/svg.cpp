// SPDX-License-Identifier: MIT
#include "croquis/io/svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/svg_path.h"
#include "croquis/io/xml.h"

namespace croquis {
namespace {

constexpr double kTolerance = 0.1;  // pixels
constexpr std::size_t kMostPoints = 4'000'000;

/// What holds for an element and all within it.
struct Group {
  Affine2 pixels_from_user = Affine2::Identity();
  bool drawn = true;
};

/// A length in pixels of CSS (96 to the inch); nothing for a percentage or what depends on a font.
std::optional<double> parse_length(std::optional<std::string_view> text) {
  if (!text) return std::nullopt;
  constexpr std::array<std::pair<std::string_view, double>, 7> kUnits = {{{"", 1.0},
                                                                          {"px", 1.0},
                                                                          {"pt", 4.0 / 3.0},
                                                                          {"pc", 16.0},
                                                                          {"in", 96.0},
                                                                          {"mm", 96.0 / 25.4},
                                                                          {"cm", 96.0 / 2.54}}};
  const std::string_view trimmed = trim(*text);
  const std::size_t number_end = trimmed.find_last_of("0123456789.") + 1;
  const auto value = parse_double(trimmed.substr(0, number_end));
  for (const auto& [unit, pixels] : kUnits) {
    if (value && trimmed.substr(number_end) == unit) return *value * pixels;
  }
  return std::nullopt;
}

/// The value of a property, from the style attribute or else the attribute of that name; empty without either.
std::string property(const XmlReader& xml, std::string_view name) {
  for (const std::string& declaration : split(xml.attribute("style").value_or(""), ';')) {
    const std::size_t colon = declaration.find(':');
    if (colon != std::string::npos && trim(declaration.substr(0, colon)) == name) {
      return std::string(trim(std::string_view(declaration).substr(colon + 1)));
    }
  }
  return std::string(trim(xml.attribute(name).value_or("")));
}

/// A box fitted into another as large as it goes, in the middle: xMidYMid meet.
Affine2 fit(const Eigen::AlignedBox2d& view, const Eigen::AlignedBox2d& into) {
  const double scale = into.sizes().cwiseQuotient(view.sizes()).minCoeff();
  Affine2 map = Affine2::Identity();
  map.translate(into.center()).scale(scale).translate(-view.center());
  return map;
}

class Reader {
 public:
  Reader(std::string_view text, int width_px, int height_px) : xml_(text), size_px_(width_px, height_px) {}

  std::vector<Stroke> read() {
    for (;;) {
      switch (xml_.next()) {
        case XmlReader::Event::start:
          open();
          break;
        case XmlReader::Event::end:
          groups_.pop_back();
          break;
        case XmlReader::Event::done:
          return finish();
      }
    }
  }

 private:
  [[nodiscard]] std::string place(std::string_view attribute) const {
    return "line " + std::to_string(xml_.line()) + ": " + std::string(attribute) + " of <" +
           printable(xml_.name(), 20) + ">";
  }

  void open() {
    const std::string_view name = xml_.name();
    if (groups_.empty() && name != "svg") {
      throw_bad_file("line " + std::to_string(xml_.line()), "got <" + printable(name, 20) + ">, wanted <svg>");
    }
    Group group = groups_.empty() ? Group() : groups_.back();
    constexpr std::string_view kNotDrawn[] = {"defs", "clipPath", "mask", "symbol", "pattern", "marker", "glyph"};
    const bool hidden = std::find(std::begin(kNotDrawn), std::end(kNotDrawn), name) != std::end(kNotDrawn) ||
                        property(xml_, "display") == "none" || property(xml_, "visibility") == "hidden";
    group.drawn = group.drawn && !hidden;
    if (group.drawn) {
      if (name == "svg") group.pixels_from_user = group.pixels_from_user * viewport();
      if (const auto transform = xml_.attribute("transform")) {
        group.pixels_from_user = group.pixels_from_user * parse_svg_transform(*transform, place("the transform"));
      }
      draw(group.pixels_from_user);
    }
    groups_.push_back(group);
  }

  /// The map from the user units of an <svg> to those around it (of the outermost: to pixels).
  Affine2 viewport() {
    const bool outermost = groups_.empty();
    const auto width = parse_length(xml_.attribute("width")), height = parse_length(xml_.attribute("height"));
    const auto length = [&](std::string_view name) { return parse_length(xml_.attribute(name)).value_or(0.0); };
    const Vec2 corner = outermost ? Vec2::Zero() : Vec2(length("x"), length("y"));
    std::optional<Eigen::AlignedBox2d> view;
    if (const auto text = xml_.attribute("viewBox")) {
      SvgNumbers in(*text, place("the viewBox"));
      const Vec2 low = in.point(), size = in.point();
      if (!(size.minCoeff() > 0.0)) in.fail("wanted a width and a height above zero");
      view.emplace(low, Vec2(low + size));
    } else if (outermost && width && height && std::min(*width, *height) > 0.0) {
      view.emplace(Vec2::Zero(), Vec2(*width, *height));
    }
    const Vec2 size = outermost ? size_px_ : Vec2(width.value_or(0.0), height.value_or(0.0));
    if (view && size.minCoeff() > 0.0) return fit(*view, {corner, Vec2(corner + size)});
    return Affine2(Eigen::Translation2d(corner));
  }

  void draw(const Affine2& map) {
    const std::string_view name = xml_.name();
    std::vector<std::vector<Vec2>> lines;
    if (name == "path") {
      const std::string_view data = xml_.attribute("d").value_or("");
      if (trim(data) != "none") lines = flatten_svg_path(data, map, kTolerance, place("the d"), points_left_);
    } else if (name == "polyline") {
      SvgNumbers in(xml_.attribute("points").value_or(""), place("the points"));
      lines.emplace_back();
      while (!in.at_end()) lines.back().push_back(map * in.point());
    } else if (name == "line") {
      const auto end = [&](std::string_view x, std::string_view y) {
        const auto coordinate = [&](std::string_view key) {
          const auto length = parse_length(xml_.attribute(key).value_or("0"));
          if (!length) throw_bad_file(place("the " + std::string(key)), "wanted a length");
          return *length;
        };
        return Vec2(map * Vec2(coordinate(x), coordinate(y)));
      };
      lines = {{end("x1", "y1"), end("x2", "y2")}};
    } else {
      return;
    }
    add(lines, map);
  }

  void add(const std::vector<std::vector<Vec2>>& lines, const Affine2& map) {
    const std::string id = to_utf8(xml_.attribute("id").value_or(""));
    int number = 0;
    for (const std::vector<Vec2>& line : lines) {
      const std::size_t used = line.size() + 1;
      if (used > points_left_) throw_bad_file("line " + std::to_string(xml_.line()), "too many points");
      points_left_ -= used;
      const auto differs = [&](const Vec2& point) { return point != line.front(); };
      if (std::none_of(line.begin(), line.end(), differs)) continue;  // a dot draws nothing
      Stroke stroke;
      stroke.name = ++number == 1 || id.empty() ? id : id + "-" + std::to_string(number);
      for (const Vec2& point : line) {
        if (!point.allFinite()) throw_bad_file("line " + std::to_string(xml_.line()), "a point beyond all bounds");
        stroke.samples.push_back({.position = point});
      }
      if (lines.size() == 1) take_samples(stroke, map);
      strokes_.push_back(std::move(stroke));
    }
  }

  /// The times and pressures that write_svg_strokes left. Where another program has changed the path since, its points
  /// no longer are the samples, and the path counts.
  void take_samples(Stroke& stroke, const Affine2& map) {
    const auto text = xml_.attribute("data-samples");
    if (!text) return;
    SvgNumbers in(*text, place("the data-samples"));
    std::vector<StrokeSample> samples;
    while (!in.at_end()) {
      const Vec2 position = map * in.point();
      const double time = in.number();
      samples.push_back({.position = position, .time = time, .pressure = std::clamp(in.number(), 0.0, 1.0)});
    }
    const double close = 1e-3 * std::max(1.0, map.linear().norm());
    const bool same = std::equal(
        samples.begin(), samples.end(), stroke.samples.begin(), stroke.samples.end(),
        [&](const StrokeSample& a, const StrokeSample& b) { return (a.position - b.position).norm() <= close; });
    if (!same) return;
    stroke.samples = std::move(samples);
    stroke.raw_pen = xml_.attribute("data-raw-pen") == "true";
  }

  std::vector<Stroke> finish() {
    if (strokes_.empty())
      throw Error(ErrorCode::bad_file, "no stroke: wanted a <path>, <polyline> or <line> that is drawn");
    return std::move(strokes_);
  }

  XmlReader xml_;
  Vec2 size_px_;
  std::vector<Group> groups_;  // of the elements that are open
  std::vector<Stroke> strokes_;
  std::size_t points_left_ = kMostPoints;
};

}  // namespace

std::vector<Stroke> read_svg_strokes(std::span<const std::byte> bytes, int width_px, int height_px) {
  if (width_px <= 0 || height_px <= 0) {
    throw_invalid_argument("read_svg_strokes: the picture is " + std::to_string(width_px) + " x " +
                           std::to_string(height_px) + " pixels, wanted sizes above zero");
  }
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with("\x1f\x8b")) {
    throw Error(ErrorCode::unsupported, "the SVG is compressed (.svgz); save it as plain .svg");
  }
  return Reader(text, width_px, height_px).read();
}

std::string write_svg_strokes(const std::vector<Stroke>& strokes, int width_px, int height_px) {
  const std::string width = std::to_string(width_px), height = std::to_string(height_px);
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
                     "\" viewBox=\"0 0 " + width + " " + height + "\">\n";
  for (const Stroke& stroke : strokes) {
    text += "  <path";
    if (!stroke.name.empty()) text += " id=\"" + xml_escaped(stroke.name) + "\"";
    text += " fill=\"none\" stroke=\"#222\" stroke-width=\"3\" stroke-linecap=\"round\" stroke-linejoin=\"round\"";
    std::string data, samples;
    for (const StrokeSample& sample : stroke.samples) {
      constexpr int kDigits = 15;  // of a decimal number all that a double keeps
      const std::string position =
          format_double(sample.position.x(), kDigits) + " " + format_double(sample.position.y(), kDigits);
      data += (data.empty() ? "M" : " L") + position;
      if (!samples.empty()) samples += "  ";
      samples += position + " " + format_double(sample.time, kDigits) + " " + format_double(sample.pressure, kDigits);
    }
    text += " d=\"" + data + "\" data-samples=\"" + samples + "\"";
    text += stroke.raw_pen ? " data-raw-pen=\"true\"/>\n" : "/>\n";
  }
  return text + "</svg>\n";
}

}  // namespace croquis
