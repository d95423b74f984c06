// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "device/decode.h"
#include "device/encode.h"
#include "device/picture.h"

// What a tape costs, in bytes of the program a second.

namespace dgt {
namespace {

/// A program of `size` characters, in blocks as ESSI and G-code have them.
std::string program(std::size_t size) {
  std::string text;
  for (int i = 0; text.size() < size; ++i) {
    text += i % 2 == 0
                ? "+" + std::to_string(i % 9973) + "-" + std::to_string(i % 613) + "\n"
                : "G01 X" + std::to_string(i % 977) + ".25 Y-" + std::to_string(i % 89) + "\n";
  }
  return text;
}

constexpr std::size_t kSize = 8 << 20;

void encode_program(benchmark::State& state) {
  const std::string text = program(kSize);
  for (auto _ : state) benchmark::DoNotOptimize(encode_tape(text, {}));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

void decode_program(benchmark::State& state) {
  const std::string text = program(kSize);
  const Tape tape{encode_tape(text, {}).rows, {}};
  for (auto _ : state) benchmark::DoNotOptimize(decode_tape(tape, {}));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

void picture_of_tape(benchmark::State& state) {
  const Tape tape{encode_tape(program(kSize / 8), {}).rows, {}};
  for (auto _ : state) benchmark::DoNotOptimize(to_picture(tape));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(tape.rows.size()));
}

BENCHMARK(encode_program)->Unit(benchmark::kMillisecond);
BENCHMARK(decode_program)->Unit(benchmark::kMillisecond);
BENCHMARK(picture_of_tape)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace dgt
