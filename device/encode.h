// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "device/tape.h"

namespace dgt {

/// Characters of one line that ISO-7 lacks and that follow each other.
struct UnpunchableRun {
  std::size_t begin = 0;  ///< bytes of the text
  std::size_t end = 0;
  bool refused = true;  ///< else `replacement` is on the tape, which may be empty
  std::string replacement;

  friend bool operator==(const UnpunchableRun&, const UnpunchableRun&) = default;
};

/// A program on tape.
struct EncodedTape {
  static constexpr std::size_t kMostRuns = 1000;

  std::vector<Row> rows;                    ///< empty when a character is refused
  std::vector<UnpunchableRun> unpunchable;  ///< the first kMostRuns
  bool refused = false;
  bool ends_in_line = false;  ///< the last line has no end: many controls do not execute it
};

/// Punches a program, UTF-8 with any line ends: leader, lettering, checksum, `%`, program, trailer,
/// as the format says.
///  (1) decode_tape() gives the text back, with LF for its line ends, when nothing was replaced and
///      (2) does not apply.
///  (2) With TapeStart::Percent a text that begins with `%` has its start and none is added. A
///      first line that is `%` alone is the tape's, and decode_tape() leaves it out, unless the
///      last line is `%` alone as well: such a pair belongs to the program.
///  (3) What is refused or dropped is a whole character; every other character is one row.
[[nodiscard]] EncodedTape encode_tape(std::string_view text, const TapeFormat& format);

}  // namespace dgt
