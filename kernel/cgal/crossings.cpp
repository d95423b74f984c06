// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/cgal/crossings.h"

#include <utility>
#include <vector>

#include "kernel/cgal/types.h"

namespace dgt::cgal {
namespace {

CircularKernel::Line_2 to_cgal(const Line& line) {
  return {line.normal().x(), line.normal().y(), Rational(-line.p())};
}

CircularKernel::Circle_2 to_cgal(const Circle& circle) {
  return {CircularKernel::Point_2(circle.centre().x, circle.centre().y),
          Rational(circle.radius() * circle.radius())};
}

using Met = std::pair<CircularKernel::Circular_arc_point_2, unsigned>;

/// CGAL lists the points in lexicographic order, each with its multiplicity.
template <class A, class B>
std::vector<Met> met(const A& a, const B& b) {
  std::vector<CGAL::Object> objects;
  CGAL::intersection(to_cgal(a), to_cgal(b), std::back_inserter(objects));
  std::vector<Met> points;
  for (const auto& object : objects) {
    Met m;
    if (CGAL::assign(m, object)) points.push_back(m);
  }
  return points;
}

ExactPoint to_point(const Met& m) { return {from_cgal(m.first.x()), from_cgal(m.first.y())}; }

template <class A, class B>
std::array<ExactPoint, 2> both(const A& a, const B& b) {
  const std::vector<Met> points = met(a, b);
  DGT_CHECK(points.size() == 2);
  return {to_point(points[0]), to_point(points[1])};
}

}  // namespace

std::array<ExactPoint, 2> crossings(const Line& line, const Circle& circle) {
  return both(line, circle);
}
std::array<ExactPoint, 2> crossings(const Circle& a, const Circle& b) { return both(a, b); }
int crossing_count(const Line& line, const Circle& circle) {
  return static_cast<int>(met(line, circle).size());
}
int crossing_count(const Circle& a, const Circle& b) { return static_cast<int>(met(a, b).size()); }

}  // namespace dgt::cgal
