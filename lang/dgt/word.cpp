// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/word.h"

#include "kernel/check.h"

namespace dgt::language {

Rational Word::magnitude() const {
  DGT_CHECK(form == NumberForm::Decimal);
  if (digits < 0) {
    std::optional<Rational> value = parse_decimal(number().text());
    DGT_CHECK(value.has_value());
    return *std::move(value);
  }
  static_assert(sizeof(long) == sizeof(std::int64_t), "GMP takes long");
  if (scale == 0) return Rational(static_cast<long>(digits));
  Integer denominator;
  mpz_ui_pow_ui(denominator.get_mpz_t(), 10, scale);
  Rational value(Integer(static_cast<long>(digits)), denominator);
  value.canonicalize();
  return value;
}

}  // namespace dgt::language
