// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/offset_source.h"

#include <algorithm>
#include <optional>

#include "kernel/check.h"
#include "kernel/fine_corner.h"

namespace dgt {
namespace {

template <class Real>
Enclosed<Real> enclosed(const Rational& value);
// mpq_get_d rounds towards zero: off by one unit in the last place.
template <>
Enclosed<double> enclosed(const Rational& value) {
  const double d = value.get_d();
  return {d, d == value ? 0 : 0x1p-52 * std::fabs(d)};
}
template <>
Enclosed<DoubleDouble> enclosed(const Rational& value) {
  const double high = value.get_d();
  const Rational rest = value - high;
  const double low = rest.get_d();
  const DoubleDouble sum = DoubleDouble::ordered_sum(high, low);
  return {sum, low == rest ? 0 : 0x1p-103 * std::fabs(high)};
}

template <class Real>
EnclosedVector<Real> enclosed(const Vector& v) {
  const Enclosed<Real> x = enclosed<Real>(v.x);
  const Enclosed<Real> y = enclosed<Real>(v.y);
  return {x.mid, y.mid, std::max(x.rad, y.rad)};
}

template <class Real>
EnclosedEdge<Real> enclosed(const ChainEdge& e) {
  return {enclosed<Real>(e.from),
          enclosed<Real>(e.to),
          enclosed<Real>(e.start.vector()),
          enclosed<Real>(e.end.vector()),
          enclosed<Real>(e.radius),
          e.is_line(),
          sgn(e.radius) > 0};
}

template <class Real>
EnclosedEdge<Real> reversed(const EnclosedEdge<Real>& e) {
  return {e.to, e.from, -e.end, -e.start, -e.radius, e.is_line, !e.counter_clockwise};
}

bool is_straight(const BulgePoint& p) {
  return std::fabs(p.bulge) < std::ldexp(1.0, kStraightBulgeExponent);
}

/// The edge from p to q. With b the bulge, the sine and cosine of half the sweep are 2b/(1 + b²)
/// and (1 − b²)/(1 + b²): by it the normals at the ends are turned against the chord's, and the
/// radius is |w| (1 + b²) / 4b. The exact radius |w|²/(2 w·n) follows the stand-in n: it is off by
/// 2⁻⁹⁶ of the sine.
template <class Real>
EnclosedEdge<Real> edge_between(const BulgePoint& p, const BulgePoint& q) {
  EnclosedEdge<Real> e;
  e.from = {p.x, p.y, 0};
  e.to = {q.x, q.y, 0};
  const EnclosedVector<Real> w = e.to - e.from;
  const Enclosed<Real> length = root(dot(w, w));
  const Enclosed<Real> one{Real(1.0), 0};
  const EnclosedVector<Real> normal = turned_left((one / length) * w);
  e.is_line = is_straight(p);
  if (e.is_line) {
    e.start = normal;
    e.start.rad += kStandIn;
    e.end = e.start;
    return e;
  }
  const Enclosed<Real> b{Real(p.bulge), 0};
  const Enclosed<Real> square = b * b;
  const Enclosed<Real> whole = one + square;
  const EnclosedVector<Real> straight = ((one - square) / whole) * normal;
  const EnclosedVector<Real> turn = ((b + b) / whole) * turned_left(normal);
  e.start = straight - turn;
  e.end = straight + turn;
  e.start.rad += kStandIn;
  e.end.rad += kStandIn;
  e.radius = (length * whole) / Enclosed<Real>{Real(4 * p.bulge), 0};
  e.radius.rad += kStandIn * e.radius.size() / std::fabs(p.bulge);
  e.counter_clockwise = p.bulge > 0;
  return e;
}

/// The edge of edge_between in doubles, and what that is off by, with u = 2⁻⁵³. A chord w is good
/// to 1 u, its square to 4 u, the root to 3 u, its inverse to 4 u, so the chord's normal to 6 u. On
/// arcs (1 − b²)/(1 + b²) is off by 6 u, 2b/(1 + b²) by 4 u of itself, their products with the
/// normal by 13 u and 11 u, and the sum of these by 26 u; the radius by 14 u of itself.
void set_between(const BulgePoint& p, const BulgePoint& q, EdgeInDoubles& e) {
  e.x = p.x;
  e.y = p.y;
  const double wx = q.x - p.x;
  const double wy = q.y - p.y;
  const double square = wx * wx + wy * wy;
  const double inverse = 1 / std::sqrt(square);
  const double nx = -wy * inverse;
  const double ny = wx * inverse;
  e.is_line = is_straight(p);
  if (e.is_line) {
    e.start_x = e.end_x = nx;
    e.start_y = e.end_y = ny;
    e.normal_rad = 0x1p-50;
    return;
  }
  const double b = p.bulge;
  const double whole = 1 + b * b;
  const double shrink = 1 / whole;
  const double c = (1 - b * b) * shrink;
  const double s = 2 * b * shrink;
  e.start_x = c * nx + s * ny;
  e.start_y = c * ny - s * nx;
  e.end_x = c * nx - s * ny;
  e.end_y = c * ny + s * nx;
  e.normal_rad = 0x1p-48;
  e.radius = square * inverse * whole * (0.25 / b);
  e.radius_rad = std::fabs(e.radius) * (0x1p-49 + kStandIn / std::fabs(b));
  e.counter_clockwise = b > 0;
}
void set_from(const ChainEdge& exact, EdgeInDoubles& e) {
  e.x = exact.from.x.get_d();
  e.y = exact.from.y.get_d();
  e.start_x = exact.start.x().get_d();
  e.start_y = exact.start.y().get_d();
  e.end_x = exact.end.x().get_d();
  e.end_y = exact.end.y().get_d();
  e.normal_rad = 0x1p-52;
  e.is_line = exact.is_line();
  if (e.is_line) return;
  e.radius = exact.radius.get_d();
  e.radius_rad = 0x1p-52 * std::fabs(e.radius);
  e.counter_clockwise = e.radius > 0;
}

/// The same edge run the other way begins where it ended.
void reverse(EdgeInDoubles& e, double x, double y) {
  e.x = x;
  e.y = y;
  std::swap(e.start_x, e.end_x);
  std::swap(e.start_y, e.end_y);
  e.start_x = -e.start_x;
  e.start_y = -e.start_y;
  e.end_x = -e.end_x;
  e.end_y = -e.end_y;
  e.radius = -e.radius;
  e.counter_clockwise = !e.counter_clockwise;
}

/// What the parting does to an edge in doubles: its ends move by no more than kPartingShare of it.
void widen(EdgeInDoubles& e) {
  e.normal_rad += 4 * kPartingShare;
  e.radius_rad += 4 * kPartingShare * std::fabs(e.radius);
}

/// The edge with its ends moved: all of it by the map z → (1 + η) z + b that moves them so, to the
/// first order in |η| ≤ 2 kPartingShare. The second one and the rounding of η are below 2⁻¹⁰³.
EnclosedEdge<DoubleDouble> displaced(EnclosedEdge<DoubleDouble> e, CoarsePoint from,
                                     CoarsePoint to) {
  constexpr double kNeglected = 0x1p-103;
  const double wx = e.to.x.hi - e.from.x.hi;
  const double wy = e.to.y.hi - e.from.y.hi;
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double square = wx * wx + wy * wy;
  const Enclosed<DoubleDouble> grown{(dx * wx + dy * wy) / square, 0};
  const Enclosed<DoubleDouble> turned{(dy * wx - dx * wy) / square, 0};
  e.from = e.from + EnclosedVector<DoubleDouble>{from.x, from.y, 0};
  e.to = e.to + EnclosedVector<DoubleDouble>{to.x, to.y, 0};
  e.start = e.start + turned * turned_left(e.start);
  e.start.rad += kNeglected;
  e.end = e.end + turned * turned_left(e.end);
  e.end.rad += kNeglected;
  if (e.is_line) return e;
  e.radius = e.radius + grown * e.radius;
  e.radius.rad += kNeglected * e.radius.size();
  return e;
}

/// A number in [−1, 1) that looks like chance, the same for the same count everywhere (the
/// finalizer of splitmix64).
double scattered(std::uint64_t count) {
  count *= 0x9e3779b97f4a7c15U;
  count = (count ^ (count >> 30U)) * 0xbf58476d1ce4e5b9U;
  count = (count ^ (count >> 27U)) * 0x94d049bb133111ebU;
  count ^= count >> 31U;
  return static_cast<double>(static_cast<std::int64_t>(count) >> 11) * 0x1p-52;
}

RationalPoint exact(const BulgePoint& p) { return {Rational(p.x), Rational(p.y)}; }

/// Polylines that doubles can follow: no arc above half a turn, nothing huge or of no length.
bool suit_doubles(const std::vector<BulgePolyline>& loops) {
  return std::ranges::all_of(loops, [](const BulgePolyline& loop) {
    const BulgePoint* before = loop.empty() ? nullptr : &loop.back();
    return loop.size() > 1 && std::ranges::all_of(loop, [&](const BulgePoint& p) {
             const double way = std::max(std::fabs(p.x - before->x), std::fabs(p.y - before->y));
             before = &p;
             return std::fabs(p.x) < kLargest && std::fabs(p.y) < kLargest &&
                    std::fabs(p.bulge) <= 1 && way > 1 / kLargest;
           });
  });
}

std::vector<BulgeVertex> exact(const BulgePolyline& loop) {
  std::vector<BulgeVertex> vertices;
  for (const BulgePoint& p : loop) vertices.push_back({exact(p), Rational(p.bulge)});
  return vertices;
}

std::vector<Chain> chains_of(const std::vector<BulgePolyline>& loops) {
  std::vector<Chain> chains;
  for (const BulgePolyline& loop : loops) {
    if (auto chain = chain_of(exact(loop), true)) chains.push_back(*std::move(chain));
  }
  return chains;
}

}  // namespace

OffsetSource::OffsetSource(const std::vector<BulgePolyline>& loops, Rational distance,
                           bool reversed, const OffsetOptions& options)
    : distance_(std::move(distance)), options_(options), reversed_(reversed) {
  if (!suit_doubles(loops)) {
    *this = OffsetSource(chains_of(loops), distance_, reversed, options);
    return;
  }
  first_.push_back(0);
  for (const BulgePolyline& loop : loops) {
    points_.insert(points_.end(), loop.begin(), loop.end());
    first_.push_back(static_cast<std::uint32_t>(points_.size()));
  }
  set_distance();
}

OffsetSource::OffsetSource(const std::vector<Chain>& loops, Rational distance, bool reversed,
                           const OffsetOptions& options)
    : distance_(std::move(distance)), options_(options), reversed_(reversed) {
  first_.push_back(0);
  for (const Chain& loop : loops) {
    DGT_CHECK(loop.closed && !loop.edges.empty());
    chain_edges_.insert(chain_edges_.end(), loop.edges.begin(), loop.edges.end());
    first_.push_back(static_cast<std::uint32_t>(chain_edges_.size()));
  }
  set_distance();
}

OffsetSource OffsetSource::about(const Chain& there_and_back, Rational distance,
                                 const OffsetOptions& options) {
  OffsetSource source(std::vector<Chain>{there_and_back}, std::move(distance), false, options);
  source.is_slit_ = true;
  return source;
}

void OffsetSource::set_distance() {
  const Rational decisive = distance_ + power_of_two(kContactExponent);
  decisive_ = enclosed<double>(decisive);
  decisive_fine_ = enclosed<DoubleDouble>(decisive);
  fine_distance_ = enclosed<DoubleDouble>(distance_);
}

template <>
const Enclosed<double>& OffsetSource::decisive_distance() const {
  return decisive_;
}
template <>
const Enclosed<DoubleDouble>& OffsetSource::decisive_distance() const {
  return decisive_fine_;
}

std::size_t OffsetSource::loop_of(std::uint32_t edge) const {
  const auto behind = std::upper_bound(first_.begin(), first_.end(), edge);
  return static_cast<std::size_t>(behind - first_.begin()) - 1;
}

std::uint32_t OffsetSource::next(std::uint32_t edge) const {
  const std::size_t loop = loop_of(edge);
  return edge + 1 == first_[loop + 1] ? first_[loop] : edge + 1;
}

std::uint32_t OffsetSource::previous(std::uint32_t edge) const {
  const std::size_t loop = loop_of(edge);
  return (edge == first_[loop] ? first_[loop + 1] : edge) - 1;
}

std::uint32_t OffsetSource::original(std::uint32_t edge) const {
  if (!reversed_) return edge;
  const std::size_t loop = loop_of(edge);
  return first_[loop] + first_[loop + 1] - 1 - edge;
}

bool OffsetSource::suits_doubles() const {
  const auto fits = [](const Rational& v) { return std::fabs(v.get_d()) < kLargest; };
  return fits(distance_) && std::ranges::all_of(chain_edges_, [&](const ChainEdge& e) {
           return fits(e.from.x) && fits(e.from.y) && fits(e.radius);
         });
}

double OffsetSource::area(std::size_t loop) const {
  const std::uint32_t first = first_[loop];
  const EdgeInDoubles origin = in_doubles(first);
  double twice_area = 0;
  EdgeInDoubles e = origin;
  for (std::uint32_t i = first; i < first_[loop + 1]; ++i) {
    const EdgeInDoubles next_edge = i + 1 == first_[loop + 1] ? origin : in_doubles(i + 1);
    twice_area +=
        (e.x - origin.x) * (next_edge.y - origin.y) - (next_edge.x - origin.x) * (e.y - origin.y);
    if (!e.is_line) {
      const double r = std::fabs(e.radius);
      const double chord = std::hypot(next_edge.x - e.x, next_edge.y - e.y);
      const double sweep = 2 * std::asin(std::min(1.0, chord / (2 * r)));
      twice_area += (e.counter_clockwise ? 1 : -1) * r * r * (sweep - std::sin(sweep));
    }
    e = next_edge;
  }
  return twice_area / 2;
}

void OffsetSource::in_doubles(std::uint32_t index, EdgeInDoubles& e) const {
  const std::uint32_t i = original(index);
  if (!points_.empty()) {
    const BulgePoint& q = points_[next(i)];
    set_between(points_[i], q, e);
    if (reversed_) reverse(e, q.x, q.y);
  } else {
    const ChainEdge& exact = chain_edges_[i];
    set_from(exact, e);
    if (reversed_) reverse(e, exact.to.x.get_d(), exact.to.y.get_d());
  }
  if (parted_) widen(e);
}

OffsetSource OffsetSource::parted() const {
  OffsetSource source = *this;
  source.parted_ = true;
  return source;
}

CoarsePoint OffsetSource::beginning(std::uint32_t original) const {
  if (!points_.empty()) return {points_[original].x, points_[original].y};
  const RationalPoint& p = chain_edges_[original].from;
  return {p.x.get_d(), p.y.get_d()};
}

CoarsePoint OffsetSource::parting(std::uint32_t original) const {
  const CoarsePoint before = beginning(previous(original));
  const CoarsePoint at = beginning(original);
  const CoarsePoint behind = beginning(next(original));
  const double shorter = std::min(std::hypot(at.x - before.x, at.y - before.y),
                                  std::hypot(behind.x - at.x, behind.y - at.y));
  const double most = 0.7 * std::min(kParting, kPartingShare * shorter);
  return {most * scattered(2 * std::uint64_t{original}),
          most * scattered(2 * std::uint64_t{original} + 1)};
}

EnclosedEdge<DoubleDouble> OffsetSource::edge(std::uint32_t index, Vertices vertices) const {
  using Real = DoubleDouble;
  const std::uint32_t i = original(index);
  EnclosedEdge<Real> e = points_.empty() ? enclosed<Real>(chain_edges_[i])
                                         : edge_between<Real>(points_[i], points_[next(i)]);
  if (parted_ && vertices == Vertices::Decisive) e = displaced(e, parting(i), parting(next(i)));
  return reversed_ ? reversed(e) : e;
}

ChainEdge OffsetSource::exact_edge(std::uint32_t index) const {
  const std::uint32_t i = original(index);
  ChainEdge e;
  if (points_.empty()) {
    e = chain_edges_[i];
  } else {
    const BulgePoint& p = points_[i];
    const RationalPoint to = exact(points_[next(i)]);
    e = is_straight(p) ? segment(exact(p), to) : arc(exact(p), to, Rational(p.bulge));
  }
  return reversed_ ? reversed(e) : e;
}

std::vector<Chain> OffsetSource::exact_loops() const {
  std::vector<Chain> chains(loops());
  for (std::size_t loop = 0; loop < loops(); ++loop) {
    for (std::uint32_t i = first_[loop]; i < first_[loop + 1]; ++i)
      chains[loop].edges.push_back(exact_edge(i));
  }
  return chains;
}

JointTurn OffsetSource::sharp_joint(std::uint32_t i) const {
  const Rational turn = cross(exact_edge(i).end.vector(), exact_edge(next(i)).start.vector());
  return sgn(turn) > 0 ? JointTurn::Left : JointTurn::Right;
}

bool OffsetSource::turns_by_rounding(std::uint32_t i, double turn) const {
  const std::uint32_t k = next(i);
  const EdgeInDoubles before = in_doubles(i);
  const EdgeInDoubles at = in_doubles(k);
  const EdgeInDoubles behind = in_doubles(next(k));
  const double chord = std::min(std::fabs(at.x - before.x) + std::fabs(at.y - before.y),
                                std::fabs(behind.x - at.x) + std::fabs(behind.y - at.y));
  return turn * chord <= kVertexRounding * (std::fabs(at.x) + std::fabs(at.y));
}

JointTurn OffsetSource::joint(std::uint32_t i) const {
  return joint(i, in_doubles(i), in_doubles(next(i)));
}

std::vector<Strand<DoubleDouble>> OffsetSource::corner_parts(std::uint32_t i,
                                                             const Enclosed<DoubleDouble>& d,
                                                             Vertices vertices) const {
  if (options_.corner == OffsetCorner::Round || joint(i) != JointTurn::Right) return {};
  const auto e = edge(i, vertices);
  const auto behind = edge(next(i), vertices);
  return options_.corner == OffsetCorner::Chamfer
             ? fine_chamfer(e, behind, d)
             : fine_sharp_corner(e, behind, d, options_.spike_limit);
}

Strand<DoubleDouble> OffsetSource::strand(RawKey key, const Enclosed<DoubleDouble>& d,
                                          Vertices vertices) const {
  const auto e = edge(key.edge(), vertices);
  if (key.part() > 0) {
    const auto parts = corner_parts(key.edge(), d, vertices);
    if (!parts.empty()) return parts[key.part() - 1];
    return corner(e, edge(next(key.edge()), vertices), joint(key.edge()), d);
  }
  const std::uint32_t before = previous(key.edge());
  const bool tangent = joint(before) == JointTurn::Tangent;
  Strand<DoubleDouble> s = moved(e, tangent ? edge(before, vertices).end : e.start, d);
  if (shrinks_to_chord(in_doubles(key.edge()))) s.is_line = true;
  return s;
}

std::optional<RawPiece> OffsetSource::exact_piece(RawKey key, const Rational& distance) const {
  const ChainEdge e = exact_edge(key.edge());
  if (key.part() == 0) return raw_edge(e, distance);
  const auto parts = raw_corner(e, exact_edge(next(key.edge())), distance, options_);
  if (parts.size() < key.part()) return std::nullopt;
  return parts[key.part() - 1];
}

RationalPoint OffsetSource::exact_beginning(RawKey key) const {
  const ChainEdge e = exact_edge(key.edge());
  if (key.part() > 0) {
    const auto piece = exact_piece(key, distance_);
    return piece ? piece->from : e.to + distance_ * e.end.vector();
  }
  const std::uint32_t before = previous(key.edge());
  const bool tangent = joint(before) == JointTurn::Tangent;
  return e.from + distance_ * (tangent ? exact_edge(before).end : e.start).vector();
}

}  // namespace dgt
