// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "lang/dgt/forms.h"
#include "lang/dgt/word.h"
#include "lang/text/source_file.h"

/// The syntax of a DGT program: what its lines say, before anything is computed.
namespace dgt::language {

inline constexpr int kVariableCount = 30;  ///< N1…N30 and B1…B30
inline constexpr int kMaxElementNumber = 9999;

/// A number as written: a decimal or a variable, with its sign.
struct Number {
  NumberForm form = NumberForm::None;
  bool minus = false;
  std::int32_t whole = 0;                 ///< the variable's number, or a whole decimal unsigned
  std::shared_ptr<const Rational> exact;  ///< any other decimal, unsigned

  [[nodiscard]] bool is_absent() const { return form == NumberForm::None; }
  [[nodiscard]] bool is_variable() const { return form == NumberForm::Variable; }
};

/// The number of a word.
[[nodiscard]] Number number_of(const Word& word);

/// A letter with its number, as operand of a definition or item of a contour. An inline `X5 Y7` is
/// one item with the letter P; a selector `X>` is `I3`.
struct Item {
  char letter = 0;
  bool is_inline_point = false;
  std::uint32_t line = 1;
  std::uint32_t column = 1;
  Number number;  ///< of an inline point, its X
  Number second;  ///< of an inline point, its Y
  Range range;
};

/// `L5=…`
struct Definition {
  ElementKind kind = ElementKind::Line;
  Item target;
  std::vector<Item> operands;  ///< without the selector
  FormMatch match;             ///< no form when the statement is broken
  std::vector<Item> selector;  ///< at most one
};

/// `N5=N1*N2+3`, worked strictly from left to right.
struct NumberAssignment {
  struct Term {
    char operation = '+';  ///< `+ - * /`, how the number joins what stands before it
    Number number;
    Range range;
  };
  std::uint8_t variable = 1;
  std::vector<Term> terms;
};

/// `B1="C2 P4 L5,"`
struct TextAssignment {
  Item target;
  std::shared_ptr<const std::vector<Word>> words;
};

/// `K1 …`
struct ContourStart {
  Item target;
  std::vector<Item> items;
};

/// Any other line of items: with a comma it goes on with the contour.
struct ItemLine {
  std::vector<Item> items;
  bool has_comma = false;
};

/// `FOR 5`; the statements up to `end`, which is its LoopEnd, are the body.
struct ForLoop {
  Number count;
  Range count_range;
  std::size_t end = 0;
};
struct LoopEnd {
  std::size_t begin = 0;
};

/// `MAC KVAD 10,20,`
struct MacroCall {
  struct Argument {
    Number number;
    Range range;
  };
  Range name;
  std::vector<Argument> arguments;
};

/// `OPR det1opr`
struct DefinitionFile {
  Range name;
};

/// A line that uses B texts: parsed when it is reached, with the texts as they are then.
struct SplicedLine {
  std::vector<Word> words;
};

/// `'@ key value`
struct Directive {
  Range key;
  Range value;
};

struct Statement {
  using Body = std::variant<Definition, NumberAssignment, TextAssignment, ContourStart, ItemLine,
                            ForLoop, LoopEnd, MacroCall, DefinitionFile, SplicedLine, Directive>;
  Body body;
  Range range;
  bool broken = false;  ///< an error in it has been reported; what it makes is unknown
};

/// Statements of a source file in order, loops flat: all of them or a piece with whole loops.
struct Program {
  const SourceFile* file = nullptr;
  std::vector<Statement> statements;
};

}  // namespace dgt::language
