// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "device/iso7.h"

/// A tape as rows, and how a program lies on it.
namespace dgt {

/// A place where rows may be missing: a line that failed, a reader that stopped.
struct Gap {
  std::size_t row = 0;  ///< how many rows lie before it
  std::string reason;   ///< one line for a person

  friend bool operator==(const Gap&, const Gap&) = default;
};

struct Tape {
  std::vector<Row> rows;
  std::vector<Gap> gaps;  ///< in the order of their rows

  friend bool operator==(const Tape&, const Tape&) = default;
};

/// Hundredths of a millimetre from one row to the next (ISO 1154: 2.54 mm).
inline constexpr std::uint64_t kRowPitch = 254;

/// Row `index` (from 0) in mm from the first row, exactly: `500.38`.
[[nodiscard]] std::string millimetres_to(std::size_t index);

/// The fewest rows that are at least so long.
[[nodiscard]] constexpr std::size_t rows_in(std::uint32_t mm) {
  return static_cast<std::size_t>((std::uint64_t{mm} * 100 + kRowPitch - 1) / kRowPitch);
}

enum class TapeStart : std::uint8_t {
  Percent,  ///< a line `%` before the program
  None      ///< none, or the program brings its own
};
enum class TapeLineEnd : std::uint8_t { CrLf, Lf };
/// What becomes of characters that ISO-7 lacks.
enum class Unpunchable : std::uint8_t { Refuse, Drop, Transliterate };
/// A line `CRC32 9A8B7C6D 1234` before the `%`: over all rows from the `%` on but blank rows and
/// rub-outs, the checksum of IEEE 802.3 and their number. Controls pass over it.
enum class TapeChecksum : std::uint8_t { None, Line };
/// What is held of rows before the `%`.
enum class BeforeStart : std::uint8_t {
  Checked,  ///< blank, our lettering or a checksum; all else is a fault
  Ignored   ///< as a control does; for tapes with lettering of others
};

/// How tapes are laid out; a machine's setting.
struct TapeFormat {
  std::uint32_t leader = 500;   ///< mm of blank tape before everything
  std::uint32_t trailer = 500;  ///< mm of blank tape at the end
  TapeStart start = TapeStart::Percent;
  TapeLineEnd line_end = TapeLineEnd::CrLf;
  Unpunchable unpunchable = Unpunchable::Refuse;
  TapeChecksum checksum = TapeChecksum::None;  ///< needs a `%`
  BeforeStart before_start = BeforeStart::Checked;
  std::string header;  ///< lettering in holes before the `%`; UTF-8, empty: none
};

}  // namespace dgt
