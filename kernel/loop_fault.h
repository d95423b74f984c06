// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/chain.h"

namespace dgt {

/// Why loops bound no region.
struct LoopFault {
  enum class Kind : std::uint8_t {
    Crossing,  ///< two edges cross, or run over each other the same way
    Nesting    ///< a loop runs the same way as the one that it lies in, or beside others backwards
  };
  Kind kind = Kind::Crossing;
  std::size_t loop = 0;  ///< counts into the loops
  std::size_t other = 0;
  double x = 0, y = 0;  ///< where, mm; of Nesting: the beginning of the loop
};

/// Whether closed loops bound a region that lies left of each of them: what an equidistant of
/// them means anything for. Winding numbers tell: there are two of them, one inside the region and
/// one outside. Loops may touch, at points and along edges. Exact, but that faces smaller than
/// kOffsetResolution in both coordinates do not count: two loops that touch, in decimals.
/// Loops whose edges stay clear of each other are told at some 4 µs an edge; where some come
/// nearer than kClear an arrangement of all decides, at some 10 to 75 µs an edge.
[[nodiscard]] std::optional<LoopFault> find_loop_fault(const std::vector<Chain>& loops);

}  // namespace dgt
