// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/transliterate.h"

#include <algorithm>
#include <array>
#include <utility>

namespace dgt {
namespace {

constexpr char32_t kNoCharacter = 0xFFFD;

/// А to Я.
constexpr std::array<std::string_view, 32> kRussian = {
    "A", "B", "V", "G", "D", "E",  "ZH", "Z",  "I",  "I",    "K",  "L", "M", "N", "O",  "P",
    "R", "S", "T", "U", "F", "KH", "TS", "CH", "SH", "SHCH", "IE", "Y", "",  "E", "IU", "IA"};

constexpr std::array<std::pair<char32_t, std::string_view>, 21> kSigns = {{
    {0x00A0, " "},                                                    // no-break space
    {0x00AB, "\""},                                                   // «
    {0x00B0, "DEG"}, {0x00B1, "+-"}, {0x00B7, "."},  {0x00BB, "\""},  // »
    {0x00D7, "*"},   {0x00D8, "D"},                                   // Ø, a diameter
    {0x0401, "E"},                                                    // Ё
    {0x0451, "E"},   {0x2013, "-"},  {0x2014, "-"},  {0x2018, "'"},   {0x2019, "'"},
    {0x201C, "\""},  {0x201D, "\""}, {0x201E, "\""}, {0x2026, "..."}, {0x2116, "NO"},  // №
    {0x2205, "D"},   {0x2212, "-"},
}};

constexpr std::string_view kCapitals = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";

constexpr bool is_between(char32_t value, char32_t first, char32_t last) {
  return value >= first && value <= last;
}

/// By its first byte; 0 where none can begin.
std::size_t size_after(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return 2;
  if (first >= 0xE0 && first <= 0xEF) return 3;
  return first >= 0xF0 && first <= 0xF4 ? 4 : 0;
}

constexpr std::array<char32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};  // by length

}  // namespace

Utf8Character utf8_character(std::string_view text, std::size_t offset) {
  const auto first = static_cast<unsigned char>(text[offset]);
  const std::size_t size = size_after(first);
  if (size == 1) return {first, 1};
  if (size == 0 || offset + size > text.size()) return {kNoCharacter, 1};
  char32_t value = first & (0xFFU >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    const auto next = static_cast<unsigned char>(text[offset + i]);
    if ((next & 0xC0) != 0x80) return {kNoCharacter, 1};
    value = value << 6 | (next & 0x3F);
  }
  const bool is_surrogate = is_between(value, 0xD800, 0xDFFF);
  if (value < kLeast.at(size) || value > 0x10FFFF || is_surrogate) return {kNoCharacter, 1};
  return {value, size};
}

std::optional<std::string_view> transliterated(char32_t character) {
  if (is_between(character, 'a', 'z')) return kCapitals.substr(character - 'a', 1);
  if (is_between(character, 0x0410, 0x042F)) return kRussian.at(character - 0x0410);
  if (is_between(character, 0x0430, 0x044F)) return kRussian.at(character - 0x0430);
  const auto sign = std::ranges::find(kSigns, character, [](const auto& row) { return row.first; });
  return sign == kSigns.end() ? std::nullopt : std::optional(sign->second);
}

}  // namespace dgt
