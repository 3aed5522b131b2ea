// SPDX-License-Identifier: MIT
#include "croquis/io/svg.h"

#include "support/data.h"
#include "support/random_math.h"
#include <chrono>
#include <cmath>

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

constexpr int kSize = 100;

std::string svg(const std::string& content, const std::string& attributes = "viewBox='0 0 100 100'") {
  return "<svg xmlns='http://www.w3.org/2000/svg' " + attributes + ">" + content + "</svg>";
}

std::vector<Stroke> read(const std::string& text, int width = kSize, int height = kSize) {
  return read_svg_strokes(bytes_of(text), width, height);
}

std::vector<Vec2> points(const Stroke& stroke) {
  std::vector<Vec2> points;
  for (const StrokeSample& sample : stroke.samples) points.push_back(sample.position);
  return points;
}

void expect_points(const std::string& text, const std::vector<Vec2>& wanted, int width = kSize, int height = kSize) {
  const std::vector<Stroke> strokes = read(text, width, height);
  ASSERT_EQ(strokes.size(), 1U) << text;
  const std::vector<Vec2> got = points(strokes[0]);
  ASSERT_EQ(got.size(), wanted.size()) << text;
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_LT((got[i] - wanted[i]).norm(), 1e-9) << text << ": point " << i << " is " << got[i].transpose();
  }
}

void expect_path(const std::string& data, const std::vector<Vec2>& wanted) {
  expect_points(svg("<path d='" + data + "'/>"), wanted);
}

Error error_of(const std::string& text) {
  try {
    (void)read(text);
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error for " << text;
  return {ErrorCode::internal, ""};
}

TEST(Svg, ReadsStraightCommandsAbsoluteAndRelative) {
  expect_path("M 1 2 L 3 4 H 5 V 6 Z", {{1, 2}, {3, 4}, {5, 4}, {5, 6}, {1, 2}});
  expect_path("m1 2l2 2h2v2z", {{1, 2}, {3, 4}, {5, 4}, {5, 6}, {1, 2}});
  expect_path("M1,2 3,4 5,6", {{1, 2}, {3, 4}, {5, 6}});
  expect_path("m1,2 3,4 5,6", {{1, 2}, {4, 6}, {9, 12}});
  expect_path("M0 0H1 2 3", {{0, 0}, {1, 0}, {2, 0}, {3, 0}});
}

TEST(Svg, ReadsNumbersAsTightAsTheyMayStand) {
  expect_path("M1.5.5-3e1-.25+4,1E1", {{1.5, 0.5}, {-30, -0.25}, {4, 10}});
  expect_path("M.5.5l.5-.5", {{0.5, 0.5}, {1, 0}});
}

TEST(Svg, GivesOneStrokePerSubpathAndLeavesOutDots) {
  const std::vector<Stroke> strokes = read(svg("<path id='a' d='M0 0L1 1M5 5M2 2L3 3zL9 9'/>"));
  ASSERT_EQ(strokes.size(), 3U);
  EXPECT_EQ(strokes[0].name, "a");
  EXPECT_EQ(strokes[1].name, "a-2");
  EXPECT_EQ(points(strokes[2]), (std::vector<Vec2>{{2, 2}, {9, 9}}));  // after a close the pen is at the start
}

/// The largest distance of the points of a flattened curve from `curve` at any parameter, and of the chords.
double flatness(const std::vector<Vec2>& line, const std::function<Vec2(double)>& curve) {
  double worst = 0.0;
  for (int i = 0; i <= 2000; ++i) {
    const Vec2 point = curve(i / 2000.0);
    double nearest = 1e9;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      const Vec2 side = line[k + 1] - line[k];
      const double t = std::clamp((point - line[k]).dot(side) / side.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (point - line[k] - t * side).norm());
    }
    worst = std::max(worst, nearest);
  }
  return worst;
}

Vec2 bezier(const std::array<Vec2, 4>& p, double t) {
  const double s = 1.0 - t;
  return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
}

TEST(Svg, FlattensCurvesToATenthOfAPixelWithFewPoints) {
  const auto strokes = read(svg("<path d='M10 90C10 10 90 10 90 90'/>"));
  const std::array<Vec2, 4> p = {Vec2(10, 90), Vec2(10, 10), Vec2(90, 10), Vec2(90, 90)};
  EXPECT_LT(flatness(points(strokes[0]), [&](double t) { return bezier(p, t); }), 0.1);
  EXPECT_LT(strokes[0].samples.size(), 40U);
  EXPECT_EQ(strokes[0].samples.back().position, p[3]);
  // Magnified ten times by the picture, it is still a tenth of a pixel.
  const auto large = read(svg("<path d='M10 90C10 10 90 10 90 90'/>"), 1000, 1000);
  EXPECT_LT(flatness(points(large[0]), [&](double t) { return Vec2(10 * bezier(p, t)); }), 0.1);
}

TEST(Svg, ReflectsTheControlPointOfSmoothCurvesOnlyAfterOneOfTheirKind) {
  const auto same = [](const std::string& a, const std::string& b) {
    EXPECT_EQ(points(read(svg("<path d='" + a + "'/>"))[0]), points(read(svg("<path d='" + b + "'/>"))[0])) << a;
  };
  same("M0 0C0 9 9 9 9 0S18 -9 18 0", "M0 0C0 9 9 9 9 0C9 -9 18 -9 18 0");
  same("M0 0L9 0S18 -9 18 0", "M0 0L9 0C9 0 18 -9 18 0");
  same("M0 0Q5 9 9 0T18 0", "M0 0Q5 9 9 0Q13 -9 18 0");
  same("M0 0Q5 9 9 0S18 -9 18 0", "M0 0Q5 9 9 0C9 0 18 -9 18 0");
  same("M5 5c1 2 3 4 5 6s7 8 9 10q1 1 2 0t4 0", "M5 5C6 7 8 9 10 11S17 19 19 21Q20 22 21 21T25 21");
}

TEST(Svg, ArcsFollowTheirEllipse) {
  const auto circle = points(read(svg("<path d='M90 50A40 40 0 1 1 50 10'/>"))[0]);
  for (const Vec2& point : circle) EXPECT_NEAR((point - Vec2(50, 50)).norm(), 40.0, 1e-9);
  // Large and sweeping (clockwise on the screen): three quarters, through the bottom and the left.
  EXPECT_LT(
      flatness(circle,
               [](double t) { return Vec2(50 + 40 * std::cos(1.5 * kPi * t), 50 + 40 * std::sin(1.5 * kPi * t)); }),
      0.1);
  const auto small = points(read(svg("<path d='M90 50a40,40,0,00-40-40'/>"))[0]);  // flags stand without a space
  EXPECT_LT(
      flatness(small,
               [](double t) { return Vec2(50 + 40 * std::cos(0.5 * kPi * t), 50 - 40 * std::sin(0.5 * kPi * t)); }),
      0.1);
  // Radii too small are scaled up: a half circle over the chord.
  for (const Vec2& point : points(read(svg("<path d='M10 50A1 1 0 0 1 90 50'/>"))[0])) {
    EXPECT_NEAR((point - Vec2(50, 50)).norm(), 40.0, 1e-9);
    EXPECT_LE(point.y(), 50.0 + 1e-9);
  }
  // A turned ellipse: every point has the same sum of distances from the foci.
  const Vec2 focus = Eigen::Rotation2Dd(30 * kDegree) * Vec2(std::sqrt(40.0 * 40 - 20 * 20), 0);
  const Vec2 from = Vec2(50, 50) + Eigen::Rotation2Dd(30 * kDegree) * Vec2(40, 0),
             to = Vec2(50, 50) - (from - Vec2(50, 50));
  const auto number = [](double value) { return std::to_string(value); };
  for (const Vec2& p : points(read(svg("<path d='M" + number(from.x()) + " " + number(from.y()) + "A40 20 30 0 1 " +
                                       number(to.x()) + " " + number(to.y()) + "'/>"))[0])) {
    EXPECT_NEAR((p - Vec2(50, 50) - focus).norm() + (p - Vec2(50, 50) + focus).norm(), 80.0, 0.01);
  }
  expect_path("M1 2A0 5 0 0 1 3 4A5 5 0 0 1 3 4", {{1, 2}, {3, 4}});  // no radius: a line; no way: nothing
}

TEST(Svg, ReadsPolylinesAndLines) {
  expect_points(svg("<polyline points='1,2 3,4,5 6'/>"), {{1, 2}, {3, 4}, {5, 6}});
  expect_points(svg("<line x1='1' y2='2px'/>"), {{1, 0}, {0, 2}});
}

TEST(Svg, AppliesNestedTransforms) {
  expect_points(svg("<g transform='translate(10,20)'><g transform='scale(2)'><line x2='1' y2='1'/></g></g>"),
                {{10, 20}, {12, 22}});
  expect_points(svg("<line transform='rotate(90)' x2='1'/>"), {{0, 0}, {0, 1}});
  expect_points(svg("<line transform='rotate(90 1 0), translate(0 3)' x2='1'/>"), {{-2, -1}, {-2, 0}});
  expect_points(svg("<line transform='matrix(1 2 3 4 5 6)' x1='1' y2='1'/>"), {{6, 8}, {8, 10}});
  expect_points(svg("<line transform='skewX(45)' y2='2' x2='1'/>"), {{0, 0}, {3, 2}});
  expect_points(svg("<line transform='skewY(45) scale(1 -1)' x2='2' y2='1'/>"), {{0, 0}, {2, 1}});
}

TEST(Svg, FitsTheViewBoxIntoTheMiddleOfThePicture) {
  const std::string line = "<line x1='0' y1='0' x2='10' y2='20'/>";
  expect_points(svg(line, "viewBox='0 0 10 20'"), {{25, 0}, {75, 100}});
  expect_points(svg(line, "viewBox='-10 0 40 20'"), {{25, 25}, {50, 75}});
  expect_points(svg(line, "width='10' height='20px'"), {{25, 0}, {75, 100}});
  expect_points(svg(line, "width='96pt' height='1in' viewBox='0 0 10 20'"), {{25, 0}, {75, 100}});
  expect_points(svg(line, "width='100%' height='100%'"), {{0, 0}, {10, 20}});
  expect_points(svg(line, ""), {{0, 0}, {10, 20}});
  expect_points(svg("<svg x='50' y='10' width='20' height='20' viewBox='0 0 10 20'>" + line + "</svg>"),
                {{55, 10}, {65, 30}});
  expect_points(svg(line, "viewBox='0 0 10 20'"), {{0, 0}, {100, 200}}, 100, 200);
}

TEST(Svg, LeavesOutWhatIsNotDrawn) {
  const std::string line = "<line x2='9'/>";
  for (const char* hidden :
       {"<defs>#</defs>", "<clipPath>#</clipPath>", "<symbol><g>#</g></symbol>", "<g display='none'>#</g>",
        "<g style='fill:red; display : none'>#</g>", "<g visibility='hidden'>#</g>", "<mask>#</mask>", "<!-- # -->",
        "<style><![CDATA[ # ]]></style>"}) {
    std::string text = hidden;
    text.replace(text.find('#'), 1, line);
    expect_points(svg(text + "<line x2='5'/>"), {{0, 0}, {5, 0}});
    EXPECT_NE(std::string(error_of(svg(text)).what()).find("no stroke"), std::string::npos);
  }
}

TEST(Svg, ReadsTheXmlThatDrawingProgramsWrite) {
  const auto strokes = read(
      "\xEF\xBB\xBF<?xml version=\"1.0\" encoding=\"UTF-8\"?>\r\n<!-- made by hand > -->\r\n"
      "<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"svg11.dtd\" [ <!ENTITY ns_svg "
      "\"http://www.w3.org/2000/svg\"> ]>\r\n"
      "<svg:svg xmlns:svg=\"&ns_svg;\" xmlns:i='i' viewBox = \"0 0 100 100\">\n<svg:title>a &amp; b</svg:title>"
      "<svg:path i:label='x > y' id=\"l&#xEF;ne &lt;1&gt;\" d='M0 0\n\tL5,5'></svg:path></svg:svg>\n");
  ASSERT_EQ(strokes.size(), 1U);
  EXPECT_EQ(strokes[0].name, "lïne <1>");
  EXPECT_FALSE(strokes[0].raw_pen);
}

TEST(Svg, NamesTheLineOfWhatIsWrong) {
  const auto expect_error = [](const std::string& text, const std::string& wanted,
                               ErrorCode code = ErrorCode::bad_file) {
    const Error error = error_of(text);
    EXPECT_EQ(error.code(), code) << text;
    EXPECT_EQ(std::string(error.what()).substr(0, wanted.size()), wanted) << text;
  };
  expect_error("", "line 1: there is no XML element");
  expect_error("hello", "line 1: got 'hello', wanted an XML element");
  expect_error("\n<html/>", "line 2: got <html>, wanted <svg>");
  expect_error(svg("\n<path d='M0 0L1'/>"), "line 2: the d of <path>: wanted a number (at character 7)");
  expect_error(svg("<path d='M0 0L1 1 X'/>"), "line 1: the d of <path>: 'X' is no path command");
  expect_error(svg("<path d='L0 0'/>"), "line 1: the d of <path>: wanted the command M first");
  expect_error(svg("<path d='M0 0A1 1 0 2 0 1 1'/>"), "line 1: the d of <path>: wanted a flag, 0 or 1");
  expect_error(svg("<path d='M0 nan'/>"), "line 1: the d of <path>: got 'n', wanted a number");
  expect_error(svg("<path d='M0 1e13'/>"), "line 1: the d of <path>: got '1e13', wanted a number");
  expect_error(svg("<polyline points='1 2 3'/>"), "line 1: the points of <polyline>: wanted a number");
  expect_error(svg("<line x2='50%'/>"), "line 1: the x2 of <line>: ");
  expect_error(svg("<g transform='turn(3)'/>"), "line 1: the transform of <g>: 'turn' with 1 numbers is no transform");
  expect_error(svg("", "viewBox='0 0 0 5'"), "line 1: the viewBox of <svg>: wanted a width and a height above zero");
  expect_error(svg("<g>\n</h>"), "line 2: got </h>, wanted </g>");
  expect_error(svg("<g a='1' a='2'/>"), "line 1: the attribute a twice");
  expect_error(svg("<g a='&nbsp;'/>"), "line 1: the entity '&nbsp;' is not known");
  expect_error(svg("<g"), "line 1: ");
  expect_error(svg("") + svg(""), "line 1: a second root element");
  expect_error("<!DOCTYPE svg [<!ENTITY a 'b'><!ENTITY c '&a;&a;'>]>" + svg(""),
               "line 1: the entity 'c' is too long or not plain text");
  expect_error(std::string("\xFF\xFE<\0", 4), "the text is UTF-16", ErrorCode::unsupported);
  expect_error("\x1f\x8b\x08", "the SVG is compressed", ErrorCode::unsupported);
}

TEST(Svg, IsBoundedInDepthAndSize) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<g>";
  EXPECT_NE(std::string(error_of(svg(deep)).what()).find("deep"), std::string::npos);
  std::string many;
  for (int i = 0; i < 500; ++i) many += "<path d='M0 0C0 1e11 1e11 0 9 9'/>";
  EXPECT_NE(std::string(error_of(svg(many)).what()).find("too many points"), std::string::npos);
  std::string scales = "<line transform='";
  for (int i = 0; i < 60; ++i) scales += "scale(1e12)";
  EXPECT_EQ(error_of(svg(scales + "' x2='5'/>")).code(), ErrorCode::bad_file);
}

TEST(Svg, ReadsAPathOfAHundredThousandPointsAtOnce) {
  std::string data = "M0 0";
  for (int i = 1; i <= 100000; ++i) data += "L" + std::to_string(i % 100) + " " + std::to_string(i % 37);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(read(svg("<path d='" + data + "'/>"))[0].samples.size(), 100001U);
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 5.0);
}

TEST(Svg, EveryTruncationIsAnError) {
  const std::string text = "<?xml version='1.0'?><!DOCTYPE svg><!-- c -->" +
                           svg("<g transform='rotate(5)'><path id='a&amp;b' d='M0 0C1 2 3 4 5 6A1 2 3 0 1 7 8z'/></g>");
  ASSERT_EQ(read(text).size(), 1U);
  for (std::size_t length = 0; length < text.size(); ++length) {
    EXPECT_EQ(error_of(text.substr(0, length)).code(), ErrorCode::bad_file) << length;
  }
}

std::vector<Stroke> some_strokes() {
  Random random(4);
  std::vector<Stroke> strokes(3);
  strokes[0].name = "line <of> \"action\" & tête";
  for (Stroke& stroke : strokes) {
    stroke.raw_pen = &stroke != &strokes[1];
    for (int i = 0; i < 50; ++i) {
      stroke.samples.push_back({.position = Vec2(random.uniform(0, 100), random.uniform(0, 100)),
                                .time = 0.01 * i,
                                .pressure = random.uniform()});
    }
  }
  return strokes;
}

TEST(Svg, GivesBackRawSamplesThatWereWritten) {
  const std::vector<Stroke> strokes = some_strokes();
  const std::vector<Stroke> again = read(write_svg_strokes(strokes, kSize, kSize));
  ASSERT_EQ(again.size(), strokes.size());
  for (std::size_t s = 0; s < strokes.size(); ++s) {
    EXPECT_EQ(again[s].name, strokes[s].name);
    EXPECT_EQ(again[s].raw_pen, strokes[s].raw_pen);
    ASSERT_EQ(again[s].samples.size(), strokes[s].samples.size());
    for (std::size_t i = 0; i < strokes[s].samples.size(); ++i) {
      EXPECT_LT((again[s].samples[i].position - strokes[s].samples[i].position).norm(), 1e-12);
      EXPECT_DOUBLE_EQ(again[s].samples[i].time, strokes[s].samples[i].time);
      EXPECT_NEAR(again[s].samples[i].pressure, strokes[s].samples[i].pressure, 1e-14);
    }
  }
  const std::vector<Stroke> doubled = read(write_svg_strokes(strokes, kSize, kSize), 2 * kSize, 2 * kSize);
  EXPECT_LT((doubled[0].samples[7].position - 2.0 * strokes[0].samples[7].position).norm(), 1e-9);
  EXPECT_TRUE(doubled[0].raw_pen);
}

TEST(Svg, APathThatAnotherProgramChangedCountsMoreThanItsOldSamples) {
  std::string text = write_svg_strokes({some_strokes()[0]}, kSize, kSize);
  const std::size_t begin = text.find(" d=\"") + 4;
  text.replace(begin, text.find('"', begin) - begin, "M0 0 L9 9");
  const std::vector<Stroke> strokes = read(text);
  ASSERT_EQ(strokes.size(), 1U);
  EXPECT_EQ(points(strokes[0]), (std::vector<Vec2>{{0, 0}, {9, 9}}));
  EXPECT_FALSE(strokes[0].raw_pen);
}

}  // namespace
}  // namespace croquis
