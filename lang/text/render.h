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
/// range, and the replacement of the fix-it under the caret; then the notes in the same form. A
/// line longer than 120 characters is shown as a window around the range.
[[nodiscard]] std::string render(const Diagnostic& diagnostic, const RenderOptions& options = {});

/// Every diagnostic of the bag, in its order.
[[nodiscard]] std::string render(const DiagnosticBag& bag, const RenderOptions& options = {});

}  // namespace dgt
