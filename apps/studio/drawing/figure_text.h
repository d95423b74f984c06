// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cmath>

namespace dgt::studio {

/// A figure with so many digits behind the point, never a negative zero.
[[nodiscard]] inline QString figure_text(double value, int decimals) {
  const bool is_nothing = std::fabs(value) * std::pow(10.0, decimals) < 0.5;
  return QString::number(is_nothing ? 0.0 : value, 'f', decimals);
}

}  // namespace dgt::studio
