// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dxf/joints.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "lang/dxf/grouping.h"
#include "lang/nc/arc.h"

namespace dgt {
namespace {

Spot spot_of(const RationalPoint& p) { return {Length(p.x), Length(p.y)}; }

/// The arc between two ends beside its circle, about the foot of its centre on their bisector. With
/// the ends off the circle by δ at most and less than half a turn between them, the foot lies
/// δ/sin(sweep/2) beside the centre along the chord, which moves no place of the arc by more than 2
/// δ.
Circle through_ends(const DxfPiece& piece) {
  const Circle& circle = *piece.circle;
  return circle_by_centre(spot_of(piece.from), spot_of(piece.to - piece.from),
                          spot_of(circle.centre() - piece.from), circle.counter_clockwise());
}

/// Whether the arc is less than half a turn.
bool is_minor(const DxfPiece& piece) {
  const Rational turn =
      cross(piece.from - piece.circle->centre(), piece.to - piece.circle->centre());
  return piece.circle->counter_clockwise() ? sgn(turn) > 0 : sgn(turn) < 0;
}

}  // namespace

/// Ends that lie near each other throw the centre of a major arc about, by the gap times radius
/// over chord: where that is more than kSteady mm, two halves do not. A minor arc whose ends have
/// passed each other is no longer than the gap, and a segment.
void Joining::append_fitted(std::vector<DxfPiece>& out, const Kept& kept) {
  DxfPiece piece = kept.piece;
  const Circle circle = *piece.circle;
  const Vector from = piece.from - circle.centre();
  const Vector to = piece.to - circle.centre();
  const bool is_near_half = sgn(dot(from, to)) < 0;
  const bool minor_now = is_minor(piece);
  constexpr double kSteady = 1e-6;
  const double swing = kept.moved * std::fabs(nearest_double(circle.radius()));
  const bool is_steady =
      !kept.minor && !minor_now && swing <= kSteady * distance_between(piece.from, piece.to);
  if (is_steady || (is_near_half ? minor_now : kept.minor)) {
    const bool is_arc = is_steady || minor_now;
    piece.circle = is_arc ? std::optional(through_ends(piece)) : std::nullopt;
    out.push_back(std::move(piece));
    return;
  }
  const Vector chord = to - from;
  const Vector aside = circle.counter_clockwise() ? turned_right(chord) : turned_left(chord);
  const Vector middle = direction_of(is_near_half ? aside : -(from + to)).unit.vector();
  DxfPiece first = piece;
  DxfPiece last = piece;
  first.to = last.from = circle.centre() + abs(circle.radius()) * middle;
  first.circle = through_ends(first);
  last.circle = through_ends(last);
  out.push_back(std::move(first));
  out.push_back(std::move(last));
}

void Joining::count(double gap, const Range& place) {
  if (gap < std::ldexp(1.0, kZeroExponent)) return;  // stand-ins that say the same
  ++joined_;
  if (gap < largest_gap_) return;
  largest_gap_ = gap;
  widest_ = place;
}

/// A whole circle begins where it was turned to.
void Joining::meet(Kept& before, Kept& behind) {
  if (before.piece.to == behind.piece.from) return;
  const double gap = distance_between(before.piece.to, behind.piece.from);
  count(gap, behind.piece.place);
  const bool moves_before = behind.piece.is_whole_circle() || (!before.given && behind.given);
  if (moves_before && !before.piece.is_whole_circle()) {
    before.piece.to = behind.piece.from;
    before.moved += gap;
  } else {
    behind.piece.from = before.piece.to;
    behind.moved += gap;
  }
}

void Joining::add(DxfStrand strand) {
  const std::size_t first = pieces_.size();
  const std::size_t count = strand.pieces.size();
  for (std::size_t i = 0; i < count; ++i) {
    const bool minor = strand.pieces[i].circle && is_minor(strand.pieces[i]);
    pieces_.push_back({std::move(strand.pieces[i]), strand.has_given_ends, minor});
  }
  if (strand.closed) closed_ = true;
  if (first == 0) return;
  meet(pieces_[first - 1], pieces_[first]);
}

void Joining::close() {
  closed_ = true;
  if (pieces_.size() > 1) {
    meet(pieces_.back(), pieces_.front());
    return;
  }
  // An arc of nearly a whole turn closes to its circle.
  Kept& only = pieces_.front();
  if (only.piece.from == only.piece.to) return;
  count(distance_between(only.piece.to, only.piece.from), only.piece.place);
  only.piece.to = only.piece.from;
}

void Joining::turn_round() {
  for (std::size_t i = 0, j = pieces_.size() - 1; i < j; ++i, --j)
    std::swap(pieces_[i], pieces_[j]);
  for (Kept& kept : pieces_) kept.piece = reversed(kept.piece);
}

DxfContour Joining::finish() {
  DxfContour contour;
  contour.closed = std::exchange(closed_, false);
  for (Kept& kept : std::exchange(pieces_, {})) {
    const bool is_gone = kept.moved > 0 && kept.piece.from == kept.piece.to;
    if (is_gone) continue;  // no longer than its gap
    if (kept.moved > 0 && kept.piece.circle)
      append_fitted(contour.pieces, kept);
    else
      contour.pieces.push_back(std::move(kept.piece));
  }
  return contour;
}

void Joining::tell_gaps(DiagnosticBag& bag) const {
  if (joined_ == 0) return;
  bag.add({Message::DxfJoined,
           widest_,
           {std::to_string(joined_), fmt::format("{:.2g}", largest_gap_)}});
}

}  // namespace dgt
