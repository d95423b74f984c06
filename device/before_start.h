// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "device/checksum.h"
#include "device/tape.h"

namespace dgt {

/// What stands on a tape before its `%`.
struct TapeBeginning {
  struct Rows {
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  std::size_t start = 0;   ///< the row of the `%`; without one the first row that is not ours
  bool has_start = false;  ///< damaged by one hole or whole
  std::string header;
  std::optional<TapeSum> sum;
  std::vector<Rows> stray;  ///< neither blank, lettering nor checksum; not looked for when ignored
};

/// Looks for the `%`. Ignoring what is before, the first whole one is it, else the first that is
/// none of ours.
[[nodiscard]] TapeBeginning beginning_of(std::span<const Row> rows, BeforeStart before);

}  // namespace dgt
