// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "post/plan.h"

namespace dgt {

/// The blocks as G-code: `G00 G01 G02 G03 G04`, X and Y as increments (a zero word is left out) or
/// absolute (both words, always), I and J from the written start to the centre, F where it changes.
[[nodiscard]] std::string gcode_text(const Plan& plan, const Toolpath& path,
                                     const Dialect& dialect);

}  // namespace dgt
