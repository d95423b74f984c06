// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/number.h"

#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "kernel/cgal/one_root_order.h"
#include "kernel/check.h"
#include "kernel/mpfr_float.h"
#include "kernel/thread_arithmetic.h"

namespace dgt {
namespace {

/// Twice the unit roundoff of long double: covers the rounding of a midpoint and, with the
/// doubling, that of the radius sums beside it.
constexpr long double kUnit = std::numeric_limits<long double>::epsilon();

constexpr auto kSignificandBits =
    static_cast<std::size_t>(std::numeric_limits<long double>::digits);

/// Below this size the relative error model of long double no longer holds (subnormals).
constexpr long double kTiny = std::numeric_limits<long double>::min() * 4;

/// The widening that keeps a radius an upper bound although it was itself summed with rounding.
constexpr long double widened(long double rad) { return rad * (1 + 8 * kUnit) + kTiny; }

/// The top 64 bits of |n| as a long double and the power of two to scale by; relative error 2⁻⁶³.
struct Leading {
  long double mantissa;
  long exponent;
};

Leading leading_bits(const mpz_t n) {
  const std::size_t limbs = mpz_size(n);
  if (limbs == 0) return {0, 0};
  static_assert(GMP_NUMB_BITS == 64, "limbs of 64 bits");
  const mp_limb_t high = mpz_getlimbn(n, static_cast<mp_size_t>(limbs - 1));
  long double m = static_cast<long double>(high) * 0x1p64L;
  if (limbs > 1) m += static_cast<long double>(mpz_getlimbn(n, static_cast<mp_size_t>(limbs - 2)));
  return {m, 64 * (static_cast<long>(limbs) - 2)};
}

/// Digits that surely fit a word of 64 bits, as does the power of ten with as many noughts.
constexpr std::size_t kMaxWordDigits = 18;

/// digits·10^−decimals. Only twos and fives can be common to both parts of the fraction, so lowest
/// terms need no greatest common divisor of long numbers.
Rational short_decimal(std::string_view digits, unsigned long decimals) {
  unsigned long numerator = 0;
  for (const char digit : digits)
    numerator = 10 * numerator + static_cast<unsigned long>(digit - '0');
  if (numerator == 0) return 0;
  unsigned long denominator = 1;
  unsigned long fives = decimals;
  for (; fives > 0 && numerator % 5 == 0; --fives) numerator /= 5;
  for (; fives > 0; --fives) denominator *= 5;
  const unsigned long twos =
      decimals - std::min(decimals, static_cast<unsigned long>(std::countr_zero(numerator)));
  numerator >>= decimals - twos;
  denominator <<= twos;
  Rational value;
  mpq_set_ui(value.get_mpq_t(), numerator, denominator);
  return value;
}

Rational long_decimal(const std::string& digits, unsigned long decimals) {
  Rational value;
  value.get_num().set_str(digits, 10);
  if (decimals > 0) {
    mpz_ui_pow_ui(value.get_den_mpz_t(), 10, decimals);
    value.canonicalize();
  }
  return value;
}

}  // namespace

Rational power_of_two(int exponent) {
  Rational r;
  if (exponent >= 0)
    mpz_ui_pow_ui(r.get_num_mpz_t(), 2, static_cast<unsigned long>(exponent));
  else {
    r = 1;
    mpz_ui_pow_ui(r.get_den_mpz_t(), 2, static_cast<unsigned long>(-exponent));
  }
  return r;
}

std::optional<Rational> parse_decimal(std::string_view text) {
  bool negative = false;
  if (!text.empty() && (text.front() == '+' || text.front() == '-')) {
    negative = text.front() == '-';
    text.remove_prefix(1);
  }
  std::string digits;
  digits.reserve(text.size());
  unsigned long decimals = 0;
  bool after_point = false;
  for (const char ch : text) {
    if (ch == '.' && !after_point) {
      after_point = true;
    } else if (ch >= '0' && ch <= '9') {
      digits.push_back(ch);
      if (after_point) ++decimals;
    } else {
      return std::nullopt;
    }
  }
  if (digits.empty()) return std::nullopt;
  Rational value = digits.size() <= kMaxWordDigits ? short_decimal(digits, decimals)
                                                   : long_decimal(digits, decimals);
  if (negative) mpq_neg(value.get_mpq_t(), value.get_mpq_t());
  return value;
}

std::optional<Rational> parse_scientific(std::string_view text) {
  const std::size_t mark = text.find_first_of("eE");
  auto value = parse_decimal(text.substr(0, mark));
  if (!value || mark == std::string_view::npos) return value;
  text.remove_prefix(mark + 1);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  int exponent = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (std::abs(exponent) > kMaxDecimalExponent) return std::nullopt;
  Integer power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
  if (exponent < 0)
    *value /= power;
  else
    *value *= power;
  return value;
}

std::string to_decimal(const Rational& value, int decimals) {
  DGT_CHECK(decimals >= 0);
  Integer scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, static_cast<unsigned long>(decimals));
  const Integer scaled = nearest_integer(value * scale);
  std::string digits = Integer(abs(scaled)).get_str();
  const auto places = static_cast<std::size_t>(decimals);
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  if (places > 0) digits.insert(digits.size() - places, ".");
  return (sgn(scaled) < 0 ? "-" : "") + digits;
}

std::string to_short_decimal(const Rational& value, int max_decimals) {
  std::string text = to_decimal(value, max_decimals);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

double nearest_double(const Rational& value) {
  // mpfr_set_q rounds once, correctly; parts are far from the limits of double, so its wider
  // exponent range changes nothing.
  MpfrFloat x(53);
  mpfr_set_q(x, value.get_mpq_t(), MPFR_RNDN);
  return mpfr_get_d(x, MPFR_RNDN);
}

Integer nearest_integer(const Rational& value) {
  // ⌊|v| + 1/2⌋ with the sign of v.
  Integer doubled = 2 * abs(value.get_num()) + value.get_den();
  Integer result;
  mpz_fdiv_q(result.get_mpz_t(), doubled.get_mpz_t(), Integer(2 * value.get_den()).get_mpz_t());
  if (sgn(value) < 0) result = -result;
  return result;
}

std::optional<Rational> exact_sqrt(const Rational& value) {
  if (sgn(value) < 0) return std::nullopt;
  if (!mpz_perfect_square_p(value.get_num_mpz_t()) || !mpz_perfect_square_p(value.get_den_mpz_t()))
    return std::nullopt;
  Rational root;
  mpz_sqrt(root.get_num_mpz_t(), value.get_num_mpz_t());
  mpz_sqrt(root.get_den_mpz_t(), value.get_den_mpz_t());
  return root;
}

Rational sqrt_within(const Rational& value, int exponent) {
  DGT_CHECK(sgn(value) >= 0);
  // ⌊√(v·4^k)⌋ / 2^k is within 2^-k of √v.
  const int k = exponent < 0 ? -exponent : 0;
  Integer scaled = value.get_num() << static_cast<unsigned long>(2 * k);
  scaled /= value.get_den();
  mpz_sqrt(scaled.get_mpz_t(), scaled.get_mpz_t());
  Rational root(scaled);
  mpq_div_2exp(root.get_mpq_t(), root.get_mpq_t(), static_cast<mp_bitcnt_t>(k));
  return root;
}

Rational on_dyadic_grid(const Rational& value, int exponent) {
  return nearest_integer(value / power_of_two(exponent)) * power_of_two(exponent);
}

std::size_t height(const Rational& value) {
  return std::max(mpz_sizeinbase(value.get_num_mpz_t(), 2),
                  mpz_sizeinbase(value.get_den_mpz_t(), 2));
}

// --- Ball -------------------------------------------------------------------------------------

Ball::Ball(const Rational& value) {
  const Leading n = leading_bits(value.get_num_mpz_t());
  if (n.mantissa == 0) return;
  const Leading d = leading_bits(value.get_den_mpz_t());
  mid = std::ldexp(n.mantissa / d.mantissa, static_cast<int>(n.exponent - d.exponent));
  const bool exact = mpz_cmp_ui(value.get_den_mpz_t(), 1) == 0 &&
                     mpz_sizeinbase(value.get_num_mpz_t(), 2) <= kSignificandBits;
  // Truncation to two limbs and rounding: at most 2⁻⁶³ in each part, and once more in the quotient.
  rad = exact ? 0 : widened(std::fabs(mid) * (4 * kUnit));
  if (sgn(value) < 0) mid = -mid;
}

std::optional<int> Ball::sign() const {
  if (mid > rad) return 1;
  if (mid < -rad) return -1;
  if (mid == 0 && rad == 0) return 0;
  return std::nullopt;
}

std::optional<double> Ball::nearest_double() const {
  const long double zero = std::ldexp(1.0L, kZeroExponent);
  const long double size = std::fabs(mid);
  if (size + rad <= zero * (1 - 4 * kUnit)) return 0.0;
  if (size - rad <= zero * (1 + 4 * kUnit)) return std::nullopt;
  const long double slack = rad + 2 * kUnit * size;  // mid ± rad is itself rounded
  const auto low = static_cast<double>(mid - slack);
  const auto high = static_cast<double>(mid + slack);
  if (low != high) return std::nullopt;
  return low;
}

Ball operator+(const Ball& a, const Ball& b) {
  const long double mid = a.mid + b.mid;
  return {mid, widened(a.rad + b.rad + std::fabs(mid) * kUnit)};
}

Ball operator-(const Ball& a, const Ball& b) {
  const long double mid = a.mid - b.mid;
  return {mid, widened(a.rad + b.rad + std::fabs(mid) * kUnit)};
}

Ball operator*(const Ball& a, const Ball& b) {
  const long double mid = a.mid * b.mid;
  return {mid, widened(std::fabs(a.mid) * b.rad + std::fabs(b.mid) * a.rad + a.rad * b.rad +
                       std::fabs(mid) * kUnit)};
}

std::optional<Ball> divide(const Ball& a, const Ball& b) {
  const long double floor = std::fabs(b.mid) - b.rad;
  if (!(floor > 0)) return std::nullopt;
  const long double mid = a.mid / b.mid;
  // |x/y − m/n| ≤ (|x−m| + |m/n|·|y−n|) / |y|
  const long double least = floor * (1 - 4 * kUnit);
  return Ball(mid, widened((a.rad + std::fabs(mid) * b.rad) / least + std::fabs(mid) * 2 * kUnit));
}

std::optional<Ball> sqrt(const Ball& a) {
  const long double least = (a.mid - a.rad) * (1 - 2 * kUnit);
  if (!(least > 0)) return a.mid == 0 && a.rad == 0 ? std::optional(Ball()) : std::nullopt;
  const long double mid = std::sqrt(a.mid);
  // |√x − √m| = |x − m| / (√x + √m) ≤ rad / √least
  return Ball(mid, widened(a.rad / (std::sqrt(least) * (1 - 4 * kUnit)) + mid * kUnit));
}

// --- OneRoot ----------------------------------------------------------------------------------

OneRoot operator+(const OneRoot& x, const Rational& y) { return {x.a + y, x.b, x.c}; }
OneRoot operator-(const OneRoot& x, const Rational& y) { return {x.a - y, x.b, x.c}; }
OneRoot operator*(const OneRoot& x, const Rational& y) { return {x.a * y, x.b * y, x.c}; }
OneRoot operator-(const OneRoot& x) { return {-x.a, -x.b, x.c}; }

OneRoot combine(const Rational& k, const OneRoot& x, const Rational& l, const OneRoot& y,
                const Rational& m) {
  if (x.is_rational()) return {k * x.a + l * y.a + m, l * y.b, y.c};
  if (y.is_rational()) return {k * x.a + l * y.a + m, k * x.b, x.c};
  DGT_CHECK(x.c == y.c);
  return {k * x.a + l * y.a + m, k * x.b + l * y.b, x.c};
}

Ball enclosure(const OneRoot& x) {
  if (x.is_rational()) return Ball(x.a);
  const auto root = sqrt(Ball(x.c));
  // A root beyond the range of long double leaves everything to the exact stage.
  if (!root) return {0, std::numeric_limits<long double>::infinity()};
  return Ball(x.a) + Ball(x.b) * *root;
}

int sign(const OneRoot& x) {
  if (x.is_rational()) return sgn(x.a);
  if (const auto certain = enclosure(x).sign()) return *certain;
  return cgal::sign(x);
}

int compare(const OneRoot& x, const OneRoot& y) {
  if (const auto certain = (enclosure(x) - enclosure(y)).sign()) return *certain;
  return cgal::compare(x, y);
}

int compare(const OneRoot& x, const Rational& y) { return sign(x - y); }

double nearest_double(const OneRoot& x) {
  if (const auto certain = enclosure(x).nearest_double()) return *certain;
  const Rational zero = power_of_two(kZeroExponent);
  if (compare(x, zero) <= 0 && compare(x, -zero) >= 0) return 0.0;
  if (x.is_rational()) return nearest_double(x.a);
  if (const auto root = exact_sqrt(x.c)) return nearest_double(Rational(x.a + x.b * *root));
  // Ziv's loop: an irrational number is never halfway between two doubles, so some precision
  // decides.
  for (int bits = 128;; bits *= 2) {
    const Rational middle = rational_within(x, -bits);
    const Rational slack = power_of_two(-bits);
    const double low = nearest_double(Rational(middle - slack));
    if (low == nearest_double(Rational(middle + slack))) return low;
  }
}

Integer nearest_integer(const OneRoot& x) {
  Integer guess = nearest_integer(rational_within(x, -8));
  const Rational half(1, 2);
  // The guess is at most one off; ties go away from zero, so the open side of the cell faces zero.
  const auto below = [&] {  // x lies under the cell of `guess`
    const int c = compare(x, guess - half);
    return sgn(guess) > 0 ? c < 0 : c <= 0;
  };
  const auto above = [&] {
    const int c = compare(x, guess + half);
    return sgn(guess) < 0 ? c > 0 : c >= 0;
  };
  while (below()) --guess;
  while (above()) ++guess;
  return guess;
}

Rational rational_within(const OneRoot& x, int exponent) {
  if (x.is_rational()) return x.a;
  // |b|·2^k ≤ 2^exponent for the error of the root
  const int size = static_cast<int>(mpz_sizeinbase(x.b.get_num_mpz_t(), 2)) -
                   static_cast<int>(mpz_sizeinbase(x.b.get_den_mpz_t(), 2)) + 1;
  return x.a + x.b * sqrt_within(x.c, std::min(exponent - size, -1));
}

void release_thread_arithmetic() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }

}  // namespace dgt
