// SPDX-License-Identifier: MIT
#include "croquis/body/implicit_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace croquis {
namespace {

struct Blend {
  double lowering;  ///< what the smooth minimum subtracts from the smaller value
  double share;     ///< the derivative by the larger value
};

/// Cubic smooth minimum of two values that are `apart` >= 0.
Blend smooth_minimum(double apart, double radius) {
  if (apart >= radius) return {0.0, 0.0};
  const double h = 1.0 - apart / radius;
  return {h * h * h * radius / 6.0, 0.5 * h * h};
}

ShapeSample sample_form(const Form& form, const Vec3& point) {
  return std::visit([&](const auto& shape) { return shape.sample(point); }, form.shape);
}

const Ball& ball_of(const Form& form) {
  return std::visit([](const auto& shape) -> const Ball& { return shape.ball(); }, form.shape);
}

bool farther_than(const Box& box, const Vec3& point, double distance) {
  return distance < 0.0 || box.squaredExteriorDistance(point) > distance * distance;
}

bool farther_than(const Ball& ball, const Vec3& point, double distance) {
  const double reach = distance + ball.radius;
  return reach < 0.0 || (point - ball.center).squaredNorm() > reach * reach;
}

Vec3 fold(const Vec3& point, bool mirrored) {
  return mirrored ? Vec3(std::abs(point.x()), point.y(), point.z()) : point;
}

}  // namespace

Box box_of(const Form& form) {
  return std::visit([](const auto& shape) { return shape.box(); }, form.shape);
}

/// The field at a point, with or without what part each form has in it.
template <bool kShares>
struct ImplicitSurface::Evaluation {
  struct None {};
  FieldSample field;
  [[no_unique_address]] std::conditional_t<kShares, std::vector<std::pair<const Form*, double>>, None> shares;

  /// this = smooth minimum of this and other.
  void unite(const Evaluation& other, double radius) {
    const bool other_smaller = other.field.value < field.value;
    const Blend blend = smooth_minimum(std::abs(other.field.value - field.value), radius);
    const double mine = other_smaller ? blend.share : 1.0 - blend.share;
    const double value = std::min(field.value, other.field.value) - blend.lowering;
    field.gradient = mine * field.gradient + (1.0 - mine) * other.field.gradient;
    field.detail = mine * field.detail + (1.0 - mine) * other.field.detail;
    field.value = value;
    if constexpr (kShares) {
      for (auto& [form, share] : shares) share *= mine;
      for (const auto& [form, share] : other.shares) shares.emplace_back(form, (1.0 - mine) * share);
    }
  }

  /// this = smooth maximum of this and -other: other is taken away. What is left keeps its owner.
  void carve(const Evaluation& other, double radius) {
    const double theirs = -other.field.value;
    const bool other_larger = theirs > field.value;
    const Blend blend = smooth_minimum(std::abs(theirs - field.value), radius);
    const double mine = other_larger ? blend.share : 1.0 - blend.share;
    const double value = std::max(field.value, theirs) + blend.lowering;
    field.gradient = mine * field.gradient - (1.0 - mine) * other.field.gradient;
    field.detail = mine * field.detail + (1.0 - mine) * other.field.detail;
    field.value = value;
  }
};

ImplicitSurface::ImplicitSurface(Limb root, bool mirrored) : root_(std::move(root)), mirrored_(mirrored) { add(root_); }

int ImplicitSurface::add(const Limb& limb) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.push_back({&limb, {}, {}, 0, forms_.size()});
  Ball ball;
  for (const Form& form : limb.forms) {
    forms_.push_back(&form);
    boxes_.push_back(box_of(form));
    if (!form.carve) ball.include(ball_of(form));
  }
  nodes_[static_cast<std::size_t>(index)].own = ball;
  for (const Limb& child : limb.limbs) ball.include(nodes_[static_cast<std::size_t>(add(child))].all);
  nodes_[static_cast<std::size_t>(index)].all = ball;
  nodes_[static_cast<std::size_t>(index)].next = static_cast<int>(nodes_.size());
  return index;
}

template <bool kShares>
ImplicitSurface::Evaluation<kShares> ImplicitSurface::evaluate_own(const Node& node, const Vec3& point) const {
  Evaluation<kShares> own;
  own.field.value = std::numeric_limits<double>::max();
  const Box* box = &boxes_[node.first_form];
  for (const Form& form : node.limb->forms) {
    const Box& form_box = *box++;
    const bool first = own.field.value == std::numeric_limits<double>::max();
    const double wanted = form.carve ? form.blend - own.field.value : own.field.value + form.blend;
    if (!first && farther_than(form_box, point, wanted)) continue;
    const ShapeSample shape = sample_form(form, point);
    Evaluation<kShares> one;
    one.field = {shape.distance, shape.direction, form.detail};
    if constexpr (kShares) {
      if (!form.carve) one.shares.emplace_back(&form, 1.0);
    }
    if (first) {
      own = std::move(one);
    } else if (form.carve) {
      own.carve(one, form.blend);
    } else {
      own.unite(one, form.blend);
    }
  }
  return own;
}

/// `limit`: whoever asks has no use for values above it (they may come back as anything above it).
template <bool kShares>
ImplicitSurface::Evaluation<kShares> ImplicitSurface::evaluate(int index, const Vec3& point, double limit) const {
  const Node& node = nodes_[static_cast<std::size_t>(index)];
  const auto next = [&](int child) { return nodes_[static_cast<std::size_t>(child)].next; };
  // Far out on a limb the masses that it grows out of, a dozen of them, are out of reach: what they are at least says
  // so before they are asked.
  const double own_least = (point - node.own.center).norm() - node.own.radius;
  Evaluation<kShares> best;
  best.field.value = std::numeric_limits<double>::max();
  if (own_least > 0.0) {
    double reach = 0.0;  // of the blends
    for (int child = index + 1; child < node.next; child = next(child)) {
      const Node& grown = nodes_[static_cast<std::size_t>(child)];
      reach = std::max(reach, grown.limb->blend);
      const double wanted = std::min({limit, best.field.value, own_least});
      if (farther_than(grown.all, point, wanted)) continue;
      Evaluation<kShares> one = evaluate<kShares>(child, point, wanted);
      if (one.field.value < best.field.value) best = std::move(one);
    }
    if (best.field.value + reach <= own_least) return best;
  }
  const Evaluation<kShares> own = evaluate_own<kShares>(node, point);
  best = own;
  for (int child = index + 1; child < node.next; child = next(child)) {
    const Node& grown = nodes_[static_cast<std::size_t>(child)];
    // The smooth minimum of two lies below the smaller by a sixth of its radius at most.
    const double blend = grown.limb->blend, least = std::min(best.field.value, limit) + blend / 6.0;
    const double wanted = own.field.value >= least ? least : own.field.value + blend;
    if (farther_than(grown.all, point, wanted)) continue;
    const Evaluation<kShares> united = evaluate<kShares>(child, point, wanted);
    // The order of the two must not matter: the parent's own masses come second.
    Evaluation<kShares> parent = own;
    parent.unite(united, blend);
    if (parent.field.value < best.field.value) best = std::move(parent);
  }
  return best;
}

FieldSample ImplicitSurface::sample(const Vec3& point) const {
  FieldSample field = evaluate<false>(0, fold(point, mirrored_), std::numeric_limits<double>::max()).field;
  if (mirrored_ && point.x() < 0.0) field.gradient.x() *= -1.0;
  return field;
}

Vec3 ImplicitSurface::normal(const Vec3& point, double step) const {
  Vec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 shift = step * Vec3::Unit(axis);
    gradient[axis] = sample(point + shift).value - sample(point - shift).value;
  }
  const double length = gradient.norm();
  return length > 0.0 ? Vec3(gradient / length) : Vec3::UnitY();
}

std::vector<std::pair<const Form*, double>> ImplicitSurface::shares(const Vec3& point) const {
  return evaluate<true>(0, fold(point, mirrored_), std::numeric_limits<double>::max()).shares;
}

}  // namespace croquis
