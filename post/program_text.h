// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "post/plan.h"

namespace dgt {

/// A unit as a whole number of steps of its last decimal.
struct DecimalUnit {
  std::int64_t steps = 1;
  int decimals = 0;
};
[[nodiscard]] DecimalUnit decimal_unit(const Rational& unit);

/// Appends a number of units in mm as `spelling` wants it.
void append_millimetres(fmt::memory_buffer& out, std::int64_t units, const DecimalUnit& unit,
                        const Spelling& spelling);

/// The lines of a program, the same for all forms: header, footer, line numbers, line ends, and the
/// limits of the dialect.
class ProgramText {
 public:
  /// Begins with the header. What passes a limit goes to `faults`.
  ProgramText(const Plan& plan, const Dialect& dialect, std::vector<WriteFault>& faults);

  /// A line that belongs to a move.
  void add(std::string_view line, std::size_t move);
  /// Whether a number may be written, in units.
  void check_size(std::int64_t units, std::size_t move);
  /// Ends with the footer.
  [[nodiscard]] std::string finish();

 private:
  void append(std::string_view line);
  void add_line(const std::string& line);
  void fault(WriteFault::Kind kind, std::size_t move);

  const Plan& plan_;
  const Dialect& dialect_;
  std::vector<WriteFault>& faults_;
  std::int64_t largest_;
  long long next_number_;
  fmt::memory_buffer out_;
};

/// What the feed words of a program say: a feed is said where it changes.
class FeedWords {
 public:
  explicit FeedWords(const Dialect& dialect) : dialect_(dialect) {}

  /// The number to write before the cut `move`, empty: none.
  [[nodiscard]] std::string next(const Move& move);

 private:
  [[nodiscard]] const Rational* feed_of(const Move& move) const;

  const Dialect& dialect_;
  const Rational* last_ = nullptr;
};

/// The number of a dwell in the dialect's unit.
[[nodiscard]] std::string dwell_number(const Move& move, const Dialect& dialect);

/// What no number that is written passes, in units.
[[nodiscard]] std::int64_t largest_units(const Dialect& dialect);

}  // namespace dgt
