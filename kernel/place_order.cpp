// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/place_order.h"

#include <cmath>

namespace dgt {
namespace {

struct BallPlace {
  Ball x, y;
};

BallPlace around(const Point& p) { return {dgt::around(p.x()), dgt::around(p.y())}; }

/// sign(p + q√e) for p, q in one field Q(√c): exact by comparing squares.
int sign_over(const OneRoot& p, const OneRoot& q, const Rational& e) {
  const int sp = sign(p);
  const int sq = sgn(e) == 0 ? 0 : sign(q);
  if (sp == 0 || sp == sq) return sq;
  if (sq == 0) return sp;
  const Rational& c = p.is_rational() ? q.c : p.c;
  const OneRoot difference{p.a * p.a + p.b * p.b * c - (q.a * q.a + q.b * q.b * c) * e,
                           2 * (p.a * p.b - q.a * q.b * e), c};
  return sp * sign(difference);  // |p| against |q|√e
}

/// The root that both coordinates are made over.
const Rational& root_of(const ExactPoint& p) { return p.x.is_rational() ? p.y.c : p.x.c; }

/// The factor of the root; a rational number may carry any.
Rational factor(const OneRoot& n) { return n.is_rational() ? Rational(0) : n.b; }

}  // namespace

Ball around(double coordinate) {
  return {coordinate, static_cast<long double>(std::fabs(coordinate)) * 0x1p-52L +
                          std::ldexp(1.0L, kZeroExponent)};
}

namespace stages {

int exact_turn_about(const RationalPoint& c, const ExactPoint& a, const ExactPoint& b) {
  const Vector u{a.x.a - c.x, a.y.a - c.y};
  const Vector v{b.x.a - c.x, b.y.a - c.y};
  const Vector u_root{factor(a.x), factor(a.y)};
  const Vector v_root{factor(b.x), factor(b.y)};
  const OneRoot p{cross(u, v), cross(u_root, v), root_of(a)};
  const OneRoot q{cross(u, v_root), cross(u_root, v_root), root_of(a)};
  return sign_over(p, q, root_of(b));
}

int exact_compare_distance(const ExactPoint& a, const ExactPoint& b, const Rational& square) {
  // a − b = u + v√c − w√e, squared and sorted by the roots.
  const Vector u{a.x.a - b.x.a, a.y.a - b.y.a};
  const Vector v{factor(a.x), factor(a.y)};
  const Vector w{factor(b.x), factor(b.y)};
  const Rational& c = root_of(a);
  const Rational& e = root_of(b);
  const Rational plain = squared_length(u) + squared_length(v) * c + squared_length(w) * e - square;
  return sign_over({plain, 2 * dot(u, v), c}, {-2 * dot(u, w), -2 * dot(v, w), c}, e);
}

}  // namespace stages

int turn_about(const RationalPoint& c, const Point& a, const Point& b) {
  const BallPlace pa = around(a);
  const BallPlace pb = around(b);
  const Ball cx(c.x);
  const Ball cy(c.y);
  const Ball turn = (pa.x - cx) * (pb.y - cy) - (pa.y - cy) * (pb.x - cx);
  if (const auto certain = turn.sign()) return *certain;
  return stages::exact_turn_about(c, a.exact(), b.exact());
}

int turn_about(const RationalPoint& c, const Point& a, const Vector& v) {
  const BallPlace p = around(a);
  const Ball turn = (p.x - Ball(c.x)) * Ball(v.y) - (p.y - Ball(c.y)) * Ball(v.x);
  if (const auto certain = turn.sign()) return *certain;
  const ExactPoint exact = a.exact();
  return sign(combine(v.y, exact.x, -v.x, exact.y, c.y * v.x - c.x * v.y));
}

int order_along(const Vector& d, const Point& a, const Point& b) {
  const BallPlace pa = around(a);
  const BallPlace pb = around(b);
  const Ball way = Ball(d.x) * (pb.x - pa.x) + Ball(d.y) * (pb.y - pa.y);
  if (const auto certain = way.sign()) return *certain;
  const ExactPoint ea = a.exact();
  const ExactPoint eb = b.exact();
  return compare(combine(d.x, eb.x, d.y, eb.y, 0), combine(d.x, ea.x, d.y, ea.y, 0));
}

int order_along(const Vector& d, const Rational& along, const Point& b) {
  const BallPlace p = around(b);
  const Ball way = Ball(d.x) * p.x + Ball(d.y) * p.y - Ball(along);
  if (const auto certain = way.sign()) return *certain;
  const ExactPoint exact = b.exact();
  return sign(combine(d.x, exact.x, d.y, exact.y, -along));
}

int compare_distance(const Point& a, const Point& b, const Rational& square) {
  const BallPlace pa = around(a);
  const BallPlace pb = around(b);
  const Ball dx = pa.x - pb.x;
  const Ball dy = pa.y - pb.y;
  if (const auto certain = (dx * dx + dy * dy - Ball(square)).sign()) return *certain;
  return stages::exact_compare_distance(a.exact(), b.exact(), square);
}

int compare_distance(const Point& a, const RationalPoint& b, const Rational& square) {
  const BallPlace p = around(a);
  const Ball dx = p.x - Ball(b.x);
  const Ball dy = p.y - Ball(b.y);
  if (const auto certain = (dx * dx + dy * dy - Ball(square)).sign()) return *certain;
  return stages::exact_compare_distance(a.exact(), ExactPoint(b), square);
}

}  // namespace dgt
