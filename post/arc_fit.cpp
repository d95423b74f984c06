// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/arc_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dgt {
namespace {

__extension__ typedef __int128 Wide;

Wide squared_distance(const GridPoint& a, const GridPoint& b) {
  const Wide dx = b.x - a.x;
  const Wide dy = b.y - a.y;
  return dx * dx + dy * dy;
}

/// A whole number as a ball: exact below 2⁶³, rounded once above.
Ball ball(Wide value) {
  const auto mid = static_cast<long double>(value);
  return {mid, mid < 0x1p63L ? 0 : mid * 0x1p-62L};
}

/// The root of a whole number ≥ 0; 0 and squares below 2⁶³ come out as they are.
Ball root(Wide value) {
  return value == 0 ? Ball() : *sqrt(ball(value));  // clear of 0, so the root is certain
}

/// A frame on the chord: its middle, and its unit normal towards the middle of the (minor or major)
/// arc, which bulges to the right of its chord when it runs counter-clockwise.
struct Chord {
  long double mx, my, nx, ny, half;
};

Chord chord_of(const GridPoint& from, const GridPoint& to, bool ccw) {
  const auto dx = static_cast<long double>(to.x - from.x);
  const auto dy = static_cast<long double>(to.y - from.y);
  const long double length = std::hypot(dx, dy);
  const long double sense = ccw ? 1 : -1;
  return {static_cast<long double>(from.x) + dx / 2, static_cast<long double>(from.y) + dy / 2,
          sense * dy / length, -sense * dx / length, length / 2};
}

// --- radius form ------------------------------------------------------------------------------

/// The least R with (2R)² ≥ chord².
std::int64_t least_radius(Wide chord_squared) {
  auto r = static_cast<std::int64_t>(std::sqrt(static_cast<long double>(chord_squared)) / 2);
  while (4 * static_cast<Wide>(r) * r < chord_squared) ++r;
  while (r > 0 && 4 * static_cast<Wide>(r - 1) * (r - 1) >= chord_squared) --r;
  return r;
}

ArcBalls radius_form(const GridPoint& from, const GridPoint& to, bool ccw, bool major,
                     std::int64_t radius) {
  // The centre lies √(R² − chord²/4) from the middle of the chord, left of a counter-clockwise
  // minor arc's chord: middle ± (−dy, dx)·√(4R² − chord²) / (2·chord).
  const Wide chord_squared = squared_distance(from, to);
  const Wide rest = 4 * static_cast<Wide>(radius) * radius - chord_squared;
  Ball scale = *divide(root(rest), Ball(2, 0) * root(chord_squared));
  if (ccw == major) scale = -scale;
  const Ball dx(static_cast<long double>(to.x - from.x), 0);
  const Ball dy(static_cast<long double>(to.y - from.y), 0);
  const Ball half(0.5L, 0);
  const BallPoint start = balls(from);
  return {{start.x + half * dx - scale * dy, start.y + half * dy + scale * dx},
          Ball(static_cast<long double>(radius), 0),
          start,
          balls(to),
          ccw,
          major};
}

/// The real radius that meets the exact arc in the middle, over the written chord.
long double radius_through_middle(const Chord& chord, const ArcBalls& exact) {
  const long double cx = exact.centre.x.mid - chord.mx;
  const long double cy = exact.centre.y.mid - chord.my;
  const long double r = exact.radius.mid;
  const long double aside = cy * chord.nx - cx * chord.ny;
  const long double along = cx * chord.nx + cy * chord.ny;  // negative for minor arcs
  if (!(std::fabs(aside) < r)) return r;
  const long double over = std::sqrt((r - aside) * (r + aside));
  // For minor arcs `along` and `over` nearly cancel: (over² − along²) / (over − along) does not.
  const long double height =
      along < 0 ? (r * r - cx * cx - cy * cy) / (over - along) : along + over;
  if (!(height > 0)) return r;
  return (chord.half / height * chord.half + height) / 2;
}

// --- centre form ------------------------------------------------------------------------------

/// The written curve of a centre-form arc lies between its two radii: the arc of the mean radius in
/// the same directions, and a band of half the difference.
struct BandedArc {
  ArcBalls arc;
  double band = 0;
  double mismatch = 0;
};

double rounded_up(long double x) { return static_cast<double>(x) * (1 + 0x1p-51) + 0x1p-1000; }

BandedArc centre_form(const WrittenArc& written) {
  const BallPoint centre = balls(written.centre);
  const Wide square_from = squared_distance(written.centre, written.from);
  const Wide square_to = squared_distance(written.centre, written.to);
  const Ball r_from = root(square_from);
  if (square_from == square_to) {
    return {
        {centre, r_from, balls(written.from), balls(written.to), written.ccw, written.major}, 0, 0};
  }
  const Ball r_to = root(square_to);
  const Ball mean = Ball(0.5L, 0) * (r_from + r_to);
  const auto at_mean = [&](const GridPoint& p, const Ball& r) {
    const Ball scale = *divide(mean, r);
    return BallPoint{centre.x + scale * Ball(static_cast<long double>(p.x - written.centre.x), 0),
                     centre.y + scale * Ball(static_cast<long double>(p.y - written.centre.y), 0)};
  };
  const Ball difference = r_from - r_to;
  const long double mismatch = std::fabs(difference.mid) + difference.rad;
  return {{centre, mean, at_mean(written.from, r_from), at_mean(written.to, r_to), written.ccw,
           written.major},
          rounded_up(mismatch / 2),
          rounded_up(mismatch)};
}

/// Which of the two arcs about a centre is the larger: seen along the chord of a counter-clockwise
/// minor arc the centre is on the left.
bool is_major(const WrittenArc& arc) {
  const Wide turn = static_cast<Wide>(arc.to.x - arc.from.x) * (arc.centre.y - arc.from.y) -
                    static_cast<Wide>(arc.to.y - arc.from.y) * (arc.centre.x - arc.from.x);
  return arc.ccw ? turn < 0 : turn > 0;
}

/// What a centre costs: the difference of the radii plus the error in the middle of the arc.
long double cost(const WrittenArc& arc, const Chord& chord, const ArcBalls& exact, double limit) {
  const auto cx = static_cast<long double>(arc.centre.x);
  const auto cy = static_cast<long double>(arc.centre.y);
  const auto length = [](long double x, long double y) { return std::sqrt(x * x + y * y); };
  const long double r1 =
      length(static_cast<long double>(arc.from.x) - cx, static_cast<long double>(arc.from.y) - cy);
  const long double r2 =
      length(static_cast<long double>(arc.to.x) - cx, static_cast<long double>(arc.to.y) - cy);
  const long double r = (r1 + r2) / 2;
  const long double error =
      length(cx + r * chord.nx - exact.centre.x.mid, cy + r * chord.ny - exact.centre.y.mid) -
      exact.radius.mid;
  const long double mismatch = std::fabs(r1 - r2);
  constexpr long double kRefused = 1000;  // nothing else is worth an arc that has to be divided
  return mismatch + std::fabs(error) + (mismatch < 0.999L * limit ? 0 : kRefused);
}

std::optional<GridPoint> best_centre(WrittenArc arc, const Chord& chord, const ArcBalls& exact,
                                     double limit) {
  const long double along =
      (exact.centre.x.mid - chord.mx) * chord.nx + (exact.centre.y.mid - chord.my) * chord.ny;
  const long double foot_x = std::round(chord.mx + along * chord.nx);
  const long double foot_y = std::round(chord.my + along * chord.ny);
  if (!(std::fabs(foot_x) < kMaxUnits) || !(std::fabs(foot_y) < kMaxUnits)) return std::nullopt;
  constexpr std::int64_t kReach = 2;
  std::optional<GridPoint> best;
  long double least = 0;
  for (std::int64_t i = -kReach; i <= kReach; ++i) {
    for (std::int64_t j = -kReach; j <= kReach; ++j) {
      arc.centre = {static_cast<std::int64_t>(foot_x) + i, static_cast<std::int64_t>(foot_y) + j};
      if (arc.centre == arc.from || arc.centre == arc.to) continue;
      const long double c = cost(arc, chord, exact, limit);
      if (best && !(c < least)) continue;
      least = c;
      best = arc.centre;
    }
  }
  return best;
}

/// The arc that a written one is read as: through its ends about the foot of its centre on the
/// bisector of the chord (lang/nc/arc.h).
ArcBalls arc_read(const WrittenArc& arc, const Chord& chord) {
  const long double along = (static_cast<long double>(arc.centre.x) - chord.mx) * chord.nx +
                            (static_cast<long double>(arc.centre.y) - chord.my) * chord.ny;
  return {{Ball(chord.mx + along * chord.nx, 0), Ball(chord.my + along * chord.ny, 0)},
          Ball(std::hypot(along, chord.half), 0),
          balls(arc.from),
          balls(arc.to),
          arc.ccw,
          arc.major};
}

/// From `centre` to one that is chosen again where the written arc is read and written: what the
/// search about the first foot did not reach may serve better. Each step costs less than the one
/// before by the difference of the radii alone, and no more beside the exact arc, since the errors
/// in the middle add up along one line.
GridPoint settled_centre(WrittenArc arc, const Chord& chord, GridPoint centre, double limit) {
  constexpr int kMostSteps = 4096;
  for (int step = 0; step < kMostSteps; ++step) {
    arc.centre = centre;
    const auto next = best_centre(arc, chord, arc_read(arc, chord), limit);
    if (!next || *next == centre) break;
    centre = *next;
  }
  return centre;
}

}  // namespace

std::optional<FittedArc> fit_by_radius(const GridPoint& from, const GridPoint& to,
                                       const ArcBalls& exact) {
  if (from == to) return std::nullopt;
  const Chord chord = chord_of(from, to, exact.ccw);
  const std::int64_t least = least_radius(squared_distance(from, to));
  const long double ideal = radius_through_middle(chord, exact);
  constexpr auto kLimit = static_cast<long double>(kMaxUnits);
  if (!(ideal < kLimit) || !(exact.radius.mid < kLimit) || least > kMaxUnits) return std::nullopt;
  const auto floor = static_cast<std::int64_t>(ideal);
  std::optional<FittedArc> best;
  std::int64_t previous = 0;
  // Between two whole radii beside the ideal one; the arc's own, should it be whole already.
  for (const std::int64_t candidate :
       {static_cast<std::int64_t>(std::round(exact.radius.mid)), floor, floor + 1}) {
    const std::int64_t radius = std::max(candidate, least);
    if (radius == previous) continue;
    previous = radius;
    const ArcBalls written = radius_form(from, to, exact.ccw, exact.major, radius);
    const double deviation = deviation_of_arc(written, 0, exact);
    if (best && !(deviation < best->deviation)) continue;
    best = FittedArc{{from, to, exact.ccw, exact.major, radius, {}}, deviation, 0, written};
  }
  return best;
}

std::optional<FittedArc> fit_by_centre(const GridPoint& from, const GridPoint& to,
                                       const ArcBalls& exact, double most_mismatch) {
  if (from == to) return std::nullopt;
  WrittenArc arc{from, to, exact.ccw, exact.major, 0, {}};
  const Chord chord = chord_of(from, to, exact.ccw);
  const auto centre = best_centre(arc, chord, exact, most_mismatch);
  if (!centre) return std::nullopt;
  arc.centre = settled_centre(arc, chord, *centre, most_mismatch);
  arc.major = is_major(arc);
  const BandedArc banded = centre_form(arc);
  return FittedArc{arc, deviation_of_arc(banded.arc, banded.band, exact), banded.mismatch,
                   arc_read(arc, chord)};
}

}  // namespace dgt
