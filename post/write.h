// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "kernel/progress.h"
#include "post/dialect.h"

/// From the tool path to the text a control reads.
namespace dgt {

/// What the dialect cannot say.
struct WriteFault {
  enum class Kind : std::uint8_t {
    UnknownCode,       ///< `code` means nothing in this dialect
    HeightImpossible,  ///< a Z in a dialect without heights
    DwellImpossible,   ///< a pause in a dialect without pauses
    OutOfRange,        ///< a coordinate or radius of more than kMaxUnits units
    MoveAfterEnd,      ///< a move follows the end of the program
    BeyondLargest,     ///< a number of the block passes Dialect::largest
    LineTooLong,       ///< the block passes Dialect::longest_line
    // Of an offset by the control (post/control_offset.h); `move` is the contour's first:
    KerfImpossible,   ///< the dialect has no words for it
    LeadLacking,      ///< no straight move leads to the contour
    LeadTooShort,     ///< it is `measure` long, and has to be longer than `limit`
    OffsetsDiffer,    ///< U within the contour
    PointsInContour,  ///< a straight cut between points within it, which W does not move
    ContourTrimmed,   ///< elements of it are left out of the equidistant
    SideChanges,      ///< it runs along some of its elements and against others
    OffsetsVary,      ///< from contour to contour, and the control has one in its settings
    EntryMissed,      ///< no straight cut from where the lead begins comes to the offset there
    EntryUnknown,     ///< nobody has said how the control comes to its offset: KerfEntry::Either
    BeginsInCorner    ///< likewise, and one of the ways cuts into the part
  };
  Kind kind = Kind::UnknownCode;
  std::size_t move = 0;  ///< index into Toolpath::moves; their number: the start
  SourcePlace place;
  std::string code;    ///< of UnknownCode
  double measure = 0;  ///< mm
  double limit = 0;    ///< mm
};

/// What the user should know although it was written.
struct WriteNote {
  enum class Kind : std::uint8_t {
    FeedDropped,    ///< the control takes the feed from its settings
    PowerDropped,   ///< likewise S
    FeedDefaulted,  ///< the control needs a feed, the program says none: `value` mm/min was written
    CutsWithTorchOff,  ///< cuts follow the code `value`, which put the torch out, and no code
                       ///< between lights it again: a warning
  };
  Kind kind;
  std::size_t move = 0;  ///< the first one concerned
  SourcePlace place;
  std::string value;  ///< of FeedDefaulted, CutsWithTorchOff
};

struct WriteReport {
  /// No point of the written curve is further than this from the exact path, move by move in order,
  /// nor the other way, in the plane, in mm; proved (post/deviation.h), rounded up.
  double deviation = 0;
  /// After any block, on each axis, in mm: at most half a unit; rounded up.
  double position_error_x = 0;
  double position_error_y = 0;
  double position_error_z = 0;
  std::size_t blocks = 0;  ///< rapids, lines, arcs, dwells and codes written
  std::size_t rapids = 0;
  std::size_t lines = 0;  ///< those of arcs included
  std::size_t arcs = 0;
  std::size_t arcs_divided = 0;   ///< exact arcs written as several pieces
  std::size_t arcs_as_lines = 0;  ///< pieces of arcs written as lines
  std::size_t dropped = 0;        ///< moves, or pieces of arcs, that round to nothing
  std::vector<WriteNote> notes;
};

struct WriteResult {
  std::string text;  ///< empty when there are faults
  WriteReport report;
  std::vector<WriteFault> faults;  ///< all of them
};

/// Writes the program.
///  (1) After every block the written position is within half a unit of the exact one on each axis,
///      and within half a unit of the exact curve at the ends of the pieces of divided arcs.
///  (2) Every arc written exists (chord ≤ 2R) and is the arc meant.
///  (3) The deviation is at most kWorstDeviation units (post/plan.h), and the report bounds it.
///  (4) The text depends on nothing but the path and the dialect.
/// `on_progress`: of the moves.
[[nodiscard]] WriteResult write(const Toolpath& path, const Dialect& dialect,
                                const OnProgress& on_progress = {});

}  // namespace dgt
