// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "post/plan.h"

namespace dgt {

/// The blocks as ESSI: `<±X><±Y>` and `<±X><±Y>+R<S><D>` in whole units, a sign always, a sign
/// alone for zero; S `+` the large arc, `-` the small one; D `+` clockwise, `-` counter-clockwise.
[[nodiscard]] std::string essi_text(const Plan& plan, const Dialect& dialect);

}  // namespace dgt
