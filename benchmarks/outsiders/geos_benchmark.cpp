// SPDX-License-Identifier: GPL-3.0-or-later
// GEOS on the shapes of offset_benchmark.cpp: arcs as chords that leave them by 1 µm at most, in
// the input (made before the clock starts) and about corners. The time is given an element of the
// shape, not a chord.
#include <benchmark/benchmark.h>
#include <geos_c.h>

#include <cmath>
#include <numbers>

#include "benchmarks/offset_shapes.h"

namespace dgt {
namespace {

/// mm.
constexpr double kChordHeight = 1e-3;

double step_of(double radius) { return 2 * std::acos(std::max(0.0, 1 - kChordHeight / radius)); }

std::vector<std::pair<double, double>> tessellated(const BulgePolyline& shape) {
  std::vector<std::pair<double, double>> ring;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const BulgePoint& p = shape[i];
    const BulgePoint& q = shape[(i + 1) % shape.size()];
    ring.emplace_back(p.x, p.y);
    if (p.bulge == 0) continue;
    const double sweep = 4 * std::atan(p.bulge);
    // The centre lies at (1 − b²)/4b of the chord to its left.
    const double k = (1 - p.bulge * p.bulge) / (4 * p.bulge);
    const double cx = (p.x + q.x) / 2 - k * (q.y - p.y);
    const double cy = (p.y + q.y) / 2 + k * (q.x - p.x);
    const double radius = std::hypot(p.x - cx, p.y - cy);
    const int parts = static_cast<int>(std::ceil(std::fabs(sweep) / step_of(radius)));
    for (int part = 1; part < parts; ++part) {
      const double angle = sweep * part / parts;
      const double x = p.x - cx;
      const double y = p.y - cy;
      ring.emplace_back(cx + x * std::cos(angle) - y * std::sin(angle),
                        cy + x * std::sin(angle) + y * std::cos(angle));
    }
  }
  ring.push_back(ring.front());
  return ring;
}

void geos(benchmark::State& state, const BulgePolyline& shape, double distance) {
  const auto ring = tessellated(shape);
  GEOSContextHandle_t handle = GEOS_init_r();
  GEOSCoordSequence* points = GEOSCoordSeq_create_r(handle, static_cast<unsigned>(ring.size()), 2);
  for (unsigned i = 0; i < ring.size(); ++i)
    GEOSCoordSeq_setXY_r(handle, points, i, ring[i].first, ring[i].second);
  GEOSGeometry* polygon =
      GEOSGeom_createPolygon_r(handle, GEOSGeom_createLinearRing_r(handle, points), nullptr, 0);
  const int quarter =
      static_cast<int>(std::ceil(std::numbers::pi / 2 / step_of(std::fabs(distance))));
  for (auto _ : state) {
    GEOSGeometry* buffer = GEOSBuffer_r(handle, polygon, -distance, quarter);
    benchmark::DoNotOptimize(buffer);
    GEOSGeom_destroy_r(handle, buffer);
  }
  state.counters["per_element"] = benchmark::Counter(
      static_cast<double>(shape.size()),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  GEOSGeom_destroy_r(handle, polygon);
  GEOS_finish_r(handle);
}

BENCHMARK_CAPTURE(geos, gear60, shapes::gear(60), 0.4);
BENCHMARK_CAPTURE(geos, rand1000, shapes::ring(1000), 1);
BENCHMARK_CAPTURE(geos, rand1000_outside, shapes::ring(1000), -5);
BENCHMARK_CAPTURE(geos, slots250, shapes::slots(250), 0.9);
BENCHMARK_CAPTURE(geos, wavy1000, shapes::wavy(1000), 2);

}  // namespace
}  // namespace dgt
