// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/nc/decimal.h"

#include "kernel/check.h"

namespace dgt {
namespace {

constexpr std::uint32_t kDecimalsOfStep = 9;  // of a mm
constexpr std::array<std::int64_t, kMaxWordDigits + 1> kPowersOfTen = [] {
  std::array<std::int64_t, kMaxWordDigits + 1> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 10 * powers[i - 1];
  return powers;
}();

const Rational& millimetres_of_inch() {
  static const Rational kInch(127, 5);
  return kInch;
}

}  // namespace

Rational Decimal::value(std::string_view text) const {
  if (is_long) {
    const auto parsed = parse_decimal(text.substr(begin, end - begin));
    DGT_CHECK(parsed.has_value());
    return is_negated ? Rational(-*parsed) : *parsed;
  }
  Rational result(mantissa, kPowersOfTen[decimals]);
  result.canonicalize();
  return result;
}

std::optional<long> Decimal::whole() const {
  constexpr std::int64_t kLargest = 1'000'000'000;
  if (is_long || mantissa % kPowersOfTen[decimals] != 0) return std::nullopt;
  const std::int64_t value = mantissa / kPowersOfTen[decimals];
  return std::abs(value) <= kLargest ? std::optional(static_cast<long>(value)) : std::nullopt;
}

Length length_of(const Decimal& decimal, LengthUnit unit, std::string_view text) {
  std::int64_t steps = decimal.mantissa;
  std::uint32_t decimals = decimal.decimals;
  bool fits = !decimal.is_long;
  if (unit == LengthUnit::Inch) {
    fits = fits && !__builtin_mul_overflow(steps, std::int64_t{254}, &steps);
    ++decimals;
  }
  if (fits && decimals <= kDecimalsOfStep &&
      !__builtin_mul_overflow(steps, kPowersOfTen[kDecimalsOfStep - decimals], &steps))
    return Length::of_steps(steps);
  const Rational value = decimal.value(text);
  return Length(unit == LengthUnit::Inch ? Rational(value * millimetres_of_inch()) : value);
}

}  // namespace dgt
