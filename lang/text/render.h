// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "lang/text/diagnostic.h"

namespace dgt {

enum class Colour : std::uint8_t { Plain, Ansi };

/// How diagnostics are shown to a person.
struct RenderOptions {
  Language language = Language::English;
  Colour colour = Colour::Plain;
};

/// `file:line:column: error: text [CODE]`, below it the source line, a caret with tildes under the
/// range up to the end of the line, tildes under the other place at fault, and the replacement of
/// the fix-it where it would stand; then the notes in the same form. Tabs are shown as blanks up to
/// the next multiple of 8, what nobody can see as U+FFFD; a line longer than 120 characters as a
/// window around the beginning of the range. The columns told count characters, a tab is one.
[[nodiscard]] std::string render(const Diagnostic& diagnostic, const RenderOptions& options = {});

/// Every diagnostic of the bag, in its order.
[[nodiscard]] std::string render(const DiagnosticBag& bag, const RenderOptions& options = {});

}  // namespace dgt
