// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/chain.h"

#include <algorithm>

#include "kernel/check.h"

namespace dgt {
namespace {

/// The point on the ideal arc of `bulge` half way between its ends, exactly: the sagitta is bulge
/// times half the chord, to the right of a counter-clockwise arc.
RationalPoint middle_of_arc(const RationalPoint& from, const RationalPoint& to,
                            const Rational& bulge) {
  const Vector w = to - from;
  return from + Rational(1, 2) * w + (bulge / 2) * turned_right(w);
}

/// A rational tan(a/2) near the bulge tan a: the bulge of half the arc.
Rational half_bulge(const Rational& bulge, int bits) {
  const Rational root = sqrt_within(1 + bulge * bulge, -(bits + 8));
  return on_dyadic_grid(bulge / (1 + root), -(bits + 8));
}

void add_edge(Chain& chain, const RationalPoint& from, const RationalPoint& to,
              const Rational& bulge) {
  if (sgn(bulge) == 0 || abs(bulge) < power_of_two(kStraightBulgeExponent)) {
    chain.edges.push_back(segment(from, to));
  } else if (abs(bulge) <= 1) {
    chain.edges.push_back(arc(from, to, bulge));
  } else {
    const RationalPoint middle = middle_of_arc(from, to, bulge);
    const Rational half = half_bulge(bulge, kStandInBits);
    add_edge(chain, from, middle, half);
    add_edge(chain, middle, to, half);
  }
}

}  // namespace

ChainEdge segment(const RationalPoint& from, const RationalPoint& to) {
  const Vector w = to - from;
  DGT_CHECK(sgn(w.x) != 0 || sgn(w.y) != 0);
  const UnitVector normal = turned_left(direction_of(w).unit);
  return {from, to, normal, normal, 0};
}

ChainEdge arc(const RationalPoint& from, const RationalPoint& to, const Rational& bulge, int bits) {
  DGT_CHECK(sgn(bulge) != 0);
  const Vector w = to - from;
  DGT_CHECK(sgn(w.x) != 0 || sgn(w.y) != 0);
  // The tangent at the beginning is the chord turned by −sweep/2, whose half tangent is −bulge: the
  // angle doubles in (1 − b², −2b).
  const Vector turn{1 - bulge * bulge, -2 * bulge};
  const Vector tangent{turn.x * w.x - turn.y * w.y, turn.x * w.y + turn.y * w.x};
  const UnitVector start = turned_left(direction_of(tangent, bits).unit);
  const Rational along = dot(w, start.vector());
  DGT_CHECK(sgn(along) == sgn(bulge));
  const Rational square = squared_length(w);
  // |from + r n − to| = |r| gives r = |w|²/(2 w·n); the other normal is n mirrored in the chord's
  // perpendicular: n − 2 (w·n) w/|w|².
  const Rational radius = square / (2 * along);
  const UnitVector end(start.vector() - (2 * along / square) * w);
  return {from, to, start, end, radius};
}

Rational bulge_of(const Circle& circle, const RationalPoint& from, const RationalPoint& to,
                  int exponent) {
  const Vector w = to - from;
  const Rational square = squared_length(w);
  DGT_CHECK(sgn(square) > 0);
  // Arcs of nearly a whole turn lose as many bits as the chord is shorter than the radius: twice
  // those of the chord's size cover that.
  const int size = static_cast<int>(mpz_sizeinbase(square.get_den_mpz_t(), 2)) -
                   static_cast<int>(mpz_sizeinbase(square.get_num_mpz_t(), 2));
  const Rational chord = sqrt_within(square, exponent - 16 - 2 * std::max(size, 0));
  return square / (2 * (circle.radius() * chord + cross(w, circle.centre() - from)));
}

std::optional<Chain> chain_of(const std::vector<BulgeVertex>& vertices, bool closed) {
  std::vector<BulgeVertex> distinct;
  for (const BulgeVertex& v : vertices) {
    if (!distinct.empty() && distinct.back().at == v.at)
      distinct.back().bulge = v.bulge;
    else
      distinct.push_back(v);
  }
  if (closed && distinct.size() > 1 && distinct.back().at == distinct.front().at)
    distinct.pop_back();
  if (distinct.size() < 2) return std::nullopt;
  Chain chain;
  chain.closed = closed;
  const std::size_t edges = closed ? distinct.size() : distinct.size() - 1;
  for (std::size_t i = 0; i < edges; ++i) {
    add_edge(chain, distinct[i].at, distinct[(i + 1) % distinct.size()].at, distinct[i].bulge);
  }
  return chain;
}

ChainEdge reversed(const ChainEdge& e) { return {e.to, e.from, -e.end, -e.start, -e.radius}; }

Chain reversed(const Chain& chain) {
  Chain result;
  result.closed = chain.closed;
  for (auto it = chain.edges.rbegin(); it != chain.edges.rend(); ++it)
    result.edges.push_back(reversed(*it));
  return result;
}

}  // namespace dgt
