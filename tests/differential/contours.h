// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "kernel/chain.h"

/// Simple contours to offset, by the thousand, in which the degenerate is ordinary.
namespace dgt::differential {

struct Case {
  std::vector<std::vector<BulgeVertex>> loops;  ///< all closed
  Rational distance;

  [[nodiscard]] std::vector<Chain> chains() const;
  /// In the form of .poly files, with the distance as a comment: to be fed to `dgt offset`.
  [[nodiscard]] std::string to_text() const;
};

enum class Family : std::uint8_t {
  Star,      ///< random decimals about a centre, half of the edges arcs
  Grid,      ///< walls and teeth on a whole-number grid, distances that just fill them
  Rounded,   ///< right angles with fillets, tangent to the last bit or to a few decimals
  Slots,     ///< round-ended slots as wide as the tool, or off by 10⁻⁹
  Islands,   ///< a star with holes, some nearer to each other than the tool is wide
  Minute,    ///< the same ten thousand times smaller
  Offset,    ///< an equidistant, rounded to doubles
  Touching,  ///< loops, and parts of one loop, that share vertices and edges
};

/// The same for the same numbers on every machine.
[[nodiscard]] Case make(Family family, std::uint32_t seed);

}  // namespace dgt::differential
