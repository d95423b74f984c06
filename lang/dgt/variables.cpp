// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/variables.h"

#include "kernel/check.h"

namespace dgt::language {

std::optional<Rational> Variables::value(const Number& number) const {
  DGT_CHECK(!number.is_absent());
  if (number.is_variable()) {
    const auto& value = numbers_.at(static_cast<std::size_t>(number.whole - 1)).value;
    if (!value || !number.minus) return value;
    return Rational(-*value);
  }
  if (!number.exact) return Rational(number.minus ? -number.whole : number.whole);
  return number.minus ? Rational(-*number.exact) : *number.exact;
}

}  // namespace dgt::language
