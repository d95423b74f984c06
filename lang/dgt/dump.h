// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "lang/dgt/syntax.h"

namespace dgt::language {

/// One line per source line that has words: its number, then its words as kind and canonical
/// spelling, `8: A-60 , L1 C2 L-2 C-1`.
[[nodiscard]] std::string print_words(const SourceFile& file);

/// One line per statement, its kind in front, loops indented: `definition C2 = PR: P(14,0) R-5`.
[[nodiscard]] std::string print_syntax(const SourceFile& file);

/// A number as the canonical layout writes it: `-0.5`, `N3`, `-N3`; empty when absent.
[[nodiscard]] std::string to_text(const Number& number);
/// A word as the canonical layout writes it: `L-2`, `X>`, `FOR`; names and directives as they are.
[[nodiscard]] std::string to_text(const Word& word);
/// An item in canonical spelling: `L-2`, `X5Y7`, `V`, `I3`.
[[nodiscard]] std::string to_text(const Item& item);

}  // namespace dgt::language
