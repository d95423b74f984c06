// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "lang/dgt/syntax.h"
#include "lang/text/diagnostic.h"

namespace dgt::language {

/// Parses a whole source. Every fault is reported and the next line taken; a line with a fault
/// stays in the program, marked broken, so that what it was to make is not missed a second time.
[[nodiscard]] Program parse(const SourceFile& file, DiagnosticBag& bag);

/// Parses one line whose B texts have been put in place; `broken` says that an error in it has been
/// reported already. Nothing when the line is blank. A spliced line that still uses a text comes
/// back as SplicedLine.
[[nodiscard]] std::optional<Statement> parse_spliced(std::span<const Word> words, bool broken,
                                                     DiagnosticBag& bag);

}  // namespace dgt::language
