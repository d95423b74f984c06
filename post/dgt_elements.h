// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "kernel/toolpath.h"

namespace dgt {

/// A coordinate as it is written: short where that is within 10⁻¹¹ mm, else with kDgtDecimals.
[[nodiscard]] Rational dgt_number(const Rational& value);
[[nodiscard]] RationalPoint dgt_place(const Point& p);
/// ` X1.5 Y-2`
[[nodiscard]] std::string dgt_coordinates(const RationalPoint& p);

/// The names of what is defined, each thing once, and the lines that define it.
class DgtNames {
 public:
  /// `P1`
  [[nodiscard]] std::string point(const RationalPoint& p);
  /// `L1`, or `L-1` where the line was defined the other way. Precondition: they differ.
  [[nodiscard]] std::string line(const RationalPoint& from, const RationalPoint& to);
  /// `C1`; `C-1` when clockwise.
  [[nodiscard]] std::string circle(const RationalPoint& centre, const Rational& radius, bool ccw);
  [[nodiscard]] std::string circle_through(const RationalPoint& a, const RationalPoint& b,
                                           const RationalPoint& c, bool ccw);
  /// What `form` defines, of the letter; the same form twice is one.
  [[nodiscard]] std::string by_form(char letter, const std::string& form);

  /// The definitions since the last call, a line each.
  [[nodiscard]] std::vector<std::string> take_definitions();
  /// Forgets the names, so that numbers begin anew: elements may be defined again.
  void begin_anew();
  /// The largest number that has been given.
  [[nodiscard]] std::size_t largest() const;

 private:
  struct LineKey {
    bool steep = false;
    Rational slope;
    Rational offset;
    auto tied() const { return std::tie(steep, slope, offset); }
    friend bool operator<(const LineKey& a, const LineKey& b) { return a.tied() < b.tied(); }
  };
  struct NamedLine {
    std::size_t number = 0;
    Vector direction;
  };
  std::size_t define(char letter, const std::string& form);

  std::map<char, std::size_t> numbers_{{'P', 0}, {'L', 0}, {'C', 0}};
  std::map<std::string, std::size_t> forms_;  ///< with the letter before
  std::map<LineKey, NamedLine> lines_;
  std::vector<std::string> definitions_;
};

}  // namespace dgt
