// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/plan.h"

/// The 3B format of Chinese wire machines, `B X B Y B J G Z`, in whole units.
///
///  * A line is seen from where it begins: X and Y are where it ends, without signs, Z is L1 to L4,
///    the quadrant it leads into; a line along an axis belongs to the quadrant that begins there,
///    counter-clockwise: +X is L1, +Y is L2. J is its length along the axis G, the longer of the
///    two; of equals Y in L1 and L3, X in L2 and L4.
///  * An arc is seen from its centre: X and Y are where it begins, without signs. Z is SR
///  (clockwise)
///    or NR (counter-clockwise) and the quadrant it runs into first: +X is NR1 and SR4. J is how
///    far it goes along the axis G, all ways back and forth summed. G is the axis along which it
///    runs at its end: X where |x| < |y| there; of equals X in quadrants 1 and 3, Y in 2 and 4.
///
/// A control that reads this has no end of an arc: it steps along the circle through the beginning
/// until J steps have been made along G. So an arc is written only when that ends in the point
/// meant, whichever way the control steps.
namespace dgt {

enum class CountedAxis : std::uint8_t { X, Y };

/// An arc as 3B says it.
struct CountedArc {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t count = 0;
  CountedAxis axis = CountedAxis::X;
  int quadrant = 1;
};
/// Nothing where counting does not end surely in `arc.to`:
///  (1) seen along G, the circle through the beginning has to pass nearest to `arc.to` of all grid
///      points;
///  (2) where the arc passes an extreme along G, all controls have to turn at the same step. One
///      that keeps outside the circle turns at ⌈√(r²−1)⌉, one that keeps beside it at r rounded;
///      where these differ nothing can be counted.
[[nodiscard]] std::optional<CountedArc> counted_arc(const WrittenArc& arc);

[[nodiscard]] std::string three_b_text(const Plan& plan, const Dialect& dialect,
                                       std::vector<WriteFault>& faults);

}  // namespace dgt
