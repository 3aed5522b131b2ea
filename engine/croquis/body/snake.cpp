// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>

#include "croquis/body/animals.h"
#include "croquis/body/forms.h"
#include "croquis/body/sculpture.h"

namespace croquis {
namespace {

constexpr int kJointsPerHalf = 16;

std::string numbered(const char* name, int i) { return std::string(name) + (i < 10 ? "_0" : "_") + std::to_string(i); }

/// A section of the body that rests on the ground.
Section lying(double z, double radius) {
  return {Vec3(0.0, 0.94 * radius, z), radius, radius, radius, 0.94 * radius, 0.0};
}

struct SnakeScale {
  const Proportions& p;
  double thick = std::pow(p.muscle, 0.8);
  double half = 0.80 * p.limbs;  // from the middle to the neck

  [[nodiscard]] double radius(double along) const {  // -1 tail tip, 0 middle, 1 neck
    const double body = 0.031 * thick;
    if (along > 0.0) return body * (1.0 - 0.42 * along * along * along);
    return body * std::max(0.08, 1.0 - 0.93 * std::pow(-along, 2.6));
  }
  [[nodiscard]] Vec3 axis(double along) const { return lying(along * half, radius(along)).center; }
};

Limb make_snake_head(const SnakeScale& k, const Armature& a) {
  const double s = 1.25 * k.p.head;
  const int head = a.find("head"), jaw = a.find("jaw");
  const Vec3 base = a.position(head);
  const auto at = [&](double x, double y, double z) { return Vec3(base + s * Vec3(x, y, z)); };
  const auto section = [&](double z, double y, double side, double up, double down, double square) {
    return oval_section(at(0, y, z), s * side, s * up, s * down, square);
  };
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY();
  Limb skull{{}, 0.010};
  skull.forms.push_back(make_form(
      Loft({section(-0.005, 0.002, 0.017, 0.014, 0.012, 0.0), section(0.022, 0.004, 0.028, 0.0165, 0.010, 0.2),
            section(0.050, 0.004, 0.0235, 0.0150, 0.007, 0.25), section(0.078, 0.003, 0.0150, 0.0100, 0.006, 0.3)},
           x, y, -1.0, 0.010 * s),
      {{a.find(numbered("spine", kJointsPerHalf)), head}, 0.0, 0.0050 * s}));
  skull.forms.push_back(make_form(
      Loft({round_section(at(0.012, 0.0155, 0.034), 0.0042 * s), round_section(at(0.0135, 0.0135, 0.062), 0.0032 * s)},
           y, x),
      {{head}, 0.008 * s, 0.0040 * s}));
  Limb eye{{make_form(Ellipsoid(at(0.0205, 0.0085, 0.0535), s * Vec3(0.0042, 0.0050, 0.0056), turned(0, 18, 0)),
                      {{head}, 0.0, 0.0026 * s})},
           0.001 * s};
  skull.limbs.push_back(eye);
  Limb lower{{make_form(Loft({section(0.012, -0.004, 0.0225, 0.0060, 0.0075, 0.2),
                              section(0.045, -0.004, 0.0195, 0.0060, 0.0075, 0.25),
                              section(0.075, -0.0035, 0.0125, 0.0050, 0.0060, 0.3)},
                             x, y, 0.012 * s, 0.008 * s),
                        {{head, jaw}, 0.0, 0.0036 * s, 0.8})},
             0.0030 * s};
  skull.limbs.push_back(lower);
  return skull;
}

}  // namespace

Character make_snake(const Proportions& proportions) {
  const SnakeScale k{proportions};
  Armature a;
  std::vector<int> forward{a.add("root", -1, k.axis(0.0))}, backward = forward;
  for (int i = 1; i <= kJointsPerHalf; ++i) {
    const double along = i / (kJointsPerHalf + 1.0);
    forward.push_back(a.add(numbered("spine", i), forward.back(), k.axis(along)));
    backward.push_back(a.add(numbered("tail", i), backward.back(), k.axis(-along)));
  }
  const int head = a.add("head", forward.back(), k.axis(1.0) + Vec3(0, 0.004, 0));
  a.add("jaw", head, a.position(head) + k.p.head * Vec3(0.0, -0.003, 0.012));
  forward.push_back(head);
  // Two hulls that are one and the same over the middle, each with its own half of the joints.
  std::vector<Section> front, back;
  for (int i = 0; i <= 10; ++i) {
    front.push_back(lying((i == 0 ? -0.04 : i / 10.0) * k.half, k.radius(i / 10.0)));
    back.push_back(lying((i == 0 ? 0.04 : -i / 10.0) * k.half, k.radius(-i / 10.0)));
  }
  Sculpture sculpture;
  sculpture.name = "body";
  sculpture.mirrored = true;
  sculpture.color = Vec4f(0.36F, 0.42F, 0.24F, 1.0F);
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY();
  sculpture.root.forms.push_back(make_form(Loft(std::move(front), x, y), {forward, 0.0, 0.0105, 0.8}));
  sculpture.root.forms.push_back(make_form(Loft(std::move(back), x, y, -1.0, 0.012), {backward, 0.0, 0.0105, 0.8}));
  sculpture.root.limbs.push_back(make_snake_head(k, a));
  return assemble("snake", a, std::move(sculpture));
}

}  // namespace croquis
