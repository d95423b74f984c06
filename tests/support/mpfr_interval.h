// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>
#include <mpfr.h>

#include <algorithm>
#include <ostream>
#include <stdexcept>
#include <utility>

/// An independent witness for the exact kernel: plain interval arithmetic over MPFR with directed
/// rounding. It shares no code with the kernel; every interval surely holds the real number meant.
namespace dgt::test {

inline constexpr mpfr_prec_t kWitnessBits = 400;

/// One MPFR number as a value.
class Real {
 public:
  explicit Real(mpfr_prec_t bits = kWitnessBits) {
    mpfr_init2(value_, bits);
    mpfr_set_zero(value_, 1);
  }
  Real(const Real& other) : Real(mpfr_get_prec(other.value_)) {
    mpfr_set(value_, other.value_, MPFR_RNDN);
  }
  Real& operator=(const Real& other) {
    if (this == &other) return *this;
    mpfr_set_prec(value_, mpfr_get_prec(other.value_));
    mpfr_set(value_, other.value_, MPFR_RNDN);
    return *this;
  }
  ~Real() { mpfr_clear(value_); }

  /// −1, 0, +1.
  [[nodiscard]] int sign() const { return mpfr_sgn(value_); }

  operator mpfr_ptr() { return value_; }           // NOLINT: a drop-in handle by design
  operator mpfr_srcptr() const { return value_; }  // NOLINT

 private:
  mpfr_t value_;
};

/// The real numbers from lo to hi.
class Interval {
 public:
  Interval() = default;
  Interval(int value) : Interval(mpq_class(value)) {}  // NOLINT: whole numbers are intervals
  Interval(const mpq_class& value) {                   // NOLINT: so are rationals
    mpfr_set_q(lo_, value.get_mpq_t(), MPFR_RNDD);
    mpfr_set_q(hi_, value.get_mpq_t(), MPFR_RNDU);
  }

  friend Interval operator+(const Interval& a, const Interval& b) {
    Interval r;
    mpfr_add(r.lo_, a.lo_, b.lo_, MPFR_RNDD);
    mpfr_add(r.hi_, a.hi_, b.hi_, MPFR_RNDU);
    return r;
  }
  friend Interval operator-(const Interval& a) {
    Interval r;
    mpfr_neg(r.lo_, a.hi_, MPFR_RNDD);
    mpfr_neg(r.hi_, a.lo_, MPFR_RNDU);
    return r;
  }
  friend Interval operator-(const Interval& a, const Interval& b) { return a + (-b); }
  friend Interval operator*(const Interval& a, const Interval& b) {
    return hull_of_corners(a, b, mpfr_mul);
  }
  friend Interval operator/(const Interval& a, const Interval& b) {
    if (b.holds_zero()) throw std::domain_error("interval division by zero");
    return hull_of_corners(a, b, mpfr_div);
  }
  /// A lower end below 0 is cut off: the operand is known to be a square or a sum of squares.
  friend Interval sqrt(const Interval& a) {
    Interval r;
    if (a.lo_.sign() > 0) mpfr_sqrt(r.lo_, a.lo_, MPFR_RNDD);
    mpfr_sqrt(r.hi_, a.hi_, MPFR_RNDU);
    return r;
  }
  friend Interval abs(const Interval& a) {
    if (a.lo_.sign() >= 0) return a;
    if (a.hi_.sign() <= 0) return -a;
    Interval r;
    mpfr_max(r.hi_, a.hi_, Interval(-a).hi_, MPFR_RNDU);
    return r;
  }
  /// Sine and cosine have slope 1 at most: the value at the lower end, widened by the width.
  friend Interval sin(const Interval& a) { return with_slope_one(a, mpfr_sin); }
  friend Interval cos(const Interval& a) { return with_slope_one(a, mpfr_cos); }

  [[nodiscard]] bool holds_zero() const { return lo_.sign() <= 0 && hi_.sign() >= 0; }
  [[nodiscard]] bool certainly_positive() const { return lo_.sign() > 0; }
  [[nodiscard]] bool certainly_negative() const { return hi_.sign() < 0; }
  [[nodiscard]] bool holds(const mpq_class& value) const {
    return mpfr_cmp_q(lo_, value.get_mpq_t()) <= 0 && mpfr_cmp_q(hi_, value.get_mpq_t()) >= 0;
  }
  /// Nothing in the interval exceeds `limit` by more than the interval's own width.
  [[nodiscard]] bool at_most(double limit) const { return mpfr_cmp_d(lo_, limit) <= 0; }
  /// How uncertain the witness itself is.
  [[nodiscard]] double width() const {
    Real w;
    mpfr_sub(w, hi_, lo_, MPFR_RNDU);
    return mpfr_get_d(w, MPFR_RNDU);
  }
  [[nodiscard]] double middle() const {
    return (mpfr_get_d(lo_, MPFR_RNDN) + mpfr_get_d(hi_, MPFR_RNDN)) / 2;
  }
  friend std::ostream& operator<<(std::ostream& out, const Interval& a) {
    return out << a.middle() << " (width " << a.width() << ")";
  }

 private:
  template <class Operation>
  static Interval hull_of_corners(const Interval& a, const Interval& b, Operation operation) {
    Interval r;
    Real down;
    Real up;
    bool first = true;
    for (const Real* x : {&a.lo_, &a.hi_}) {
      for (const Real* y : {&b.lo_, &b.hi_}) {
        operation(down, *x, *y, MPFR_RNDD);
        operation(up, *x, *y, MPFR_RNDU);
        if (first || mpfr_less_p(down, r.lo_)) r.lo_ = down;
        if (first || mpfr_greater_p(up, r.hi_)) r.hi_ = up;
        first = false;
      }
    }
    return r;
  }
  template <class Function>
  static Interval with_slope_one(const Interval& a, Function function) {
    Interval r;
    Real width;
    mpfr_sub(width, a.hi_, a.lo_, MPFR_RNDU);
    function(r.lo_, a.lo_, MPFR_RNDD);
    function(r.hi_, a.lo_, MPFR_RNDU);
    mpfr_sub(r.lo_, r.lo_, width, MPFR_RNDD);
    mpfr_add(r.hi_, r.hi_, width, MPFR_RNDU);
    return r;
  }

  Real lo_;
  Real hi_;

  friend Interval pi_interval();
};

[[nodiscard]] inline Interval pi_interval() {
  Interval r;
  mpfr_const_pi(r.lo_, MPFR_RNDD);
  mpfr_const_pi(r.hi_, MPFR_RNDU);
  return r;
}

[[nodiscard]] inline Interval radians(const mpq_class& degrees) {
  return Interval(mpq_class(degrees / 180)) * pi_interval();
}

}  // namespace dgt::test
