// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/double_double.h"

#include <gtest/gtest.h>

#include <random>

#include "kernel/enclosed.h"
#include "kernel/number.h"

namespace dgt {
namespace {

Rational exact(DoubleDouble a) { return Rational(a.hi) + Rational(a.lo); }

/// Numbers of all sizes up to 2⁴⁰ with full tails; neighbours of each other now and then.
class Numbers {
 public:
  DoubleDouble next() {
    const double hi = std::ldexp(unit(), static_cast<int>(random_() % 80) - 40);
    return DoubleDouble::sum(hi, hi * std::ldexp(unit(), -53));
  }
  DoubleDouble beside(DoubleDouble a) {
    return DoubleDouble::sum(a.hi, a.lo + a.hi * std::ldexp(unit(), -50));
  }

 private:
  double unit() {
    const double mantissa = static_cast<double>(random_()) / 4294967296.0 + 1;
    return random_() % 2 == 0 ? mantissa : -mantissa;
  }
  std::mt19937 random_{4};
};

void expect_near(DoubleDouble result, const Rational& ideal) {
  EXPECT_LE(abs(exact(result) - ideal), Rational(DoubleDouble::kRoundoff) * abs(ideal));
}

TEST(DoubleDouble, SumsProductsAndQuotientsAreWithinTheRoundoffSaid) {
  Numbers numbers;
  for (int i = 0; i < 20000; ++i) {
    const DoubleDouble a = numbers.next();
    const DoubleDouble b = i % 3 == 0 ? numbers.beside(-a) : numbers.next();
    expect_near(a + b, exact(a) + exact(b));
    expect_near(a - b, exact(a) - exact(b));
    expect_near(a * b, exact(a) * exact(b));
    expect_near(a / b, exact(a) / exact(b));
  }
}

TEST(DoubleDouble, RootsAreWithinTheRoundoffSaid) {
  Numbers numbers;
  for (int i = 0; i < 5000; ++i) {
    const DoubleDouble a = numbers.next();
    const DoubleDouble square = a.hi < 0 ? -a : a;
    const Rational r = exact(root(square));
    // |r − √x| = |r² − x| / (r + √x), and r + √x is above r.
    EXPECT_LE(abs(r * r - exact(square)), Rational(DoubleDouble::kRoundoff) * 2 * r * r);
  }
}

template <class Real>
Rational value(const Real& x) {
  if constexpr (std::is_same_v<Real, double>)
    return Rational(x);
  else
    return exact(x);
}

/// Whether the enclosure holds the ideal number.
template <class Real>
::testing::AssertionResult holds(const Enclosed<Real>& e, const Rational& ideal) {
  if (abs(value(e.mid) - ideal) <= Rational(e.rad)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << "off by " << Rational(value(e.mid) - ideal).get_d() << ", radius " << e.rad;
}

template <class Real>
class EnclosedNumbers : public testing::Test {
 protected:
  /// An enclosure of a number of its own, at times as wide as half of it.
  std::pair<Enclosed<Real>, Rational> next() {
    const DoubleDouble ideal = numbers_.next();
    const double rad = std::ldexp(std::fabs(ideal.hi), -(static_cast<int>(step_++ % 60) + 1));
    if constexpr (std::is_same_v<Real, double>)
      return {{ideal.hi, rad + std::fabs(ideal.lo)}, exact(ideal)};
    else
      return {{ideal + DoubleDouble(rad * 0.75), rad}, exact(ideal)};
  }

 private:
  Numbers numbers_;
  unsigned step_ = 0;
};
using Precisions = testing::Types<double, DoubleDouble>;
TYPED_TEST_SUITE(EnclosedNumbers, Precisions);

TYPED_TEST(EnclosedNumbers, OperationsHoldTheIdealResult) {
  for (int i = 0; i < 20000; ++i) {
    const auto [a, x] = this->next();
    const auto [b, y] = this->next();
    EXPECT_TRUE(holds(a + b, x + y));
    EXPECT_TRUE(holds(a - b, x - y));
    EXPECT_TRUE(holds(a * b, x * y));
    if (b.sign() != 0) {
      EXPECT_TRUE(holds(a / b, x / y));
      EXPECT_EQ(b.sign(), sgn(y));
    }
    const auto square = a * a;
    if (square.sign() <= 0) continue;
    const auto r = root(square);  // of the square of |x|
    EXPECT_TRUE(holds(r, abs(x)));
  }
}

TYPED_TEST(EnclosedNumbers, ProductsOfVectorsHoldTheIdealOnes) {
  using Vector = EnclosedVector<TypeParam>;
  for (int i = 0; i < 20000; ++i) {
    const auto [ax, x1] = this->next();
    const auto [ay, y1] = this->next();
    const auto [bx, x2] = this->next();
    const auto [by, y2] = this->next();
    const Vector a{ax.mid, ay.mid, std::max(ax.rad, ay.rad)};
    const Vector b{bx.mid, by.mid, std::max(bx.rad, by.rad)};
    EXPECT_TRUE(holds(dot(a, b), x1 * x2 + y1 * y2));
    EXPECT_TRUE(holds(cross(a, b), x1 * y2 - y1 * x2));
    const Vector sum = a + b;
    EXPECT_TRUE(holds(Enclosed<TypeParam>{sum.x, sum.rad}, x1 + x2));
    const Vector scaled = ax * b;
    EXPECT_TRUE(holds(Enclosed<TypeParam>{scaled.y, scaled.rad}, x1 * y2));
  }
}

}  // namespace
}  // namespace dgt
