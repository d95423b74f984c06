// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "kernel/meet.h"

namespace dgt {

/// A length of an NC program in mm, exactly. Nearly all are whole steps of 10⁻⁹ mm, and these take
/// a machine word; what is finer or larger, a turned subprogram for one, is kept as a rational.
class Length {
 public:
  Length() = default;
  explicit Length(const Rational& millimetres);
  [[nodiscard]] static Length of_steps(std::int64_t steps) {
    return fits(steps) ? Length(steps) : Length(in_millimetres(steps));
  }

  [[nodiscard]] bool on_grid() const { return !exact_; }
  /// Precondition: on_grid().
  [[nodiscard]] std::int64_t steps() const { return steps_; }
  [[nodiscard]] Rational millimetres() const { return exact_ ? *exact_ : in_millimetres(steps_); }
  [[nodiscard]] bool is_zero() const { return on_grid() && steps_ == 0; }

  friend Length operator+(const Length& a, const Length& b) {
    if (a.on_grid() && b.on_grid()) return of_steps(a.steps_ + b.steps_);
    return Length(a.millimetres() + b.millimetres());
  }
  friend Length operator-(const Length& a, const Length& b) {
    if (a.on_grid() && b.on_grid()) return of_steps(a.steps_ - b.steps_);
    return Length(a.millimetres() - b.millimetres());
  }
  friend bool operator==(const Length& a, const Length& b) {
    if (a.on_grid() != b.on_grid()) return false;  // a rational is never on the grid
    return a.on_grid() ? a.steps_ == b.steps_ : *a.exact_ == *b.exact_;
  }

 private:
  explicit Length(std::int64_t steps) : steps_(steps) {}
  static bool fits(std::int64_t steps) {
    return steps >= -Point::kMaxDecimalSteps && steps <= Point::kMaxDecimalSteps;
  }
  static Rational in_millimetres(std::int64_t steps);

  std::int64_t steps_ = 0;
  std::shared_ptr<const Rational> exact_;  ///< null: steps_
};

/// A place, or the way from one to another.
struct Spot {
  Length x;
  Length y;

  [[nodiscard]] bool on_grid() const { return x.on_grid() && y.on_grid(); }
  [[nodiscard]] Point point() const;
  [[nodiscard]] RationalPoint exact() const { return {x.millimetres(), y.millimetres()}; }

  friend Spot operator+(const Spot& a, const Spot& b) { return {a.x + b.x, a.y + b.y}; }
  friend Spot operator-(const Spot& a, const Spot& b) { return {a.x - b.x, a.y - b.y}; }
  friend bool operator==(const Spot&, const Spot&) = default;
};

}  // namespace dgt
