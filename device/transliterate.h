// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace dgt {

/// The character of UTF-8 that begins at `offset`: its value and length. A byte that begins none
/// has the value U+FFFD and the length 1. Precondition: offset < text.size().
struct Utf8Character {
  char32_t value = 0;
  std::size_t size = 1;
};
[[nodiscard]] Utf8Character utf8_character(std::string_view text, std::size_t offset);

/// A character in capitals of ISO-7: small Latin letters as capitals, Russian letters after the
/// passports' table (ICAO Doc 9303; Ь is nothing), quotes, dashes and signs of the trade by what
/// looks or means the same. Nothing when there is no such spelling.
[[nodiscard]] std::optional<std::string_view> transliterated(char32_t character);

}  // namespace dgt
