// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program of many blocks, from its bytes: read, proved against what it was written from, and
// written again. Memory is what `/usr/bin/time -v` tells of a run with one size.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <string>

#include "apps/driver/pipeline.h"
#include "apps/driver/verify.h"
#include "post/write.h"

namespace dgt {
namespace {

/// Plates of eight blocks, four of them arcs, in rows of a hundred; eleven blocks with the torch
/// and the rapid.
std::string plates(std::int64_t blocks) {
  std::string text = "G21 G90 G17 G40 G91.1\n";
  for (std::int64_t i = 0; i < blocks / 11; ++i) {
    const std::int64_t x = 20 * (i % 100);
    const std::int64_t y = 20 * (i / 100);
    text += fmt::format("G00 X{}.000 Y{}.000\nM07\n", x + 2, y);
    text += fmt::format("G01 X{}.000 Y{}.000 F1000\nG03 X{}.000 Y{}.000 I0.000 J2.000\n", x + 8, y,
                        x + 10, y + 2);
    text += fmt::format("G01 X{0}.000 Y{1}.000\nG03 X{2}.000 Y{3}.000 I-2.000 J0.000\n", x + 10,
                        y + 8, x + 8, y + 10);
    text += fmt::format("G01 X{0}.000 Y{1}.000\nG03 X{2}.000 Y{3}.000 I0.000 J-2.000\n", x + 2,
                        y + 10, x, y + 8);
    text += fmt::format("G01 X{0}.000 Y{1}.000\nG03 X{2}.000 Y{3}.000 I2.000 J0.000\nM08\n", x,
                        y + 2, x + 2, y);
  }
  return text + "M02\n";
}

void read_prove_and_rewrite(benchmark::State& state) {
  const std::string text = plates(state.range(0));
  const Dialect& dialect = *find_dialect("linuxcnc");
  for (auto _ : state) {
    const Compilation exact = compile_bytes("a.ngc", text, {});
    const WriteResult written = write(*exact.result.path, dialect);
    const Compilation program = compile_bytes("b.ngc", written.text, {});
    const Certificate proof = verify(program, exact, dialect.name, limits_of(dialect));
    if (!proof.holds()) return state.SkipWithError("the program is not proved");
    benchmark::DoNotOptimize(proof.rows.data());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(read_prove_and_rewrite)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace dgt
