// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/offset_raw.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/box_tree.h"
#include "kernel/cgal/raw_crossing.h"
#include "kernel/check.h"
#include "kernel/contour_legs.h"

namespace dgt {
namespace {

/// Sine of the angle up to which one segment goes straight on from another: over a metre the two
/// are kOffsetResolution apart.
constexpr double kStraightOn = 1e-12;

/// Cosine of the turn beyond which a corner has no chamfer: the edge all but doubles back.
const Rational kNearlyBack(-999999, 1000000);

RationalPoint moved(const RationalPoint& p, const UnitVector& normal, const Rational& distance) {
  return p + distance * normal.vector();
}

Bounds box_of(const OffsetLoop& loop) {
  const Point& first = loop.pieces.front().from;
  Bounds box{first.x(), first.y(), first.x(), first.y()};
  for (const OffsetPiece& piece : loop.pieces)
    box = box.united({piece.to.x(), piece.to.y(), piece.to.x(), piece.to.y()});
  return box;
}

bool is_sliver(const OffsetLoop& loop) {
  const Bounds box = box_of(loop);
  // A loop of two arcs spans its box between two vertices only; its area tells a disc from a
  // sliver.
  return box.max_x - box.min_x <= kOffsetResolution && box.max_y - box.min_y <= kOffsetResolution;
}

/// A rational point on the piece, near its middle.
RationalPoint point_inside(const OffsetPiece& piece) {
  const auto near = [](const Point& p) {
    const ExactPoint exact = p.exact();
    return RationalPoint{rational_within(exact.x, -80), rational_within(exact.y, -80)};
  };
  const RationalPoint from = near(piece.from);
  const RationalPoint to = near(piece.to);
  const RationalPoint middle = Rational(1, 2) * (from + to);
  if (piece.is_line) return middle;
  // x-monotone arcs cover at most half a turn: the middle of the chord points to the arc's own,
  // unless the chord is a diameter.
  Vector out = middle - piece.centre;
  if (squared_length(out) * 1000000 < piece.radius * piece.radius) {
    out = turned_right(to - from);
    if (sgn(piece.radius) < 0) out = -out;
  }
  return piece.centre + abs(piece.radius) * direction_of(out).unit.vector();
}

/// Whether a whole component of the region may fit into the disc: only then does a number lie. The
/// ends of its edges span its box up to the arcs' heights, at most half of that more on each side.
bool may_have_voids(const std::vector<Chain>& loops, const Rational& distance) {
  const double width = 2 * nearest_double(distance) + kOffsetResolution;
  return std::any_of(loops.begin(), loops.end(), [&](const Chain& loop) {
    Bounds box{1e300, 1e300, -1e300, -1e300};
    for (const ChainEdge& e : loop.edges) {
      const double x = nearest_double(e.from.x);
      const double y = nearest_double(e.from.y);
      box = box.united({x, y, x, y});
    }
    return std::max(box.max_x - box.min_x, box.max_y - box.min_y) <= width;
  });
}

bool same_support(const OffsetPiece& a, const OffsetPiece& b) {
  if (a.is_line != b.is_line) return false;
  if (!a.is_line) {
    // Prolonged arcs are stand-ins for those that they go on from.
    static const Rational kReach = power_of_two(kContactExponent);
    return abs(a.centre.x - b.centre.x) <= kReach && abs(a.centre.y - b.centre.y) <= kReach &&
           abs(a.radius - b.radius) <= kReach;
  }
  // Lines of one edge are cut at one-root points only: their directions agree to rounding.
  const auto direction = [](const OffsetPiece& p) {
    return std::pair(p.to.x() - p.from.x(), p.to.y() - p.from.y());
  };
  const auto [ax, ay] = direction(a);
  const auto [bx, by] = direction(b);
  return std::fabs(ax * by - ay * bx) <= kStraightOn * std::hypot(ax, ay) * std::hypot(bx, by) &&
         ax * bx + ay * by > 0;
}

/// What lies between ideal edges and their stand-ins (kOffsetResolution).
void drop_minute_pieces(OffsetLoop& loop) {
  const auto is_minute = [](const OffsetPiece& p) {
    return std::fabs(p.to.x() - p.from.x()) <= kOffsetResolution &&
           std::fabs(p.to.y() - p.from.y()) <= kOffsetResolution;
  };
  // Begin at something larger, so that no run of them passes the seam.
  const auto first = std::ranges::find_if_not(loop.pieces, is_minute);
  if (first == loop.pieces.end()) return;  // together they are more
  if (loop.closed) {
    std::ranges::rotate(loop.pieces, first);
  } else {
    first->from = loop.pieces.front().from;
    loop.pieces.erase(loop.pieces.begin(), first);
  }
  std::vector<OffsetPiece> kept;
  for (OffsetPiece& piece : loop.pieces) {
    if (is_minute(piece))
      kept.back().to = piece.to;
    else
      kept.push_back(std::move(piece));
  }
  loop.pieces = std::move(kept);
}

/// Joins the x-monotone parts of one arc, and of one line, again.
void merge_pieces(OffsetLoop& loop) {
  auto& pieces = loop.pieces;
  // Begin at a true corner, so that no run passes the seam.
  for (std::size_t i = 0; loop.closed && i < pieces.size(); ++i) {
    const OffsetPiece& before = pieces[(i + pieces.size() - 1) % pieces.size()];
    if (same_support(before, pieces[i])) continue;
    std::rotate(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(i), pieces.end());
    break;
  }
  std::vector<OffsetPiece> merged;
  for (OffsetPiece& piece : pieces) {
    const bool goes_on = !merged.empty() && same_support(merged.back(), piece) &&
                         (!loop.closed || merged.size() + pieces.size() > 3);
    if (goes_on && !(piece.is_line == false && merged.back().from == piece.to))
      merged.back().to = piece.to;
    else
      merged.push_back(std::move(piece));
  }
  pieces = std::move(merged);
}

RawPiece segment_between(const RationalPoint& from, const RationalPoint& to) {
  RawPiece piece;
  piece.from = from;
  piece.to = to;
  return piece;
}

/// The tangents at the ends of the corner's arc, and between them the one at its middle. A line
/// that touches the unit circle in m meets that in n at (m + n)/(1 + m·n).
std::vector<RawPiece> chamfer(const ChainEdge& edge, const ChainEdge& next,
                              const Rational& distance) {
  const Vector n = edge.end.vector();
  const Vector k = next.start.vector();
  if (dot(n, k) < kNearlyBack) return {};
  const Vector m = direction_of(n + k).unit.vector();
  if (m == n || m == k) return {};
  const RationalPoint begin = edge.to + (distance / (1 + dot(n, m))) * (n + m);
  const RationalPoint end = edge.to + (distance / (1 + dot(m, k))) * (m + k);
  return {segment_between(moved(edge.to, edge.end, distance), begin), segment_between(begin, end),
          segment_between(end, moved(edge.to, next.start, distance))};
}

CoarsePoint spot(const RationalPoint& p) { return {p.x.get_d(), p.y.get_d()}; }

/// From `end` of an edge, moved, with its normal there, to a place on its support: along the line,
/// or along the arc through both that has this normal (chain.h): the edge's own circle but for what
/// the place is off by.
RawPiece prolonged(const ChainEdge& edge, const RationalPoint& end, const UnitVector& normal,
                   const RationalPoint& to) {
  RawPiece piece = segment_between(end, to);
  if (edge.is_line()) return piece;
  const Vector w = to - end;
  const Rational radius = squared_length(w) / (2 * dot(w, normal.vector()));
  piece.is_line = false;
  piece.centre = end + radius * normal.vector();
  piece.squared_radius = radius * radius;
  piece.counter_clockwise = sgn(edge.radius) > 0;
  return piece;
}

/// Nothing when the equidistants do not meet ahead, or too far away. Arcs that the offset turned
/// inside out are not prolonged.
std::vector<RawPiece> sharp_corner(const ChainEdge& edge, const ChainEdge& next,
                                   const Rational& distance, double limit) {
  const auto inside_out = [&](const ChainEdge& e) {
    return sgn(e.radius) > 0 && e.radius <= distance;
  };
  if (inside_out(edge) || inside_out(next)) return {};
  const RawPiece before = raw_edge(edge, distance).value();
  const RawPiece behind = raw_edge(next, distance).value();
  const CoarsePoint corner = spot(edge.to);
  const auto far = [&](const ExactPoint& p) {
    return std::hypot(nearest_double(p.x) - corner.x, nearest_double(p.y) - corner.y);
  };
  const auto places = cgal::support_crossings(before, behind);
  if (places.empty()) return {};
  const ExactPoint& exact = *std::ranges::min_element(places, {}, far);
  // A short arc is known worse than its ends by the square of how often it goes into its radius.
  constexpr int kFiner = -(kStandInBits + 64);
  const RationalPoint at{rational_within(exact.x, kFiner), rational_within(exact.y, kFiner)};
  if (at == before.to || at == behind.from) return {};
  if (!is_ahead(spot(at), spot(before.to), spot(turned_right(edge.end.vector())), spot(behind.from),
                spot(turned_right(next.start.vector())), corner, limit * distance.get_d()))
    return {};
  RawPiece last = prolonged(next, behind.from, next.start, at);
  std::swap(last.from, last.to);
  return {prolonged(edge, before.to, edge.end, at), last};
}

}  // namespace

bool is_ahead(CoarsePoint at, CoarsePoint from, CoarsePoint before, CoarsePoint to,
              CoarsePoint behind, CoarsePoint corner, double limit) {
  constexpr double kRoom = 1 + 1e-12;
  return (at.x - from.x) * before.x + (at.y - from.y) * before.y > 0 &&
         (to.x - at.x) * behind.x + (to.y - at.y) * behind.y > 0 &&
         std::hypot(at.x - corner.x, at.y - corner.y) <= limit * kRoom;
}

std::vector<RawPiece> raw_corner(const ChainEdge& edge, const ChainEdge& next,
                                 const Rational& distance, const OffsetOptions& options) {
  if (edge.end == next.start || sgn(distance) == 0) return {};
  const bool left = sgn(cross(edge.end.vector(), next.start.vector())) > 0;
  std::vector<RawPiece> parts;
  if (!left && options.corner == OffsetCorner::Sharp)
    parts = sharp_corner(edge, next, distance, options.spike_limit);
  if (!left && options.corner == OffsetCorner::Chamfer) parts = chamfer(edge, next, distance);
  if (!parts.empty()) return parts;
  RawPiece piece;
  piece.from = moved(edge.to, edge.end, distance);
  piece.to = moved(edge.to, next.start, distance);
  piece.is_line = false;
  piece.centre = edge.to;
  piece.squared_radius = distance * distance;
  piece.counter_clockwise = left;
  return {piece};
}

std::optional<RawPiece> raw_edge(const ChainEdge& edge, const Rational& distance) {
  if (edge.radius == distance && !edge.is_line()) return std::nullopt;
  RawPiece piece;
  piece.from = moved(edge.from, edge.start, distance);
  piece.to = moved(edge.to, edge.end, distance);
  piece.is_line = edge.is_line();
  if (!piece.is_line) {
    const Rational radius = edge.radius - distance;
    piece.centre = edge.centre();
    piece.squared_radius = radius * radius;
    // The normal turns the same way whatever the offset does to the radius.
    piece.counter_clockwise = sgn(edge.radius) > 0;
  }
  return piece;
}

std::vector<RawPiece> raw_curve(const std::vector<Chain>& loops, const Rational& distance,
                                const OffsetOptions& options) {
  std::vector<RawPiece> raw;
  std::uint32_t index = 0;
  for (const Chain& loop : loops) {
    DGT_CHECK(loop.closed && !loop.edges.empty());
    for (std::size_t i = 0; i < loop.edges.size(); ++i) {
      const ChainEdge& edge = loop.edges[i];
      const ChainEdge& next = loop.edges[(i + 1) % loop.edges.size()];
      DGT_CHECK(edge.to == next.from);
      std::uint32_t part = 0;
      const auto add = [&](RawPiece piece) {
        piece.key = RawKey(index, part++);
        raw.push_back(std::move(piece));
      };
      if (auto piece = raw_edge(edge, distance)) add(*std::move(piece));
      part = 1;
      for (RawPiece& piece : raw_corner(edge, next, distance, options)) add(std::move(piece));
      ++index;
    }
  }
  return raw;
}

// The loop of the largest area is an outermost one; doubles tell its sense, since its area is far
// from 0 wherever there is a region at all.
int number_of_region(const std::vector<Chain>& loops) {
  double largest = 0;
  for (const Chain& loop : loops) {
    const double a = area(loop);
    if (std::fabs(a) > std::fabs(largest)) largest = a;
  }
  return largest < 0 ? 0 : 1;
}

void drop_void_loops(std::vector<OffsetLoop>& result, const std::vector<Chain>& loops,
                     const Rational& distance) {
  const bool voids = may_have_voids(loops, distance);
  std::erase_if(result, [&](const OffsetLoop& loop) {
    if (is_sliver(loop)) return true;
    return voids && !keeps_distance(loops, point_inside(loop.pieces.front()), distance);
  });
}

void tidy(OffsetLoop& loop) {
  merge_pieces(loop);  // the parts of a small arc are smaller than it
  drop_minute_pieces(loop);
  merge_pieces(loop);
}

std::vector<Chain> reversed(const std::vector<Chain>& loops) {
  std::vector<Chain> result;
  for (const Chain& loop : loops) result.push_back(reversed(loop));
  return result;
}

void reverse_loops(std::vector<OffsetLoop>& loops) {
  for (OffsetLoop& loop : loops) {
    std::reverse(loop.pieces.begin(), loop.pieces.end());
    for (OffsetPiece& piece : loop.pieces) {
      std::swap(piece.from, piece.to);
      piece.radius = -piece.radius;
    }
  }
}

bool keeps_distance(const std::vector<Chain>& loops, const RationalPoint& p,
                    const Rational& distance) {
  // Stand-ins are off by 2⁻⁹⁶ of their size: a contact may look like a touch of that depth.
  const Rational reach = distance - power_of_two(kContactExponent);
  const Rational square = reach * reach;
  const auto edge_away = [&](const ChainEdge& e) {
    if (squared_length(p - e.from) < square || squared_length(p - e.to) < square) return false;
    if (e.is_line()) {
      const Vector w = e.to - e.from;
      const Rational along = dot(p - e.from, w);
      const Rational length = squared_length(w);
      if (sgn(along) <= 0 || along >= length) return true;
      const Rational off = cross(w, p - e.from);
      return off * off >= square * length;
    }
    const RationalPoint c = e.centre();
    const Vector v = p - c;
    Vector u = e.from - c;
    Vector t = e.to - c;
    if (sgn(e.radius) < 0) std::swap(u, t);
    const bool after = sgn(cross(u, v)) >= 0;
    const bool before = sgn(cross(v, t)) >= 0;
    const bool short_arc = sgn(cross(u, t)) >= 0;
    if (!(short_arc ? after && before : after || before)) return true;
    const Rational r = abs(e.radius);
    const Rational from_centre = squared_length(v);
    const Rational inner = r - reach;
    return from_centre >= (r + reach) * (r + reach) ||
           (sgn(inner) > 0 && from_centre <= inner * inner);
  };
  for (const Chain& loop : loops) {
    if (!std::all_of(loop.edges.begin(), loop.edges.end(), edge_away)) return false;
  }
  return true;
}

double area(const OffsetLoop& loop) {
  // Shoelace about the first vertex, so that nothing cancels, plus the segments between arcs and
  // chords: r²(θ − sin θ)/2.
  const double x0 = loop.pieces.front().from.x();
  const double y0 = loop.pieces.front().from.y();
  double sum = 0;
  for (const OffsetPiece& p : loop.pieces) {
    const Point& from = p.from;
    const Point& to = p.to;
    sum += (from.x() - x0) * (to.y() - y0) - (from.y() - y0) * (to.x() - x0);
    if (p.is_line) continue;
    const double r = nearest_double(p.radius);
    const double theta =
        coarse_sweep(Circle(p.centre, p.radius), from, to) * std::numbers::pi / 180;
    sum += r * r * (theta - std::sin(theta));
  }
  return sum / 2;
}

double area(const Chain& closed) {
  const auto coarse = [](const Rational& value) { return static_cast<double>(Ball(value).mid); };
  const double x0 = coarse(closed.edges.front().from.x);
  const double y0 = coarse(closed.edges.front().from.y);
  double sum = 0;
  for (const ChainEdge& e : closed.edges) {
    const double ax = coarse(e.from.x) - x0;
    const double ay = coarse(e.from.y) - y0;
    const double bx = coarse(e.to.x) - x0;
    const double by = coarse(e.to.y) - y0;
    sum += ax * by - ay * bx;
    if (e.is_line()) continue;
    const double r = coarse(e.radius);
    const double theta =
        2 * std::asin(std::min(1.0, std::hypot(bx - ax, by - ay) / (2 * std::fabs(r))));
    sum += (r > 0 ? 1 : -1) * r * r * (theta - std::sin(theta));
  }
  return sum / 2;
}

double length(const OffsetLoop& loop) {
  double sum = 0;
  for (const OffsetPiece& p : loop.pieces) {
    const Point& from = p.from;
    const Point& to = p.to;
    if (p.is_line) {
      sum += std::hypot(to.x() - from.x(), to.y() - from.y());
    } else {
      sum += std::fabs(coarse_sweep(Circle(p.centre, p.radius), from, to) * std::numbers::pi / 180 *
                       nearest_double(p.radius));
    }
  }
  return sum;
}

}  // namespace dgt
