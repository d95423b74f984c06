// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "kernel/contour_legs.h"
#include "kernel/gouge.h"

namespace dgt {

/// The steps of a contour as shifts to the left; `side` +1: W > 0 lies to the left, −1: to the
/// right.
[[nodiscard]] Shifts shifts_for(const ContourLegs& legs, int side);

/// Legs to moves for one set of shifts: programmed (all null) or equidistant. Internal to the
/// kernel.
class Path {
 public:
  Path(const ContourLegs& legs, const Shifts& shifts, const ContourOptions& options,
       bool equidistant)
      : legs_(legs), shifts_(shifts), options_(options), equidistant_(equidistant) {}

  /// Faults first: what the moves are is said only when there are none.
  std::vector<Move> run();

  [[nodiscard]] const Point& end() const { return stands_; }

  std::vector<ContourFault> faults;
  std::vector<ContourNotice> notices;
  std::vector<std::size_t> leg_of_move;  ///< counts into ContourLegs::legs

 private:
  [[nodiscard]] bool eaten(const UsedElement& used) const;
  void check_survival(const UsedElement& used);
  void place(const Joint& joint);
  void place_corner(const Joint& joint);
  bool rests_on_eaten(const Joint& joint);
  void emit(const Leg& leg, std::vector<Move>& moves);
  [[nodiscard]] bool grows(const Leg& leg) const;
  void emit_turn(const Leg& leg, std::vector<Move>& moves);
  void emit_stop(const Leg& leg, std::vector<Move>& moves);
  void check_motion(const Leg& leg, const Move& move);

  // contour_overlap.cpp
  struct LegEnd;
  void check_blends(const Leg& leg, const Move& move);
  [[nodiscard]] LegEnd end_of(const Leg& leg, int way) const;
  [[nodiscard]] const Leg* beside(const Leg& leg, int way) const;

  void report(ContourFault::Kind kind, std::size_t item, double measure = 0);

  const ContourLegs& legs_;
  const Shifts& shifts_;
  const ContourOptions& options_;
  bool equidistant_;
  /// Where a joint is come to and left from; between them, round an outer corner, on `turn`.
  struct Place {
    Point arrive;
    Point leave;
    std::optional<Carrier> turn{};
  };
  std::vector<Place> places_;
  Point stands_;
};

/// Motion along a line from one point of it to another: +1 with its direction, −1 against it, 0:
/// none.
[[nodiscard]] int motion_along(const Line& line, const Point& from, const Point& to);
/// Whether `p` lies on the stretch that `move` covers.
[[nodiscard]] bool covers(const Move& move, const Point& p);

/// The programmed contour of the legs, and from the same legs the equidistant; `side` as for
/// shifts_for(), 0: there is none.
void run_legs(const ContourLegs& legs, int side, const ContourOptions& options, BuiltContour& out,
              ToolState& state);

/// Looks for places where the tool cuts into the programmed contour and reports them as the options
/// say. Precondition: both paths are without faults but overruns, which a gouge explains better and
/// replaces.
void check_gouges(const ContourLegs& legs, int side, const ContourOptions& options,
                  const Path& programmed, const Path& equidistant, BuiltContour& out);

/// The programmed contour as the gouge check sees it.
[[nodiscard]] Walls walls_of(const ContourLegs& legs, const Path& programmed,
                             const ContourOptions& options, const BuiltContour& out);

/// Takes the loops that gouge out of the equidistant: moves, notices and `end`, where the tool
/// ends, replace what was built. Adds a fault and returns false where that is no answer.
[[nodiscard]] bool trim_gouges(const ContourLegs& legs, int side, const ContourOptions& options,
                               const Path& programmed, BuiltContour& out, Point& end);

/// The part of the legs that concerns the items of a fault, with the joints between them.
[[nodiscard]] ContourLegs stretch_of(const ContourLegs& legs, const ContourFault& fault);
/// The largest offset, at most the programmed one, with which `works` holds for all of the legs
/// `part` at once: bisection over whole steps, each tried exactly. The programmed contour works, so
/// 0 does.
template <class Works>
[[nodiscard]] std::optional<Rational> largest_offset(ContourLegs part, int side, Works&& works);

template <class Works>
std::optional<Rational> largest_offset(ContourLegs part, int side, Works&& works) {
  const std::vector<Rational> steps = part.steps;
  Rational full;
  for (const Rational& step : steps) {
    if (sgn(step) == 0) continue;
    full = step;
    break;
  }
  Integer good = 0;
  Integer bad = nearest_integer(kOffsetStepsPerMillimetre * abs(full)) + 1;
  while (bad - good > 1) {
    const Integer middle = (good + bad) / 2;
    const Rational scale = Rational(middle) / (kOffsetStepsPerMillimetre * abs(full));
    for (std::size_t i = 0; i < steps.size(); ++i) part.steps[i] = scale * steps[i];
    (works(part, shifts_for(part, side)) ? good : bad) = middle;
  }
  if (good == 0) return std::nullopt;
  const Rational found = Rational(good) / kOffsetStepsPerMillimetre;
  return sgn(full) < 0 ? Rational(-found) : found;
}

}  // namespace dgt
