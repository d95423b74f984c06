// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/nc/length.h"

namespace dgt {
namespace {

constexpr long kSteps = Point::kDecimalStepsPerMillimetre;

}  // namespace

Length::Length(const Rational& millimetres) {
  const Rational steps = millimetres * kSteps;
  if (steps.get_den() == 1 && steps.get_num().fits_slong_p() && fits(steps.get_num().get_si()))
    steps_ = steps.get_num().get_si();
  else
    exact_ = std::make_shared<const Rational>(millimetres);
}

Rational Length::in_millimetres(std::int64_t steps) {
  Rational value(steps, kSteps);
  value.canonicalize();
  return value;
}

Point Spot::point() const {
  return on_grid() ? Point::decimal(x.steps(), y.steps()) : Point(exact());
}

}  // namespace dgt
