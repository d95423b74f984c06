// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/nc/arc_check.h"

#include <fmt/format.h>

#include <cmath>

#include "kernel/angle.h"

namespace dgt {
namespace {

std::string shown(double millimetres) { return fmt::format("{:.3f}", millimetres); }

bool is_nowhere(const Spot& v) { return v.x.is_zero() && v.y.is_zero(); }

void count(ArcSummary& summary, double difference, const Range& block) {
  ++summary.adjusted;
  if (summary.worst && difference <= summary.largest_difference) return;
  summary.largest_difference = difference;
  summary.worst = block;
}

/// In the program's own numbers, with at most three decimals.
std::string in_units(double millimetres, const Rational& unit) {
  return to_short_decimal(Rational(millimetres) / unit, 3);
}

bool is_short_by_at_most(const Spot& chord, const Length& radius, const Rational& most) {
  const Rational reach = 2 * radius.millimetres() + most;
  return squared_length(chord.exact()) <= reach * reach;
}

}  // namespace

const Rational& radius_shortfall() {
  static const Rational kShortfall(1, 200);
  return kShortfall;
}

std::optional<Diagnostic> fault_of_centre(const Spot& chord, const Spot& centre,
                                          const NcOptions& options, const Range& block,
                                          ArcSummary& summary) {
  ++summary.arcs;
  if (is_nowhere(centre)) return Diagnostic{Message::ArcCentreAtEnd, block, {}};
  if (is_nowhere(chord)) return std::nullopt;
  const EndRadii radii = end_radii(chord, centre);
  if (radii.equal) return std::nullopt;
  if (radii.to == 0) return Diagnostic{Message::ArcCentreAtEnd, block, {}};
  const double difference = std::fabs(radii.from - radii.to);
  if (!radii_differ(chord, centre, options.arc_tolerance)) {
    count(summary, difference, block);
    summary.mismatches.push_back({block, difference});
    return std::nullopt;
  }
  return Diagnostic{Message::ArcRadiiDiffer,
                    block,
                    {shown(radii.from), shown(radii.to), shown(difference),
                     to_short_decimal(options.arc_tolerance)}};
}

std::optional<Spot> division_of(const Spot& chord, const Spot& centre, bool counter_clockwise) {
  if (is_nowhere(chord) || half_turns(chord, centre, counter_clockwise) <= 0) return std::nullopt;
  const EndRadii radii = end_radii(chord, centre);
  if (radii.equal || length_of(chord) >= radii.from) return std::nullopt;
  // The middle lies on the other side of the centre than the chord's.
  const RationalPoint c = centre.exact();
  const Vector away = c - Rational(1, 2) * chord.exact();
  const Rational radius((radii.from + radii.to) / 2);
  const RationalPoint middle = c + radius * direction_of(away).unit.vector();
  return Spot{Length(on_dyadic_grid(middle.x, -kArcBits)),
              Length(on_dyadic_grid(middle.y, -kArcBits))};
}

RadiusVerdict judge_radius(const Spot& chord, const RadiusWord& word,
                           const Rational& unit_of_repair, const NcOptions& options,
                           const Range& block, ArcSummary& summary) {
  ++summary.arcs;
  if (word.radius.is_zero()) return {false, Diagnostic{Message::ArcWithoutRadius, block, {}}};
  if (is_nowhere(chord)) return {false, Diagnostic{Message::ArcEndsWhereItBegins, block, {}}};
  if (chord_against_diameter(chord, word.radius) <= 0) return {};
  const double length = length_of(chord);
  const double radius = nearest_double(word.radius.millimetres());
  if (word.is_lenient && is_short_by_at_most(chord, word.radius, 2 * radius_shortfall())) {
    count(summary, length / 2 - radius, block);
    return {true, std::nullopt};
  }
  const std::vector<std::string> figures = {in_units(length, word.unit),
                                            in_units(2 * radius, word.unit)};
  if (!is_short_by_at_most(chord, word.radius, unit_of_repair))
    return {false, Diagnostic{Message::ArcChordTooLong, block, figures}};
  if (options.repair) return {true, Diagnostic{Message::ArcRadiusRepaired, block, figures}};
  Diagnostic fault{Message::ArcChordTooLong, block, figures};
  fault.notes.push_back({Message::ArcRepairable, block, {}});
  return {false, fault};
}

void report(const ArcSummary& summary, DiagnosticBag& bag) {
  if (!summary.worst) return;
  bag.add({Message::ArcsAdjusted,
           *summary.worst,
           {std::to_string(summary.adjusted), fmt::format("{:.4f}", summary.largest_difference)}});
}

}  // namespace dgt
