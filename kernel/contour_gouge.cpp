// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "kernel/contour_path.h"
#include "kernel/gouge.h"

namespace dgt {
namespace {

/// Reports of one contour: what is wrong shows in the first, and a slot too narrow makes hundreds.
constexpr std::size_t kMaxGouges = 10;

/// A line cut against its direction bounds nothing: the tool is on the other side of it, which has
/// a notice of its own.
bool runs_backwards(const Leg& leg, const Move& move) {
  if (move.role == Role::Corner) return false;
  const auto* line = std::get_if<Line>(leg.element.element.get());
  return line && motion_along(*line, move.from, move.to) < 0;
}

/// The part's cut of a path, with what lies before or beyond its own meeting taken off: that is
/// lead.
std::vector<CutPiece> cut_of(const ContourLegs& legs, const std::vector<Move>& moves,
                             const std::vector<std::size_t>& leg_of_move) {
  std::vector<CutPiece> pieces;
  const Move* first = nullptr;
  const Move* last = nullptr;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const Leg& leg = legs.legs[leg_of_move[i]];
    if (!is_part(moves[i]) || leg.travel != Leg::Travel::Along) continue;
    if (runs_backwards(leg, moves[i])) continue;
    if (!first) first = &moves[i];
    last = &moves[i];
    pieces.push_back({stretch_of(moves[i]), abs(legs.steps[leg.element.step]), leg.element.item});
  }
  if (!first || first == last || first->from == last->to) return pieces;
  if (covers(*first, last->to)) {
    pieces.front().stretch.from = last->to;
  } else if (covers(*last, first->from)) {
    pieces.back().stretch.to = first->from;
  }
  return pieces;
}

/// By how much the steps of `part` are those of `legs` scaled down.
Rational scale_of(const ContourLegs& part, const ContourLegs& legs) {
  std::size_t i = 0;
  while (sgn(legs.steps[i]) == 0) ++i;
  return part.steps[i] / legs.steps[i];
}

/// Near misses were joined within their tolerance: the tool is nearer by that much there. To that
/// comes what the options allow.
Rational allowed_gouge(const BuiltContour& out, const ContourOptions& options) {
  double gap = 0;  // its rounding is far below the resolution
  for (const ContourNotice& notice : out.notices) {
    if (notice.kind == ContourNotice::Kind::JoinedGap) gap = std::max(gap, notice.measure);
  }
  return Rational(gap) + options.gouge_tolerance;
}

/// The largest offset with which the tool, on its way between the two items, cuts into neither.
std::optional<Rational> largest_without(const ContourFault& fault, const ContourLegs& legs,
                                        int side, const ContourOptions& options,
                                        const Walls& contour, const Rational& tolerance) {
  std::vector<CutPiece> named;
  for (const CutPiece& piece : contour.pieces())
    if (piece.item == fault.item || piece.item == fault.other) named.push_back(piece);
  return largest_offset(
      stretch_of(legs, fault), side, [&](const ContourLegs& part, const Shifts& by) {
        Path moved(part, by, options, true);
        const std::vector<Move> moves = moved.run();
        if (!moved.faults.empty()) return false;
        std::vector<CutPiece> scaled = named;
        const Rational scale = scale_of(part, legs);
        for (CutPiece& piece : scaled) piece.reach *= scale;
        return find_gouges(cut_of(part, moves, moved.leg_of_move), Walls(scaled, tolerance))
            .empty();
      });
}

}  // namespace

/// The stretch of legs that a fault speaks of, with the joints between them.
ContourLegs stretch_of(const ContourLegs& legs, const ContourFault& f) {
  std::size_t first = legs.legs.size();
  std::size_t last = 0;
  for (std::size_t i = 0; i < legs.legs.size(); ++i) {
    const Leg& leg = legs.legs[i];
    const bool named = leg.travel == Leg::Travel::Along &&
                       (leg.element.item == f.item || leg.element.item == f.other);
    if (!named) continue;
    first = std::min(first, i);
    last = i;
  }
  if (first > last) {  // the elements only bound others
    first = 0;
    last = legs.legs.size() - 1;
  }
  ContourLegs part;
  part.steps = legs.steps;
  const std::size_t base = legs.legs[first].from;
  for (std::size_t j = base; j <= legs.legs[last].to; ++j) part.joints.push_back(legs.joints[j]);
  for (std::size_t i = first; i <= last; ++i) {
    Leg& leg = part.legs.emplace_back(legs.legs[i]);
    leg.from -= base;
    leg.to -= base;
  }
  return part;
}

Walls walls_of(const ContourLegs& legs, const Path& programmed, const ContourOptions& options,
               const BuiltContour& out) {
  return {cut_of(legs, out.programmed, programmed.leg_of_move), allowed_gouge(out, options)};
}

void check_gouges(const ContourLegs& legs, int side, const ContourOptions& options,
                  const Path& programmed, const Path& equidistant, BuiltContour& out) {
  const Rational tolerance = allowed_gouge(out, options);
  const Walls contour = walls_of(legs, programmed, options, out);
  const std::vector<CutPiece> path = cut_of(legs, out.moves, equidistant.leg_of_move);
  std::vector<Gouge> gouges = find_gouges(path, contour);
  if (gouges.size() > kMaxGouges) gouges.resize(kMaxGouges);
  if (!gouges.empty() && options.gouge != GougePolicy::Warn) out.faults.clear();
  for (const Gouge& gouge : gouges) {
    ContourFault fault{};
    fault.kind = ContourFault::Kind::Gouge;
    fault.item = path[gouge.path].item;
    fault.other = contour.pieces()[gouge.programmed].item;
    fault.largest_offset = largest_without(fault, legs, side, options, contour, tolerance);
    fault.measure = gouge.depth;
    fault.on_equidistant = true;
    fault.x = gouge.x;
    fault.y = gouge.y;
    if (options.gouge != GougePolicy::Warn) {
      out.faults.push_back(fault);
      continue;
    }
    ContourNotice notice{ContourNotice::Kind::Gouge, fault.item, fault.other, fault.measure};
    notice.on_equidistant = true;
    notice.largest_offset = fault.largest_offset;
    notice.x = fault.x;
    notice.y = fault.y;
    out.notices.push_back(notice);
  }
}

}  // namespace dgt
