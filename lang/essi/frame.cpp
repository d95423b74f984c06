// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/essi/frame.h"

#include "kernel/angle.h"

namespace dgt::essi {
namespace {

/// Turned by the sine and cosine on this grid, sums of any length stay short. Finer than the
/// stand-ins of elements.
constexpr int kTurnExponent = -128;

}  // namespace

Frame Frame::turned(std::int64_t tenths, const Rational& scale) const {
  Frame frame;
  frame.tenths_ = tenths_ + tenths;
  frame.scale_ = scale_ * scale;
  frame.is_plain_ = frame.tenths_ % kWholeTurn == 0 && frame.scale_ == 1;
  if (frame.is_plain_) return frame;
  const Rational degrees = Rational(static_cast<long>(frame.tenths_)) / 10;
  const UnitVector x = direction_of(degrees, 2 - kTurnExponent).unit;
  frame.along_x_ = frame.scale_ * on_dyadic_grid(x.x(), kTurnExponent);
  frame.along_y_ = frame.scale_ * on_dyadic_grid(x.y(), kTurnExponent);
  return frame;
}

Spot Frame::place(const Spot& way) const {
  if (is_plain_) return way;
  const RationalPoint p = place(way.exact());
  return {Length(p.x), Length(p.y)};
}

Circle Frame::place(const Circle& circle, const Spot& from) const {
  return {from.exact() + place(circle.centre()), scale_ * circle.radius()};
}

}  // namespace dgt::essi
