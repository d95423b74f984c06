// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "kernel/enclosed.h"

/// Pieces of a raw curve in one precision, and where two of them cross. Internal to the kernel.
namespace dgt {

/// A segment, or an arc of at most half a turn.
template <class Real>
struct Strand {
  EnclosedVector<Real> from, to;
  EnclosedVector<Real> centre;  ///< of an arc
  Enclosed<Real> radius;        ///< of an arc, not negative
  bool is_line = true;
  bool counter_clockwise = true;
};

/// A place where two strands cross. Positions are numbers that rise along a strand: the projection
/// on its chord, times the chord. On arcs of at most half a turn it is monotone.
template <class Real>
struct Crossing {
  EnclosedVector<Real> at;
  std::array<Enclosed<Real>, 2> position;  ///< on the first strand, on the second
  /// +1 where the second strand passes from the right of the first to its left.
  int turn = 0;
};

/// Where two strands cross inside both, or that this precision cannot tell.
template <class Real>
struct Crossings {
  bool decided = true;
  int count = 0;
  std::array<Crossing<Real>, 2> found;

  void add(const Crossing<Real>& crossing) { found[static_cast<std::size_t>(count++)] = crossing; }
};

namespace crossing {

template <class Real>
Crossings<Real> undecided() {
  Crossings<Real> result;
  result.decided = false;
  return result;
}

/// Of two enclosures of one number.
template <class Real>
const Enclosed<Real>& finer(const Enclosed<Real>& a, const Enclosed<Real>& b) {
  return a.rad < b.rad ? a : b;
}

/// A place on an arc's circle, against its chord: that parts the circle, and the arc is what lies
/// to the right of it when it turns to the left.
template <class Real>
class OnCircle {
 public:
  /// The place base + k u, seen from where the arc begins. Where two curves all but touch, k is
  /// known far worse than the rest, and matters little where u is square to what is asked: then it
  /// is multiplied last. Elsewhere the place itself is the smaller number.
  OnCircle(const Strand<Real>& arc, const EnclosedVector<Real>& base, const Enclosed<Real>& k,
           const EnclosedVector<Real>& u) {
    const EnclosedVector<Real> chord = arc.to - arc.from;
    const EnclosedVector<Real> out = base + k * u;
    const int side = finer(cross(chord, base) + k * cross(chord, u), cross(chord, out)).sign();
    on_arc_ = arc.counter_clockwise ? -side : side;
    position_ = finer(dot(chord, base) + k * dot(chord, u), dot(chord, out));
  }
  /// +1 when it surely lies on the arc, −1 when surely not.
  [[nodiscard]] int on_arc() const { return on_arc_; }
  [[nodiscard]] const Enclosed<Real>& position() const { return position_; }

 private:
  Enclosed<Real> position_;
  int on_arc_;
};
template <class Real>
int on_arc(const Strand<Real>& arc, const EnclosedVector<Real>& at) {
  const int side = cross(arc.to - arc.from, at - arc.from).sign();
  return arc.counter_clockwise ? -side : side;
}

template <class Real>
Crossings<Real> of_lines(const Strand<Real>& a, const Strand<Real>& b) {
  const EnclosedVector<Real> u = a.to - a.from;
  const EnclosedVector<Real> w = b.from - a.from;
  const Enclosed<Real> b_from = cross(u, w);
  const Enclosed<Real> b_to = cross(u, b.to - a.from);
  const int b0 = b_from.sign();
  const int b1 = b_to.sign();
  if (b0 * b1 > 0) return {};
  const EnclosedVector<Real> v = b.to - b.from;
  const Enclosed<Real> a_from = cross(w, v);
  const Enclosed<Real> a_to = cross(v, a.to - b.from);
  const int a0 = a_from.sign();
  const int a1 = a_to.sign();
  if (a0 * a1 > 0) return {};
  if (a0 * a1 * b0 * b1 == 0) return undecided<Real>();
  const Enclosed<Real> fall = a_from - a_to;
  const Enclosed<Real> rise = b_from - b_to;
  if (fall.sign() == 0 || rise.sign() == 0) return undecided<Real>();
  const Enclosed<Real> t = a_from / fall;
  Crossings<Real> result;
  result.add({a.from + t * u, {t * dot(u, u), b_from / rise * dot(v, v)}, b1});
  return result;
}

/// With u along the line, c from its beginning to the centre and h = u × c, the line meets the
/// circle at (u·c ± √(r²u² − h²)) / u² of its length, entering it first.
template <class Real>
Crossings<Real> of_line_and_arc(const Strand<Real>& line, const Strand<Real>& arc) {
  const EnclosedVector<Real> u = line.to - line.from;
  const EnclosedVector<Real> c = arc.centre - line.from;
  const Enclosed<Real> h = cross(u, c);
  const Enclosed<Real> square = dot(u, u);
  const Enclosed<Real> reach = arc.radius * arc.radius * square - h * h;
  const int meets = reach.sign();
  if (meets < 0) return {};
  if (square.sign() <= 0) return undecided<Real>();
  const Enclosed<Real> foot = dot(u, c);
  Crossings<Real> result;
  const auto within = [&](const Enclosed<Real>& t) {
    const int behind = t.sign();
    const int before = (square - t).sign();
    return behind < 0 || before < 0 ? -1 : behind > 0 && before > 0 ? 1 : 0;
  };
  if (meets == 0) {
    // In contact or nearly so. It matters only where both are: all that may be met lies within the
    // largest root that the reach allows.
    Enclosed<Real> t = foot;
    t.rad += std::sqrt(reach.size() + reach.rad) * kUp;
    if (within(t) < 0 || on_arc(arc, line.from + (t / square) * u) < 0) return {};
    return undecided<Real>();
  }
  const Enclosed<Real> half = root(reach);
  for (const int way : {-1, 1}) {
    const Enclosed<Real> t = way < 0 ? foot - half : foot + half;
    const int on_line = within(t);
    if (on_line < 0) continue;
    const Enclosed<Real> k = t / square;
    const OnCircle<Real> place(arc, line.from - arc.from, k, u);
    if (place.on_arc() < 0) continue;
    if (place.on_arc() == 0 || on_line == 0) return undecided<Real>();
    // Where the line leaves the circle, a counter-clockwise arc passes from its right to its left.
    result.add({line.from + k * u, {t, place.position()}, arc.counter_clockwise ? way : -way});
  }
  return result;
}

/// Arcs of nearly the same circle, which no root can part: they are apart when neither holds an end
/// of the other, all ends taken within the distance of the two circles.
template <class Real>
bool apart_on_one_circle(const Strand<Real>& a, const Strand<Real>& b, double distance) {
  const auto holds = [distance](const Strand<Real>& arc, EnclosedVector<Real> end) {
    end.rad += distance;
    return on_arc(arc, end) >= 0;
  };
  return !holds(a, b.from) && !holds(a, b.to) && !holds(b, a.from) && !holds(b, a.to);
}

/// With v from the first centre to the second, the circles meet at k v ± s v⊥ from the first, where
/// 2 k v² = v² + (r₁ − r₂)(r₁ + r₂) and 4 s²v⁴ = ((r₁ + r₂)² − v²)(v² − (r₁ − r₂)²).
template <class Real>
Crossings<Real> of_arcs(const Strand<Real>& a, const Strand<Real>& b) {
  const EnclosedVector<Real> v = b.centre - a.centre;
  const Enclosed<Real> square = dot(v, v);
  const Enclosed<Real> sum = a.radius + b.radius;
  const Enclosed<Real> outside = sum * sum - square;
  const int nearer = outside.sign();
  if (nearer < 0) return {};
  const Enclosed<Real> difference = a.radius - b.radius;
  const Enclosed<Real> inside = square - difference * difference;
  const int farther = inside.sign();
  if (farther < 0) return {};
  const EnclosedVector<Real> left = turned_left(v);
  if (square.sign() > 0) {
    const Enclosed<Real> half_inverse = Enclosed<Real>{Real(0.5), 0} / square;
    const EnclosedVector<Real> foot = (half_inverse * (square + difference * sum)) * v;
    const Enclosed<Real> reach = outside * inside;
    if (nearer > 0 && farther > 0 && reach.sign() > 0) {
      const Enclosed<Real> off = root(reach) * half_inverse;
      const EnclosedVector<Real> middle = a.centre + foot;
      Crossings<Real> result;
      const int senses = a.counter_clockwise == b.counter_clockwise ? 1 : -1;
      for (const int way : {-1, 1}) {
        const Enclosed<Real> k = way < 0 ? -off : off;
        const OnCircle<Real> on_a(a, middle - a.from, k, left);
        if (on_a.on_arc() < 0) continue;
        const OnCircle<Real> on_b(b, middle - b.from, k, left);
        if (on_b.on_arc() < 0) continue;
        if (on_a.on_arc() == 0 || on_b.on_arc() == 0) return undecided<Real>();
        result.add({middle + k * left, {on_a.position(), on_b.position()}, way * senses});
      }
      return result;
    }
    // In contact or nearly so: see above.
    EnclosedVector<Real> near = a.centre + foot;
    near.rad += std::sqrt(reach.size() + reach.rad) * (half_inverse.size() + half_inverse.rad) *
                left.size() * kUp;
    if (on_arc(a, near) < 0 || on_arc(b, near) < 0) return {};
  }
  const double distance = (v.size() + 2 * v.rad + difference.size() + difference.rad) * kUp;
  if (apart_on_one_circle(a, b, distance)) return {};
  return undecided<Real>();
}

/// Where the lines and circles that carry two strands cross, as far as that is certain.
template <class Real>
std::vector<EnclosedVector<Real>> of_supports(const Strand<Real>& a, const Strand<Real>& b) {
  if (b.is_line && !a.is_line) return of_supports(b, a);
  const Enclosed<Real> half{Real(0.5), 0};
  if (a.is_line) {
    const EnclosedVector<Real> u = a.to - a.from;
    if (b.is_line) {
      const EnclosedVector<Real> v = b.to - b.from;
      const Enclosed<Real> turn = cross(u, v);
      if (turn.sign() == 0) return {};
      return {a.from + (cross(b.from - a.from, v) / turn) * u};
    }
    const EnclosedVector<Real> c = b.centre - a.from;
    const Enclosed<Real> square = dot(u, u);
    const Enclosed<Real> h = cross(u, c);
    const Enclosed<Real> reach = b.radius * b.radius * square - h * h;
    if (reach.sign() <= 0) return {};
    const Enclosed<Real> foot = dot(u, c);
    const Enclosed<Real> way = root(reach);
    return {a.from + ((foot - way) / square) * u, a.from + ((foot + way) / square) * u};
  }
  const EnclosedVector<Real> v = b.centre - a.centre;
  const Enclosed<Real> square = dot(v, v);
  const Enclosed<Real> sum = a.radius + b.radius;
  const Enclosed<Real> difference = a.radius - b.radius;
  const Enclosed<Real> outside = sum * sum - square;
  const Enclosed<Real> inside = square - difference * difference;
  if (square.sign() <= 0 || outside.sign() <= 0 || inside.sign() <= 0) return {};
  const Enclosed<Real> inverse = half / square;
  const EnclosedVector<Real> foot = a.centre + (inverse * (square + difference * sum)) * v;
  const EnclosedVector<Real> off = (root(outside * inside) * inverse) * turned_left(v);
  return {foot - off, foot + off};
}

}  // namespace crossing

/// Where the strands cross, in the order met along a line or, of two arcs, from the right of the
/// line of their centres to its left.
template <class Real>
[[nodiscard]] Crossings<Real> cross(const Strand<Real>& a, const Strand<Real>& b) {
  if (a.is_line) {
    return b.is_line ? crossing::of_lines(a, b) : crossing::of_line_and_arc(a, b);
  }
  if (!b.is_line) return crossing::of_arcs(a, b);
  Crossings<Real> result = crossing::of_line_and_arc(b, a);
  for (Crossing<Real>& c : result.found) {
    c.turn = -c.turn;
    std::swap(c.position[0], c.position[1]);
  }
  return result;
}

}  // namespace dgt
