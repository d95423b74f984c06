// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

/// What stands in a program where a Latin letter or an ASCII sign was meant.
namespace dgt {

/// The Latin capital that a Cyrillic letter looks like; small letters are taken for the same. NUL:
/// none.
[[nodiscard]] char latin_look_alike(char32_t c);
/// `text` with its Cyrillic letters that look like Latin ones replaced by these, upper case.
[[nodiscard]] std::string latin_look_alike(std::string_view text);

/// The Latin letter on the key of a Cyrillic one that looks like none. NUL: no such letter.
[[nodiscard]] char latin_on_key(char32_t c);

[[nodiscard]] bool is_cyrillic(char32_t c);

/// `"` or `'` for the quotes and apostrophes that word processors put in their place. NUL: neither.
[[nodiscard]] char typewriter_sign_for(char32_t c);

/// The signs − and –, which word processors make of a minus.
[[nodiscard]] constexpr bool is_typographic_minus(char32_t c) { return c == 0x2212 || c == 0x2013; }

/// No-break spaces and their kin, and the byte order mark in the midst of a text.
[[nodiscard]] constexpr bool is_wide_blank(char32_t c) {
  return c == 0xA0 || c == 0x2007 || c == 0x202F || c == 0xFEFF;
}

}  // namespace dgt
