// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lang/dxf/strand.h"

namespace dgt {

/// Pieces that follow each other exactly.
struct DxfContour {
  std::vector<DxfPiece> pieces;
  bool closed = false;
};

/// Strands put together where their ends meet.
///  (1) Ends within 10⁻⁶ mm of each other are one place. Where two ends share a place the strands
///  go
///      on into each other; where more do, contours end. An end that is alone then is joined to
///      another such one within the tolerance, if there is just one.
///  (2) A contour begins with its first strand in the file, an open one at the end before it, and
///      runs the way its first directed strand is drawn.
///  (3) Ends that do not meet exactly are moved to one place, coordinates that the drawing gives
///      before those that follow from an angle; arcs then run through their new ends about the
///      nearest centre that fits, no farther from where they were than twice the gap.
///  (4) What is drawn twice is kept once. It is told, as are moved ends, places where more than two
///      ends meet, ends that meet nothing, and pieces that run along each other for a while.
[[nodiscard]] std::vector<DxfContour> chained(std::vector<DxfStrand> strands,
                                              const DxfOptions& options, DiagnosticBag& bag);

/// Strands as a path: each goes on from the one before it if it begins there, and begins a contour
/// if it does not. Nothing is sorted or left out.
[[nodiscard]] std::vector<DxfContour> in_drawn_order(std::vector<DxfStrand> strands,
                                                     const DxfOptions& options, DiagnosticBag& bag);

}  // namespace dgt
