// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/contour.h"

#include <algorithm>

#include "kernel/contour_path.h"

namespace dgt {
namespace {

using Kind = ContourFault::Kind;

ContourFault fault(Kind kind, std::size_t item, double measure = 0) {
  ContourFault f{};
  f.kind = kind;
  f.item = item;
  f.measure = measure;
  return f;
}

bool any_offset(const ContourLegs& legs) {
  for (const Rational& step : legs.steps)
    if (sgn(step) != 0) return true;
  return false;
}

/// +1: W > 0 lies to the left of the elements, −1: to the right; 0 with a fault when nobody can
/// say.
int side_of_offset(const ContourLegs& legs, const ContourOptions& options, BuiltContour& out) {
  if (options.offset_side == OffsetSide::Left) return 1;
  if (options.offset_side == OffsetSide::Right) return -1;
  const UsedElement& first = *legs.first_element;
  if (sgn(legs.steps.front()) < 0) {
    out.faults.push_back(fault(Kind::SideOfNegative, first.item));
    return 0;
  }
  if (lies_on(*first.element, legs.tool_before)) {
    out.faults.push_back(fault(Kind::SideUnknown, first.item));
    return 0;
  }
  const int side = side_of(*first.element, legs.tool_before.exact());
  ContourNotice notice{ContourNotice::Kind::SideChosen, first.item};
  notice.side = side > 0 ? Side::Left : Side::Right;
  out.notices.push_back(notice);
  return side;
}

/// Ends where it began, or meets its own first or last stretch: what lies beyond is lead.
bool is_closed(const std::vector<Move>& programmed) {
  const Move* first = nullptr;
  const Move* last = nullptr;
  for (const Move& move : programmed) {
    if (!is_part(move)) continue;
    if (!first) first = &move;
    last = &move;
  }
  if (!first) return false;
  if (first == last) return first->full_circle;
  return first->from == last->to || covers(*first, last->to) || covers(*last, first->from);
}

void add_equidistant(const ContourLegs& legs, int side, const ContourOptions& options,
                     const Path& programmed, BuiltContour& out, ToolState& state);

/// Whether everything would go well with round corners.
bool works_round(const ContourLegs& legs, int side, ContourOptions options, const Path& programmed,
                 const BuiltContour& built) {
  options.corner = CornerStyle::Round;
  options.gouge = GougePolicy::Error;
  BuiltContour trial;
  trial.programmed = built.programmed;
  ToolState state;
  add_equidistant(legs, side, options, programmed, trial, state);
  return trial.faults.empty();
}

void add_equidistant(const ContourLegs& legs, int side, const ContourOptions& options,
                     const Path& programmed, BuiltContour& out, ToolState& state) {
  const Shifts shifts = shifts_for(legs, side);
  Path equidistant(legs, shifts, options, true);
  out.moves = equidistant.run();
  out.notices.insert(out.notices.end(), equidistant.notices.begin(), equidistant.notices.end());
  out.faults = equidistant.faults;
  for (ContourFault& f : out.faults) {
    f.largest_offset =
        largest_offset(stretch_of(legs, f), side, [&](const ContourLegs& part, const Shifts& by) {
          Path path(part, by, options, true);
          path.run();
          return path.faults.empty();
        });
  }
  const bool at_corner = std::any_of(out.faults.begin(), out.faults.end(),
                                     [](const auto& f) { return f.round_works; });
  if (at_corner && !works_round(legs, side, options, programmed, out))
    for (ContourFault& f : out.faults) f.round_works = false;
  const bool followed = std::all_of(out.faults.begin(), out.faults.end(),
                                    [](const auto& f) { return f.kind == Kind::Overrun; });
  if (followed) {
    state.at = equidistant.end();
    check_gouges(legs, side, options, programmed, equidistant, out);
  }
  if (options.gouge != GougePolicy::Trim || out.faults.empty()) return;
  Point end;
  if (trim_gouges(legs, side, options, programmed, out, end)) state.at = end;
}

}  // namespace

void run_legs(const ContourLegs& legs, int side, const ContourOptions& options, BuiltContour& out,
              ToolState& state) {
  const Shifts none(legs.steps.size());
  Path programmed(legs, none, options, false);
  out.programmed = programmed.run();
  out.faults = programmed.faults;
  out.closed = is_closed(out.programmed);
  if (out.faults.empty() && side != 0)
    add_equidistant(legs, side, options, programmed, out, state);
  else if (out.faults.empty())
    out.moves = out.programmed;
}

BuiltContour build_contour(const std::vector<ContourItem>& items, ToolState& state,
                           const ContourOptions& options) {
  BuiltContour out;
  ContourLegs legs = lay_out(items, state, options);
  mark_corners(legs);
  out.offset = legs.steps.front();
  out.notices = std::move(legs.notices);
  out.faults = std::move(legs.faults);

  const bool offset = any_offset(legs) && legs.first_element;
  int side = 0;
  if (offset) {
    side = side_of_offset(legs, options, out);
    const int of_w = side * (sgn(out.offset) < 0 ? -1 : 1);
    out.side = of_w > 0 ? Side::Left : of_w < 0 ? Side::Right : Side::None;
  }
  state.at = legs.joints.back().programmed;
  if (out.faults.empty()) run_legs(legs, offset ? side : 0, options, out, state);
  for (const Move& move : out.moves) state.moved = state.moved || move.travels();
  return out;
}

}  // namespace dgt
