// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/progress.h"
#include "kernel/toolpath.h"
#include "lang/text/diagnostic.h"

/// What the readers of NC programs share: options, and what a program comes to.
namespace dgt {

/// How the tool comes from its programmed place to its offset.
enum class KerfLead : std::uint8_t {
  Moved,  ///< it does not: all that is cut with the kerf is moved, and the rapid leads to where
          ///< that begins
  Meets,  ///< on the first cut, which is straight, to where its offset and the next cut's meet
  Beside  ///< likewise, to beside where the next cut begins
};

struct NcOptions {
  /// The two radii of an arc about a centre may differ by at most this, in mm. The default is the
  /// step of the coarsest controls: what its grid can make of an arc, and no more.
  Rational arc_tolerance = Rational(1, 10);
  /// Take the radius of an arc that lacks at most one unit for its chord as half the chord.
  bool repair = false;
  /// How wide the tool cuts, in mm; a kerf without a value of its own is offset by half of it.
  Rational kerf_width;
  KerfLead kerf_lead = KerfLead::Moved;
  std::uint64_t max_moves = 10'000'000;
  /// Executed, those of subprograms counted as they run.
  std::uint64_t max_blocks = 10'000'000;
  OnProgress on_progress;  ///< of the lines read
};

/// The kerf compensation that is in force from a move on.
struct KerfSwitch {
  std::size_t move = 0;    ///< index into Toolpath::moves; their number: at the end
  Side side = Side::None;  ///< None: off
  Rational offset;         ///< mm, how far the tool runs beside the contour
  Range block;
};

/// One run of a subprogram: the moves it made, and the block that called it.
struct SubprogramRun {
  std::size_t first = 0;  ///< moves [first, last)
  std::size_t last = 0;
  long number = 0;
  Range call;
};

/// What the radii of arcs were taken for.
struct ArcSummary {
  std::size_t arcs = 0;
  std::size_t adjusted = 0;       ///< whose radii differ within the tolerance
  double largest_difference = 0;  ///< mm
  std::optional<Range> worst;
  /// Each of the adjusted ones about a centre, in the order in which they were read.
  struct Mismatch {
    Range block;
    double difference = 0;  ///< mm
  };
  std::vector<Mismatch> mismatches;
  /// Blocks of 3B, lines too, that controls end so far apart, in the order in which they were read.
  std::vector<Mismatch> apart;
};

/// A program as read, before its kerf is applied.
struct NcProgram {
  Toolpath path;
  std::vector<KerfSwitch> kerf;     ///< in the order of the moves
  std::vector<SubprogramRun> runs;  ///< in the order in which they ended
  SourcePlace placed_by;            ///< what told where the program starts; line 0: nothing
  ArcSummary arcs;
  Rational step;  ///< of the grid that its numbers lie on, mm; 0: not known
};

}  // namespace dgt
