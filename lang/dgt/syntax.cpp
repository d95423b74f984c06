// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/syntax.h"

namespace dgt::language {

Number number_of(const Word& word) {
  Number number;
  number.form = word.form;
  number.minus = word.minus;
  constexpr std::int64_t kLargestPlain = 1'000'000'000;
  if (word.form == NumberForm::None) return number;
  if (word.scale == 0 && word.digits >= 0 && word.digits <= kLargestPlain) {
    number.whole = static_cast<std::int32_t>(word.digits);
    return number;
  }
  Rational value = word.magnitude();
  if (value.get_den() == 1 && value <= Rational(1'000'000'000)) {
    number.whole = static_cast<std::int32_t>(value.get_num().get_si());
  } else {
    number.exact = std::make_shared<const Rational>(std::move(value));
  }
  return number;
}

}  // namespace dgt::language
