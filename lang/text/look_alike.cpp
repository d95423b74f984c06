// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/look_alike.h"

#include <array>

#include "lang/text/utf8.h"

namespace dgt {
namespace {

struct LookAlike {
  char32_t cyrillic;
  char latin;
};

// Capitals whose shape is a Latin letter's.
constexpr std::array kLookAlikes = {
    LookAlike{U'А', 'A'}, LookAlike{U'В', 'B'}, LookAlike{U'С', 'C'}, LookAlike{U'Е', 'E'},
    LookAlike{U'К', 'K'}, LookAlike{U'М', 'M'}, LookAlike{U'Н', 'H'}, LookAlike{U'О', 'O'},
    LookAlike{U'Р', 'P'}, LookAlike{U'Т', 'T'}, LookAlike{U'У', 'Y'}, LookAlike{U'Х', 'X'},
    LookAlike{U'І', 'I'}, LookAlike{U'Ѕ', 'S'}, LookAlike{U'Ј', 'J'}};

}  // namespace

char latin_look_alike(char32_t c) {
  if (c >= U'а' && c <= U'я') c -= U'а' - U'А';
  if (c >= U'ѐ' && c <= U'џ') c -= U'ѐ' - U'Ѐ';
  for (const LookAlike& pair : kLookAlikes) {
    if (pair.cyrillic == c) return pair.latin;
  }
  return '\0';
}

std::string latin_look_alike(std::string_view text) {
  std::string latin;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint c = code_point_at(text, at);
    if (const char letter = latin_look_alike(c.value)) {
      latin += letter;
    } else {
      latin += text.substr(at, c.size);
    }
    at += c.size;
  }
  return latin;
}

char latin_on_key(char32_t c) {
  static constexpr std::u32string_view kCyrillic = U"ЦГШЩЗФЫПЛДЯЧИЬ";
  static constexpr std::string_view kLatin = "WUIOPASGKLZXBM";
  if (c >= U'а' && c <= U'я') c -= U'а' - U'А';
  const std::size_t at = kCyrillic.find(c);
  return at == std::u32string_view::npos ? '\0' : kLatin[at];
}

bool is_cyrillic(char32_t c) { return (c >= U'А' && c <= U'я') || c == U'Ё' || c == U'ё'; }

char typewriter_sign_for(char32_t c) {
  if (c == U'«' || c == U'»' || (c >= U'“' && c <= U'‟')) return '"';
  return c == U'‘' || c == U'’' || c == U'‛' ? '\'' : '\0';
}

}  // namespace dgt
