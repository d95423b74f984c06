// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/arc_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "post/plan.h"
#include "post/three_b.h"

namespace dgt {
namespace {

constexpr long double kPi = std::numbers::pi_v<long double>;
constexpr long double kAngleSlack = 1e-9L;  // radians: what an exact half turn may be miscounted by

// --- the sweep --------------------------------------------------------------------------------

/// Whether the second of two nearly equal directions lies left (+1) or right (−1) of the first,
/// from more digits than a ball has. 0: the points coincide to 2⁻²⁰⁰ mm.
int turn_from_digits(const Move& move) {
  constexpr int kDigits = -256;
  const RationalPoint centre = move.circle().centre();
  const auto from_centre = [&](const Point& p) {
    const ExactPoint exact = p.exact();
    return Vector{rational_within(exact.x, kDigits) - centre.x,
                  rational_within(exact.y, kDigits) - centre.y};
  };
  const Rational turn = cross(from_centre(move.from), from_centre(move.to));
  return abs(turn) > power_of_two(-200) ? sgn(turn) : 0;
}

long double sweep_of(const ArcBalls& arc, const Move& move) {
  const long double ax = arc.from.x.mid - arc.centre.x.mid;
  const long double ay = arc.from.y.mid - arc.centre.y.mid;
  const long double bx = arc.to.x.mid - arc.centre.x.mid;
  const long double by = arc.to.y.mid - arc.centre.y.mid;
  const long double sense = arc.ccw ? 1 : -1;
  const long double dot = ax * bx + ay * by;
  const long double cross = sense * (ax * by - ay * bx);
  const long double doubt = 4 * arc.radius.mid *
                            (arc.from.x.rad + arc.from.y.rad + arc.to.x.rad + arc.to.y.rad +
                             arc.centre.x.rad + arc.centre.y.rad);
  if (dot > 0 && std::fabs(cross) <= doubt) {
    const int turn = turn_from_digits(move) * (arc.ccw ? 1 : -1);
    return turn < 0 ? 2 * kPi : 0;
  }
  const long double angle = std::atan2(cross, dot);
  return angle < 0 ? angle + 2 * kPi : angle;
}

// --- dividing ---------------------------------------------------------------------------------

/// A grid point beside an exact arc, and the point of the arc it stands for.
struct Stop {
  GridPoint at;
  BallPoint exact;
  long double angle = 0;  // radians from the beginning of the arc
};

/// Divides one arc.
class Divider {
 public:
  Divider(const ExactArc& whole, const ArcLimits& limits) : whole_(whole), limits_(limits) {}

  /// The piece as one arc, if that is exact on the grid, or is what a reader makes of an arc on the
  /// grid; then there is nothing to gain by dividing it.
  std::optional<WrittenPiece> exactly(const ArcPiece& piece) const {
    if (distance_bound(balls(piece.from), piece.exact.from) > kExactDeviation ||
        distance_bound(balls(piece.to), piece.exact.to) > kExactDeviation)
      return std::nullopt;
    const auto fitted = fit(piece);
    if (!fitted || !is_read_as(fitted->as_read, piece.exact) ||
        fitted->mismatch > limits_.mismatch || is_too_small(fitted->arc) ||
        !is_countable(fitted->arc))
      return std::nullopt;
    return as_arc(piece, *fitted);
  }

  /// Two half turns of a full circle.
  std::optional<std::vector<WrittenPiece>> exact_semicircles(const GridPoint& at) const {
    const ArcBalls& arc = whole_.arc;
    const Ball two(2, 0);
    const BallPoint opposite{two * arc.centre.x - arc.from.x, two * arc.centre.y - arc.from.y};
    const GridPoint middle{std::llround(opposite.x.mid), std::llround(opposite.y.mid)};
    const auto first = exactly({at, middle, part(arc.from, opposite), 0, kPi});
    const auto second = exactly({middle, at, part(opposite, arc.from), kPi, 2 * kPi});
    if (!first || !second) return std::nullopt;
    return std::vector{*first, *second};
  }

  /// Appends what is written for `piece`, divided further where one arc will not do.
  void append(const ArcPiece& piece, int divisions, std::vector<WrittenPiece>& out) const {
    if (sagitta_bound(piece.exact) < kLeastSagitta) return append_line(piece, out);
    if (const auto fitted = fit(piece); fitted && acceptable(*fitted)) {
      // Rounding may have flattened it, and read again it would be a line.
      if (!(sagitta_bound(fitted->as_read) < kLeastSagitta)) {
        out.push_back(as_arc(piece, *fitted));
        return;
      }
      if (deviation_of_chord(piece.from, piece.to, piece.exact) <= kWorstDeviation)
        return append_line(piece, out);
    }
    if (divisions == 0) return append_line(piece, out);
    append_parts(piece, 2, divisions - 1, out);
  }

  /// Divides where the arc passes from one quadrant to the next: a counted arc inside a quadrant
  /// needs no extreme.
  void append_quadrants(const ArcPiece& piece, int divisions,
                        std::vector<WrittenPiece>& out) const {
    const ArcBalls& arc = whole_.arc;
    const long double begin =
        std::atan2(arc.from.y.mid - arc.centre.y.mid, arc.from.x.mid - arc.centre.x.mid);
    const long double past = std::fmod((arc.ccw ? begin : -begin) + 2 * kPi, kPi / 2);
    // A joint so near an end would be the end.
    const long double least = 1 / arc.radius.mid;
    Stop last{piece.from, piece.exact.from, piece.begin};
    for (long double angle = kPi / 2 - past; angle < piece.end - least; angle += kPi / 2) {
      if (angle < piece.begin + least) continue;
      const Stop next = stop_at(angle);
      append({last.at, next.at, part(last.exact, next.exact), last.angle, next.angle}, divisions,
             out);
      last = next;
    }
    append({last.at, piece.to, part(last.exact, piece.exact.to), last.angle, piece.end}, divisions,
           out);
  }

  /// Whether one arc will do for the piece.
  bool is_one_arc(const ArcPiece& piece) const {
    const auto fitted = fit(piece);
    return fitted && acceptable(*fitted);
  }

  void append_parts(const ArcPiece& piece, int count, int divisions,
                    std::vector<WrittenPiece>& out) const {
    const long double step = (piece.end - piece.begin) / count;
    Stop last{piece.from, piece.exact.from, piece.begin};
    for (int k = 1; k <= count; ++k) {
      const Stop next = k == count ? Stop{piece.to, piece.exact.to, piece.end}
                                   : stop_near(piece.begin + step * k, step);
      append({last.at, next.at, part(last.exact, next.exact), last.angle, next.angle}, divisions,
             out);
      last = next;
    }
  }

 private:
  static bool is_read_as(const ArcBalls& read, const ArcBalls& exact) {
    const Ball radii = read.radius - exact.radius;
    return distance_bound(read.centre, exact.centre) <= kExactDeviation &&
           std::fabs(radii.mid) + radii.rad <= kExactDeviation;
  }

  ArcBalls part(const BallPoint& from, const BallPoint& to) const {
    return {whole_.arc.centre, whole_.arc.radius, from, to, whole_.arc.ccw, false};
  }

  std::optional<FittedArc> fit(const ArcPiece& piece) const {
    return limits_.form == ArcForm::Radius
               ? fit_by_radius(piece.from, piece.to, piece.exact)
               : fit_by_centre(piece.from, piece.to, piece.exact, limits_.mismatch);
  }

  bool acceptable(const FittedArc& fitted) const {
    if (fitted.deviation > kWorstDeviation || fitted.mismatch > limits_.mismatch) return false;
    if (limits_.form == ArcForm::Centre)
      return !is_too_small(fitted.arc) && is_countable(fitted.arc);
    // What was rounded keeps to the limit as well.
    const WrittenArc& arc = fitted.arc;
    const auto dx = static_cast<long double>(arc.to.x - arc.from.x);
    const auto dy = static_cast<long double>(arc.to.y - arc.from.y);
    const long double widest =
        2 * static_cast<long double>(arc.radius) * std::sin(limits_.sweep / 2);
    return dx * dx + dy * dy <= widest * widest * (1 + kAngleSlack);
  }

  /// Whether a control would take an arc about a centre for none at all.
  bool is_too_small(const WrittenArc& arc) const {
    const auto below = [&](const GridPoint& p) {
      const auto x = static_cast<long double>(p.x - arc.centre.x);
      const auto y = static_cast<long double>(p.y - arc.centre.y);
      return x * x + y * y < limits_.least_radius * limits_.least_radius * (1 + kAngleSlack);
    };
    return limits_.form == ArcForm::Centre && (below(arc.from) || below(arc.to));
  }

  bool is_countable(const WrittenArc& arc) const {
    if (!limits_.counted) return true;
    const auto counted = counted_arc(arc);
    return counted && counted->count <= limits_.largest && counted->x <= limits_.largest &&
           counted->y <= limits_.largest;
  }

  static WrittenPiece as_arc(const ArcPiece& piece, const FittedArc& fitted) {
    return {WrittenPiece::Kind::Arc, piece, fitted.arc, fitted.deviation};
  }

  static void append_line(const ArcPiece& piece, std::vector<WrittenPiece>& out) {
    const auto kind =
        piece.from == piece.to ? WrittenPiece::Kind::Nothing : WrittenPiece::Kind::Line;
    out.push_back({kind, piece, {}, deviation_of_chord(piece.from, piece.to, piece.exact)});
  }

  /// The grid point near the given angle that lies best beside the arc, so that neither end of the
  /// pieces it joins costs more than it must. Looked for along the arc, a unit a step, not so far
  /// that pieces become longer than allowed.
  Stop stop_near(long double angle, long double step) const {
    const long double radius = whole_.arc.radius.mid;
    const long double room = std::clamp((limits_.sweep - step) / 2, 0.0L, step / 16);
    const long double spacing = std::max(1.0L, std::sqrt(radius) / 3);
    const int reach = static_cast<int>(std::min(8.0L, radius * room / spacing));
    Stop best = stop_at(angle);
    long double least = off_circle(best.at);
    for (int k = -reach; k <= reach; ++k) {
      Stop stop = stop_at(angle + static_cast<long double>(k) * spacing / radius);
      const long double off = off_circle(stop.at);
      if (!(off < least)) continue;
      least = off;
      best = stop;
    }
    // The nearest point of the arc stands for the grid point, if that is near enough on each axis
    // (it always is unless the circle passes a grid square by its corner), and if it is sure to
    // keep its place between its neighbours: on a circle of a few units it may lie anywhere.
    constexpr long double kRadiusOfFeet = 8;
    if (least < 0.4999L && radius >= kRadiusOfFeet)
      if (const auto foot = foot_on_circle(best.at)) best.exact = *foot;
    return best;
  }

  Stop stop_at(long double angle) const {
    const ArcBalls& arc = whole_.arc;
    const long double turn = arc.ccw ? angle : -angle;
    const long double c = std::cos(turn);
    const long double s = std::sin(turn);
    const long double x = arc.from.x.mid - arc.centre.x.mid;
    const long double y = arc.from.y.mid - arc.centre.y.mid;
    const BallPoint beside{Ball(arc.centre.x.mid + c * x - s * y, 0),
                           Ball(arc.centre.y.mid + s * x + c * y, 0)};
    const GridPoint at{std::llround(beside.x.mid), std::llround(beside.y.mid)};
    return {at, foot_on_circle(beside).value_or(beside), angle};
  }

  long double off_circle(const GridPoint& p) const {
    const long double x = static_cast<long double>(p.x) - whole_.arc.centre.x.mid;
    const long double y = static_cast<long double>(p.y) - whole_.arc.centre.y.mid;
    return std::fabs(std::sqrt(x * x + y * y) - whole_.arc.radius.mid);
  }

  std::optional<BallPoint> foot_on_circle(const GridPoint& p) const {
    return foot_on_circle(balls(p));
  }
  std::optional<BallPoint> foot_on_circle(const BallPoint& p) const {
    const ArcBalls& arc = whole_.arc;
    const BallPoint out{p.x - arc.centre.x, p.y - arc.centre.y};
    const auto length = sqrt(out.x * out.x + out.y * out.y);
    if (!length) return std::nullopt;
    const auto scale = divide(arc.radius, *length);
    if (!scale) return std::nullopt;
    return BallPoint{arc.centre.x + *scale * out.x, arc.centre.y + *scale * out.y};
  }

  const ExactArc& whole_;
  const ArcLimits& limits_;
};

/// Pieces of a divided arc stay a little below the limit, which leaves room to choose good joints.
int pieces_needed(const ExactArc& arc, long double limit) {
  if (!arc.full_circle && arc.sweep <= limit + kAngleSlack) return 1;
  const int count = static_cast<int>(std::ceil(arc.sweep / (0.98L * limit)));
  return std::max(count, arc.full_circle ? 3 : 2);
}

}  // namespace

ExactArc exact_arc(const Move& move, const Grid& grid) {
  const auto& base = std::get<Circle>(*move.carrier.base);
  Ball radius(base.radius());
  if (move.carrier.shift) radius = radius - Ball(*move.carrier.shift);
  // The filter has the sign of every radius but those at the resolution of 0.
  const bool ccw = radius.sign() ? radius.mid > 0 : move.circle().counter_clockwise();
  if (!ccw) radius = -radius;
  ExactArc arc;
  arc.arc = {grid.enclosure(base.centre()),
             grid.enclosure(radius),
             grid.enclosure(move.from),
             grid.enclosure(move.to),
             ccw,
             false};
  arc.full_circle = move.full_circle;
  arc.sweep = move.full_circle ? 2 * kPi : sweep_of(arc.arc, move);
  arc.arc.major = arc.sweep > kPi;
  return arc;
}

std::vector<WrittenPiece> written_pieces(const ExactArc& arc, const GridPoint& from,
                                         const GridPoint& to, const ArcLimits& limits) {
  const Divider divider(arc, limits);
  const ArcPiece whole{from, to, arc.arc, 0, arc.sweep};
  std::vector<WrittenPiece> pieces;
  constexpr int kDivisions = 24;
  const int count = pieces_needed(arc, limits.sweep);
  if (count == 1 && (!limits.counted || divider.is_one_arc(whole))) {
    divider.append(whole, kDivisions, pieces);
  } else if (arc.full_circle) {
    if (auto halves = divider.exact_semicircles(from)) return *std::move(halves);
    if (limits.counted) {
      divider.append_quadrants(whole, kDivisions, pieces);
    } else {
      divider.append_parts(whole, count, kDivisions, pieces);
    }
  } else if (auto exact = divider.exactly(whole)) {
    pieces.push_back(*std::move(exact));
  } else if (limits.counted) {
    divider.append_quadrants(whole, kDivisions, pieces);
  } else {
    divider.append_parts(whole, count, kDivisions, pieces);
  }
  return pieces;
}

}  // namespace dgt
