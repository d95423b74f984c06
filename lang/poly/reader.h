// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "kernel/chain.h"
#include "lang/text/diagnostic.h"

/// Polylines with bulges, the plain form in which contours are exchanged. One vertex a line, `x y
/// bulge`, parted by blanks or tabs: decimals (`-0.25`, `2e-5`), parsed exactly. The bulge is
/// tan(sweep/4) of the arc to the next vertex, 0 a line, positive counter-clockwise. A blank line
/// ends a loop, `#` begins a comment, and a line that holds nothing but a comment is as if it were
/// not there. A line `open` before the first vertex makes the loop open.
namespace dgt {

struct PolyLoop {
  Chain chain;
  std::vector<Range> places;  ///< for each edge of the chain the vertex that it begins at
};

/// A number has at most this many digits.
inline constexpr std::ptrdiff_t kMaxPolyDigits = 200;

/// The loops of a file, in its order.
///  (1) Vertices are exact; arcs are the rational ones of chain_of().
///  (2) A file without vertices has no loops, which is no fault.
///  (3) A line with a fault is reported and reading goes on; its loop is not among the result.
///  Loops
///      that cross are not looked for.
[[nodiscard]] std::vector<PolyLoop> read_poly(const SourceFile& file, DiagnosticBag& bag);

}  // namespace dgt
