// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/line.h"

namespace dgt {

/// How fine a rational stand-in follows the ideal element it stands for: relative error at most
/// 2^−bits. 96 bits leave 43 beyond a double's, so that no chain of constructions that a person
/// would write shows it.
inline constexpr int kStandInBits = 96;

/// A unit vector beside an ideal direction, and how far it may be off.
struct Direction {
  UnitVector unit;
  double bound = 0;  ///< largest angle to the ideal direction, in radians; 0 when exact
};

/// The direction at `degrees` counter-clockwise from +X.
///  (1) Multiples of 90° are exact; whole turns change nothing.
///  (2) direction_of(a + 90) turns a quarter, exactly; direction_of(−a) mirrors, exactly, save at
///      odd multiples of 45°: there both would ask for a rational vector with |x| = |y|, which no
///      unit vector is, and the quarter turns are kept, so that perpendiculars stay perpendicular.
///  (3) The angle differs from the ideal by at most `bound` ≤ 2^−bits.
[[nodiscard]] Direction direction_of(const Rational& degrees, int bits = kStandInBits);

/// The direction of `v`. Precondition (checked): v is not zero.
///  (1) It depends on the ratio of the coordinates alone, so parallel vectors get the same unit
///      vector, and opposite ones opposite vectors, exactly.
///  (2) It is exact when |v| is rational.
///  (3) Quarter-turning `v` does the same to the result, exactly; so does mirroring `v` unless
///      |x| = |y| (see above).
[[nodiscard]] Direction direction_of(const Vector& v, int bits = kStandInBits);

/// The direction of a vector with one-root coordinates, within `bound`.
[[nodiscard]] Direction direction_of(const OneRoot& x, const OneRoot& y, int bits = kStandInBits);

}  // namespace dgt
