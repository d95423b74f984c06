// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/offset_shapes.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace dgt::shapes {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// Uniform in [low, high), from the generator's own bits: library distributions differ between
/// machines.
double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

BulgePoint polar(double radius, double angle, double bulge = 0) {
  return {radius * std::cos(angle), radius * std::sin(angle), bulge};
}

struct Spot {
  double x, y;
};
Spot at(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// A round of radius r in the corner a–b–c, as its two ends and its bulge.
struct Round {
  Spot begin, end;
  double bulge;
};
Round round_corner(Spot a, Spot b, Spot c, double r) {
  const double back = std::hypot(a.x - b.x, a.y - b.y);
  const double on = std::hypot(c.x - b.x, c.y - b.y);
  const Spot u{(b.x - a.x) / back, (b.y - a.y) / back};
  const Spot v{(c.x - b.x) / on, (c.y - b.y) / on};
  const double turn = std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y);
  const double cut = r * std::fabs(std::tan(turn / 2));
  return {
      {b.x - cut * u.x, b.y - cut * u.y}, {b.x + cut * v.x, b.y + cut * v.y}, std::tan(turn / 4)};
}

}  // namespace

BulgePolyline gear(unsigned teeth) {
  const double pitch = teeth / 2.0;
  const double root = pitch - 1.25;
  const double tip = pitch + 1;
  const double step = kTurn / teeth;
  BulgePolyline gear;
  for (unsigned i = 0; i < teeth; ++i) {
    // A tooth from the middle of one gap to that of the next; the flanks are straight.
    const double mid = step * (i + 0.5);
    const double wide = 0.36 * step;
    const double narrow = 0.16 * step;
    const std::array<Spot, 6> corners = {at(root, mid - 0.5 * step), at(root, mid - wide),
                                         at(tip, mid - narrow),      at(tip, mid + narrow),
                                         at(root, mid + wide),       at(root, mid + 0.5 * step)};
    const Round in = round_corner(corners[0], corners[1], corners[2], 0.25);
    const Round up = round_corner(corners[1], corners[2], corners[3], 0.15);
    const Round down = round_corner(corners[2], corners[3], corners[4], 0.15);
    const Round out = round_corner(corners[3], corners[4], corners[5], 0.25);
    const double land = std::tan(2 * narrow / 8);
    for (const Round& r : {in, up}) {
      gear.push_back({r.begin.x, r.begin.y, r.bulge});
      gear.push_back({r.end.x, r.end.y, r.bulge == up.bulge ? land : 0});
    }
    for (const Round& r : {down, out}) {
      gear.push_back({r.begin.x, r.begin.y, r.bulge});
      gear.push_back({r.end.x, r.end.y, r.bulge == out.bulge ? std::tan(0.28 * step / 4) : 0});
    }
  }
  return gear;
}

BulgePolyline ring(unsigned n, unsigned seed) {
  std::mt19937 random(seed);
  const double radius = n / kTurn;
  BulgePolyline ring;
  for (unsigned i = 0; i < n; ++i) {
    const double angle = kTurn * i / n;
    const double r = radius * (1 + 0.1 * std::sin(5 * angle)) + uniform(random, -0.4, 0.4);
    const double bulge = random() % 2 == 0 ? uniform(random, -0.25, 0.25) : 0;
    ring.push_back(polar(r, angle, bulge));
  }
  return ring;
}

BulgePolyline slots(unsigned k) {
  const double outer = 4.0 * k / kTurn + 8;
  const double inner = outer - 8;
  BulgePolyline slots;
  for (unsigned i = 0; i < k; ++i) {
    const double angle = kTurn * i / k;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const auto add = [&](double along, double across, double bulge) {
      slots.push_back({along * c - across * s, along * s + across * c, bulge});
    };
    add(outer, -1, 0);
    add(inner, -1, -1);
    add(inner, 1, 0);
    add(outer, 1, 0);
  }
  return slots;
}

BulgePolyline wavy(unsigned n) {
  const double radius = n * 0.1 / kTurn;
  BulgePolyline wavy;
  for (unsigned i = 0; i < n; ++i) {
    const double angle = kTurn * i / n;
    wavy.push_back(polar(radius + 2 * std::sin(12 * angle), angle));
  }
  return wavy;
}

Chain chain(const BulgePolyline& shape) {
  std::vector<BulgeVertex> vertices;
  for (const BulgePoint& p : shape)
    vertices.push_back({{Rational(p.x), Rational(p.y)}, Rational(p.bulge)});
  return chain_of(vertices, true).value();
}

}  // namespace dgt::shapes
