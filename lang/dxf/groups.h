// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "kernel/number.h"
#include "lang/text/diagnostic.h"

namespace dgt {

/// A pair of lines of a DXF file: what the value means, and the value.
struct DxfGroup {
  int code = 0;
  Range value;  ///< without blanks around it

  [[nodiscard]] std::string_view text() const { return value.text(); }
  [[nodiscard]] bool is(int c, std::string_view t) const { return code == c && text() == t; }
};

/// A number of a drawing has at most this many digits.
inline constexpr std::ptrdiff_t kMaxDxfDigits = 200;
/// No coordinate of a part is larger, in the drawing's unit: a thousand kilometres in mm.
inline constexpr long kMaxDxfNumber = 1'000'000'000;

/// Reads a DXF file pair by pair, and numbers exactly. Nothing is guessed: a code that is no number
/// would shift all that follows, so it ends the reading.
class DxfGroups {
 public:
  DxfGroups(const SourceFile& file, DiagnosticBag& bag) : file_(file), bag_(bag) {}

  /// The next pair; comments (999) are passed over. Nothing at the end and behind a fault.
  [[nodiscard]] std::optional<DxfGroup> next();
  /// Whether the pairs ended in a fault that has been told.
  [[nodiscard]] bool is_broken() const { return broken_; }

  /// The value as a decimal; a value that is none, or beyond kMaxDxfNumber, is an error and 0.
  [[nodiscard]] Rational number(const DxfGroup& group);
  /// The value as a whole number, likewise.
  [[nodiscard]] long whole(const DxfGroup& group);

 private:
  [[nodiscard]] Range line(std::uint32_t number) const;

  const SourceFile& file_;
  DiagnosticBag& bag_;
  std::uint32_t next_line_ = 1;
  bool broken_ = false;
};

}  // namespace dgt
