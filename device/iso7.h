// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>

/// The code of NC tape: the seven bits of ISO 646 (ISO 840, GOST 13052) in tracks 1 to 7, and in
/// track 8 the hole that makes their number even.
namespace dgt {

/// One row of holes: bit 0 is track 1, bit 7 track 8; a set bit is a hole.
using Row = std::uint8_t;

inline constexpr std::size_t kTracks = 8;
inline constexpr Row kBlankRow = 0x00;  ///< NUL: feed hole only; means nothing
inline constexpr Row kRubOut = 0xFF;    ///< DEL: what was punched here has been punched out
inline constexpr Row kTab = 0x09;
inline constexpr Row kLineFeed = 0x0A;
inline constexpr Row kCarriageReturn = 0x8D;
inline constexpr Row kStartOfProgram = 0xA5;  ///< `%`

[[nodiscard]] constexpr bool has_even_parity(Row row) { return std::popcount(row) % 2 == 0; }

/// The row of a code from 0 to 127.
[[nodiscard]] constexpr Row row_of(char code) {
  const auto bits = static_cast<Row>(code & 0x7F);
  return has_even_parity(bits) ? bits : static_cast<Row>(bits | 0x80);
}
static_assert(row_of('\n') == kLineFeed && row_of('\r') == kCarriageReturn &&
              row_of('%') == kStartOfProgram && row_of('\x7F') == kRubOut);

/// What a row is. Every one of the 256 is exactly one of these.
enum class RowKind : std::uint8_t {
  Blank,
  RubOut,
  LineFeed,
  CarriageReturn,
  Character,  ///< what programs are written in: see is_punchable()
  Foreign,    ///< even, yet no code of NC tape: small letters, other controls
  Damaged     ///< an odd number of holes
};
[[nodiscard]] RowKind kind_of(Row row);

/// The tabulator and the codes from blank to `_`: digits, capitals, signs.
[[nodiscard]] constexpr bool is_punchable(char code) {
  return code == '\t' || (code >= ' ' && code <= '_');
}

/// The seven bits, whatever track 8 says.
[[nodiscard]] constexpr char code_of(Row row) { return static_cast<char>(row & 0x7F); }

/// Track numbers of the holes, `1 3 6 8`; empty for a blank row.
[[nodiscard]] std::string holes_of(Row row);

/// What a person calls the row: the character itself, `NUL`, `LF`, `DEL`, `SP`, `0x07`, and for a
/// damaged one `?`.
[[nodiscard]] std::string name_of(Row row);

}  // namespace dgt
