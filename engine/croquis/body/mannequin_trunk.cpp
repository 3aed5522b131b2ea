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
  const double yoke = std::max(chest, m.shoulder_wide);  // keeps the pit over wide shoulders filled
  const std::vector<int> spine{a.find("hips"), a.find("spine"), a.find("chest"), a.find("upperChest"), a.find("neck")};
  const int upper_leg = a.find("leftUpperLeg"), shoulder = a.find("leftShoulder");
  const double detail = 0.068 * u;
  const auto traits = [&](double blend) { return FormTraits{spine, blend * u, detail, 0.75}; };
  const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ();
  Limb trunk;
  // One hull from the crotch to the pit of the neck, with the S of the spine in its back: pelvis forward, small of the
  // back hollow, ribcage leaning back. Front and back are given as they stand in the profile.
  const auto hull = [&](double y, double side, double front, double back, double wide, double square) {
    const double middle = -0.05;  // a straight axis: where it bends the outline would crease
    return t.section(y, middle, side, front - middle, middle - back, wide, square);
  };
  trunk.forms.push_back(make_form(
      Loft({hull(4.24, 0.60, 0.29, -0.37, hips, 0.1), hull(4.45, 0.655, 0.34, -0.40, hips, 0.2),
            hull(4.72, 0.605, 0.35, -0.345, hips, 0.2), hull(4.95, 0.525, 0.330, -0.27, 0.6 * hips + 0.4 * waist, 0.15),
            hull(5.18, 0.475, 0.305, -0.235, waist, 0.1), hull(5.45, 0.50, 0.30, -0.27, 0.4 * waist + 0.6 * chest, 0.1),
            hull(5.80, 0.58, 0.34, -0.375, chest, 0.15), hull(6.12, 0.655, 0.37, -0.45, chest, 0.2),
            hull(6.36, 0.615, 0.28, -0.445, yoke, 0.2), hull(6.55, 0.40, 0.11, -0.37, yoke, 0.1),
            hull(6.74, 0.15, 0.00, -0.26, chest, 0.0)},
           x, z, 0.25 * u, 0.06 * u),
      traits(0.0)));
  // Ribcage: an egg that stands out of the hull below the breast, so that its arch reads.
  trunk.forms.push_back(make_form(
      Ellipsoid(t.at(0.0, 5.98, -0.035), u * Vec3(0.575 * chest, 0.74, 0.445 * m.trunk_thick), turned(-9.0, 0.0, 0.0)),
      traits(0.08)));
  // The arch of the ribs over the pit of the stomach; the furrow along the spine.
  trunk.forms.push_back(make_carving(
      Ellipsoid(t.at(0.0, 5.22, 0.475), u * Vec3(0.28 * chest, 0.48, 0.17 * m.trunk_thick), turned(-4.0, 0.0, 0.0)),
      traits(0.20)));
  trunk.forms.push_back(make_carving(
      Loft({round_section(t.at(0.0, 4.92, -0.345), 0.06 * u), round_section(t.at(0.0, 5.35, -0.305), 0.06 * u),
            round_section(t.at(0.0, 5.80, -0.462), 0.06 * u), round_section(t.at(0.0, 6.20, -0.555), 0.05 * u)},
           x, z),
      traits(0.16)));
  // The crest of the pelvis, from the hip bone in front round the side; the seats behind.
  trunk.forms.push_back(make_form(Loft({round_section(t.at(0.355 * hips, 4.64, 0.180), 0.115 * u),
                                        round_section(t.at(0.470 * hips, 4.80, 0.055), 0.115 * u),
                                        round_section(t.at(0.440 * hips, 4.86, -0.090), 0.115 * u),
                                        round_section(t.at(0.270 * hips, 4.82, -0.180), 0.105 * u)},
                                       Vec3::UnitY(), x),
                                  {{spine[0], spine[1]}, 0.22 * u, detail, 0.9}));
  const FormTraits seat{{spine[0], upper_leg}, 0.16 * u, detail, 1.3};
  trunk.forms.push_back(
      make_form(Ellipsoid(t.at(0.31 * hips, 4.20, -0.235),
                          u * Vec3(0.27 * (0.4 + 0.6 * hips), 0.33, 0.25 * m.trunk_thick), turned(14.0, 0.0, 0.0)),
                seat));
  // Chest muscle from the breastbone to the armpit, shoulder blade.
  const FormTraits flank{{spine[3], shoulder}, 0.20 * u, detail, 2.0};
  trunk.forms.push_back(
      make_form(Ellipsoid(t.at(0.31 * chest, 6.15, 0.235), u * Vec3(0.37 * chest, 0.225, 0.135 * m.trunk_thick),
                          turned(-20.0, 18.0, 12.0)),
                flank));
  trunk.forms.push_back(
      make_form(Ellipsoid(t.at(0.34 * chest, 6.16, -0.345), u * Vec3(0.22 * chest, 0.34, 0.09 * m.trunk_thick),
                          turned(-13.0, -18.0, 12.0)),
                flank));
  // Neck, and the slope from it to the shoulder.
  const double neck = u * m.trunk_thick, top = m.chin + 0.22 * m.head;
  trunk.forms.push_back(make_form(Loft({oval_section(t.at(0.0, 6.42, -0.14), 0.30 * neck, 0.28 * neck),
                                        oval_section(t.at(0.0, 6.72, -0.12), 0.245 * neck, 0.25 * neck),
                                        oval_section(Vec3(0.0, m.chin + 0.02 * u, -0.05 * u), 0.23 * neck, 0.24 * neck),
                                        oval_section(Vec3(0.0, top, -0.03 * u), 0.23 * neck, 0.25 * neck)},
                                       x, z),
                                  {{spine[3], spine[4], a.find("head")}, 0.16 * u, detail, 0.9}));
  // Collar bone.
  const double acromion = a.position(a.find("leftUpperArm")).x() / u;
  trunk.forms.push_back(make_form(Loft({round_section(t.at(0.06, 6.53, 0.095), 0.05 * u),
                                        round_section(t.at(0.40 * acromion, 6.575, 0.050), 0.050 * u),
                                        round_section(t.at(0.86 * acromion, 6.59, -0.05), 0.05 * u)},
                                       Vec3::UnitY(), z),
                                  {{spine[3], shoulder}, 0.11 * u, detail, 2.5}));
  FormTraits trapezius{{spine[3], shoulder}, 0.20 * u, detail, 2.5};
  trunk.forms.push_back(make_form(Loft({oval_section(t.at(0.10, 6.90, -0.16), 0.14 * u, 0.10 * u),
                                        oval_section(t.at(0.42 * acromion, 6.635, -0.145), 0.19 * u, 0.12 * u),
                                        oval_section(t.at(0.92 * acromion, 6.53, -0.10), 0.17 * u, 0.10 * u)},
                                       z, Vec3::UnitY()),
                                  trapezius));
  return trunk;
}

}  // namespace croquis
