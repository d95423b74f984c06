// SPDX-License-Identifier: GPL-3.0-or-later
// What exactness costs: the filter against the exact stage, each construction, roundings, and the
// bit lengths that a chain of dependent constructions reaches.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

#include "kernel/construct.h"

namespace dgt {
namespace {

const Line& slanted_line() {
  static const Line line = line_at_angle(known_point(RationalPoint{1, 2}), 30).value;
  return line;
}
const Circle& circle() {
  static const Circle c({Rational(31, 10), Rational(47, 10)}, 5);
  return c;
}
const Circle& other_circle() {
  static const Circle c({Rational(72, 10), Rational(13, 10)}, -4);
  return c;
}
KnownPoint outside() { return known_point(RationalPoint{40, Rational(-77, 10)}); }

// --- meetings -----------------------------------------------------------------------------------

void meet_filtered(benchmark::State& state, const Element& a, const Element& b) {
  const Carrier ca = carrier(a);
  const Carrier cb = carrier(b);
  for (auto _ : state) benchmark::DoNotOptimize(stages::filtered(ca, cb));
}
void meet_exact(benchmark::State& state, const Element& a, const Element& b) {
  for (auto _ : state) benchmark::DoNotOptimize(stages::exact(a, b));
}
void crossing_filtered(benchmark::State& state, const Element& a, const Element& b) {
  const Carrier ca = carrier(a);
  const Carrier cb = carrier(b);
  for (auto _ : state) benchmark::DoNotOptimize(Point::crossing(ca, cb, Which::Exit).x());
}
void crossing_exact(benchmark::State& state, const Element& a, const Element& b) {
  for (auto _ : state) {
    const ExactPoint p = stages::exact_crossing(a, b, Which::Exit);
    benchmark::DoNotOptimize(nearest_double(p.x));
    benchmark::DoNotOptimize(nearest_double(p.y));
  }
}

// --- directions and roundings -------------------------------------------------------------------

void direction_of_degrees(benchmark::State& state) {
  const Rational degrees(12345, 1000);
  for (auto _ : state) benchmark::DoNotOptimize(direction_of(degrees));
}
BENCHMARK(direction_of_degrees);

void direction_of_vector(benchmark::State& state) {
  const Vector v{Rational(12345, 1000), Rational(-678, 100)};
  for (auto _ : state) benchmark::DoNotOptimize(direction_of(v));
}
BENCHMARK(direction_of_vector);

void nearest_double_filtered(benchmark::State& state) {
  const OneRoot x(Rational(1, 3), Rational(2, 7), 5);
  for (auto _ : state) benchmark::DoNotOptimize(nearest_double(x));
}
BENCHMARK(nearest_double_filtered);

void nearest_double_beside_a_tie(benchmark::State& state) {
  const OneRoot x(1 + power_of_two(-53) - 2, 1, 4 + power_of_two(-200));
  for (auto _ : state) benchmark::DoNotOptimize(nearest_double(x));
}
BENCHMARK(nearest_double_beside_a_tie);

void nearest_integer_of_a_root(benchmark::State& state) {
  const OneRoot x(Rational(1, 3), Rational(2000, 7), 5);
  for (auto _ : state) benchmark::DoNotOptimize(nearest_integer(x));
}
BENCHMARK(nearest_integer_of_a_root);

// --- constructions ------------------------------------------------------------------------------

template <class Form>
void construction(benchmark::State& state, Form form) {
  for (auto _ : state) benchmark::DoNotOptimize(form());
}

template <class Form>
void add(const char* name, Form form) {
  benchmark::RegisterBenchmark(name,
                               [form](benchmark::State& state) { construction(state, form); });
}

// --- a chain ------------------------------------------------------------------------------------

template <class T>
T result_of(const Construction<T>& c) {
  return std::get<Constructed<T>>(c).value;
}

std::size_t height_of(const Circle& c) {
  return std::max({height(c.centre().x), height(c.centre().y), height(c.radius())});
}

/// Round and round a plate: a tangent to the last circle from a point, a circle touching both, the
/// next point on that circle. Counters: the longest coordinate in bits.
void chain_of_1000(benchmark::State& state) {
  std::size_t highest = 0;
  for (auto _ : state) {
    Circle last({3, 4}, 5);
    for (int i = 0; i < 250; ++i) {
      const KnownPoint from =
          point_polar(known_point(RationalPoint{0, 0}), 60, Rational(7 * i)).value;
      const Line tangent = result_of(tangent_from(from, last));
      const Circle around = result_of(circle_about(
          result_of(meeting_point(tangent, Circle({0, 0}, 70), Selector::I2)), Rational(45, 10)));
      const Circle next =
          result_of(touching(tangent.reversed(), around, Rational(-65, 10), Selector::I2));
      last = Circle({next.centre().x / 8, next.centre().y / 8}, 5);
      highest = std::max({highest, height(tangent.p()), height_of(around), height_of(next)});
    }
  }
  state.counters["greatest_bit_length"] = static_cast<double>(highest);
}
BENCHMARK(chain_of_1000)->Unit(benchmark::kMillisecond);

const bool kRegistered = [] {
  const auto meetings = [](const char* kind, const Element& a, const Element& b) {
    const auto name = [&](const char* what) { return std::string(what) + "/" + kind; };
    using benchmark::RegisterBenchmark;
    RegisterBenchmark(name("meet_filtered").c_str(), meet_filtered, a, b);
    RegisterBenchmark(name("meet_exact").c_str(), meet_exact, a, b);
    RegisterBenchmark(name("crossing_filtered").c_str(), crossing_filtered, a, b);
    RegisterBenchmark(name("crossing_exact").c_str(), crossing_exact, a, b);
  };
  meetings("line_circle", slanted_line(), circle());
  meetings("circle_circle", circle(), other_circle());

  const KnownPoint p = outside();
  const KnownPoint q = known_point(RationalPoint{-3, 8});
  const KnownPoint r = known_point(RationalPoint{Rational(55, 10), -11});
  add("line_through", [=] { return line_through(p, q); });
  add("line_at_angle", [=] { return line_at_angle(p, Rational(123, 10)); });
  add("line_turned", [=] { return line_turned(slanted_line(), Rational(123, 10), p); });
  add("tangent_at_angle", [=] { return tangent_at_angle(circle(), Rational(123, 10)); });
  add("tangent_from", [=] { return tangent_from(p, circle()); });
  add("common_tangent", [=] { return common_tangent(circle(), Circle({50, 60}, -7)); });
  add("circle_through", [=] { return circle_through(p, q, r); });
  add("circle_polar", [=] { return circle_polar(p, 10, Rational(123, 10), 3); });
  add("touching/line_line", [=] { return touching(slanted_line(), horizontal_line(1), 3); });
  add("touching/line_circle", [=] { return touching(slanted_line(), circle(), 3, Selector::I1); });
  add("touching/circle_circle",
      [=] { return touching(circle(), other_circle(), -6, Selector::I1); });
  add("point_polar", [=] { return point_polar(p, 10, Rational(123, 10)); });
  add("meeting_point/line_line",
      [=] { return meeting_point(slanted_line(), horizontal_line(1), Selector::Default); });
  add("meeting_point/line_circle",
      [=] { return meeting_point(slanted_line(), circle(), Selector::I1); });
  add("meeting_point/circle_circle",
      [=] { return meeting_point(circle(), other_circle(), Selector::I1); });
  return true;
}();

}  // namespace
}  // namespace dgt
