// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "apps/driver/pipeline.h"
#include "post/svg_names.h"

namespace dgt {

/// What a drawing of a program may name: its lines, circles, points and coordinate systems, as they
/// stand at the end and in their own directions; but an element that a contour moves by A or O as
/// it is cut there, by the word that says so (`L-2`); and the fillets, chamfers and tangents of the
/// contours by theirs (`R5`). Nothing without a path.
[[nodiscard]] std::vector<NamedShape> names_of(const Compilation& made);

}  // namespace dgt
