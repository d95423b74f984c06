// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tl/expected.hpp>

#include "post/write.h"

/// Where the straight cut has to end on which a control comes to its offset.
///
/// The tool is to go straight to where the equidistant begins, `begin`, and the control decides
/// where it goes from the programmed lead and the element behind it:
///
///  * One that goes beside the beginning of the element (KerfEntry::Beside) is led to the foot of
///    `begin` on the element.
///  * One that goes where the offsets of the lead and of the element meet (KerfEntry::Meets) keeps
///    the offset from the lead as programmed. So the lead has to pass `begin` at just the offset,
///    with `begin` on the side of the tool: it is the tangent to the circle of the offset about
///    `begin`, and ends where that meets the element, some way before the foot. From so near that
///    the circle is about the tool already there is no tangent.
///  * Of one that nobody knows (KerfEntry::Either) the second lead is right the first way, too, if
///    the tool may run from beside its end to `begin`: where a closed contour comes in to its end
///    it runs anyway, and elsewhere it may where that cuts into no part.
namespace dgt {

/// The lead of one contour, as it is to be cut.
struct WantedEntry {
  const Toolpath& path;
  const Contour& contour;
  Point from;         ///< where the tool stands, without an offset
  Point begin;        ///< where the equidistant begins
  const Move& first;  ///< the first element, as programmed
  const Move& last;   ///< the last of the equidistant
  bool left = false;  ///< where the tool runs, seen along the travel
};

struct EntryFault {
  WriteFault::Kind kind;
  double measure = 0;  ///< as in WriteFault
  double limit = 0;
};

/// Where the lead ends and the contour begins, as programmed: on the first element, prolonged.
[[nodiscard]] tl::expected<Point, EntryFault> control_entry(const WantedEntry& wanted,
                                                            const Dialect& dialect);

/// The place beside `at` on the element of `cut`; `beside` itself if that is there to within what
/// shows.
[[nodiscard]] Point foot_on(const Move& cut, const Point& at, const Point& beside);

}  // namespace dgt
