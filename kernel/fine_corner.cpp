// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/fine_corner.h"

#include <cmath>

namespace dgt {
namespace {

using Fine = DoubleDouble;

Strand<Fine> segment_between(const EnclosedVector<Fine>& from, const EnclosedVector<Fine>& to) {
  Strand<Fine> s;
  s.from = from;
  s.to = to;
  return s;
}

CoarsePoint spot(const EnclosedVector<Fine>& v) { return {v.x.hi, v.y.hi}; }

}  // namespace

std::vector<Strand<Fine>> fine_chamfer(const EnclosedEdge<Fine>& e, const EnclosedEdge<Fine>& next,
                                       const Enclosed<Fine>& d) {
  const Enclosed<Fine> cosine = dot(e.end, next.start);
  if (cosine.mid.hi < -0.999999) return {};
  const EnclosedVector<Fine> sum = e.end + next.start;
  const Enclosed<Fine> one{1.0, 0};
  EnclosedVector<Fine> m = (one / root(dot(sum, sum))) * sum;
  m.rad += kStandIn;
  const auto touch = [&](const EnclosedVector<Fine>& n) {
    return e.to + (d / (one + dot(n, m))) * (n + m);
  };
  const auto begin = touch(e.end);
  const auto end = touch(next.start);
  return {segment_between(e.to + d * e.end, begin), segment_between(begin, end),
          segment_between(end, e.to + d * next.start)};
}

std::vector<Strand<Fine>> fine_sharp_corner(const EnclosedEdge<Fine>& e,
                                            const EnclosedEdge<Fine>& next, const Enclosed<Fine>& d,
                                            double limit) {
  const auto inside_out = [&](const EnclosedEdge<Fine>& edge) {
    return edge.radius.mid.hi > 0 && (edge.radius - d).sign() <= 0;
  };
  if (inside_out(e) || inside_out(next)) return {};
  Strand<Fine> before = moved(e, e.start, d);
  Strand<Fine> behind = moved(next, next.start, d);
  const CoarsePoint corner = spot(e.to);
  const EnclosedVector<Fine>* nearest = nullptr;
  const auto far = [&](const EnclosedVector<Fine>& p) {
    return std::hypot(p.x.hi - corner.x, p.y.hi - corner.y);
  };
  const auto places = crossing::of_supports(before, behind);
  for (const EnclosedVector<Fine>& p : places)
    if (!nearest || far(p) < far(*nearest)) nearest = &p;
  if (!nearest ||
      !is_ahead(spot(*nearest), spot(before.to), spot(-turned_left(e.end)), spot(behind.from),
                spot(-turned_left(next.start)), corner, limit * d.mid.hi))
    return {};
  before.from = before.to;
  before.to = *nearest;
  behind.to = behind.from;
  behind.from = *nearest;
  return {before, behind};
}

}  // namespace dgt
