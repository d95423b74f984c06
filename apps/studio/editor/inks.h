// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QStringView>
#include <cstdint>
#include <vector>

#include "apps/driver/pipeline.h"

/// What the parts of a line are, for their colours.
namespace dgt::studio {

enum class Ink : std::uint8_t { Element, Number, Keyword, Variable, Comment };

/// Characters `begin` to `begin + length` of a line, in UTF-16 units.
struct InkedRange {
  int begin = 0;
  int length = 0;
  Ink ink = Ink::Comment;

  friend bool operator==(const InkedRange&, const InkedRange&) = default;
};

/// Lines beyond this are left as they are: no program has them, and a file of one line must not
/// stop the editor.
inline constexpr qsizetype kLongestInkedLine = 4000;

/// The inks of a line, from left to right; what is nothing of them is left out. DGT is cut by the
/// lexer of the compiler; NC programs, which have no comments across lines either, by letters,
/// numbers and brackets.
[[nodiscard]] std::vector<InkedRange> inks_of(QStringView line, InputLanguage language);

/// The colour of an ink in force.
[[nodiscard]] QColor colour_of(Ink ink);

}  // namespace dgt::studio
