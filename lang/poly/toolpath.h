// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/toolpath.h"
#include "lang/poly/reader.h"

namespace dgt {

/// Runs along the edges of a chain.
[[nodiscard]] std::vector<Move> moves_along(const Chain& chain);

/// The loops as contours without an offset, in their order, rapids between them. The tool starts
/// at the first vertex. `file`: where the loops were read from.
[[nodiscard]] Toolpath toolpath_of(const std::vector<PolyLoop>& loops, const SourceFile& file);

}  // namespace dgt
