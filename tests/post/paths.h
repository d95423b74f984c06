// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <string>
#include <utility>

#include "kernel/toolpath.h"
#include "tests/support/nc_replay.h"

/// Tool paths made by hand, in rationals, for the tests of the writers.
namespace dgt::testing {

inline Rational q(const char* decimal) { return *parse_decimal(decimal); }

/// A rational near `value`, with few bits.
inline Rational near(double value, int bits = 10) {
  const double scale = std::ldexp(1.0, bits);
  Rational r(std::round(value * scale));
  r /= Rational(scale);
  return r;
}

/// The rational unit vector near an angle in degrees.
inline UnitVector unit_at(double degrees) {
  const double t = std::tan(degrees * std::acos(-1.0) / 360);
  if (std::fabs(t) > 1e6) return UnitVector({-1, 0});
  return UnitVector::from_half_tangent(near(t, std::fabs(t) > 16 ? 4 : 12));
}

class PathBuilder {
 public:
  explicit PathBuilder(RationalPoint start = {}) : at_(start) { path_.start = std::move(start); }

  PathBuilder& straight(MoveKind kind, RationalPoint to) {
    Move& m = add(kind);
    m.from = Point(at_);
    m.to = Point(to);
    at_ = std::move(to);
    return *this;
  }
  PathBuilder& line(RationalPoint to) { return straight(MoveKind::Line, std::move(to)); }
  PathBuilder& rapid(RationalPoint to) { return straight(MoveKind::Rapid, std::move(to)); }
  PathBuilder& line(const char* x, const char* y) { return line({q(x), q(y)}); }
  PathBuilder& rapid(const char* x, const char* y) { return rapid({q(x), q(y)}); }

  /// Precondition: `to` lies on the circle about `centre` through the present point.
  PathBuilder& arc(RationalPoint to, const RationalPoint& centre, bool ccw) {
    const auto radius = exact_sqrt(squared_length(at_ - centre));
    DGT_CHECK(radius && squared_length(to - centre) == *radius * *radius);
    Move& m = add(MoveKind::Arc);
    m.from = Point(at_);
    m.to = Point(to);
    m.full_circle = at_ == to;
    m.carrier = carrier(Circle(centre, ccw ? *radius : Rational(-*radius)));
    at_ = std::move(to);
    return *this;
  }
  /// An arc whose centre is seen from here at `radius` in the direction opposite to `outwards`.
  PathBuilder& turn(const UnitVector& outwards, const Rational& radius, double degrees, bool ccw) {
    const RationalPoint centre = at_ - radius * outwards.vector();
    const UnitVector end = rotated(outwards, unit_at(ccw ? degrees : -degrees));
    return arc(centre + radius * end.vector(), centre, ccw);
  }
  PathBuilder& code(std::string text) {
    add(MoveKind::Code).code = std::move(text);
    return *this;
  }
  PathBuilder& dwell(const char* seconds) {
    add(MoveKind::Dwell).seconds = shared(q(seconds));
    return *this;
  }
  PathBuilder& height(const char* z) {
    path_.moves.back().z = shared(q(z));
    return *this;
  }
  PathBuilder& feed(const char* f) {
    feed_ = shared(q(f));
    return *this;
  }

  const RationalPoint& at() const { return at_; }
  const Toolpath& path() const { return path_; }

 private:
  Move& add(MoveKind kind) {
    Move& m = path_.moves.emplace_back();
    m.kind = kind;
    m.from = m.to = Point(at_);
    m.feed = feed_;
    m.source.line = static_cast<std::uint32_t>(path_.moves.size());
    m.source.column = 1;
    return m;
  }

  Toolpath path_;
  RationalPoint at_;
  RationalPtr feed_;
};

/// What an exact move looks like to the reader of the written text.
inline replay::Step step_of(const Move& m) {
  replay::Step s;
  s.kind = m.kind == MoveKind::Arc ? replay::Step::Kind::Arc : replay::Step::Kind::Line;
  s.from = {m.from.x(), m.from.y()};
  s.to = {m.to.x(), m.to.y()};
  if (m.kind != MoveKind::Arc) return s;
  const Circle circle = m.circle();
  s.centre = {nearest_double(circle.centre().x), nearest_double(circle.centre().y)};
  s.radius = std::fabs(nearest_double(circle.radius()));
  s.ccw = circle.counter_clockwise();
  const double a = std::atan2(s.from.y - s.centre.y, s.from.x - s.centre.x);
  const double b = std::atan2(s.to.y - s.centre.y, s.to.x - s.centre.x);
  const double turn = 2 * std::acos(-1.0);
  s.sweep = s.ccw ? b - a : a - b;
  while (s.sweep <= 0) s.sweep += turn;
  while (s.sweep > turn) s.sweep -= turn;
  if (m.full_circle) s.sweep = turn;
  return s;
}

/// The largest distance found, both ways, between two chains of steps.
inline double measured_distance(const std::vector<replay::Step>& a,
                                const std::vector<replay::Step>& b, int count) {
  double worst = 0;
  const auto one_way = [&](const auto& from, const auto& to) {
    for (const auto& step : from) {
      for (const auto& p : replay::samples(step, count)) {
        double least = 1e300;
        for (const auto& other : to) least = std::min(least, replay::distance(p, other));
        worst = std::max(worst, least);
      }
    }
  };
  one_way(a, b);
  one_way(b, a);
  return worst;
}

}  // namespace dgt::testing
