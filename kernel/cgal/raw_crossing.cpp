// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/cgal/raw_crossing.h"

#include "kernel/cgal/types.h"

namespace dgt::cgal {
namespace {

CircularKernel::Point_2 to_cgal(const RationalPoint& p) { return {p.x, p.y}; }
CircularKernel::Line_2 line_of(const RawPiece& p) { return {to_cgal(p.from), to_cgal(p.to)}; }
CircularKernel::Circle_2 circle_of(const RawPiece& p) {
  return {to_cgal(p.centre), p.squared_radius};
}

template <class A, class B>
std::vector<ExactPoint> met(const A& a, const B& b) {
  std::vector<CGAL::Object> objects;
  CGAL::intersection(a, b, std::back_inserter(objects));
  std::vector<ExactPoint> points;
  for (const auto& object : objects) {
    std::pair<CircularKernel::Circular_arc_point_2, unsigned> m;
    if (CGAL::assign(m, object))
      points.emplace_back(from_cgal(m.first.x()), from_cgal(m.first.y()));
  }
  return points;
}

}  // namespace

std::vector<ExactPoint> support_crossings(const RawPiece& a, const RawPiece& b) {
  if (a.is_line && b.is_line) {
    const Vector u = a.to - a.from;
    const Vector v = b.to - b.from;
    const Rational det = cross(u, v);
    if (sgn(det) == 0) return {};
    const Rational t = cross(b.from - a.from, v) / det;
    return {ExactPoint(a.from + t * u)};
  }
  if (a.is_line) return met(line_of(a), circle_of(b));
  if (b.is_line) return met(line_of(b), circle_of(a));
  return met(circle_of(a), circle_of(b));
}

}  // namespace dgt::cgal
