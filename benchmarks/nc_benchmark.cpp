// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bytes of an NC program to its tool path: decoding, reading, contours.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <random>
#include <string>

#include "lang/essi/reader.h"
#include "lang/gcode/reader.h"
#include "lang/nc/kerf.h"
#include "lang/three_b/reader.h"

namespace dgt {
namespace {

/// A million lines by default; every `arc_every`th is an arc, none for 0.
std::string gcode(std::int64_t lines, int arc_every) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-500, 500);
  std::uniform_real_distribution<double> angle(0.2, 2.5);
  std::string text = "G21 G90\nG00 X0 Y0\n";
  double x = 0;
  double y = 0;
  const auto rounded = [](double value) { return std::round(value * 1000) / 1000; };
  for (std::int64_t i = 1; i <= lines; ++i) {
    if (arc_every > 0 && i % arc_every == 0) {
      const double begin = angle(random);
      const double end = begin + angle(random);
      const double radius = 1 + std::fabs(anywhere(random)) / 10;
      const double i_word = -radius * std::cos(begin);
      const double j_word = -radius * std::sin(begin);
      x = rounded(x + radius * (std::cos(end) - std::cos(begin)));
      y = rounded(y + radius * (std::sin(end) - std::sin(begin)));
      text += fmt::format("G03 X{:.3f} Y{:.3f} I{:.3f} J{:.3f}\n", x, y, i_word, j_word);
    } else {
      x = rounded(anywhere(random));
      y = rounded(anywhere(random));
      text += fmt::format("G01 X{:.3f} Y{:.3f}\n", x, y);
    }
  }
  return text + "M02\n";
}

std::string essi(std::int64_t lines, int arc_every) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> step(-5000, 5000);
  std::string text = "53\n";
  for (std::int64_t i = 1; i <= lines; ++i) {
    const int x = step(random);
    const int y = step(random);
    text += fmt::format("{:+}{:+}", x, y);
    if (arc_every > 0 && i % arc_every == 0 && (x != 0 || y != 0)) text += "+8000-+";
    text += '\n';
  }
  return text + "54\n";
}

/// Arcs within a quadrant and through two, each counted along the way of its end.
std::string three_b(std::int64_t lines, int arc_every) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> step(1, 99999);
  std::uniform_int_distribution<int> quadrant(1, 4);
  std::string text;
  for (std::int64_t i = 1; i <= lines; ++i) {
    const int x = step(random);
    const int y = step(random);
    const int q = quadrant(random);
    if (arc_every > 0 && i % arc_every == 0) {
      // From 20° on to 70° from there in the quadrant, or as far again into the next one.
      const bool is_long = i % (2 * arc_every) == 0;
      const int r = x + 1000;
      const auto at = [r](double degrees) {
        return static_cast<std::int64_t>(std::lround(r * std::cos(degrees * 0.017453292519943295)));
      };
      const std::int64_t count = is_long ? r - at(70) + r - at(50) : at(20) - at(70);
      const bool along_x = (q % 2 == 1) != is_long;
      text += fmt::format("B{}B{}B{}G{}NR{}\n", q % 2 == 1 ? at(20) : at(70),
                          q % 2 == 1 ? at(70) : at(20), count, along_x ? 'X' : 'Y', q);
    } else {
      text += fmt::format("B{}B{}B{}G{}L{}\n", x, y, std::max(x, y), x > y ? 'X' : 'Y', q);
    }
  }
  return text + "DD\n";
}

template <class ReadText>
void read(benchmark::State& state, const std::string& text, ReadText&& read_text) {
  for (auto _ : state) {
    const SourceFile file("large", text);
    DiagnosticBag bag;
    const Toolpath path = with_kerf(file, read_text(file, bag), ContourOptions{}, bag);
    if (bag.has_errors()) return state.SkipWithError("the program has errors");
    benchmark::DoNotOptimize(path.moves.data());
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void read_gcode_lines(benchmark::State& state, int arc_every) {
  read(state, gcode(state.range(0), arc_every), [](const SourceFile& file, DiagnosticBag& bag) {
    return read_gcode(file, GcodeOptions{}, bag);
  });
}
BENCHMARK_CAPTURE(read_gcode_lines, lines, 0)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_gcode_lines, half_arcs, 2)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void read_essi_lines(benchmark::State& state, int arc_every) {
  read(state, essi(state.range(0), arc_every), [](const SourceFile& file, DiagnosticBag& bag) {
    return read_essi(file, EssiOptions{}, bag);
  });
}
BENCHMARK_CAPTURE(read_essi_lines, lines, 0)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_essi_lines, half_arcs, 2)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void read_three_b_lines(benchmark::State& state, int arc_every) {
  read(state, three_b(state.range(0), arc_every), [](const SourceFile& file, DiagnosticBag& bag) {
    return read_three_b(file, ThreeBOptions{}, bag);
  });
}
BENCHMARK_CAPTURE(read_three_b_lines, lines, 0)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_three_b_lines, half_arcs, 2)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace dgt
