// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lang/text/diagnostic.h"

namespace dgt {

/// Reports what went wrong when the file's bytes became text: an encoding that was guessed without
/// certainty (a warning at the first character that depends on it), each run of bytes that are no
/// text (an error), UTF-16 (an error).
void report_reading(const SourceFile& file, DiagnosticBag& bag);

}  // namespace dgt
