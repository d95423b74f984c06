// SPDX-License-Identifier: GPL-3.0-or-later
// The formulas are those of strand.h. Bounds, with u = 2⁻⁵³ and a name's error written e_name:
//
//  * A difference of two coordinates good to e is good to 2 e and u of itself.
//  * |a × b| and |a · b| of vectors with 1-norms A, B, components good to e_a, e_b: A e_b + B e_a +
//    2 e_a e_b by propagation, 3 u A B by rounding. Where e_a ≤ A/256 (it is asked for) the second
//    order is below a hundredth of the first: kMore covers it.
//  * √x for x > e_x: e_x/√x and u √x.
//  * p/q: (e_p + |p/q| e_q)/q, and kMore where e_q ≤ q/128.
//
// Roundings of the bounds themselves are a few units in 2⁵³ and drown in kMore. Nothing underflows
// that matters: lengths are above 2⁻⁶⁰ or fail the asking.
#include "kernel/quick_crossing.h"

#include <cmath>

namespace dgt::quick {
namespace {

constexpr double kMore = 1.02;
constexpr double kRound = 0x1p-51;

struct Span {  ///< a chord, or a way between two points
  double x, y;
  double size;  ///< 1-norm
  double rad;   ///< of a component

  Span(double x_, double y_, double ends_rad)
      : x(x_), y(y_), size(std::fabs(x) + std::fabs(y)), rad(ends_rad + kRound * size) {}
  [[nodiscard]] bool is_sound() const { return 256 * rad <= size; }
};

Span chord(const RawCurve& curve, std::uint32_t i) {
  return {curve[i + 1].x - curve[i].x, curve[i + 1].y - curve[i].y, 2.0 * curve[i].ends_rad};
}

double wedge(const Span& a, const Span& b) { return a.x * b.y - a.y * b.x; }
double dot(const Span& a, const Span& b) { return a.x * b.x + a.y * b.y; }
/// Of a cross or dot product; one of the two is sound.
double product_rad(const Span& a, const Span& b) {
  return kMore * (a.size * b.rad + b.size * a.rad) + kRound * a.size * b.size;
}

/// Of a square.
double square_rad(double size, double rad) {
  return (2 * kMore * size + rad) * rad + kRound * size * size;
}

/// A place on an arc's circle, by the way to it from where the arc begins.
struct OnCircle {
  int on_arc;  ///< +1 surely on the arc, −1 surely not
  double position, rad;

  OnCircle(const RawStrand& arc, const Span& chord, const Span& way) {
    const double side = arc.counter_clockwise ? -wedge(chord, way) : wedge(chord, way);
    rad = product_rad(chord, way);
    on_arc = side > rad ? 1 : side < -rad ? -1 : 0;
    position = dot(chord, way);
  }
};

bool of_lines(const RawCurve& curve, std::uint32_t i, std::uint32_t j,
              std::vector<Passing>& found) {
  const RawStrand& a = curve[i];
  const RawStrand& b = curve[j];
  const Span u = chord(curve, i);
  const Span v = chord(curve, j);
  if (!u.is_sound() || !v.is_sound()) return false;
  const Span w{b.x - a.x, b.y - a.y, static_cast<double>(a.ends_rad) + b.ends_rad};
  const double turn = wedge(u, v);
  const double b_from = wedge(u, w);
  const double b_to = b_from + turn;
  const double a_from = wedge(w, v);
  const double a_to = a_from - turn;
  const double turn_rad = product_rad(u, v);
  const double rad_a = product_rad(u, w) + turn_rad;  // of b's sides of a
  const double rad_b = product_rad(v, w) + turn_rad;
  const auto sure = [](double x, double rad) { return std::fabs(x) > rad; };
  if (sure(b_from, rad_a) && sure(b_to, rad_a) && (b_from > 0) == (b_to > 0)) return true;
  if (sure(a_from, rad_b) && sure(a_to, rad_b) && (a_from > 0) == (a_to > 0)) return true;
  if (!sure(b_from, rad_a) || !sure(b_to, rad_a) || !sure(a_from, rad_b) || !sure(a_to, rad_b) ||
      std::fabs(turn) < 128 * turn_rad)
    return false;
  // b_to − b_from and a_from − a_to are both the turn.
  const double inverse = 1 / turn;
  const double t = a_from * inverse;
  const double s = -b_from * inverse;
  const double size = kMore * std::fabs(inverse);
  const double t_rad = (rad_b + turn_rad) * size + kRound;
  const double s_rad = (rad_a + turn_rad) * size + kRound;
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  Passing& p = found.emplace_back();
  p.x = a.x + t * u.x;
  p.y = a.y + t * u.y;
  p.along = {t * uu, s * vv};
  p.along_rad = {rounded_up(kMore * (t_rad * uu + product_rad(u, u))),
                 rounded_up(kMore * (s_rad * vv + product_rad(v, v)))};
  p.strand = {i, j};
  p.turn = b_to > 0 ? 1 : -1;
  p.last = false;
  return true;
}

/// `arc_first`: whether the arc is the first of the two.
bool of_line_and_arc(const RawCurve& curve, std::uint32_t i, std::uint32_t j, bool arc_first,
                     std::vector<Passing>& found) {
  const RawStrand& line = curve[i];
  const RawStrand& arc = curve[j];
  const Span u = chord(curve, i);
  const Span v = chord(curve, j);
  const Span c{arc.centre_x - line.x, arc.centre_y - line.y,
               static_cast<double>(line.ends_rad) + arc.centre_rad};
  const double r = arc.radius;
  if (!u.is_sound() || !v.is_sound() || 256.0 * arc.radius_rad > r) return false;
  const double h = wedge(u, c);
  const double foot_rad = product_rad(u, c);
  const double uu = dot(u, u);
  const double uu_rad = product_rad(u, u);
  const double rr = r * r;
  const double rr_rad = square_rad(r, arc.radius_rad);
  const double reach = rr * uu - h * h;
  const double reach_rad = kMore * (rr * uu_rad + uu * rr_rad) +
                           (2 * std::fabs(h) + foot_rad) * foot_rad * kMore +
                           kRound * (rr * uu + h * h);
  if (reach < -reach_rad) return true;
  if (reach <= reach_rad) return false;
  const double half = std::sqrt(reach);
  const double foot = dot(u, c);
  const double t_rad = foot_rad + kMore * reach_rad / half + kRound * (std::fabs(foot) + half);
  const double outer = t_rad + uu_rad;
  const double inverse = 1 / uu;
  const Span base{line.x - arc.x, line.y - arc.y,
                  static_cast<double>(line.ends_rad) + arc.ends_rad};
  const std::size_t before = found.size();
  for (const int way : {-1, 1}) {
    const double t = foot + way * half;
    if (t < -t_rad || t > uu + outer) continue;
    const double k = t * inverse;
    const double k_rad =
        kMore * (t_rad + std::fabs(k) * uu_rad) * inverse + 2 * kRound * std::fabs(k);
    Span to{base.x + k * u.x, base.y + k * u.y, base.rad};
    to.rad += kMore * (k_rad * u.size + std::fabs(k) * (u.rad + kRound * u.size));
    const OnCircle on(arc, v, to);
    if (on.on_arc < 0) continue;
    if (on.on_arc == 0 || !(t > t_rad && t < uu - outer)) {
      found.resize(before);
      return false;
    }
    Passing& p = found.emplace_back();
    p.x = line.x + k * u.x;
    p.y = line.y + k * u.y;
    p.along[arc_first] = t;
    p.along_rad[arc_first] = rounded_up(t_rad);
    p.strand[arc_first] = i;
    p.along[!arc_first] = on.position;
    p.along_rad[!arc_first] = rounded_up(on.rad);
    p.strand[!arc_first] = j;
    // Where the line leaves the circle, a counter-clockwise arc passes from its right to its left.
    p.turn = static_cast<std::int8_t>(arc.counter_clockwise != arc_first ? way : -way);
    p.last = found.size() - before == 2;
  }
  return true;
}

bool of_arcs(const RawCurve& curve, std::uint32_t i, std::uint32_t j, std::vector<Passing>& found) {
  const RawStrand& a = curve[i];
  const RawStrand& b = curve[j];
  const Span v{b.centre_x - a.centre_x, b.centre_y - a.centre_y,
               static_cast<double>(a.centre_rad) + b.centre_rad};
  const Span chord_a = chord(curve, i);
  const Span chord_b = chord(curve, j);
  if (!v.is_sound() || !chord_a.is_sound() || !chord_b.is_sound()) return false;
  const double vv = dot(v, v);
  const double vv_rad = product_rad(v, v);
  const double sum = a.radius + b.radius;
  const double difference = a.radius - b.radius;
  const double radii_rad = static_cast<double>(a.radius_rad) + b.radius_rad + kRound * sum;
  const double outside = sum * sum - vv;
  const double outside_rad = square_rad(sum, radii_rad) + vv_rad + kRound * (sum * sum + vv);
  if (outside < -outside_rad) return true;
  const double inside = vv - difference * difference;
  const double inside_rad = (2 * kMore * std::fabs(difference) + radii_rad) * radii_rad + vv_rad +
                            kRound * (difference * difference + vv);
  if (inside < -inside_rad) return true;
  if (outside <= outside_rad || inside <= inside_rad) return false;
  const double reach = outside * inside;
  const double reach_rad =
      outside * inside_rad + (inside + inside_rad) * outside_rad + kRound * reach;
  const double root = std::sqrt(reach);
  const double inverse = 0.5 / vv;
  const double k = (vv + difference * sum) * inverse;
  const double m = root * inverse;
  const double k_rad =
      kMore * inverse *
          (vv_rad + (std::fabs(difference) + sum + radii_rad) * radii_rad +
           2 * std::fabs(k) * vv_rad + kRound * (vv + std::fabs(difference) * sum)) +
      kRound * std::fabs(k);
  const double m_rad =
      kMore * inverse * (kMore * reach_rad / root + 2 * m * vv_rad) + 2 * kRound * m;
  const double off_rad =
      kMore * ((k_rad + m_rad) * v.size + (std::fabs(k) + m) * (v.rad + kRound * v.size));
  const Span from_a{a.centre_x - a.x, a.centre_y - a.y,
                    static_cast<double>(a.centre_rad) + a.ends_rad};
  const Span from_b{a.centre_x - b.x, a.centre_y - b.y,
                    static_cast<double>(a.centre_rad) + b.ends_rad};
  const int senses = a.counter_clockwise == b.counter_clockwise ? 1 : -1;
  const std::size_t before = found.size();
  for (const int way : {-1, 1}) {
    const double x = k * v.x - way * m * v.y;
    const double y = k * v.y + way * m * v.x;
    const OnCircle on_a(a, chord_a, {from_a.x + x, from_a.y + y, from_a.rad + off_rad});
    if (on_a.on_arc < 0) continue;
    const OnCircle on_b(b, chord_b, {from_b.x + x, from_b.y + y, from_b.rad + off_rad});
    if (on_b.on_arc < 0) continue;
    if (on_a.on_arc == 0 || on_b.on_arc == 0) {
      found.resize(before);
      return false;
    }
    Passing& p = found.emplace_back();
    p.x = a.centre_x + x;
    p.y = a.centre_y + y;
    p.along = {on_a.position, on_b.position};
    p.along_rad = {rounded_up(on_a.rad), rounded_up(on_b.rad)};
    p.strand = {i, j};
    p.turn = static_cast<std::int8_t>(way * senses);
    p.last = found.size() - before == 2;
  }
  return true;
}

}  // namespace

bool cross(const RawCurve& curve, std::uint32_t a, std::uint32_t b, std::vector<Passing>& found) {
  if (curve[a].is_line)
    return curve[b].is_line ? of_lines(curve, a, b, found)
                            : of_line_and_arc(curve, a, b, false, found);
  return curve[b].is_line ? of_line_and_arc(curve, b, a, true, found) : of_arcs(curve, a, b, found);
}

}  // namespace dgt::quick
