// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>
#include <string_view>

#include "device/decode.h"
#include "device/encode.h"

/// Tapes for tests.
namespace dgt::support {

[[nodiscard]] inline Tape tape_of(std::string_view text, const TapeFormat& format = {}) {
  return {encode_tape(text, format).rows, {}};
}

/// Short leaders: what is tested is between them.
[[nodiscard]] inline TapeFormat short_format() {
  TapeFormat format;
  format.leader = 30;
  format.trailer = 30;
  return format;
}

/// `lines` blocks like those of real programs, every kind of character among them.
[[nodiscard]] inline std::string long_program(int lines) {
  std::string text;
  for (int i = 0; i < lines; ++i) {
    text += "N" + std::to_string(i) + " G01 X" + std::to_string(i * 37 % 1000) + ".5 Y-" +
            std::to_string(i * 91 % 777) + "\t(BLOCK " + std::to_string(i) +
            ": \"#$&'*,;<=>?@!\")\n";
  }
  return text;
}

/// A text of characters that can be punched; some long, some short, some with `%` first.
[[nodiscard]] inline std::string random_text(std::mt19937_64& random) {
  std::string text;
  const auto size = random() % (random() % 8 == 0 ? 300 : 40);
  for (std::uint64_t i = 0; i < size; ++i) {
    const auto kind = random() % 16;
    text += kind == 0   ? '\n'
            : kind == 1 ? '\t'
            : kind == 2 ? '%'
                        : static_cast<char>(' ' + random() % ('_' - ' ' + 1));
  }
  return text;
}

}  // namespace dgt::support
