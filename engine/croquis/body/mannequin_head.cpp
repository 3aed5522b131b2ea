// SPDX-License-Identifier: MIT
#include "croquis/body/forms.h"
#include "croquis/body/mannequin.h"

namespace croquis {

/// In head heights: y from the chin, z from the axis of the neck. Simple planes, as on a drawing-school head: a ball
/// for the skull, a wedge for the face, brow, nose, cheekbone and jaw where the light turns.
Limb make_head(const MannequinMeasures& m, const Armature& a) {
  const double h = m.head;
  const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ();
  const auto at = [&](double px, double py, double pz) { return Vec3(h * px, m.chin + h * py, h * (pz + 0.01)); };
  const auto section = [&](double y, double cz, double side, double front, double back, double square = 0.0) {
    return oval_section(at(0.0, y, cz), h * side, h * front, h * back, square);
  };
  const auto traits = [&](double blend, double detail = 0.05) {
    return FormTraits{{a.find("head")}, blend * h, detail * h, 0.9};
  };
  Limb head{{}, 0.13 * m.unit};
  head.forms.push_back(make_form(Ellipsoid(at(0.0, 0.655, -0.06), h * Vec3(0.330, 0.345, 0.405)), traits(0.0)));
  head.forms.push_back(
      make_form(Loft({section(0.075, 0.235, 0.115, 0.10, 0.10), section(0.20, 0.19, 0.20, 0.165, 0.16, 0.1),
                      section(0.38, 0.15, 0.258, 0.20, 0.20, 0.2), section(0.55, 0.11, 0.28, 0.24, 0.2, 0.25),
                      section(0.72, 0.06, 0.28, 0.28, 0.2, 0.2)},
                     x, z, 0.075 * h, 0.1 * h),
                traits(0.10, 0.045)));
  // Jaw, from the ear to the chin.
  head.forms.push_back(make_form(Loft({oval_section(at(0.240, 0.40, -0.03), 0.055 * h, 0.09 * h),
                                       oval_section(at(0.218, 0.23, 0.02), 0.055 * h, 0.08 * h),
                                       oval_section(at(0.07, 0.075, 0.235), 0.06 * h, 0.065 * h)},
                                      x, z),
                                 traits(0.13, 0.045)));
  head.forms.push_back(make_form(Ellipsoid(at(0.180, 0.42, 0.180), h * Vec3(0.085, 0.080, 0.10)), traits(0.13, 0.04)));
  // The mouth: one rounded mass, and the chin below it.
  head.forms.push_back(make_form(Ellipsoid(at(0.0, 0.225, 0.255), h * Vec3(0.125, 0.10, 0.105)), traits(0.08, 0.04)));
  head.forms.push_back(make_form(Ellipsoid(at(0.0, 0.228, 0.335), h * Vec3(0.085, 0.040, 0.036)), traits(0.07, 0.022)));
  head.forms.push_back(make_form(Ellipsoid(at(0.0, 0.072, 0.285), h * Vec3(0.075, 0.060, 0.060)), traits(0.08, 0.028)));
  head.forms.push_back(make_carving(
      Ellipsoid(at(0.135, 0.495, 0.385), h * Vec3(0.095, 0.052, 0.065), turned(0.0, 20.0, -4.0)), traits(0.08, 0.032)));
  head.forms.push_back(make_form(
      Loft({round_section(at(0.03, 0.555, 0.312), 0.032 * h), round_section(at(0.13, 0.570, 0.293), 0.032 * h),
            round_section(at(0.22, 0.545, 0.215), 0.03 * h)},
           Vec3::UnitY(), z),
      traits(0.06, 0.032)));
  // Nose: a wedge that comes forward and broadens to a rounded tip.
  head.forms.push_back(make_form(Loft({oval_section(at(0.0, 0.560, 0.305), 0.030 * h, 0.030 * h),
                                       oval_section(at(0.0, 0.465, 0.350), 0.034 * h, 0.036 * h),
                                       oval_section(at(0.0, 0.375, 0.378), 0.058 * h, 0.058 * h)},
                                      x, z, -1.0, 0.030 * h),
                                 traits(0.055, 0.023)));
  Limb ear{{}, 0.06 * h};
  ear.forms.push_back(
      make_form(Ellipsoid(at(0.328, 0.455, -0.07), h * Vec3(0.042, 0.100, 0.066), turned(-14.0, -20.0, -8.0)),
                traits(0.0, 0.020)));
  head.limbs.push_back(ear);
  return head;
}

}  // namespace croquis
