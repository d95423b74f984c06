// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace dgt {

/// Stands in decoded text for every byte that the encoding does not know (U+FFFD).
inline constexpr char32_t kReplacementCharacter = 0xFFFD;

/// One character of valid UTF-8: its code point and how many bytes it takes.
struct CodePoint {
  char32_t value = 0;
  std::uint32_t size = 0;
};

/// The character that begins at `offset`. A byte that begins no valid character comes back as
/// kReplacementCharacter of size 1. Precondition: offset < text.size().
[[nodiscard]] CodePoint code_point_at(std::string_view text, std::size_t offset);

/// False for what code_point_at() gives for a byte that begins no valid character; true for a
/// replacement character that stands in the text itself.
[[nodiscard]] constexpr bool is_valid(const CodePoint& c) {
  return c.value != kReplacementCharacter || c.size != 1;
}

/// How many bytes of ASCII `text` has from `offset` on, up to the first other one.
[[nodiscard]] std::size_t ascii_run(std::string_view text, std::size_t offset);

/// Appends a code point as UTF-8.
void append_utf8(std::string& text, char32_t value);

/// How many code points `text` has.
[[nodiscard]] std::uint32_t count_code_points(std::string_view text);

/// Latin and Cyrillic capitals as small letters: names that differ in case alone become equal.
[[nodiscard]] std::string fold_case(std::string_view text);

/// How many columns of a terminal the character takes: none for combining marks, two for the wide
/// letters of East Asia and for pictures, otherwise one.
[[nodiscard]] std::uint32_t display_width(char32_t value);

/// True for what a person cannot see, or what makes a terminal do something: controls (but not the
/// tabulator and line ends), zero-width characters and marks that turn the direction of writing.
[[nodiscard]] bool is_invisible(char32_t value);

/// The text fit for a person's eyes, on one line and valid UTF-8 whatever it was: what is invisible
/// and line ends as `U+200B`, tabs as blanks, bytes that are no text as U+FFFD.
[[nodiscard]] std::string visible(std::string_view text);

}  // namespace dgt
