// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "lang/text/diagnostic.h"

namespace dgt {

/// A text with fix-its put in place.
struct FixedText {
  std::string text;
  std::vector<const Diagnostic*> applied;  ///< whose fix-its, in the order of the text
};

/// Puts in place the fix-its of errors and warnings about `file` that are sure. Of those whose
/// ranges overlap, or that insert at one place, the first is taken: once it is there the others
/// may mean something else. Fix-its about other files are left out.
[[nodiscard]] FixedText apply_fixes(const SourceFile& file, const DiagnosticBag& bag);

}  // namespace dgt
