// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "post/write.h"

// What writing costs once the tool path is there.

namespace dgt {
namespace {

/// A wheel of `teeth` quarter arcs with lines between them, its points off every grid.
Toolpath wheel(std::int64_t teeth) {
  Toolpath path;
  RationalPoint at{Rational(1, 3), Rational(1, 7)};
  path.start = at;
  const auto add = [&](MoveKind kind, const RationalPoint& to) -> Move& {
    Move& m = path.moves.emplace_back();
    m.kind = kind;
    m.from = Point(at);
    m.to = Point(to);
    at = to;
    return m;
  };
  const Rational r(37, 9);
  for (std::int64_t i = 0; i < teeth; ++i) {
    add(MoveKind::Line, {at.x + Rational(11, 17), at.y + (i % 2 == 0 ? r : -r)});
    const Circle circle({at.x, at.y + r}, r);
    add(MoveKind::Arc, {at.x + r, at.y + r}).carrier = carrier(circle);
  }
  return path;
}

void write_wheel(benchmark::State& state, const char* dialect) {
  const Toolpath path = wheel(state.range(0) / 2);
  for (auto _ : state) benchmark::DoNotOptimize(write(path, *find_dialect(dialect)));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

BENCHMARK_CAPTURE(write_wheel, essi, "essi")->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write_wheel, plasmatic, "plasmatic")->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write_wheel, linuxcnc, "linuxcnc")->Arg(100'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace dgt
