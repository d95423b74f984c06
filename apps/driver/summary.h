// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "apps/driver/timing.h"
#include "kernel/toolpath.h"
#include "lang/text/diagnostic.h"
#include "post/figures.h"

namespace dgt {

inline constexpr std::size_t kMoveKinds = 5;

/// What a tool path amounts to.
struct Summary {
  std::array<std::size_t, kMoveKinds> moves{};  ///< by MoveKind
  std::size_t contours = 0;
  std::size_t pierces = 0;  ///< how often cutting begins after the start or a rapid
  Lengths length;           ///< mm
  double dwell = 0;         ///< seconds
  Box box;                  ///< of everything travelled; empty when nothing is
  Times times;              ///< under the machine's settings
};
[[nodiscard]] Summary summarise(const Toolpath& path, const MotionSettings& motion = {});

/// How long the ways of a path are, in mm; approaches and departures count.
struct WayLengths {
  double programmed = 0;  ///< cut along the contours with W = 0
  double cut = 0;         ///< cut by the tool
  double rapid = 0;
};
[[nodiscard]] WayLengths way_lengths(const Toolpath& path);

/// A few lines for a person; lengths with three decimals.
[[nodiscard]] std::string to_text(const Summary& summary, Language language);
/// `dgt-info/1`: {"schema", "units", "moves": {kind: count}, "contours", "pierces", "length":
/// {"cut", "rapid"}, "dwell", "time": {"total", "cut", "rapid", "pierce", "dwell"} in seconds,
/// "box": {"min": [x, y], "max": [x, y]} or null}.
[[nodiscard]] std::string to_json(const Summary& summary);

}  // namespace dgt
