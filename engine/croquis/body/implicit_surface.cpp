// SPDX-License-Identifier: MIT
#include "croquis/body/implicit_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

struct ImplicitSurface::Evaluation {
  FieldSample field;
  std::vector<std::pair<const Form*, double>> shares;

  /// this = smooth minimum of this and other.
  void unite(const Evaluation& other, double radius) {
    const bool other_smaller = other.field.value < field.value;
    const Blend blend = smooth_minimum(std::abs(other.field.value - field.value), radius);
    const double mine = other_smaller ? blend.share : 1.0 - blend.share;
    const double value = std::min(field.value, other.field.value) - blend.lowering;
    mix(other, mine);
    field.value = value;
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

 private:
  void mix(const Evaluation& other, double mine) {
    field.gradient = mine * field.gradient + (1.0 - mine) * other.field.gradient;
    field.detail = mine * field.detail + (1.0 - mine) * other.field.detail;
    for (auto& [form, share] : shares) share *= mine;
    for (const auto& [form, share] : other.shares) shares.emplace_back(form, (1.0 - mine) * share);
  }
};

ImplicitSurface::ImplicitSurface(Limb root, bool mirrored) : root_(std::move(root)), mirrored_(mirrored) { add(root_); }

int ImplicitSurface::add(const Limb& limb) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.push_back({&limb, {}, 0});
  Ball ball;
  for (const Form& form : limb.forms) {
    forms_.push_back(&form);
    if (!form.carve) ball.include(ball_of(form));
  }
  for (const Limb& child : limb.limbs) ball.include(nodes_[static_cast<std::size_t>(add(child))].ball);
  nodes_[static_cast<std::size_t>(index)].ball = ball;
  nodes_[static_cast<std::size_t>(index)].next = static_cast<int>(nodes_.size());
  return index;
}

/// `limit`: whoever asks has no use for values above it (they may come back as anything above it).
ImplicitSurface::Evaluation ImplicitSurface::evaluate(int index, const Vec3& point, double limit,
                                                      bool with_shares) const {
  const Node& node = nodes_[static_cast<std::size_t>(index)];
  Evaluation own;
  own.field.value = std::numeric_limits<double>::max();
  for (const Form& form : node.limb->forms) {
    const bool first = own.field.value == std::numeric_limits<double>::max();
    const double wanted = form.carve ? form.blend - own.field.value : own.field.value + form.blend;
    if (!first && farther_than(ball_of(form), point, wanted)) continue;
    const ShapeSample shape = sample_form(form, point);
    Evaluation one;
    one.field = {shape.distance, shape.direction, form.detail};
    if (with_shares && !form.carve) one.shares.emplace_back(&form, 1.0);
    if (first) {
      own = std::move(one);
    } else if (form.carve) {
      own.carve(one, form.blend);
    } else {
      own.unite(one, form.blend);
    }
  }
  Evaluation best = own;
  for (int child = index + 1; child < node.next; child = nodes_[static_cast<std::size_t>(child)].next) {
    const Node& grown = nodes_[static_cast<std::size_t>(child)];
    const double wanted = std::min(own.field.value, limit) + grown.limb->blend;
    if (farther_than(grown.ball, point, wanted)) continue;
    Evaluation united = evaluate(child, point, wanted, with_shares);
    // The order of the two must not matter: the parent's own masses come second.
    Evaluation parent = own;
    parent.unite(united, grown.limb->blend);
    if (parent.field.value < best.field.value) best = std::move(parent);
  }
  return best;
}

FieldSample ImplicitSurface::sample(const Vec3& point) const {
  Evaluation result = evaluate(0, fold(point, mirrored_), std::numeric_limits<double>::max(), false);
  if (mirrored_ && point.x() < 0.0) result.field.gradient.x() *= -1.0;
  return result.field;
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
  return evaluate(0, fold(point, mirrored_), std::numeric_limits<double>::max(), true).shares;
}

}  // namespace croquis
