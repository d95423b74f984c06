// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/construct.h"

/// What the constructions share: nearness decided within the contact resolution, upper bounds in
/// doubles, and the cap on bit lengths. Internal to the kernel.
namespace dgt {

/// |v| in mm, for messages.
[[nodiscard]] double length(const Vector& v);
/// A double that is at least |value|.
[[nodiscard]] double upper_bound(const Rational& value);
/// Shorter than the contact resolution.
[[nodiscard]] bool within_contact(const Vector& v);
/// On the circle within the contact resolution, by the point's exact form.
[[nodiscard]] bool on_circle(const Circle& circle, const KnownPoint& point);
/// |c1 − c2| = |r1 − r2| within the contact resolution.
[[nodiscard]] bool in_oriented_contact(const Circle& a, const Circle& b);
/// |value| ≤ the contact resolution.
[[nodiscard]] bool is_contact(const Rational& value);

/// Rounds coordinates longer than kMaxHeight bits onto a dyadic grid and enlarges the bound; a line
/// keeps to `anchor`.
void cap_height(Constructed<Line>& line, const RationalPoint& anchor);
void cap_height(Constructed<Circle>& circle);
void cap_height(KnownPoint& point);

}  // namespace dgt
