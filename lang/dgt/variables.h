// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "lang/dgt/syntax.h"

namespace dgt::language {

/// N1…N30 and B1…B30. A macro shares them with its program.
class Variables {
 public:
  using TextWords = std::shared_ptr<const std::vector<Word>>;

  struct NumberVariable {
    std::optional<Rational> value = Rational(0);  ///< nothing: its assignment failed
    Range place;                                  ///< its last assignment; no file: none yet
    const SourceFile* owner = nullptr;  ///< the file it was assigned for: of an argument, the macro
  };
  struct TextVariable {
    TextWords words;  ///< null: never assigned, or its assignment failed
    bool failed = false;
  };

  /// Indices count from 1.
  [[nodiscard]] NumberVariable& number(int index) {
    return numbers_.at(static_cast<std::size_t>(index - 1));
  }
  [[nodiscard]] TextVariable& text(int index) {
    return texts_.at(static_cast<std::size_t>(index - 1));
  }

  /// What a written number is worth now; nothing when it rests on a failed assignment.
  /// Precondition: the number is not absent.
  [[nodiscard]] std::optional<Rational> value(const Number& number) const;

 private:
  std::array<NumberVariable, kVariableCount> numbers_;
  std::array<TextVariable, kVariableCount> texts_;
};

}  // namespace dgt::language
