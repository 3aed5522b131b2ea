// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <variant>
#include <vector>

#include "croquis/body/shapes.h"

namespace croquis {

/// One mass of a body: a shape, how softly it joins what stands before it in its limb, and what the mesh and the
/// weights should know about it.
struct Form {
  std::variant<Loft, Ellipsoid> shape;
  double blend = 0.0;       ///< radius of the smooth union (or carving) in metres; 0: a sharp crease
  bool carve = false;       ///< takes the shape away instead of adding it
  double detail = 0.012;    ///< wanted length of the mesh's edges on it, metres
  double gap = 0.0;         ///< the narrowest gap beside it that must stay open, metres; 0: none narrower than `detail`
  std::vector<int> joints;  ///< the chain of joints that move it, from the body outwards; one: it is rigid
  double softness = 0.7;    ///< half width of the change-over at each of those joints, in local radii ...
  double last_softness = 0.0;  ///< ... and at the last of them, where it is another; 0: the same
};

/// A limb: masses that melt into each other in the order given, and limbs that grow out of them. A limb melts into the
/// masses of its parent, never into its siblings: fingers do not web, thighs do not fuse.
struct Limb {
  std::vector<Form> forms;  ///< at least one, the first of which does not carve
  double blend = 0.0;       ///< radius of the smooth union with the parent limb's masses, metres
  std::vector<Limb> limbs = {};
};

struct FieldSample {
  double value = 0.0;             ///< about the signed distance in metres, negative inside
  Vec3 gradient = Vec3::UnitY();  ///< about a unit vector, outwards
  double detail = 0.0;            ///< wanted edge length there, metres
};

/// The surface value = 0 of a tree of limbs,
///     F(limb) = min over its limbs c of smin(own(limb), F(c), blend(c)),   own = smooth union of its forms in order,
/// with smin the cubic polynomial smooth minimum of compact support (quilez_smin): it is C2 and exactly the smaller
/// value where the two differ by more than the radius, so that whatever is out of reach is skipped unseen.
class ImplicitSurface {
 public:
  /// `mirrored`: the half x < 0 is the mirror image of what is described (describe the left limbs only).
  ImplicitSurface(Limb root, bool mirrored);
  ImplicitSurface(const ImplicitSurface&) = delete;
  ImplicitSurface& operator=(const ImplicitSurface&) = delete;

  [[nodiscard]] FieldSample sample(const Vec3& point) const;
  /// Normal by central differences of the field over `step` metres, unit, outwards.
  [[nodiscard]] Vec3 normal(const Vec3& point, double step) const;
  /// What part each form has in the surface at a point (derivatives of the smooth minima): not negative, sum 1. For a
  /// mirrored surface the point is folded to x >= 0 first.
  [[nodiscard]] std::vector<std::pair<const Form*, double>> shares(const Vec3& point) const;

  [[nodiscard]] bool mirrored() const { return mirrored_; }
  [[nodiscard]] const std::vector<const Form*>& forms() const { return forms_; }

 private:
  struct Node {
    const Limb* limb = nullptr;
    Ball own;      ///< holds the limb's own masses
    Ball all;      ///< holds the limb and what grows out of it
    int next = 0;  ///< index after the last node of this subtree (nodes stand in preorder)
    std::size_t first_form = 0;
  };
  template <bool kShares>
  struct Evaluation;
  int add(const Limb& limb);
  template <bool kShares>
  [[nodiscard]] Evaluation<kShares> evaluate(int node, const Vec3& point, double limit) const;
  template <bool kShares>
  [[nodiscard]] Evaluation<kShares> evaluate_own(const Node& node, const Vec3& point) const;

  Limb root_;
  bool mirrored_;
  std::vector<Node> nodes_;
  std::vector<const Form*> forms_;
  std::vector<Box> boxes_;  // of the forms
};

/// The bounding box of a form.
[[nodiscard]] Box box_of(const Form& form);

}  // namespace croquis
