// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "kernel/number.h"
#include "lang/text/source_file.h"

namespace dgt::language {

/// What a line of DGT source is made of.
enum class WordKind : std::uint8_t {
  Letter,      ///< a letter with its number: `L-2`, `X0.5`, `AN1`, `V`
  Selector,    ///< `X>`, `Y>`, `X<`, `Y<`; the number is 3, 4, 5, 6
  Number,      ///< a number without a letter, as in `FOR 5`
  Operator,    ///< `+ - * /` of an assignment, in `letter`
  Equals,      ///< `=`
  Comma,       ///< `,`
  QuoteOpen,   ///< the quote before the words of a B text
  QuoteClose,  ///< and the one behind them
  For,
  Next,
  Mac,
  Opr,
  Name,      ///< the file name behind MAC or OPR
  Directive  ///< what follows `'@`
};

enum class NumberForm : std::uint8_t { None, Decimal, Variable };

/// One word, as read. A letter is upper-case Latin.
struct Word {
  /// Whole digits of a decimal are kept in place while they fit, so that reading makes no big
  /// numbers: the value is digits / 10^scale.
  static constexpr int kMaxPlainDigits = 18;

  WordKind kind = WordKind::Comma;
  char letter = 0;
  bool minus = false;  ///< a minus stands before the number
  NumberForm form = NumberForm::None;
  std::uint32_t scale = 0;  ///< digits behind the point
  std::int64_t digits = 0;  ///< of a decimal; the number of a variable; −1: too many, read the text
  std::uint32_t line = 1;          ///< where the word stands
  std::uint32_t column = 1;        ///< in code points
  std::uint32_t number_begin = 0;  ///< where the number begins behind its sign; ends with the word
  Range range;

  [[nodiscard]] bool is(WordKind k) const { return kind == k; }
  [[nodiscard]] bool is_letter(char c) const { return kind == WordKind::Letter && letter == c; }
  /// The number as written, without its sign; empty when there is none.
  [[nodiscard]] Range number() const { return {range.file, number_begin, range.end}; }
  /// The unsigned value. Precondition: form == Decimal.
  [[nodiscard]] Rational magnitude() const;
};

}  // namespace dgt::language
