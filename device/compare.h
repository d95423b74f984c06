// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "device/iso7.h"

namespace dgt {

/// One row in which a tape is not what it should be.
struct RowDifference {
  enum class Kind : std::uint8_t {
    Changed,  ///< `found` instead of `wanted`
    Missing,  ///< `wanted` is not there
    Extra     ///< `found` stands there besides
  };
  Kind kind = Kind::Changed;
  std::size_t wanted_row = 0;  ///< from 0, on the tape as it should be
  std::size_t found_row = 0;   ///< from 0, on the tape as it is
  Row wanted = 0;
  Row found = 0;

  friend bool operator==(const RowDifference&, const RowDifference&) = default;
};

/// What differs, row by row.
struct TapeDifferences {
  static constexpr std::size_t kMost = 1000;

  std::vector<RowDifference> rows;  ///< the first kMost
  std::size_t count = 0;
};

/// Compares what is punched; how much blank tape lies before and behind it makes no difference.
///  (1) No differences only if all rows between are the same.
///  (2) Up to kMostShift rows that are missing or too many are told as that, not as a change of all
///      that follow, when the kInStep rows behind them agree.
[[nodiscard]] TapeDifferences compare_rows(std::span<const Row> wanted, std::span<const Row> found);

inline constexpr std::size_t kInStep = 16;
inline constexpr std::size_t kMostShift = 64;

}  // namespace dgt
