// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/essi/arc.h"

#include "lang/nc/arc_check.h"
#include "lang/nc/told_arc.h"

namespace dgt::essi {
namespace {

constexpr std::size_t kSense = 4;  // field

std::optional<Arc> read_radius_arc(const Block& block, const Spot& chord, const Unit& unit,
                                   const NcOptions& options, Messages& messages,
                                   ArcSummary& summary) {
  const Field& radius = block.fields[2];
  const Field& size = block.fields[3];
  if (radius.negative)
    return messages.report(Message::EssiRadiusNegative, messages.range_of(radius)), std::nullopt;
  if (size.has_digits) return messages.refuse(size, Message::EssiSignWithDigits), std::nullopt;
  Arc arc;
  arc.chord = chord;
  arc.radius = unit.length(radius.value);
  arc.major = !size.negative;
  arc.counter_clockwise = block.fields[kSense].negative;
  RadiusVerdict verdict = judge_radius(chord, {arc.radius, unit.width(), false}, unit.width(),
                                       options, messages.range_of(block), summary);
  const bool is_fault = verdict.message && verdict.message->severity() == Severity::Error;
  if (verdict.message) messages.add(*std::move(verdict.message));
  if (is_fault) return std::nullopt;
  arc.is_half_turn = verdict.is_half_turn;
  return arc;
}

std::optional<Arc> read_centre_arc(const Block& block, const Spot& chord, const Unit& unit,
                                   const EssiOptions& options, Messages& messages,
                                   ArcSummary& summary) {
  Arc arc;
  arc.is_by_radius = false;
  arc.chord = chord;
  arc.centre = unit.way(block, 2);
  const bool plus = !block.fields[kSense].negative;
  arc.counter_clockwise = plus == (options.iso_plus == RotationSense::CounterClockwise);
  if (auto fault =
          fault_of_centre(chord, arc.centre, options.nc, messages.range_of(block), summary)) {
    messages.add(*std::move(fault));
    return std::nullopt;
  }
  return arc;
}

}  // namespace

Length Unit::length(std::int64_t units) const {
  std::int64_t steps = 0;
  if (length_.on_grid() && !__builtin_mul_overflow(units, length_.steps(), &steps))
    return Length::of_steps(steps);
  return Length(Rational(static_cast<long>(units)) * width_);
}

std::optional<Arc> read_arc(const Block& block, const Spot& chord, const Unit& unit,
                            const EssiOptions& options, Messages& messages, ArcSummary& summary) {
  const Field& sense = block.fields[kSense];
  if (sense.has_digits) return messages.refuse(sense, Message::EssiSignWithDigits), std::nullopt;
  return options.dialect == EssiDialect::Guide
             ? read_radius_arc(block, chord, unit, options.nc, messages, summary)
             : read_centre_arc(block, chord, unit, options, messages, summary);
}

ElementPtr curve_of(const Arc& arc, const Spot& from) {
  if (!arc.is_by_radius) return told_by_centre(from, arc.chord, arc.centre, arc.counter_clockwise);
  if (arc.is_half_turn) return told_half_turn(from, arc.chord, arc.counter_clockwise);
  return told_by_radius(from, arc.chord, arc.radius, arc.major, arc.counter_clockwise);
}

}  // namespace dgt::essi
