// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "kernel/element.h"
#include "lang/nc/length.h"

namespace dgt::essi {

inline constexpr std::int64_t kWholeTurn = 3600;  ///< tenths of a degree

/// How a subprogram lies on the path: turned, then scaled. Quarter turns are exact, other sines and
/// cosines within 2⁻¹²⁸.
class Frame {
 public:
  /// Inside this one, turned counter-clockwise by `tenths` of a degree and scaled.
  [[nodiscard]] Frame turned(std::int64_t tenths, const Rational& scale) const;

  /// Whether everything lies as the program says.
  [[nodiscard]] bool is_plain() const { return is_plain_; }
  /// A way as it lies on the path.
  [[nodiscard]] Spot place(const Spot& way) const;
  /// A circle about a centre seen from `from`, a place on the path.
  [[nodiscard]] Circle place(const Circle& circle, const Spot& from) const;

 private:
  [[nodiscard]] RationalPoint place(const RationalPoint& v) const {
    return {along_x_ * v.x - along_y_ * v.y, along_y_ * v.x + along_x_ * v.y};
  }

  std::int64_t tenths_ = 0;
  Rational scale_ = 1;
  bool is_plain_ = true;
  Rational along_x_ = 1;  ///< where a step of X leads
  Rational along_y_;
};

}  // namespace dgt::essi
