// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/checksum.h"

#include <array>
#include <charconv>

namespace dgt {
namespace {

constexpr std::string_view kWord = "CRC32 ";
constexpr std::size_t kDigits = 8;
constexpr std::uint32_t kPolynomial = 0xEDB88320;  // reflected

constexpr auto kTable = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ ((value & 1) != 0 ? kPolynomial : 0);
    table[i] = value;
  }
  return table;
}();

template <class T>
bool read_whole(T& value, std::string_view text, int base) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

TapeSum sum_of(std::span<const Row> rows) {
  TapeSum sum;
  std::uint32_t crc = 0xFFFFFFFF;
  for (const Row row : rows) {
    if (row == kBlankRow || row == kRubOut) continue;
    crc = (crc >> 8) ^ kTable[(crc ^ row) & 0xFF];
    ++sum.count;
  }
  sum.crc = ~crc;
  return sum;
}

std::string to_line(const TapeSum& sum) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string line(kWord);
  for (int shift = 28; shift >= 0; shift -= 4) line += kHex[sum.crc >> shift & 15];
  return line + " " + std::to_string(sum.count);
}

std::optional<TapeSum> sum_in_line(std::string_view line) {
  if (!line.starts_with(kWord)) return std::nullopt;
  line.remove_prefix(kWord.size());
  if (line.size() < kDigits + 2 || line[kDigits] != ' ') return std::nullopt;
  const bool has_small = line.find_first_of("abcdef") != std::string_view::npos;
  TapeSum sum;
  if (has_small || !read_whole(sum.crc, line.substr(0, kDigits), 16)) return std::nullopt;
  if (!read_whole(sum.count, line.substr(kDigits + 1), 10)) return std::nullopt;
  return sum;
}

}  // namespace dgt
