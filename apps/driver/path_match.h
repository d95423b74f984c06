// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/measure.h"
#include "kernel/progress.h"

/// Which blocks of a program that was read back run which move of the exact path, and how far away.
///
/// Nouns. A *stop* is the end of a move that travels. Every stop of the exact path has to be a stop
/// of the program, within half a unit on each axis; between two of them the program may have
/// further stops, which have to lie beside the exact move within half a unit, too: arcs are
/// divided. A move may be left out when all of it is that near. All ways to match the two are
/// followed at once, so that a stop which could be taken for two is no matter.
namespace dgt {

struct MatchOptions {
  Rational unit;   ///< of the program, mm
  Rational limit;  ///< the largest distance of the curves, mm
  /// False when the program does not tell cuts from rapids.
  bool tells_cuts = true;
  OnProgress on_progress;  ///< of the exact path's moves
  /// Moves of the exact path that a control offsets, by their indices; empty: none. The program has
  /// their contour, whose stops lie within half a unit, and how far those beside it are off depends
  /// on the corners; they may lie `limit` off on each axis.
  std::vector<bool> offset_by_control{};
};

/// One move of the exact path and what runs it.
struct MatchedMove {
  std::size_t exact = 0;  ///< index into the moves of the exact path
  std::size_t first = 0;  ///< moves [first, last) of the program, those between included that do
  std::size_t last = 0;   ///< not travel; equal: left out
  double deviation = 0;   ///< upper bound of the distance both ways, mm
  double error_x = 0;     ///< upper bounds of the distance of the last stop from the exact one, mm
  double error_y = 0;
};

/// Why the program does not run the exact path.
struct MatchFault {
  enum class Kind : std::uint8_t {
    Start,      ///< begins beside the path by dx, dy
    Displaced,  ///< stops beside the path by dx, dy
    Deviates,   ///< runs beside the path by `measure` at most, which is beyond the limit
    WrongKind,  ///< cuts where the path is rapid, or the other way about
    Lost,       ///< nothing here resembles the path any more; what follows was not compared
    Ended,      ///< the program ends before the path
    Surplus     ///< the program goes on behind the path
  };
  Kind kind;
  std::size_t exact = 0;  ///< of the path; its number of moves: behind its end
  std::size_t first = 0;  ///< the program's moves, one of which it is: [first, last]
  std::size_t last = 0;
  double dx = 0;  ///< mm
  double dy = 0;
  double measure = 0;  ///< mm
};

struct PathMatch {
  RationalPoint
      shift;  ///< to be added to the program: an incremental one begins at the path's start
  std::vector<MatchedMove> moves;  ///< as far as there is a match
  std::vector<MatchFault> faults;  ///< empty: all of both paths is matched
  bool is_complete = false;        ///< no move of either was left uncompared
};

/// Faults that are told; a program that is wrong everywhere is not told so a million times.
inline constexpr std::size_t kMaxMatchFaults = 20;

[[nodiscard]] PathMatch match(const Toolpath& program, const Toolpath& exact,
                              const MatchOptions& options);

}  // namespace dgt
