// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/element.h"
#include "lang/nc/length.h"

/// The arcs of arc.h as elements of a tool path.
///  (1) Each is the circle that the function of arc.h with the same operands gives, and has its
///      preconditions.
///  (2) Where all operands are whole steps, as nearly everywhere, these are kept, 96 bytes in all,
///      and the circle is worked out when somebody asks for it. Else it is worked out at once.
namespace dgt {

[[nodiscard]] ElementPtr told_by_centre(const Spot& from, const Spot& chord, const Spot& centre,
                                        bool counter_clockwise);
[[nodiscard]] ElementPtr told_by_radius(const Spot& from, const Spot& chord, const Length& radius,
                                        bool major, bool counter_clockwise);
[[nodiscard]] ElementPtr told_half_turn(const Spot& from, const Spot& chord,
                                        bool counter_clockwise);

}  // namespace dgt
