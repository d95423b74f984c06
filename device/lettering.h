// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "device/iso7.h"

/// Writing in holes that a person reads off the tape: characters of five by seven dots, the top in
/// track 7, the foot in track 1, so that the tape is held with the three-hole edge down and read
/// from left to right. Track 8 stays free, so no row of it is a `%`.
namespace dgt {

/// Blank rows that stand for a space between words, besides the one between letters.
inline constexpr std::size_t kSpaceRows = 3;

/// The text in rows, letters apart by one blank row. Small and Russian letters are transliterated;
/// what has no letter in holes (all but A–Z, 0–9 and `+-./_()=`) is left out.
[[nodiscard]] std::vector<Row> lettering(std::string_view text);

/// The character whose rows are exactly these, without the blank rows around it.
///  (1) A character with one hole more or less anywhere is none.
[[nodiscard]] std::optional<char> letter_in_holes(std::span<const Row> rows);

}  // namespace dgt
