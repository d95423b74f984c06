// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>

// The bound for two arcs.
//
// Let W be the written arc (centre C, radius R, from A' to B') and E the exact one (centre c,
// radius r, from A to B), both counter-clockwise (clockwise ones are mirrored first) and of at most
// half a turn; a = |A' − A|, b = |B' − B|, m = max(a, b), d = C − c, ε = |d|.
//
// Radial bound. Suppose ε ≤ R/2, m ≤ r/2 and |AB| ≥ 1.04 m. A point of W in the direction φ from C
// is C + R e(φ) = c + (d + R e(φ)). Since ε < R the vector d + R e(φ) turns steadily
// counter-clockwise with φ (its cross product with its derivative is R(R + d·e(φ)) > 0), and it is
// never further than arcsin(ε/R) ≤ 30° from e(φ). So the direction θ seen from c increases along W,
// and by at most 240°. A' is seen within arcsin(a/r) ≤ 30° of A, B' within 30° of B. Lift the
// angles so that θ(A') is next to θ(A). E covers more than 0° and at most 180°, so θ(B') − θ(B)
// lies between −210° and 270°, and being within 30° of a multiple of 360° it is next to 0: the
// ranges of angles of W and E differ only by what the ends are off. The last condition makes them
// overlap: the angle covered by E is at least arcsin(m/r), since a chord under the angle α =
// arcsin(m/r) ≤ 30° is 2 r sin(α/2) ≤ 1.036 m. Match points of equal angle, and for angles which
// only one of the two covers, match the end of the other. With
//     F = max over W of | |p − c| − r |
// points of equal angle are at most F apart. Where W begins before E, the piece of W before θ(A) is
// matched to A; its ends are A', a from A, and a point at most F from A. It is an arc of less than
// half a turn over a chord of at most h = a + F, so none of its points is further from A than
// max(a, F) + s, s = (h/2)² / (ρ + √(ρ² − (h/2)²)) with ρ = R: the distance from A is convex along
// the chord, and the arc is within its sagitta of the chord, which grows with the chord. Where W
// begins after E, the same holds for the piece of E matched to A', with ρ = r. So do both ends, and
//     deviation ≤ max(F, m) + s,  h = m + F,  ρ = min(R, r),  provided h ≤ 2ρ.
// F: |p − c|² = ε² + R² + 2 R d·e(φ) has its extremes over W at the ends, or where e(φ) is parallel
// to d (giving R + ε) or to −d (giving |R − ε| = R − ε), should W contain these directions.
//
// Bound by graphs. Both arcs are graphs over their chords, with heights between 0 and the sagittas
// S (of W) and s (of E), on the right. At equal fractions of the chords, the feet are at most m
// apart, and the heights along the normals n', n differ by at most |h_W − h_E| + min(h_W, h_E) |n'
// − n|, so
//     deviation ≤ m + max(S, s) + min(S, s) |n' − n|,  |n' − n| ≤ 2 (a + b) / max(|A'B'|, |AB|).
//
// Crude bound, for arcs of any extent. Run through W while waiting in A, never further than a + 2R,
// then through E while waiting in B', never further than b + 2r:
//     deviation ≤ m + 2 max(R, r).
//
// The least of these is taken. Arcs of about half a turn and more are divided first: W in its
// middle M', E in the point M of its circle in the direction of M' from c, which must lie inside E
// with less than half a turn to either side; then the halves are matched, in order.
//
// Band. A curve that runs in each direction from C within w of radius R is within w of W, so w is
// added.
namespace dgt {
namespace {

constexpr long double kInfinity = std::numeric_limits<long double>::infinity();

/// Lifts a non-negative result above the rounding of a few operations.
long double up(long double x) { return x * (1 + 0x1p-58L) + 0x1p-16000L; }

double up_to_double(long double x) {
  const auto rounded = static_cast<double>(x);
  return static_cast<long double>(rounded) >= x
             ? rounded
             : std::nextafter(rounded, std::numeric_limits<double>::infinity());
}

long double upper(const Ball& b) { return up(std::fabs(b.mid) + b.rad); }
long double lower(const Ball& b) {  // of |b|
  return std::max(0.0L, (std::fabs(b.mid) - b.rad) * (1 - 0x1p-58L));
}
bool perhaps_positive(const Ball& b) { return b.mid + b.rad >= 0; }

BallPoint operator-(const BallPoint& a, const BallPoint& b) { return {a.x - b.x, a.y - b.y}; }
BallPoint operator+(const BallPoint& a, const BallPoint& b) { return {a.x + b.x, a.y + b.y}; }
BallPoint operator*(const Ball& k, const BallPoint& a) { return {k * a.x, k * a.y}; }
Ball cross(const BallPoint& a, const BallPoint& b) { return a.x * b.y - a.y * b.x; }
Ball squared_length(const BallPoint& a) { return a.x * a.x + a.y * a.y; }

/// √b for b ≥ 0, also where b may be 0.
Ball root(const Ball& b) {
  if (const auto certain = sqrt(b)) return *certain;
  const long double high = up(std::sqrt(std::max(0.0L, b.mid + b.rad)));
  return {high / 2, up(high / 2)};
}

Ball length(const BallPoint& a) { return root(squared_length(a)); }
long double distance(const BallPoint& a, const BallPoint& b) { return upper(length(a - b)); }

BallPoint mirrored(const BallPoint& p) { return {p.x, -p.y}; }

ArcBalls made_counter_clockwise(const ArcBalls& arc) {
  if (arc.ccw) return arc;
  return {mirrored(arc.centre), arc.radius, mirrored(arc.from), mirrored(arc.to), true, arc.major};
}

/// Sagitta of an arc of at most half a turn with a chord of at most `chord`: rises with the chord,
/// falls with the radius.
long double sagitta(long double chord, long double radius_at_least) {
  const long double half = chord / 2;
  const long double rest = (radius_at_least - half) * (radius_at_least + half);
  if (!(radius_at_least > 0)) return half;
  if (!(rest > 0)) return up(half * half / radius_at_least);
  return up(half * half / (radius_at_least + std::sqrt(rest)));
}

long double sagitta(const ArcBalls& minor) {
  const long double chord = upper(length(minor.to - minor.from));
  return std::min(sagitta(chord, lower(minor.radius)), upper(minor.radius));
}

/// Two arcs to be held against each other, both counter-clockwise.
struct Pair {
  ArcBalls written;
  ArcBalls exact;
  long double at_from = 0;  // a
  long double at_to = 0;    // b
};

long double crude_bound(const Pair& p) {
  return up(std::max(p.at_from, p.at_to) +
            2 * std::max(upper(p.written.radius), upper(p.exact.radius)));
}

long double graph_bound(const Pair& p) {
  const long double ends = std::max(p.at_from, p.at_to);
  const long double of_written = sagitta(p.written);
  const long double of_exact = sagitta(p.exact);
  const long double chord = std::max(lower(length(p.written.to - p.written.from)),
                                     lower(length(p.exact.to - p.exact.from)));
  const long double turn = chord > 0 ? std::min(2.0L, up(2 * (p.at_from + p.at_to) / chord)) : 2.0L;
  return up(ends + std::max(of_written, of_exact) + std::min(of_written, of_exact) * turn);
}

/// F of the proof above.
long double largest_radial_error(const Pair& p, const BallPoint& d, const Ball& shift) {
  const ArcBalls& w = p.written;
  const Ball& r = p.exact.radius;
  const auto radial = [&](const Ball& reach) { return upper(reach - r); };
  long double worst =
      std::max(radial(length(w.from - p.exact.centre)), radial(length(w.to - p.exact.centre)));
  const Ball after_from = cross(w.from - w.centre, d);
  const Ball before_to = cross(d, w.to - w.centre);
  if (perhaps_positive(after_from) && perhaps_positive(before_to))
    worst = std::max(worst, radial(w.radius + shift));
  if (perhaps_positive(-after_from) && perhaps_positive(-before_to))
    worst = std::max(worst, radial(w.radius - shift));
  return worst;
}

long double radial_bound(const Pair& p) {
  const BallPoint d = p.written.centre - p.exact.centre;
  const Ball shift = length(d);
  const long double ends = std::max(p.at_from, p.at_to);
  const long double radius = std::min(lower(p.written.radius), lower(p.exact.radius));
  if (!(2 * upper(shift) <= lower(p.written.radius)) || !(2 * ends <= lower(p.exact.radius)) ||
      !(lower(length(p.exact.to - p.exact.from)) >= 1.04L * ends))
    return kInfinity;
  const long double radial = largest_radial_error(p, d, shift);
  const long double chord = up(ends + radial);
  if (!(chord <= 2 * radius)) return kInfinity;
  return up(std::max(radial, ends) + sagitta(chord, radius));
}

/// More than about 135°, or not certain to be less.
bool is_wide(const ArcBalls& arc) {
  const long double radius = lower(arc.radius);
  return arc.major || !(upper(squared_length(arc.to - arc.from)) <= 3.4L * radius * radius);
}

/// The middle of a counter-clockwise arc lies right of its chord, seen from the centre.
std::optional<BallPoint> middle(const ArcBalls& arc) {
  const BallPoint chord = arc.to - arc.from;
  const auto scale = divide(arc.radius, length(chord));
  if (!scale) return std::nullopt;
  return arc.centre + *scale * BallPoint{chord.y, -chord.x};
}

std::optional<BallPoint> projection(const BallPoint& p, const ArcBalls& circle) {
  const BallPoint from_centre = p - circle.centre;
  const auto scale = divide(circle.radius, length(from_centre));
  if (!scale) return std::nullopt;
  return circle.centre + *scale * from_centre;
}

bool left_of(const BallPoint& from, const BallPoint& to) {
  const auto s = cross(from, to).sign();
  return s && *s > 0;
}

ArcBalls part(const ArcBalls& arc, const BallPoint& from, const BallPoint& to) {
  return {arc.centre, arc.radius, from, to, true, false};
}

long double bound(const Pair& p, int divisions);

long double bound_of_halves(const Pair& p, int divisions) {
  const auto of_written = middle(p.written);
  if (divisions == 0 || !of_written) return kInfinity;
  const auto of_exact = projection(*of_written, p.exact);
  if (!of_exact) return kInfinity;
  const BallPoint to_middle = *of_exact - p.exact.centre;
  if (!left_of(p.exact.from - p.exact.centre, to_middle) ||
      !left_of(to_middle, p.exact.to - p.exact.centre))
    return kInfinity;
  const long double between = distance(*of_written, *of_exact);
  const Pair first{part(p.written, p.written.from, *of_written),
                   part(p.exact, p.exact.from, *of_exact), p.at_from, between};
  const Pair second{part(p.written, *of_written, p.written.to),
                    part(p.exact, *of_exact, p.exact.to), between, p.at_to};
  return std::max(bound(first, divisions - 1), bound(second, divisions - 1));
}

long double bound(const Pair& p, int divisions) {
  if (is_wide(p.written) || is_wide(p.exact))
    return std::min(crude_bound(p), bound_of_halves(p, divisions));
  const long double radial = radial_bound(p);
  if (radial < kInfinity) return radial;
  return std::min(graph_bound(p), crude_bound(p));
}

}  // namespace

BallPoint balls(const GridPoint& p) {
  return {Ball(static_cast<long double>(p.x), 0), Ball(static_cast<long double>(p.y), 0)};
}

double distance_bound(const BallPoint& a, const BallPoint& b) {
  return up_to_double(distance(a, b));
}

double sagitta_bound(const ArcBalls& arc) {
  return up_to_double(arc.major ? upper(Ball(2, 0) * arc.radius) : sagitta(arc));
}

double deviation_of_line(const GridPoint& from, const GridPoint& to, const BallPoint& exact_from,
                         const BallPoint& exact_to) {
  return std::max(distance_bound(balls(from), exact_from), distance_bound(balls(to), exact_to));
}

double deviation_of_chord(const GridPoint& from, const GridPoint& to, const ArcBalls& exact) {
  const long double ends =
      std::max(distance(balls(from), exact.from), distance(balls(to), exact.to));
  if (exact.major) return up_to_double(up(ends + 2 * upper(exact.radius)));
  return up_to_double(up(ends + sagitta(exact)));
}

double deviation_of_arc(const ArcBalls& written, double band, const ArcBalls& exact) {
  DGT_CHECK(written.ccw == exact.ccw);
  const Pair pair{made_counter_clockwise(written), made_counter_clockwise(exact),
                  distance(written.from, exact.from), distance(written.to, exact.to)};
  constexpr int kDivisions = 3;  // a whole turn, a half, a quarter
  return up_to_double(up(bound(pair, kDivisions) + band));
}

}  // namespace dgt
