// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/dgt_elements.h"

#include <algorithm>
#include <utility>

#include "post/dgt.h"

namespace dgt {
namespace {

/// Of exact coordinates, enough for every digit that is written.
constexpr int kCoordinateExponent = -80;

std::string decimal(const Rational& value) { return to_short_decimal(value, kDgtDecimals); }

std::string signed_name(char letter, std::size_t number, bool reversed) {
  return letter + std::string(reversed ? "-" : "") + std::to_string(number);
}

Rational rounded(const Rational& value, int decimals) {
  return *parse_decimal(to_decimal(value, decimals));
}

}  // namespace

Rational dgt_number(const Rational& value) {
  constexpr int kShort = 6;
  static const Rational kSlack(1, 100'000'000'000);  // what doubles of a metre leave, and more
  const Rational near = rounded(value, kShort);
  return abs(near - value) <= kSlack ? near : rounded(value, kDgtDecimals);
}

RationalPoint dgt_place(const Point& p) {
  const ExactPoint exact = p.exact();
  return {dgt_number(rational_within(exact.x, kCoordinateExponent)),
          dgt_number(rational_within(exact.y, kCoordinateExponent))};
}

std::string dgt_coordinates(const RationalPoint& p) {
  return "X" + decimal(p.x) + " Y" + decimal(p.y);
}

std::size_t DgtNames::define(char letter, const std::string& form) {
  const auto [found, is_new] = forms_.emplace(letter + form, numbers_[letter] + 1);
  if (is_new) {
    ++numbers_[letter];
    definitions_.push_back(letter + std::to_string(found->second) + "=" + form);
  }
  return found->second;
}

std::string DgtNames::by_form(char letter, const std::string& form) {
  return signed_name(letter, define(letter, form), false);
}

std::string DgtNames::point(const RationalPoint& p) { return by_form('P', dgt_coordinates(p)); }

std::string DgtNames::line(const RationalPoint& from, const RationalPoint& to) {
  const Vector w = to - from;
  const bool steep = abs(w.y) > abs(w.x);
  const Rational slope = steep ? w.x / w.y : w.y / w.x;
  const Rational offset = steep ? from.x - slope * from.y : from.y - slope * from.x;
  const auto [found, is_new] = lines_.emplace(LineKey{steep, slope, offset}, NamedLine{});
  NamedLine& named = found->second;
  if (is_new) {
    // L=X points down, L=Y to the right.
    if (sgn(w.x) == 0)
      named = {define('L', "X" + decimal(from.x)), {0, -1}};
    else if (sgn(w.y) == 0)
      named = {define('L', "Y" + decimal(from.y)), {1, 0}};
    else
      named = {define('L', dgt_coordinates(from) + " " + dgt_coordinates(to)), w};
  }
  return signed_name('L', named.number, sgn(dot(named.direction, w)) < 0);
}

std::string DgtNames::circle(const RationalPoint& centre, const Rational& radius, bool ccw) {
  return signed_name('C', define('C', dgt_coordinates(centre) + " R" + decimal(abs(radius))), !ccw);
}

std::string DgtNames::circle_through(const RationalPoint& a, const RationalPoint& b,
                                     const RationalPoint& c, bool ccw) {
  const std::string form = dgt_coordinates(a) + " " + dgt_coordinates(b) + " " + dgt_coordinates(c);
  return signed_name('C', define('C', form), !ccw);
}

std::vector<std::string> DgtNames::take_definitions() { return std::exchange(definitions_, {}); }

std::size_t DgtNames::largest() const {
  std::size_t most = 0;
  for (const auto& [letter, number] : numbers_) most = std::max(most, number);
  return most;
}

void DgtNames::begin_anew() {
  for (auto& [letter, number] : numbers_) number = 0;
  forms_.clear();
  lines_.clear();
}

}  // namespace dgt
