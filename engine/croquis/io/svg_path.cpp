// SPDX-License-Identifier: MIT
//
// Path data as SVG 1.1, chapter 8 and appendix F.6 (arcs from end points), defines it; key svg11 in
// docs/bibliography.bib.
#include "croquis/io/svg_path.h"

#include <algorithm>
#include <cmath>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/ascii.h"

namespace croquis {
namespace {

constexpr double kLargestCoordinate = 1e12;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Collects the points of subpaths in pixels.
class Flattener {
 public:
  Flattener(const Affine2& map, double tolerance, const std::string& place, std::size_t most_points)
      : map_(map), tolerance_(tolerance), place_(place), left_(most_points) {}

  void begin(const Vec2& point) {
    subpaths_.emplace_back();
    add(map_ * point);
  }
  void line(const Vec2& to) { add(map_ * to); }

  /// A Bezier curve is mapped by its control points. With M the larger of |p0 - 2 p1 + p2| and |p1 - 2 p2 + p3| its
  /// second derivative is at most 6 M, so n equal steps leave chords within 6 M / (8 n^2).
  void cubic(const Vec2& from, const Vec2& first, const Vec2& second, const Vec2& to) {
    const Vec2 p0 = map_ * from, p1 = map_ * first, p2 = map_ * second, p3 = map_ * to;
    const double bend = std::max((p0 - 2 * p1 + p2).norm(), (p1 - 2 * p2 + p3).norm());
    const int steps = step_count(std::sqrt(0.75 * bend / tolerance_));
    for (int i = 1; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps, s = 1.0 - t;
      add(s * s * s * p0 + 3.0 * s * s * t * p1 + 3.0 * s * t * t * p2 + t * t * t * p3);
    }
  }

  /// An elliptical arc from its end points.
  void arc(const Vec2& from, Vec2 radii, double rotation, bool large, bool sweep, const Vec2& to) {
    radii = radii.cwiseAbs();
    if (from == to) return;
    if (radii.minCoeff() < 1e-12 * (to - from).norm()) return line(to);
    const Eigen::Rotation2Dd turn(rotation);
    // In the frame in which the ellipse is the unit circle about the origin.
    const Vec2 half = (turn.inverse() * ((from - to) / 2.0)).cwiseQuotient(radii);
    const double grow = std::max(1.0, half.norm());  // radii too small to reach are scaled up
    radii *= grow;
    const Vec2 chord = half / grow;
    const double height = std::sqrt(std::max(0.0, 1.0 / chord.squaredNorm() - 1.0));
    const Vec2 centre = (large == sweep ? -height : height) * Vec2(chord.y(), -chord.x());
    const Vec2 start = chord - centre, end = -chord - centre;
    double angle = std::atan2(cross(start, end), start.dot(end));
    if (sweep && angle < 0.0) angle += 2.0 * kPi;
    if (!sweep && angle > 0.0) angle -= 2.0 * kPi;
    Eigen::Matrix2d frame = map_.linear() * turn.toRotationMatrix() * radii.asDiagonal();
    const Vec2 middle = map_ * Vec2((from + to) / 2.0) + frame * centre;
    // A chord over the angle a of a circle of radius r is r (1 - cos(a / 2)) < r a^2 / 8 off.
    const int steps = step_count(std::abs(angle) * std::sqrt(frame.norm() / (8.0 * tolerance_)));
    for (int i = 1; i < steps; ++i) add(middle + frame * (Eigen::Rotation2Dd(angle * i / steps) * start));
    line(to);
  }

  std::vector<std::vector<Vec2>> take() { return std::move(subpaths_); }

 private:
  static int step_count(double wanted) {
    constexpr int kMost = 10000;  // also where the number is none: `add` refuses such a point
    return wanted < kMost ? std::max(1, static_cast<int>(std::ceil(wanted))) : kMost;
  }

  void add(const Vec2& point) {
    if (!point.allFinite() || point.cwiseAbs().maxCoeff() > kLargestCoordinate)
      throw_bad_file(place_, "a point beyond all bounds");
    if (left_-- == 0) throw_bad_file(place_, "too many points");
    subpaths_.back().push_back(point);
  }

  Affine2 map_;
  double tolerance_;
  const std::string& place_;
  std::size_t left_;  // of the points that may still be added
  std::vector<std::vector<Vec2>> subpaths_;
};

/// Carries out the commands of path data.
class PathInterpreter {
 public:
  PathInterpreter(SvgNumbers& numbers, Flattener& out) : numbers_(numbers), out_(out) {}

  void run() {
    if (numbers_.at_end()) return;
    char command = numbers_.letter();
    if (command != 'M' && command != 'm') numbers_.fail("wanted the command M first");
    for (;;) {
      carry_out(command);
      if (numbers_.at_end()) return;
      if (!numbers_.at_number()) {
        command = numbers_.letter();
      } else if (command == 'Z' || command == 'z') {
        numbers_.fail("numbers behind Z");
      } else if (command == 'M' || command == 'm') {
        command = command == 'M' ? 'L' : 'l';  // further points of a move are lines
      }
    }
  }

 private:
  void carry_out(char command) {
    const bool relative = command >= 'a';
    const Vec2 origin = relative ? at_ : Vec2::Zero();
    const auto point = [&] { return Vec2(origin + numbers_.point()); };
    const char kind = relative ? static_cast<char>(command - 'a' + 'A') : command;
    if (kind != 'M' && kind != 'Z' && !drawing_) {
      out_.begin(at_);
      drawing_ = true;
    }
    Vec2 control = at_;  // for a following S or T; without a curve it is the current point
    switch (kind) {
      case 'M':
        at_ = start_ = point();
        out_.begin(at_);
        drawing_ = true;
        break;
      case 'Z':
        if (drawing_) out_.line(start_);
        at_ = start_;
        drawing_ = false;
        break;
      case 'L':
        line(point());
        break;
      case 'H':
        line(Vec2(origin.x() + numbers_.number(), at_.y()));
        break;
      case 'V':
        line(Vec2(at_.x(), origin.y() + numbers_.number()));
        break;
      case 'C':
      case 'S': {
        const Vec2 first = kind == 'C' ? point() : last_kind_ == 'C' ? Vec2(2.0 * at_ - control_) : at_;
        control = point();
        curve(first, control, point());
        break;
      }
      case 'Q':
      case 'T': {
        control = kind == 'Q' ? point() : last_kind_ == 'Q' ? Vec2(2.0 * at_ - control_) : at_;
        const Vec2 to = point();
        curve(at_ + 2.0 / 3.0 * (control - at_), to + 2.0 / 3.0 * (control - to), to);
        break;
      }
      case 'A':
        arc(origin);
        break;
      default:
        numbers_.fail("'" + printable({&command, 1}) + "' is no path command");
    }
    control_ = control;
    last_kind_ = kind == 'S' ? 'C' : kind == 'T' ? 'Q' : kind;
  }

  void line(const Vec2& to) {
    out_.line(to);
    at_ = to;
  }
  void curve(const Vec2& first, const Vec2& second, const Vec2& to) {
    out_.cubic(at_, first, second, to);
    at_ = to;
  }
  void arc(const Vec2& origin) {
    const Vec2 radii = numbers_.point();
    const double rotation = numbers_.number() * kDegree;
    const bool large = numbers_.flag(), sweep = numbers_.flag();
    const Vec2 to = origin + numbers_.point();
    out_.arc(at_, radii, rotation, large, sweep, to);
    at_ = to;
  }

  SvgNumbers& numbers_;
  Flattener& out_;
  Vec2 at_ = Vec2::Zero();
  Vec2 start_ = Vec2::Zero();    // of the subpath
  Vec2 control_ = Vec2::Zero();  // the last control point of the last command, if that was a curve
  char last_kind_ = 'M';
  bool drawing_ = false;  // a subpath is open
};

}  // namespace

void SvgNumbers::fail(std::string_view text) const {
  throw_bad_file(place_, std::string(text) + " (at character " + std::to_string(position_ + 1) + ")");
}

void SvgNumbers::skip_separators() {
  while (position_ < text_.size() && std::string_view(" \t\r\n\f,").find(text_[position_]) != std::string_view::npos) {
    ++position_;
  }
}

bool SvgNumbers::at_end() {
  skip_separators();
  return position_ >= text_.size();
}

bool SvgNumbers::at_number() {
  skip_separators();
  if (position_ >= text_.size()) return false;
  const char c = text_[position_];
  return is_digit(c) || c == '+' || c == '-' || c == '.';
}

double SvgNumbers::number() {
  skip_separators();
  std::size_t end = position_;
  const auto here = [&] { return end < text_.size() ? text_[end] : '\0'; };
  const auto digits = [&] {
    while (is_digit(here())) ++end;
  };
  if (here() == '+' || here() == '-') ++end;
  digits();
  if (here() == '.') {
    ++end;
    digits();
  }
  if (here() == 'e' || here() == 'E') {
    const std::size_t mantissa = end++;
    if (here() == '+' || here() == '-') ++end;
    if (is_digit(here()))
      digits();
    else
      end = mantissa;  // the "e" of "em" is no exponent
  }
  const auto value = parse_double(text_.substr(position_, end - position_));
  if (!value || std::abs(*value) > kLargestCoordinate) {
    const std::string_view shown = text_.substr(position_, std::max<std::size_t>(end - position_, 1));
    fail(shown.empty() ? "wanted a number" : "got '" + printable(shown, 20) + "', wanted a number");
  }
  position_ = end;
  return *value;
}

bool SvgNumbers::flag() {
  skip_separators();
  const char c = position_ < text_.size() ? text_[position_] : '\0';
  if (c != '0' && c != '1') fail("wanted a flag, 0 or 1");
  ++position_;
  return c == '1';
}

char SvgNumbers::letter() {
  skip_separators();
  return position_ < text_.size() ? text_[position_++] : '\0';
}

std::string_view SvgNumbers::word() {
  skip_separators();
  const std::size_t begin = position_;
  while (position_ < text_.size() && is_letter(text_[position_])) ++position_;
  return text_.substr(begin, position_ - begin);
}

void SvgNumbers::expect(char character) {
  skip_separators();
  if (position_ >= text_.size() || text_[position_] != character) fail("wanted '" + std::string(1, character) + "'");
  ++position_;
}

Affine2 parse_svg_transform(std::string_view text, const std::string& place) {
  SvgNumbers in(text, place);
  Affine2 all = Affine2::Identity();
  while (!in.at_end()) {
    const std::string name(in.word());
    if (name == "none") continue;
    in.expect('(');
    std::vector<double> v;
    while (in.at_number() && v.size() < 6) v.push_back(in.number());
    in.expect(')');
    const auto has = [&](std::size_t fewest, std::size_t most) { return v.size() == fewest || v.size() == most; };
    Affine2 one = Affine2::Identity();
    if (name == "matrix" && has(6, 6))
      one.matrix().topRows<2>() << v[0], v[2], v[4], v[1], v[3], v[5];
    else if (name == "translate" && has(1, 2))
      one.translate(Vec2(v[0], v.size() > 1 ? v[1] : 0.0));
    else if (name == "scale" && has(1, 2))
      one.scale(Vec2(v[0], v.back()));
    else if (name == "rotate" && has(1, 1))
      one.rotate(v[0] * kDegree);
    else if (name == "rotate" && has(3, 3)) {
      const Vec2 about(v[1], v[2]);
      one.translate(about).rotate(v[0] * kDegree).translate(-about);
    } else if (name == "skewX" && has(1, 1))
      one(0, 1) = std::tan(v[0] * kDegree);
    else if (name == "skewY" && has(1, 1))
      one(1, 0) = std::tan(v[0] * kDegree);
    else
      in.fail("'" + printable(name, 20) + "' with " + std::to_string(v.size()) + " numbers is no transform");
    all = all * one;
  }
  return all;
}

std::vector<std::vector<Vec2>> flatten_svg_path(std::string_view data, const Affine2& pixels_from_path,
                                                double tolerance, const std::string& place, std::size_t most_points) {
  SvgNumbers numbers(data, place);
  Flattener out(pixels_from_path, tolerance, place, most_points);
  PathInterpreter(numbers, out).run();
  return out.take();
}

}  // namespace croquis
