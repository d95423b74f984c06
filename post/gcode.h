// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "post/plan.h"

namespace dgt {

/// The blocks as G-code: positions as increments or absolute, arcs by centre or radius, F where it
/// changes, spelled as Dialect::spelling says. A radius is negative for more than half a turn.
[[nodiscard]] std::string gcode_text(const Plan& plan, const Toolpath& path, const Dialect& dialect,
                                     std::vector<WriteFault>& faults);

}  // namespace dgt
