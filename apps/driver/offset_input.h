// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "kernel/chain.h"
#include "kernel/toolpath.h"

namespace dgt {

/// The part of a contour of `path` as a loop of its own: the programmed path without leads and
/// positioning, and where the beginning and the end run over each other once only. Open when these
/// do not meet; nothing when it is not in one piece. Lines and arcs are those of the path, within
/// 2⁻⁹⁶ mm: joints as rational points, arcs as the rational ones of arc(), full circles as two
/// halves. The direction is the programmed one.
[[nodiscard]] std::optional<Chain> loop_of(const Toolpath& path, const Contour& contour);

}  // namespace dgt
