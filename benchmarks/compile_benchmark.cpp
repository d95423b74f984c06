// SPDX-License-Identifier: GPL-3.0-or-later
//
// Source to NC text: every program of the corpus, a wheel that grows, and the front end alone.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "apps/driver/pipeline.h"
#include "lang/dgt/parser.h"
#include "post/write.h"

namespace dgt {
namespace {

Compilation compile_text(const std::string& text) {
  Compilation c;
  c.file = std::make_shared<const SourceFile>("generated.bgt", text);
  FolderLoader nothing{std::nullopt};
  c.result = compile(*c.file, nothing, EvaluateOptions{}, c.bag);
  return c;
}

void compile_and_write(const Compilation& c, const Dialect& dialect, benchmark::State& state) {
  if (!c.result.path) return state.SkipWithError("the program does not compile");
  benchmark::DoNotOptimize(write(*c.result.path, dialect));
}

// --- the corpus ---------------------------------------------------------------------------------

void corpus_program(benchmark::State& state, const std::string& name) {
  for (auto _ : state) {
    const auto compiled = compile_file(name, SourceSettings{});
    if (!compiled) return state.SkipWithError(compiled.error().text().c_str());
    compile_and_write(*compiled, *find_dialect("essi"), state);
  }
}

const bool kCorpusRegistered = [] {
  const std::filesystem::path corpus = std::filesystem::path(DGT_SOURCE_DIR) / "tests/corpus";
  std::vector<std::filesystem::path> programs;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus)) {
    if (entry.path().extension() == ".bgt") programs.push_back(entry.path());
  }
  std::sort(programs.begin(), programs.end());
  for (const auto& program : programs) {
    // Definition files and programs meant to be refused are no work to time.
    const auto compiled = compile_file(program.string(), SourceSettings{});
    if (!compiled || !compiled->result.path || compiled->result.path->moves.empty()) continue;
    benchmark::RegisterBenchmark(
        ("Corpus/" + std::filesystem::relative(program, corpus).string()).c_str(), corpus_program,
        program.string());
  }
  return true;
}();

// --- the wheel ----------------------------------------------------------------------------------

/// Sample 3P with `teeth` distinct teeth on a rim as long as they need: four moves a tooth. With
/// 30 000 the step is 0.012° and the rim's radius 30 000 mm.
std::string wheel(std::int64_t teeth) {
  const Rational step = Rational(360) / Rational(static_cast<long>(teeth));
  return fmt::format(
      "L1=Y2\nL2=Y-2\nC1=X0 Y0 R{0}\nC2=X{1} Y0 R-3\nG54 X{1} Y0\n"
      "K1 W0.2 L1 C2 L-2 C-1\nFOR {2}\nN1=N1-{3}\nAN1, L1 C2 L-2 C-1\nNEXT\nA-0, L1 C2\n"
      "G0 X{1} Y0\n",
      teeth, teeth + 5, teeth - 1, to_short_decimal(step, 12));
}

void wheel_to_essi(benchmark::State& state) {
  const std::string text = wheel(state.range(0));
  for (auto _ : state) compile_and_write(compile_text(text), *find_dialect("essi"), state);
  state.SetComplexityN(state.range(0));
  state.counters["moves/s"] = benchmark::Counter(static_cast<double>(4 * state.range(0)),
                                                 benchmark::Counter::kIsIterationInvariantRate);
}
// Teeth that divide 360°: 0.36, 0.12, 0.036, 0.012.
BENCHMARK(wheel_to_essi)
    ->Name("Wheel")
    ->Arg(1000)
    ->Arg(3000)
    ->Arg(10000)
    ->Arg(30000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);

// --- the front end ------------------------------------------------------------------------------

/// Ten megabytes of definitions and contours, as a generator would write them.
std::string large_source() {
  std::string text;
  for (int i = 0; text.size() < 10'000'000; ++i) {
    const int n = i % 3000;
    text += fmt::format(
        "L{0}=X{1}.125 Y{2} X{2}.5 Y-{1}\nC{0}=X{1} Y{2}.75 R-{3}.25 ' comment\n"
        "K{0} W0.15 X{1} Y{2} L{0} R2.5 C-{0} V3 L-{0} G0 F120.5,\n",
        n, i % 997, i % 811, i % 50 + 1);
  }
  return text;
}

void parse_alone(benchmark::State& state) {
  const SourceFile file("large.bgt", large_source());
  for (auto _ : state) {
    DiagnosticBag bag;
    benchmark::DoNotOptimize(language::parse(file, bag));
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(file.text().size()));
}
BENCHMARK(parse_alone)->Name("LexAndParse")->Unit(benchmark::kMillisecond);

void loop_arithmetic(benchmark::State& state) {
  const std::string text = "FOR 1000000\nN1=N1+0.001\nNEXT\n";
  for (auto _ : state) benchmark::DoNotOptimize(compile_text(text));
}
BENCHMARK(loop_arithmetic)->Name("LoopArithmetic/1000000")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace dgt
