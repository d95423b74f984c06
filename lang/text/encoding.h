// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace dgt {

/// Stands in decoded text for every byte that the encoding does not know (U+FFFD).
inline constexpr char32_t kReplacementCharacter = 0xFFFD;

/// The text of a file as UTF-8 without byte order mark. Bytes that are no UTF-8 become
/// kReplacementCharacter, one for one, so that columns still count characters.
[[nodiscard]] std::string decode(std::string_view bytes);

/// One character of valid UTF-8: its code point and how many bytes it takes.
struct CodePoint {
  char32_t value = 0;
  std::uint32_t size = 0;
};

/// The character that begins at `offset`. A byte that begins no valid character comes back as
/// kReplacementCharacter of size 1. Precondition: offset < text.size().
[[nodiscard]] CodePoint code_point_at(std::string_view text, std::size_t offset);

/// How many code points `text` has.
[[nodiscard]] std::uint32_t count_code_points(std::string_view text);

}  // namespace dgt
