// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>

#include "croquis/body/animals.h"
#include "croquis/body/forms.h"
#include "croquis/body/sculpture.h"

namespace croquis {
namespace {

constexpr double kBelly = 0.235;  // height of the limbs' roots at limbs = 1, metres
constexpr int kTailJoints = 8;

/// Metres; x outwards, y up from the ground, z forward, before the proportions.
struct CatScale {
  const Proportions& p;
  double thick = std::pow(p.muscle, 0.6);
  double lift = kBelly * (p.limbs - 1.0);

  [[nodiscard]] Vec3 trunk(double x, double y, double z) const { return {x, y + lift, z}; }
  [[nodiscard]] Vec3 front(double x, double y, double z) const { return {x * p.shoulders, leg_height(y), z}; }
  [[nodiscard]] Vec3 hind(double x, double y, double z) const { return {x * p.hips, leg_height(y), z}; }
  /// Paws keep their height; the rest of a leg stretches.
  [[nodiscard]] double leg_height(double y) const {
    const double stretched = std::max(y - 0.03, 0.0) * (kBelly - 0.03 + lift) / (kBelly - 0.03);
    return std::min(y, 0.03) * paw_height(y) + stretched;
  }
  [[nodiscard]] double paw_height(double) const { return 0.4 + 0.6 * p.hands; }
  [[nodiscard]] Vec3 head(double x, double y, double z) const {
    const Vec3 base(0.0, 0.355, 0.225), neck(0.0, 0.345, 0.212);
    return trunk(0, 0, 0) + neck + 1.16 * p.head * (Vec3(x, y, z) - base);
  }
};

Vec3 tail_point(const CatScale& c, double t) {  // back, down and up again, as a question mark lies
  const Vec3 at[] = {c.trunk(0, 0.272, -0.215), c.trunk(0, 0.235, -0.29),  c.trunk(0, 0.195, -0.36),
                     c.trunk(0, 0.195, -0.43),  c.trunk(0, 0.245, -0.475), c.trunk(0, 0.315, -0.47)};
  const double x = std::clamp(t, 0.0, 1.0) * 5.0;
  const int i = std::min(static_cast<int>(x), 4);
  const double s = x - i;
  const Vec3 a = at[std::max(i - 1, 0)], b = at[i], d = at[i + 1], e = at[std::min(i + 2, 5)];
  return b + 0.5 * s * (d - a + s * (2.0 * a - 5.0 * b + 4.0 * d - e + s * (3.0 * (b - d) + e - a)));
}

Armature make_armature(const CatScale& c) {
  Armature a;
  const int hips = a.add("hips", -1, c.trunk(0, 0.275, -0.165));
  const int spine_1 = a.add("spine_1", hips, c.trunk(0, 0.285, -0.095));
  const int spine_2 = a.add("spine_2", spine_1, c.trunk(0, 0.285, -0.015));
  const int chest = a.add("chest", spine_2, c.trunk(0, 0.280, 0.065));
  const int neck = a.add("neck", chest, c.trunk(0, 0.290, 0.150));
  const int head = a.add("head", neck, c.trunk(0, 0.350, 0.215));
  a.add("jaw", head, c.head(0, 0.350, 0.255));
  a.add_pair("left_ear", head, c.head(0.030, 0.408, 0.235));
  int parent = hips;
  for (int i = 0; i < kTailJoints; ++i) {
    parent = a.add("tail_" + std::to_string(i + 1), parent, tail_point(c, i / static_cast<double>(kTailJoints)));
  }
  const int blade = a.add_pair("front_left_shoulder", chest, c.trunk(0.030 * c.p.shoulders, 0.290, 0.120));
  const int upper = a.add_pair("front_left_upper", blade, c.front(0.043, 0.215, 0.160));
  const int lower = a.add_pair("front_left_lower", upper, c.front(0.046, 0.150, 0.112));
  const int paw = a.add_pair("front_left_foot", lower, c.front(0.045, 0.048, 0.125));
  a.add_pair("front_left_toes", paw, c.front(0.045, 0.017, 0.148));
  const int thigh = a.add_pair("hind_left_upper", hips, c.hind(0.040, 0.245, -0.175));
  const int shank = a.add_pair("hind_left_lower", thigh, c.hind(0.054, 0.160, -0.120));
  const int foot = a.add_pair("hind_left_foot", shank, c.hind(0.048, 0.085, -0.218));
  a.add_pair("hind_left_toes", foot, c.hind(0.048, 0.017, -0.178));
  return a;
}

Limb make_paw(const CatScale& c, const Vec3& wrist, int foot, int toes) {
  const double s = c.p.hands;
  const auto at = [&](double x, double y, double z) { return Vec3(wrist.x() + s * x, s * y, wrist.z() + s * z); };
  const std::vector<int> joints{foot, toes};
  Limb paw{{}, 0.012};
  paw.forms.push_back(make_form(Loft({oval_section(at(0, 0.013, 0.0), s * 0.014, s * 0.012, s * 0.013, 0.3),
                                      oval_section(at(0, 0.014, 0.026), s * 0.019, s * 0.013, s * 0.014, 0.35)},
                                     Vec3::UnitX(), Vec3::UnitY(), s * 0.010, s * 0.012),
                                {joints, 0.0, 0.0055 * s}));
  for (const double x : {-0.0135, -0.0045, 0.0045, 0.0135}) {
    const double z = std::abs(x) < 0.01 ? 0.040 : 0.033;
    paw.forms.push_back(
        make_form(Ellipsoid(at(x, 0.0095, z), s * Vec3(0.0058, 0.0088, 0.0105)), {joints, 0.003 * s, 0.0040 * s}));
  }
  return paw;
}

void add_legs(Limb& trunk, const CatScale& c, const Armature& a) {
  const double t = c.thick;
  const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ();
  const auto section = [&](const Vec3& p, double side, double front, double back) {
    return oval_section(p, side * t, front * t, back * t, 0.0);
  };
  const auto mid = [](const Vec3& p, const Vec3& q, double s) { return Vec3((1.0 - s) * p + s * q); };
  {
    const int blade = a.find("front_left_shoulder"), upper = a.find("front_left_upper"),
              lower = a.find("front_left_lower");
    const int foot = a.find("front_left_foot");
    const Vec3 shoulder = a.position(upper), elbow = a.position(lower), wrist = a.position(foot);
    Limb leg{{}, 0.035};
    leg.forms.push_back(make_form(
        Loft({section(mid(shoulder, elbow, -0.15), 0.022, 0.030, 0.034),
              section(mid(shoulder, elbow, 0.5), 0.025, 0.028, 0.030), section(elbow, 0.0195, 0.021, 0.022),
              section(mid(elbow, wrist, 0.45), 0.0155, 0.0165, 0.0165), section(wrist, 0.0130, 0.0135, 0.0135),
              section(Vec3(wrist.x(), 0.016, wrist.z() + 0.006), 0.0135, 0.0140, 0.0135)},
             x, z),
        {{a.find("chest"), blade, upper, lower, foot}, 0.0, 0.0085, 0.8}));
    leg.limbs.push_back(make_paw(c, wrist, foot, a.find("front_left_toes")));
    trunk.limbs.push_back(leg);
  }
  const int upper = a.find("hind_left_upper"), lower = a.find("hind_left_lower"), foot = a.find("hind_left_foot");
  const Vec3 hip = a.position(upper), knee = a.position(lower), hock = a.position(foot);
  Limb leg{{}, 0.04};
  std::vector<Section> thigh{section(mid(hip, knee, -0.15), 0.026, 0.046, 0.046),
                             section(mid(hip, knee, 0.35), 0.030, 0.050, 0.054),
                             section(mid(hip, knee, 0.95), 0.023, 0.024, 0.032)};
  std::vector<Section> shank{section(mid(knee, hock, 0.05), 0.022, 0.022, 0.026),
                             section(mid(knee, hock, 0.45), 0.0180, 0.0185, 0.0200),
                             section(hock, 0.0130, 0.0140, 0.0140)};
  const Vec3 ankle(hock.x(), 0.016, hock.z() + 0.022);
  std::vector<Section> cannon{section(hock, 0.0130, 0.0140, 0.0145),
                              section(mid(hock, ankle, 0.5), 0.0122, 0.0128, 0.0128),
                              section(ankle, 0.0130, 0.0135, 0.0130)};
  leg.forms.push_back(make_form(Loft(std::move(thigh), x, z), {{a.find("hips"), upper, lower}, 0.0, 0.0085, 0.8}));
  leg.forms.push_back(make_form(Loft(std::move(shank), x, z), {{upper, lower, foot}, 0.030, 0.0085, 0.8}));
  leg.forms.push_back(make_form(Loft(std::move(cannon), x, z), {{lower, foot}, 0.012, 0.0075, 0.8}));
  leg.limbs.push_back(make_paw(c, hock + Vec3(0, 0, 0.020), foot, a.find("hind_left_toes")));
  trunk.limbs.push_back(leg);
}

Limb make_cat_head(const CatScale& c, const Armature& a) {
  const double s = 1.16 * c.p.head;
  const int head = a.find("head"), jaw = a.find("jaw"), ear_joint = a.find("left_ear");
  const auto traits = [&](double blend, double detail) { return FormTraits{{head}, blend * s, detail * s}; };
  Limb limb{{}, 0.028};
  limb.forms.push_back(
      make_form(Ellipsoid(c.head(0, 0.378, 0.240), s * Vec3(0.047, 0.042, 0.047)), traits(0.0, 0.0075)));
  limb.forms.push_back(
      make_form(Ellipsoid(c.head(0.027, 0.362, 0.256), s * Vec3(0.023, 0.021, 0.022)), traits(0.02, 0.0075)));
  // Muzzle: two pads, the bridge of the nose, its tip.
  limb.forms.push_back(make_form(
      Loft({round_section(c.head(0, 0.388, 0.268), s * 0.012), round_section(c.head(0, 0.370, 0.294), s * 0.0085)},
           Vec3::UnitX(), Vec3::UnitZ()),
      traits(0.014, 0.0055)));
  limb.forms.push_back(
      make_form(Ellipsoid(c.head(0.0095, 0.3585, 0.2865), s * Vec3(0.0125, 0.0105, 0.0130)), traits(0.008, 0.0042)));
  limb.forms.push_back(
      make_form(Ellipsoid(c.head(0, 0.3665, 0.3005), s * Vec3(0.0062, 0.0042, 0.0045)), traits(0.003, 0.0032)));
  limb.forms.push_back(
      make_carving(Ellipsoid(c.head(0.0215, 0.3855, 0.2865), s * Vec3(0.0125, 0.0085, 0.0095), turned(0, 22, 12)),
                   traits(0.008, 0.0042)));
  limb.forms.push_back(
      make_form(Ellipsoid(c.head(0.0205, 0.3845, 0.2735), s * Vec3(0.0100, 0.0092, 0.0092)), traits(0.0015, 0.0036)));
  Limb chin{{make_form(Ellipsoid(c.head(0, 0.3475, 0.2800), s * Vec3(0.0125, 0.0075, 0.0125)),
                       {{head, jaw}, 0.0, 0.0045 * s})},
            0.006 * s};
  limb.limbs.push_back(chin);
  // Ears: cupped triangles that look forward and a little outwards.
  const Vec3 across = turned(0, 28, -22) * Vec3::UnitX(), forward = turned(-8, 28, 0) * Vec3::UnitZ();
  const auto ear_section = [&](double x, double y, double z, double wide, double thick) {
    return oval_section(c.head(x, y, z), s * wide, s * thick);
  };
  Limb ear{{make_form(Loft({ear_section(0.0265, 0.402, 0.235, 0.0205, 0.0085),
                            ear_section(0.0335, 0.424, 0.233, 0.0155, 0.0070),
                            ear_section(0.0405, 0.448, 0.229, 0.0045, 0.0035)},
                           across, forward, -1.0, 0.004 * s),
                      {{head, ear_joint}, 0.0, 0.0052 * s, 1.2})},
           0.008 * s};
  ear.forms.push_back(make_carving(
      Loft({ear_section(0.0290, 0.408, 0.2435, 0.0120, 0.0055), ear_section(0.0345, 0.424, 0.2410, 0.0090, 0.0050),
            ear_section(0.0395, 0.441, 0.2355, 0.0025, 0.0025)},
           across, forward, 0.004 * s, 0.002 * s),
      {{head, ear_joint}, 0.004 * s, 0.0045 * s}));
  limb.limbs.push_back(ear);
  return limb;
}

Limb make_trunk_of_cat(const CatScale& c, const Armature& a) {
  const double t = c.thick, hips = 0.4 + 0.6 * c.p.hips, chest = 0.4 + 0.6 * c.p.shoulders,
               waist = 0.5 * (hips + chest);
  const auto hull = [&](double z, double side, double back, double belly, double wide) {  // heights from the ground
    return oval_section(c.trunk(0, 0.250, z), side * t * wide, (back - 0.250) * t, (0.250 - belly) * t, 0.1);
  };
  const std::vector<int> spine{a.find("hips"), a.find("spine_1"), a.find("spine_2"), a.find("chest"), a.find("neck")};
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  Limb trunk;
  std::vector<Section> sections_of_hull{
      hull(-0.195, 0.046, 0.292, 0.210, hips),  hull(-0.145, 0.060, 0.309, 0.196, hips),
      hull(-0.075, 0.061, 0.316, 0.192, waist), hull(0.010, 0.066, 0.310, 0.174, chest),
      hull(0.085, 0.064, 0.307, 0.160, chest),  hull(0.140, 0.052, 0.304, 0.172, chest)};
  trunk.forms.push_back(make_form(Loft(std::move(sections_of_hull), x, y, 0.034, 0.045), {spine, 0.0, 0.0115, 0.6}));
  trunk.forms.push_back(make_form(
      Ellipsoid(c.trunk(0.036 * c.p.shoulders, 0.245, 0.125), t * Vec3(0.024, 0.062, 0.040), turned(18, 0, 6)),
      {{spine[3], a.find("front_left_shoulder"), a.find("front_left_upper")}, 0.03, 0.0105, 1.2}));
  std::vector<Section> neck{round_section(c.trunk(0, 0.250, 0.125), 0.056 * t),
                            round_section(c.trunk(0, 0.302, 0.172), 0.048 * t),
                            round_section(c.trunk(0, 0.352, 0.215), 0.042 * t)};
  trunk.forms.push_back(
      make_form(Loft(std::move(neck), x, z), {{spine[3], spine[4], a.find("head")}, 0.040, 0.0105, 0.8}));
  trunk.limbs.push_back(make_cat_head(c, a));
  Limb tail{{}, 0.025};
  std::vector<Section> sections;
  std::vector<int> joints{spine[0]};
  for (int i = 0; i <= 12; ++i) {
    const double along = i / 12.0;
    sections.push_back(round_section(tail_point(c, along), t * (0.0185 - 0.0070 * along)));
  }
  for (int i = 0; i < kTailJoints; ++i) joints.push_back(a.find("tail_" + std::to_string(i + 1)));
  tail.forms.push_back(make_form(Loft(std::move(sections), x, z, -1.0, 0.012), {joints, 0.0, 0.0085, 1.0}));
  trunk.limbs.push_back(tail);
  return trunk;
}

}  // namespace

Character make_cat(const Proportions& proportions) {
  const CatScale scale{proportions};
  const Armature armature = make_armature(scale);
  Sculpture sculpture;
  sculpture.name = "body";
  sculpture.mirrored = true;
  sculpture.color = Vec4f(0.70F, 0.50F, 0.33F, 1.0F);
  sculpture.root = make_trunk_of_cat(scale, armature);
  add_legs(sculpture.root, scale, armature);
  return assemble("cat", armature, std::move(sculpture));
}

}  // namespace croquis
