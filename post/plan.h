// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "post/arc_fit.h"
#include "post/write.h"

/// The blocks of a program in whole units, before they get their spelling: what all dialects share.
namespace dgt {

/// No piece is written that deviates more, in units. A line deviates by at most √½ at its ends and
/// by a sagitta under a half, 1.21 in all; an arc that would deviate more than this is divided, in
/// the end into lines.
inline constexpr double kWorstDeviation = 1.25;
/// Up to here, in units, a written arc is the exact one, told apart only by the stand-ins of
/// irrational numbers and the balls.
inline constexpr double kExactDeviation = 1e-6;
/// An arc whose sagitta is less, in units, is written as a line.
inline constexpr double kLeastSagitta = 0.5;

enum class BlockKind : std::uint8_t { Rapid, Line, Arc, Dwell, Words };

struct Block {
  BlockKind kind = BlockKind::Rapid;
  bool has_height = false;
  WrittenArc path;          ///< ends; of arcs all of it
  std::int64_t height = 0;  ///< in units from 0 mm, reached at the end
  std::size_t move = 0;     ///< the move it belongs to; their number: the start or the end
  std::string words;        ///< of Words
};

struct Plan {
  GridPoint start;  ///< where the program begins
  std::vector<Block> blocks;
  WriteReport report;
  std::vector<WriteFault> faults;
};

/// `words`: further lines to be written before a move, those of the number of moves at the end.
[[nodiscard]] Plan plan(const Toolpath& path, const Dialect& dialect,
                        const std::map<std::size_t, std::vector<std::string>>& words = {},
                        const OnProgress& on_progress = {});

}  // namespace dgt
