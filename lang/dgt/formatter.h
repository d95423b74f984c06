// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "lang/text/diagnostic.h"

namespace dgt::language {

/// The source in canonical layout, valid UTF-8 with LF line ends; encode() with the form of the
/// file writes it as it lay. Nothing when the lexer or the parser finds an error; whatever they
/// find goes to `bag`.
///
/// One statement a line, Latin capitals, a letter and its number together, one blank between items,
/// numbers in their shortest spelling (a minus stays, also before 0: `A-0` is an idiom, `L-0` the
/// reverse of L0). Commas stay where they say something: behind the arguments of MAC, in texts and
/// in lines that use texts, and once, at the end, in a line that goes on with a contour. Bodies of
/// FOR are indented by two. Comments behind code stand in one column through runs of lines that
/// have them; their words are never touched. Blank lines stay, one for a run of them, none at the
/// beginning and end.
///
///  (1) Formatting twice is formatting once.
///  (2) The program keeps its meaning: the same tool path but for places in the source.
///  (3) Every comment stays, in its order, but for blanks at its end.
[[nodiscard]] std::optional<std::string> format(const SourceFile& file, DiagnosticBag& bag);

}  // namespace dgt::language
