// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "lang/nc/arc.h"
#include "lang/nc/program.h"

/// Whether there is an arc such as a block asks for, and the message when there is none.
namespace dgt {

/// A chord may pass twice the radius by twice this, in mm, in a language with decimals, where it is
/// the last digit of the radius that is missing; LinuxCNC takes as much. The arc is half a turn
/// then.
[[nodiscard]] const Rational& radius_shortfall();

/// What is wrong with an arc about a centre; nothing when it is one. What has to be adjusted is
/// counted.
[[nodiscard]] std::optional<Diagnostic> fault_of_centre(const Spot& chord, const Spot& centre,
                                                        const NcOptions& options,
                                                        const Range& block, ArcSummary& summary);

/// Where to divide an arc about a centre that is so near a whole turn, beside its ends' difference,
/// that its chord would not tell where its centre lies: seen from the beginning, in the middle of
/// the arc. Nothing for all other arcs. Precondition: no fault.
[[nodiscard]] std::optional<Spot> division_of(const Spot& chord, const Spot& centre,
                                              bool counter_clockwise);

/// The arc by radius of a block.
struct RadiusWord {
  Length radius;
  /// The number and the chord as the program counts, for messages.
  const Rational& unit;     ///< mm
  bool is_lenient = false;  ///< radius_shortfall() is allowed
};
struct RadiusVerdict {
  bool is_half_turn = false;          ///< the radius is taken as half the chord
  std::optional<Diagnostic> message;  ///< an error: there is no arc
};
[[nodiscard]] RadiusVerdict judge_radius(const Spot& chord, const RadiusWord& word,
                                         const Rational& unit_of_repair, const NcOptions& options,
                                         const Range& block, ArcSummary& summary);

/// A note of the arcs that were adjusted, if there are any.
void report(const ArcSummary& summary, DiagnosticBag& bag);

}  // namespace dgt
