// SPDX-License-Identifier: MIT
#include <algorithm>

#include "croquis/body/forms.h"
#include "croquis/body/mannequin.h"

namespace croquis {
namespace {

/// Writes lengths in units: x and y across and up, thickness in z.
struct TrunkScale {
  const MannequinMeasures& m;

  [[nodiscard]] Vec3 at(double x, double y, double z) const {
    return {m.unit * x, m.lift + m.unit * y, m.unit * z * m.trunk_thick};
  }
  /// A section at height y about the axis z; `wide` is what the proportions make of widths there.
  [[nodiscard]] Section section(double y, double z, double side, double front, double back, double wide,
                                double square = 0.0) const {
    const double s = m.unit * side * wide * m.trunk_thick, t = m.unit * m.trunk_thick;
    return oval_section(at(0.0, y, z), s, t * front, t * back, square);
  }
};

}  // namespace

Limb make_trunk(const MannequinMeasures& m, const Armature& a) {
  const TrunkScale t{m};
  const double u = m.unit;
  const double chest = 0.55 + 0.45 * m.shoulder_wide, hips = m.hip_wide, waist = 0.5 * (chest + hips);
  const std::vector<int> spine{a.find("hips"), a.find("spine"), a.find("chest"), a.find("upperChest"), a.find("neck")};
  const int upper_leg = a.find("leftUpperLeg"), shoulder = a.find("leftShoulder");
  const double detail = 0.068 * u;
  const auto traits = [&](double blend) { return FormTraits{spine, blend * u, detail, 0.75}; };
  const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ();
  Limb trunk;
  // Ribcage: an egg that leans back.
  trunk.forms.push_back(make_form(
      Loft(
          {t.section(5.30, 0.03, 0.40, 0.26, 0.26, chest), t.section(5.58, 0.01, 0.53, 0.36, 0.36, chest, 0.1),
           t.section(5.95, -0.03, 0.61, 0.41, 0.43, chest, 0.25), t.section(6.25, -0.07, 0.57, 0.36, 0.43, chest, 0.25),
           t.section(6.50, -0.11, 0.42, 0.25, 0.34, chest), t.section(6.66, -0.13, 0.22, 0.15, 0.20, chest)},
          x, z, 0.10 * u, 0.05 * u),
      traits(0.0)));
  // Waist.
  trunk.forms.push_back(make_form(Loft({t.section(4.35, -0.01, 0.46, 0.32, 0.30, hips),
                                        t.section(4.80, 0.01, 0.46, 0.34, 0.27, 0.5 * (waist + hips)),
                                        t.section(5.10, 0.01, 0.43, 0.31, 0.25, waist),
                                        t.section(5.40, 0.01, 0.44, 0.30, 0.28, 0.5 * (waist + chest)),
                                        t.section(5.75, -0.01, 0.46, 0.32, 0.32, chest)},
                                       x, z, 0.1 * u, 0.1 * u),
                                  traits(0.16)));
  // Pelvis: a bowl.
  trunk.forms.push_back(make_form(
      Loft({t.section(4.02, -0.04, 0.20, 0.16, 0.18, hips), t.section(4.18, -0.04, 0.46, 0.27, 0.32, hips, 0.1),
            t.section(4.42, -0.03, 0.62, 0.35, 0.38, hips, 0.2), t.section(4.68, -0.01, 0.58, 0.36, 0.33, hips, 0.15),
            t.section(4.86, 0.00, 0.47, 0.31, 0.26, hips)},
           x, z, 0.06 * u, 0.06 * u),
      traits(0.14)));
  FormTraits glute{{spine[0], upper_leg}, 0.12 * u, detail, 1.2};
  trunk.forms.push_back(
      make_form(Ellipsoid(t.at(0.30 * hips, 4.22, -0.22),
                          u * Vec3(0.28 * (0.4 + 0.6 * hips), 0.33, 0.27 * m.trunk_thick), turned(10.0, 0.0, 0.0)),
                glute));
  // Chest muscle, from the breastbone to the armpit.
  FormTraits pectoral{{spine[3], shoulder}, 0.10 * u, detail, 2.0};
  trunk.forms.push_back(
      make_form(Ellipsoid(t.at(0.30 * chest, 6.13, 0.22), u * Vec3(0.34 * chest, 0.22, 0.15 * m.trunk_thick),
                          turned(-14.0, 14.0, 8.0)),
                pectoral));
  // The back's broad muscle, which makes the taper from the armpit to the waist.
  trunk.forms.push_back(make_form(Loft({oval_section(t.at(0.40 * waist, 5.25, -0.10), 0.07 * u, 0.12 * u),
                                        oval_section(t.at(0.53 * chest, 5.85, -0.14), 0.12 * u, 0.2 * u),
                                        oval_section(t.at(0.60 * chest, 6.28, -0.14), 0.13 * u, 0.18 * u)},
                                       x, z),
                                  traits(0.14)));
  // Neck, and the slope from it to the shoulder.
  const double neck = u * m.trunk_thick, top = m.chin + 0.22 * m.head;
  trunk.forms.push_back(make_form(Loft({oval_section(t.at(0.0, 6.42, -0.14), 0.30 * neck, 0.28 * neck),
                                        oval_section(t.at(0.0, 6.72, -0.12), 0.245 * neck, 0.25 * neck),
                                        oval_section(Vec3(0.0, m.chin + 0.02 * u, -0.05 * u), 0.23 * neck, 0.24 * neck),
                                        oval_section(Vec3(0.0, top, -0.03 * u), 0.23 * neck, 0.25 * neck)},
                                       x, z),
                                  {{spine[3], spine[4], a.find("head")}, 0.16 * u, detail, 0.9}));
  const double acromion = a.position(a.find("leftUpperArm")).x() / u;
  FormTraits trapezius{{spine[3], shoulder}, 0.20 * u, detail, 2.5};
  trunk.forms.push_back(make_form(Loft({oval_section(t.at(0.10, 6.74, -0.16), 0.12 * u, 0.10 * u),
                                        oval_section(t.at(0.5 * acromion, 6.56, -0.15), 0.13 * u, 0.10 * u),
                                        oval_section(t.at(0.94 * acromion, 6.50, -0.10), 0.13 * u, 0.10 * u)},
                                       z, Vec3::UnitY()),
                                  trapezius));
  return trunk;
}

}  // namespace croquis
