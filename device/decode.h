// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "device/checksum.h"
#include "device/tape.h"

namespace dgt {

/// Something on a tape that is not as it should be.
struct TapeFault {
  enum class Kind : std::uint8_t {
    Parity,  ///< an odd number of holes
    Gap,     ///< rows may be missing before `row`; `detail` says why
    NothingPunched,
    NoStart,          ///< no `%`; `row` is the first that is punched
    StrayRows,        ///< `count` rows before the `%`, neither blank, lettering nor checksum
    ChecksumDiffers,  ///< `said` on the tape, `found` in the rows
    ChecksumMissing,  ///< the format wants one
    ForeignCode       ///< a doubt, no damage: `count` rows, the first in `row`
  };
  Kind kind = Kind::Parity;
  std::size_t row = 0;  ///< from 0
  std::size_t count = 1;
  Row seen = 0;            ///< what `row` holds
  std::size_t offset = 0;  ///< where in the decoded text
  std::string detail = {};
  TapeSum said = {};
  TapeSum found = {};

  [[nodiscard]] bool is_damage() const { return kind != Kind::ForeignCode; }
};

/// The program that lies on a tape.
struct DecodedTape {
  static constexpr std::size_t kMostFaults = 100;

  std::string text;               ///< UTF-8, lines end in LF; every damaged row is one U+FFFD
  std::string header;             ///< read back from the lettering
  std::optional<TapeSum> sum;     ///< read from the tape
  std::size_t program_begin = 0;  ///< rows from the `%` to the last that is punched
  std::size_t program_end = 0;
  std::vector<TapeFault> faults;  ///< by rows; of more than kMostFaults the first
  std::size_t damage_count = 0;   ///< all that is damage

  [[nodiscard]] bool is_damaged() const { return damage_count > 0; }
};

/// Reads what is punched, whatever it is.
///  (1) Every row with an odd number of holes is told with its place, wherever it stands; the rest
///      of the text is as if the row were whole.
///  (2) Every single flipped hole is told when BeforeStart::Checked holds.
///  (3) Blank rows and rub-outs mean nothing. LF ends a line, and so does a CR without an LF beside
///      it; CRs beside an LF belong to it.
///  (4) A `%` with one hole too many or too few is told and still begins the program.
///  (5) What follows a missing `%` is text from the first row that is none of ours.
[[nodiscard]] DecodedTape decode_tape(const Tape& tape, const TapeFormat& format);

}  // namespace dgt
