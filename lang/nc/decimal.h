// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "lang/nc/length.h"

namespace dgt {

/// A decimal as it stands in a program: mantissa / 10^decimals, or digits too many for a word.
struct Decimal {
  std::int64_t mantissa = 0;
  std::uint32_t decimals = 0;
  bool is_long = false;     ///< only the text says it
  bool is_negated = false;  ///< by a sign that stands before `begin`; of long ones
  std::uint32_t begin = 0;  ///< in the file's text, sign included
  std::uint32_t end = 0;

  [[nodiscard]] bool is_zero() const { return !is_long && mantissa == 0; }
  [[nodiscard]] bool same_as(const Decimal& other) const {
    return !is_long && !other.is_long && mantissa == other.mantissa && decimals == other.decimals;
  }
  [[nodiscard]] Rational value(std::string_view text) const;
  /// The value when it is whole and no larger than 10⁹ either way.
  [[nodiscard]] std::optional<long> whole() const;
};

/// Digits that surely fit a word of 64 bits.
inline constexpr std::size_t kMaxWordDigits = 18;
/// No number of a program has more.
inline constexpr std::size_t kMaxNcDigits = 200;

enum class LengthUnit : std::uint8_t { Millimetre, Inch };

/// A coordinate in mm: the decimal, or 25.4 times it.
[[nodiscard]] Length length_of(const Decimal& decimal, LengthUnit unit, std::string_view text);

}  // namespace dgt
