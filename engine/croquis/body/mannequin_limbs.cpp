// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <string>

#include "croquis/body/forms.h"
#include "croquis/body/mannequin.h"

namespace croquis {
namespace {

constexpr double kWristSoftness = 1.5;  // the forearm's turning is shared out along it

/// A finger in hands: radii at the root, along the bones and at the knuckles, tapering to a rounded tip.
Limb make_finger(const MannequinMeasures& m, const Armature& a, const std::array<int, 4>& chain, double radius,
                 double blend) {
  const double r = radius * m.hand;
  const Vec3 hand = a.position(chain[0]), knuckle = a.position(chain[1]), middle = a.position(chain[2]),
             last = a.position(chain[3]);
  const Vec3 tip = last + 0.92 * (last - middle).norm() *
                              (last - middle + 0.25 * (middle - knuckle).norm() * Vec3(0, -0.4, 0)).normalized();
  const auto between = [](const Vec3& p, const Vec3& q, double t) { return Vec3((1.0 - t) * p + t * q); };
  const auto section = [&](const Vec3& at, double size) { return oval_section(at, size * r, 0.96 * size * r); };
  Loft loft(
      {section(between(knuckle, hand, 0.16), 1.05), section(knuckle, 1.12),
       section(between(knuckle, middle, 0.5), 1.04), section(middle, 1.06), section(between(middle, last, 0.5), 0.96),
       section(last, 0.96), section(between(last, tip, 0.45), 0.90), section(between(last, tip, 0.85), 0.76)},
      Vec3::UnitZ(), Vec3::UnitY(), -1.0, 0.72 * r);
  const std::vector<int> joints(chain.begin(), chain.end());
  return {{make_form(std::move(loft), {joints, 0.0, 0.54 * r, 0.9, 0.40 * r})}, blend * m.hand};
}

Limb make_hand(const MannequinMeasures& m, const Armature& a) {
  const double s = m.hand;
  const int hand = a.find("leftHand");
  const Vec3 wrist = a.position(hand);
  const auto at = [&](double x, double y, double z) { return Vec3(wrist + s * Vec3(x, y, z)); };
  const auto section = [&](double x, double y, double z, double side, double up, double down, double square) {
    return oval_section(at(x, y, z), s * side, s * up, s * down, square);
  };
  const std::vector<int> joints{a.find("leftLowerArm"), hand};
  Limb palm{{}, 0.10 * s};
  palm.forms.push_back(make_form(
      Loft({section(0.02, 0.0, 0.0, 0.135, 0.085, 0.09, 0.0), section(0.14, 0.005, 0.005, 0.175, 0.085, 0.095, 0.15),
            section(0.32, 0.012, 0.005, 0.215, 0.075, 0.085, 0.35),
            section(0.445, 0.012, 0.0, 0.215, 0.062, 0.065, 0.4)},
           Vec3::UnitZ(), Vec3::UnitY(), 0.08 * s, 0.045 * s),
      {joints, 0.0, 0.036 * s, kWristSoftness}));
  palm.forms.push_back(make_form(Ellipsoid(at(0.20, -0.055, -0.12), s * Vec3(0.15, 0.055, 0.07)),
                                 {joints, 0.06 * s, 0.036 * s, kWristSoftness}));
  const auto chain = [&](const char* name, const char* p, const char* i, const char* d) {
    const std::string n = std::string("left") + name;
    return std::array<int, 4>{hand, a.find(n + p), a.find(n + i), a.find(n + d)};
  };
  const auto finger = [&](const char* name, double radius) {
    palm.limbs.push_back(make_finger(m, a, chain(name, "Proximal", "Intermediate", "Distal"), radius, 0.05));
  };
  finger("Index", 0.0465);
  finger("Middle", 0.0480);
  finger("Ring", 0.0455);
  finger("Little", 0.0395);
  // Thumb, with the ball that it stands on.
  const std::array<int, 4> t = chain("Thumb", "Metacarpal", "Proximal", "Distal");
  const Vec3 root = a.position(t[1]), knuckle = a.position(t[2]), last = a.position(t[3]);
  const Vec3 tip = last + 0.78 * (last - knuckle);
  const auto round = [&](const Vec3& p, double radius) { return round_section(p, radius * s); };
  Limb thumb{{make_form(Loft({round(root, 0.075), round(0.5 * (root + knuckle), 0.078), round(knuckle, 0.058),
                              round(0.5 * (knuckle + last), 0.051), round(last, 0.051),
                              round(0.5 * (last + tip), 0.047), round(tip, 0.034)},
                             Vec3::UnitZ(), Vec3::UnitY()),
                        {{t.begin(), t.end()}, 0.0, 0.030 * s, 0.9})},
             0.11 * s};
  palm.limbs.push_back(thumb);
  return palm;
}

}  // namespace

Limb make_arm(const MannequinMeasures& m, const Armature& a) {
  const double u = m.unit, t = u * m.thick;
  const int upper = a.find("leftUpperArm"), lower = a.find("leftLowerArm"), hand = a.find("leftHand");
  const Vec3 shoulder = a.position(upper), elbow = a.position(lower), wrist = a.position(hand);
  const auto on = [](const Vec3& p, const Vec3& q, double s) { return Vec3((1.0 - s) * p + s * q); };
  // Thin and flat at the wrist, whose size is the hand's as much as the arm's.
  const double wrist_side = 0.5 * (0.112 * t + 0.135 * m.hand), wrist_up = 0.5 * (0.075 * t + 0.09 * m.hand);
  const auto section = [&](const Vec3& p, double front, double back, double up, double down) {
    return Section{p, t * front, t * back, t * up, t * down, 0.0};
  };
  const std::vector<int> joints{a.find("leftShoulder"), upper, lower, hand};
  Limb arm{{}, 0.16 * u};
  std::vector<Section> sections{
      section(shoulder + u * Vec3(-0.10, 0.0, 0.0), 0.20, 0.20, 0.16, 0.20),
      section(on(shoulder, elbow, 0.07), 0.21, 0.20, 0.185, 0.21),
      section(on(shoulder, elbow, 0.27), 0.19, 0.185, 0.185, 0.195),
      section(on(shoulder, elbow, 0.55), 0.19, 0.165, 0.165, 0.175),
      section(on(shoulder, elbow, 0.85), 0.148, 0.142, 0.138, 0.138),
      section(elbow, 0.138, 0.142, 0.138, 0.132),
      section(on(elbow, wrist, 0.22), 0.172, 0.150, 0.155, 0.145),
      section(on(elbow, wrist, 0.45), 0.150, 0.138, 0.130, 0.130),
      section(on(elbow, wrist, 0.78), 0.110, 0.106, 0.088, 0.088),
      {on(elbow, wrist, 0.96), wrist_side, wrist_side, wrist_up, wrist_up},
      {wrist + Vec3(0.03 * u, 0, 0), wrist_side, wrist_side, wrist_up, wrist_up},
  };
  arm.forms.push_back(make_form(Loft(std::move(sections), Vec3::UnitZ(), Vec3::UnitY(), 0.15 * u),
                                {joints, 0.0, 0.062 * u, 0.9, 0.0, kWristSoftness}));
  // The cap of the shoulder.
  const Vec3 cap = on(shoulder, elbow, 0.10) + u * Vec3(0.0, 0.03, -0.01);
  arm.forms.push_back(make_form(Ellipsoid(cap, t * Vec3(0.30, 0.215, 0.235)), {joints, 0.14 * u, 0.062 * u, 0.9}));
  arm.limbs.push_back(make_hand(m, a));
  return arm;
}

namespace {

Limb make_foot(const MannequinMeasures& m, const Armature& a) {
  const double f = m.foot;
  const int foot = a.find("leftFoot"), toes = a.find("leftToes");
  const Vec3 ankle = a.position(foot);
  const Mat3 out = turned(0.0, 7.0, 0.0);
  const auto at = [&](double x, double y, double z) {
    const Vec3 p = out * Vec3(x, 0.0, z) * f;
    return Vec3(ankle.x() + p.x(), f * y, ankle.z() + p.z());
  };
  const Vec3 side = out.col(0), up = Vec3::UnitY();
  const auto section = [&](double z, double y, double x, double outer, double inner, double top, double square) {
    return Section{at(x, y, z), f * outer, f * inner, f * top, f * y, square};
  };
  const std::vector<int> joints{foot, toes};
  const double detail = 0.045 * f;
  Limb limb{{}, 0.12 * f};
  limb.forms.push_back(make_form(
      Loft({section(-0.13, 0.13, 0.0, 0.110, 0.110, 0.20, 0.2), section(-0.02, 0.15, 0.0, 0.122, 0.122, 0.20, 0.3),
            section(0.22, 0.13, 0.01, 0.15, 0.125, 0.15, 0.35), section(0.44, 0.10, 0.01, 0.185, 0.155, 0.10, 0.4),
            section(0.56, 0.08, 0.01, 0.18, 0.165, 0.075, 0.4)},
           side, up, 0.115 * f, 0.07 * f),
      {{a.find("leftLowerLeg"), foot, toes}, 0.0, detail, 0.8}));
  // Ankle bones, and the instep between shin and foot.
  limb.forms.push_back(
      make_form(Loft({round_section(at(0.0, 0.36, 0.0), 0.12 * f), round_section(at(0.0, 0.24, 0.14), 0.11 * f),
                      round_section(at(-0.01, 0.16, 0.34), 0.085 * f)},
                     side, Vec3::UnitY()),
                {{foot}, 0.10 * f, detail, 0.8}));
  // The heel cord.
  limb.forms.push_back(
      make_form(Loft({round_section(at(0.0, 0.60, -0.075), 0.06 * f), round_section(at(0.0, 0.40, -0.105), 0.062 * f),
                      round_section(at(0.0, 0.22, -0.145), 0.085 * f)},
                     side, Vec3::UnitZ()),
                {{a.find("leftLowerLeg"), foot}, 0.11 * f, detail, 0.8}));
  for (const Vec3& bone : {at(0.095, 0.335, -0.015), at(-0.095, 0.375, 0.02)}) {
    limb.forms.push_back(make_form(Ellipsoid(bone, f * Vec3(0.045, 0.065, 0.060)), {{foot}, 0.07 * f, detail, 0.8}));
  }
  struct Toe {
    double x, root_z, tip_x, tip_z, radius;
  };
  const Toe plan[] = {{-0.105, 0.54, -0.100, 0.735, 0.066},
                      {-0.005, 0.56, 0.002, 0.735, 0.050},
                      {0.068, 0.54, 0.080, 0.70, 0.045},
                      {0.126, 0.51, 0.145, 0.655, 0.042},
                      {0.172, 0.47, 0.196, 0.59, 0.041}};
  for (const Toe& toe : plan) {
    const double r = toe.radius;
    Limb one{{make_form(Loft({oval_section(at(toe.x, r, toe.root_z - 0.05), f * r, f * r),
                              oval_section(at(0.5 * (toe.x + toe.tip_x), 1.12 * r, 0.5 * (toe.root_z + toe.tip_z)),
                                           f * r * 0.98, f * r * 1.02),
                              oval_section(at(toe.tip_x, 0.95 * r, toe.tip_z), f * r * 0.95, f * r * 0.92)},
                             side, up, f * r, f * r * 0.95),
                        {{foot, toes}, 0.0, 0.030 * f, 1.5, 0.018 * f})},
             0.05 * f};
    limb.limbs.push_back(one);
  }
  return limb;
}

}  // namespace

Limb make_leg(const MannequinMeasures& m, const Armature& a) {
  const double u = m.unit, t = u * m.thick;
  const int upper = a.find("leftUpperLeg"), lower = a.find("leftLowerLeg"), foot = a.find("leftFoot");
  const Vec3 hip = a.position(upper), knee = a.position(lower), ankle = a.position(foot);
  const auto on = [](const Vec3& p, const Vec3& q, double s) { return Vec3((1.0 - s) * p + s * q); };
  // Thighs and calves of heavy legs on narrow hips give way where they would touch.
  const auto section = [&](const Vec3& p, double outer, double inner, double front, double back) {
    return Section{p, t * outer, std::min(t * inner, p.x() - 0.035 * u), t * front, t * back, 0.0};
  };
  Limb leg{{}, 0.28 * u};
  std::vector<Section> sections{
      section(on(hip, knee, -0.11), 0.22, 0.20, 0.24, 0.26),
      section(hip, 0.30, 0.29, 0.32, 0.34),
      section(on(hip, knee, 0.15), 0.335, 0.325, 0.36, 0.36),
      section(on(hip, knee, 0.38), 0.305, 0.295, 0.345, 0.30),
      section(on(hip, knee, 0.65), 0.25, 0.245, 0.285, 0.245),
      section(on(hip, knee, 0.87), 0.205, 0.21, 0.225, 0.215),
      section(knee, 0.195, 0.20, 0.225, 0.20),
      section(on(knee, ankle, 0.11), 0.195, 0.195, 0.185, 0.22),
      section(on(knee, ankle, 0.27), 0.23, 0.21, 0.165, 0.28),
      section(on(knee, ankle, 0.38), 0.215, 0.22, 0.155, 0.275),
      section(on(knee, ankle, 0.58), 0.165, 0.17, 0.14, 0.205),
      section(on(knee, ankle, 0.82), 0.115, 0.115, 0.12, 0.135),
      section(ankle, 0.125, 0.125, 0.125, 0.12),
      section(ankle - Vec3(0, 0.1 * u, 0), 0.115, 0.115, 0.12, 0.11),
  };
  leg.forms.push_back(make_form(Loft(std::move(sections), Vec3::UnitX(), Vec3::UnitZ(), 0.2 * u),
                                {{a.find("hips"), upper, lower, foot}, 0.0, 0.066 * u, 0.9}));
  const Vec3 kneecap = knee + u * Vec3(0.0, 0.02, 0.0) + t * Vec3(0.0, 0.0, 0.145);
  leg.forms.push_back(
      make_form(Ellipsoid(kneecap, t * Vec3(0.115, 0.15, 0.075)), {{upper, lower}, 0.12 * u, 0.062 * u, 0.9}));
  leg.limbs.push_back(make_foot(m, a));
  return leg;
}

}  // namespace croquis
