// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "kernel/contour.h"

namespace dgt::language {

struct OpenContour;

/// A contour that can be cut once one of its elements is turned round: a minus was forgotten, or is
/// too much.
struct Turn {
  std::size_t item = 0;  ///< the element; with it turns every item that its word made, in a loop
  BuiltContour built;    ///< the contour with it turned
};

/// Looks for such an element where the tool cuts into the contour. `before`: where the tool stood.
/// Only what the faults name is tried, since who turns elements long enough gets some contour.
[[nodiscard]] std::optional<Turn> find_turn(const OpenContour& contour, const BuiltContour& built,
                                            const ToolState& before, const ContourOptions& options);

}  // namespace dgt::language
