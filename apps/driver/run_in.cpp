// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/run_in.h"

#include <cmath>
#include <optional>
#include <utility>

#include "kernel/measure.h"
#include "kernel/part_crossing.h"

namespace dgt {
namespace {

/// Below, in mm, two exact places are one.
constexpr double kOnePlace = 1e-7;

double distance(const Point& a, const Point& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

bool is_along(const Move& move) { return move.cuts() && is_part(move) && move.carrier.base; }

/// The moves of a contour that matter: the one that leads to it, its first cut and its last.
struct Ends {
  std::optional<std::size_t> lead;
  std::optional<std::size_t> first;
  std::size_t last = 0;
};
Ends ends_of(const Toolpath& path, const Contour& contour) {
  Ends ends;
  for (std::size_t i = contour.first; i < contour.last; ++i) {
    const Move& move = path.moves[i];
    if (is_along(move)) {
      if (!ends.first) ends.first = i;
      ends.last = i;
    } else if (move.travels() && !ends.first) {
      ends.lead = i;
    }
  }
  return ends;
}

/// The place beside `p` on the element of a move.
Point beside(const Move& move, const Point& p) {
  const auto at = foot(curve_of(move, {}), place_of(p));
  if (!at) return p;
  return Point(RationalPoint{Rational(static_cast<double>(at->x.mid)),
                             Rational(static_cast<double>(at->y.mid))});
}

class RunIns {
 public:
  RunIns(const Toolpath& exact, const Toolpath& written, const Rational& unit)
      : made_(exact),
        written_(written),
        shift_(exact.start - written.start),
        unit_(nearest_double(unit)) {}

  Toolpath run() {
    std::size_t next = 0;
    for (std::size_t c = 0; c < made_.contours.size(); ++c) {
      if (made_.contours[c].side == Side::None) continue;
      const Contour* const run = next_offset(next);
      if (run == nullptr) break;
      end_before_corner(c);
      begin_as(c, *run);
    }
    return std::move(made_);
  }

 private:
  /// The contours that are offset follow each other alike on both paths.
  const Contour* next_offset(std::size_t& next) const {
    while (next < written_.contours.size()) {
      const Contour& contour = written_.contours[next++];
      if (contour.side != Side::None) return &contour;
    }
    return nullptr;
  }

  /// The outer corner that a closed contour begins in is not gone round at its end: there is
  /// nothing to cut between two places of the tool that both touch the corner.
  void end_before_corner(std::size_t c) {
    const Contour& contour = made_.contours[c];
    const Ends ends = ends_of(made_, contour);
    if (!contour.closed || !ends.first) return;
    Move& last = made_.moves[ends.last];
    if (last.role != Role::Corner || !(last.to == made_.moves[*ends.first].from)) return;
    last.kind = MoveKind::Line;
    last.carrier = {};
    last.to = last.from;
    for (std::size_t i = ends.last + 1; i < made_.moves.size(); ++i) {
      Move& move = made_.moves[i];
      move.from = last.to;
      if (move.travels()) break;
      move.to = last.to;
    }
  }

  void begin_as(std::size_t c, const Contour& run) {
    const Ends ends = ends_of(made_, made_.contours[c]);
    const Ends theirs = ends_of(written_, run);
    if (!made_.contours[c].closed || !ends.lead || !ends.first || !theirs.first) return;
    const Move& first = made_.moves[*ends.first];
    const Move& last = made_.moves[ends.last];
    const Point begin = first.from;
    const Point& from = written_.moves[*theirs.first].from;
    const Point at =
        beside(first, Point(RationalPoint{Rational(from.x()), Rational(from.y())} + shift_));
    if (distance(at, begin) <= unit_ || begins_behind(first, at)) return;
    if (!runs_by(last, at, begin) && !keeps_off(c, *ends.lead, at, begin)) return;
    made_.moves[*ends.lead].to = at;
    if (first.kind == MoveKind::Line) {
      made_.moves[*ends.first].from = at;
    } else {
      prolong_arc(*ends.first, at);
    }
  }

  /// Whether the last of a contour comes by `at` on its way to `begin`.
  static bool runs_by(const Move& last, const Point& at, const Point& begin) {
    return distance(last.to, begin) <= kOnePlace && distance(beside(last, at), at) <= kOnePlace &&
           is_within(last, at);
  }
  /// A full circle comes by everywhere.
  static bool begins_behind(const Move& first, const Point& at) {
    if (!first.full_circle) return is_within(first, at);
    return progress(curve_of(first, {}), place_of(at)) < 0.5L;
  }
  static bool is_within(const Move& move, const Point& at) {
    const long double along = progress(curve_of(move, {}), place_of(at));
    return along > 0 && along < 1;
  }

  /// Whether the tool touches no part on the way by `at`.
  bool keeps_off(std::size_t c, std::size_t lead, const Point& at, const Point& begin) const {
    Toolpath tried = made_;
    Contour& added = tried.contours.emplace_back(made_.contours[c]);
    added.programmed.emplace();
    added.first = tried.moves.size();
    Move move = made_.moves[lead];
    move.carrier = {};
    for (const Point& to : {at, begin}) {
      move.to = to;
      tried.moves.push_back(move);
      move.from = to;
    }
    added.last = tried.moves.size();
    for (const PartCrossing& crossing :
         find_part_crossings(tried, CrossingMoves::Leads, Rational(0)))
      if (crossing.move >= added.first) return false;
    return true;
  }

  /// In two, at the place opposite to where it began: together they may be more than a turn.
  void prolong_arc(std::size_t index, const Point& from) {
    Move arc = made_.moves[index];
    const RationalPoint centre = arc.circle().centre();
    Move before = arc;
    before.full_circle = false;
    before.from = from;
    const bool is_long = arc.full_circle || std::fabs(sweep_degrees(arc)) > 180;
    if (!is_long) {
      made_.moves[index].from = from;
      return;
    }
    before.to = Point(2 * centre - RationalPoint{Rational(arc.from.x()), Rational(arc.from.y())});
    arc.full_circle = false;
    arc.from = before.to;
    made_.moves[index] = arc;
    made_.moves.insert(made_.moves.begin() + static_cast<std::ptrdiff_t>(index), before);
    for (Contour& contour : made_.contours) {
      if (contour.first > index) ++contour.first;
      if (contour.last > index) ++contour.last;
    }
  }

  Toolpath made_;
  const Toolpath& written_;
  const Vector shift_;  ///< an incremental program is read from X0 Y0
  const double unit_;
};

}  // namespace

Toolpath with_run_ins(const Toolpath& exact, const Toolpath& written, const Rational& unit) {
  return RunIns(exact, written, unit).run();
}

}  // namespace dgt
