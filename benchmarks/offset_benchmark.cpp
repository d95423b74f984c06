// SPDX-License-Identifier: GPL-3.0-or-later
// Offsets by both engines over families of contours (offset_shapes.h); GEOS on the same shapes with
// arcs as chords of 1 µm height, tessellation not timed. Counters: time an element, decisions an
// element and how many of these each stage of the cascade had to take.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include "benchmarks/offset_shapes.h"
#include "kernel/loop_fault.h"
#include "kernel/offset.h"

namespace dgt {
namespace {

/// glibc hands memory back to the system after each run and gets it again page by page: a fifth of
/// the time of a short one. A program that offsets many contours keeps it, and so do these runs,
/// for every engine.
const bool kKeepsMemory =
    mallopt(M_MMAP_THRESHOLD, 1 << 30) == 1 && mallopt(M_TRIM_THRESHOLD, 1 << 30) == 1;

/// Ordinary parts ask the exact stage for less than a thousandth of their decisions.
constexpr double kExactShare = 0.001;

void report(benchmark::State& state, std::size_t elements, const OffsetCounts& counts) {
  const auto n = static_cast<double>(elements);
  state.counters["per_element"] = benchmark::Counter(
      n, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  const auto decisions = static_cast<double>(counts.decisions);
  state.counters["pairs/element"] = static_cast<double>(counts.pairs) / n;
  state.counters["decisions/element"] = decisions / n;
  state.counters["crossings/element"] = static_cast<double>(counts.crossings) / n;
  state.counters["fine"] = static_cast<double>(counts.fine) / decisions;
  state.counters["exact"] = static_cast<double>(counts.exact) / decisions;
}

enum class Part { Ordinary, Degenerate };

void production(benchmark::State& state, const BulgePolyline& shape, const char* distance,
                Part part) {
  if (!kKeepsMemory) state.SkipWithError("the allocator takes no settings");
  const std::vector<BulgePolyline> loops = {shape};
  const Rational d = parse_decimal(distance).value();
  OffsetCounts counts;
  for (auto _ : state) benchmark::DoNotOptimize(production_offset(loops, d, {}, &counts).loops());
  report(state, shape.size(), counts);
  if (part == Part::Ordinary &&
      static_cast<double>(counts.exact) > kExactShare * static_cast<double>(counts.decisions))
    state.SkipWithError("too many decisions reach the exact stage");
}

void reference(benchmark::State& state, const BulgePolyline& shape, const char* distance) {
  const std::vector<Chain> loops = {shapes::chain(shape)};
  const Rational d = parse_decimal(distance).value();
  for (auto _ : state) benchmark::DoNotOptimize(reference_offset(loops, d).size());
  report(state, shape.size(), {.decisions = 1});
}

using shapes::gear;
using shapes::ring;
using shapes::slots;
using shapes::wavy;

BENCHMARK_CAPTURE(production, gear60, gear(60), "0.4", Part::Ordinary);
BENCHMARK_CAPTURE(production, rand1000, ring(1000), "1", Part::Ordinary);
BENCHMARK_CAPTURE(production, rand1000_outside, ring(1000), "-5", Part::Ordinary);
BENCHMARK_CAPTURE(production, slots250, slots(250), "0.9", Part::Ordinary);
BENCHMARK_CAPTURE(production, slots250_as_wide_as_the_tool, slots(250), "1", Part::Degenerate);
BENCHMARK_CAPTURE(production, wavy1000, wavy(1000), "2", Part::Ordinary);
BENCHMARK_CAPTURE(production, gear6000, gear(6000), "0.4", Part::Ordinary)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(production, rand10000, ring(10000), "1", Part::Ordinary)
    ->Unit(benchmark::kMillisecond);

/// n squares of a chessboard, whose corners touch, grown: raw curves coincide at every distance.
void touching_loops(benchmark::State& state) {
  const auto side = static_cast<int>(state.range(0));
  std::vector<BulgePolyline> loops;
  for (int x = 0; x < side; ++x) {
    for (int y = x % 2; y < side; y += 2) {
      const double a = 4 * x;
      const double b = 4 * y;
      loops.push_back({{a, b, 0}, {a + 4, b, 0}, {a + 4, b + 4, 0}, {a, b + 4, 0}});
    }
  }
  OffsetCounts counts;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        production_offset(loops, parse_decimal("-0.3").value(), {}, &counts).loops());
  report(state, 4 * loops.size(), counts);
}
BENCHMARK(touching_loops)->Arg(10)->Arg(32)->Arg(100);

BENCHMARK_CAPTURE(reference, rand1000, ring(1000), "1")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(reference, gear60, gear(60), "0.4")->Unit(benchmark::kMillisecond);

/// Whether loops bound a region, as `dgt offset` asks before it does anything.
void sound_loops(benchmark::State& state, const BulgePolyline& shape) {
  const std::vector<Chain> loops = {shapes::chain(shape)};
  for (auto _ : state) benchmark::DoNotOptimize(find_loop_fault(loops));
  report(state, shape.size(), {.decisions = 1});
}

/// A comb of n slots of no width: edges that touch.
BulgePolyline shut_slots(unsigned n) {
  BulgePolyline shape = {{0, -20, 0}, {2.0 * n + 2, -20, 0}, {2.0 * n + 2, 0, 0}};
  for (unsigned i = n; i > 0; --i) {
    shape.push_back({2.0 * i, 0, 0});
    shape.push_back({2.0 * i, -10, 0});
    shape.push_back({2.0 * i, 0, 0});
  }
  shape.push_back({0, 0, 0});
  return shape;
}

BENCHMARK_CAPTURE(sound_loops, rand10000, ring(10000))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sound_loops, gear6000, gear(6000))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sound_loops, shut_slots330, shut_slots(330))->Unit(benchmark::kMillisecond);

void growth(benchmark::State& state) {
  const std::vector<BulgePolyline> loops = {ring(static_cast<unsigned>(state.range(0)))};
  for (auto _ : state) benchmark::DoNotOptimize(production_offset(loops, 1).loops());
  state.SetComplexityN(state.range(0));
}
BENCHMARK(growth)->RangeMultiplier(10)->Range(100, 1000000)->Complexity(benchmark::oNLogN);

}  // namespace
}  // namespace dgt
