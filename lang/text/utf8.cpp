// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace dgt {
namespace {

unsigned byte_at(std::string_view text, std::size_t offset) {
  return static_cast<unsigned char>(text[offset]);
}

bool is_continuation(unsigned byte) { return (byte & 0xC0U) == 0x80U; }

// The length that a lead byte announces; 0 for a byte that cannot lead (RFC 3629, section 3).
std::uint32_t announced_length(unsigned lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return 2;
  if (lead >= 0xE0 && lead <= 0xEF) return 3;
  if (lead >= 0xF0 && lead <= 0xF4) return 4;
  return 0;
}

// Overlong forms, surrogates and values past U+10FFFF have the right shape and yet are no text.
bool is_encodable(char32_t value, std::uint32_t length) {
  switch (length) {
    case 3:
      return value >= 0x800 && (value < 0xD800 || value > 0xDFFF);
    case 4:
      return value >= 0x10000 && value <= 0x10FFFF;
    default:
      return true;
  }
}

struct Span {
  char32_t first;
  char32_t last;
};

template <std::size_t n>
bool is_in(const std::array<Span, n>& spans, char32_t value) {
  return std::ranges::any_of(
      spans, [value](const Span& s) { return value >= s.first && value <= s.last; });
}

// After the East Asian Width property (Unicode Standard Annex 11), coarsely: blocks, not letters.
constexpr std::array kWide = {Span{0x1100, 0x115F},   Span{0x2E80, 0xA4CF},  Span{0xAC00, 0xD7A3},
                              Span{0xF900, 0xFAFF},   Span{0xFE30, 0xFE6F},  Span{0xFF00, 0xFF60},
                              Span{0x1F300, 0x1FAFF}, Span{0x20000, 0x3FFFD}};
constexpr std::array kCombining = {Span{0x300, 0x36F}, Span{0x483, 0x489}, Span{0x1AB0, 0x1AFF},
                                   Span{0x20D0, 0x20FF}, Span{0xFE00, 0xFE0F}};
constexpr std::array kInvisible = {
    Span{0x00, 0x08},     Span{0x0B, 0x0C},     Span{0x0E, 0x1F},
    Span{0x7F, 0x9F},     Span{0xAD, 0xAD},     Span{0x200B, 0x200F},
    Span{0x2028, 0x202E}, Span{0x2060, 0x206F}, Span{0xFEFF, 0xFEFF}};

}  // namespace

CodePoint code_point_at(std::string_view text, std::size_t offset) {
  constexpr CodePoint kInvalid{kReplacementCharacter, 1};
  const unsigned lead = byte_at(text, offset);
  const std::uint32_t length = announced_length(lead);
  if (length == 1) return {static_cast<char32_t>(lead), 1};
  if (length == 0 || text.size() - offset < length) return kInvalid;
  char32_t value = lead & (0x7FU >> length);
  for (std::uint32_t i = 1; i < length; ++i) {
    const unsigned byte = byte_at(text, offset + i);
    if (!is_continuation(byte)) return kInvalid;
    value = (value << 6) | (byte & 0x3FU);
  }
  return is_encodable(value, length) ? CodePoint{value, length} : kInvalid;
}

std::size_t ascii_run(std::string_view text, std::size_t offset) {
  constexpr std::uint64_t kHighBits = 0x8080'8080'8080'8080;
  std::size_t at = offset;
  for (std::uint64_t eight = 0; at + sizeof eight <= text.size(); at += sizeof eight) {
    std::memcpy(&eight, text.data() + at, sizeof eight);
    if ((eight & kHighBits) != 0) break;
  }
  while (at < text.size() && static_cast<unsigned char>(text[at]) < 0x80) ++at;
  return at - offset;
}

void append_utf8(std::string& text, char32_t value) {
  const auto put = [&text](char32_t byte) { text += static_cast<char>(byte); };
  if (value < 0x80) {
    put(value);
  } else if (value < 0x800) {
    put(0xC0 | (value >> 6));
    put(0x80 | (value & 0x3F));
  } else if (value < 0x10000) {
    put(0xE0 | (value >> 12));
    put(0x80 | ((value >> 6) & 0x3F));
    put(0x80 | (value & 0x3F));
  } else {
    put(0xF0 | (value >> 18));
    put(0x80 | ((value >> 12) & 0x3F));
    put(0x80 | ((value >> 6) & 0x3F));
    put(0x80 | (value & 0x3F));
  }
}

std::uint32_t count_code_points(std::string_view text) {
  return static_cast<std::uint32_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return !is_continuation(static_cast<unsigned char>(c));
  }));
}

std::string fold_case(std::string_view text) {
  std::string folded;
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint c = code_point_at(text, i);
    char32_t small = c.value;
    if (small >= U'A' && small <= U'Z') small += U'a' - U'A';
    if (small >= U'А' && small <= U'Я') small += U'а' - U'А';
    if (small >= U'Ѐ' && small <= U'Џ') small += U'ѐ' - U'Ѐ';
    if (small != c.value) {
      append_utf8(folded, small);
    } else {
      folded += text.substr(i, c.size);  // as it stands, valid or not
    }
    i += c.size;
  }
  return folded;
}

std::uint32_t display_width(char32_t value) {
  if (value < 0x300) return 1;
  if (is_in(kCombining, value)) return 0;
  return is_in(kWide, value) ? 2 : 1;
}

bool is_invisible(char32_t value) { return is_in(kInvisible, value); }

std::string visible(std::string_view text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint c = code_point_at(text, i);
    if (is_invisible(c.value) || c.value == '\n' || c.value == '\r') {
      shown += fmt::format("U+{:04X}", static_cast<std::uint32_t>(c.value));
    } else {
      append_utf8(shown, c.value == '\t' ? U' ' : c.value);
    }
    i += c.size;
  }
  return shown;
}

}  // namespace dgt
