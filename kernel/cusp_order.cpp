// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/cusp_order.h"

#include <optional>

namespace dgt {
namespace {

using Fine = DoubleDouble;

/// How many times the angle at which a strand passes a cusp is larger than what all of them turn by
/// on the way from there, so that they count as straight.
constexpr double kStraightOn = 16;
/// And the least sine of that angle.
constexpr double kTransversal = 0x1p-40;

/// Along the strand, at a place on it.
EnclosedVector<Fine> heading(const Strand<Fine>& s, const EnclosedVector<Fine>& at) {
  if (s.is_line) return s.to - s.from;
  const EnclosedVector<Fine> left = turned_left(at - s.centre);
  return s.counter_clockwise ? left : -left;
}
/// Positive to the left; nothing when the radius may be 0.
std::optional<Enclosed<Fine>> curvature(const Strand<Fine>& s) {
  if (s.is_line) return Enclosed<Fine>{};
  if (s.radius.sign() <= 0) return std::nullopt;
  const Enclosed<Fine> bend = Enclosed<Fine>{1.0, 0} / s.radius;
  return s.counter_clockwise ? bend : -bend;
}

double length_squared(const EnclosedVector<Fine>& v) { return v.x.hi * v.x.hi + v.y.hi * v.y.hi; }

}  // namespace

int order_at_cusp(const Strand<Fine>& into, const Strand<Fine>& out, const Strand<Fine>& third,
                  CoarsePoint at) {
  const auto ahead = heading(out, out.from);
  if (dot(heading(into, into.to), ahead).sign() >= 0) return 0;
  const auto bend = curvature(out);
  const auto bend_back = curvature(into);
  const auto third_bend = curvature(third);
  if (!bend || !bend_back || !third_bend) return 0;
  const auto through = heading(third, out.from);
  const Enclosed<Fine> across = cross(ahead, through);
  const double sine = across.size() / std::sqrt(length_squared(ahead) * length_squared(through));
  const double h =
      std::hypot(at.x - out.from.x.hi, at.y - out.from.y.hi) + 0x1p-48 * out.from.size();
  const double turned = h * (bend->size() + bend_back->size() + third_bend->size());
  if (!(sine > kStraightOn * turned + kTransversal)) return 0;
  // The first strand, seen from the cusp, runs backwards. +1: it lies to the left of the second.
  const int above = (-*bend_back - *bend).sign();
  return -above * across.sign();
}

}  // namespace dgt
