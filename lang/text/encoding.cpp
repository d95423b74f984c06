// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/encoding.h"

#include <algorithm>

namespace dgt {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

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

std::uint32_t count_code_points(std::string_view text) {
  return static_cast<std::uint32_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return !is_continuation(static_cast<unsigned char>(c));
  }));
}

std::string decode(std::string_view bytes) {
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  std::string text;
  text.reserve(bytes.size());
  std::size_t copied = 0;
  for (std::size_t i = 0; i < bytes.size();) {
    const CodePoint c = code_point_at(bytes, i);
    const bool invalid = c.value == kReplacementCharacter && c.size == 1;
    if (invalid) {
      text.append(bytes, copied, i - copied).append(kReplacement);
      copied = i + 1;
    }
    i += c.size;
  }
  return text.append(bytes, copied);
}

}  // namespace dgt
