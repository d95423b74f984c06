// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "post/plan.h"

namespace dgt {

/// The blocks as ESSI in whole units, a sign always, a sign alone for zero: `<±X><±Y>`; arcs by
/// radius `<±X><±Y>+R<S><D>`, S `+` the large arc, `-` the small one; arcs by centre
/// `<±X><±Y><±I><±J><D>`, seen from where they begin; D is the sense, as the dialect has it.
[[nodiscard]] std::string essi_text(const Plan& plan, const Toolpath& path, const Dialect& dialect,
                                    std::vector<WriteFault>& faults);

}  // namespace dgt
