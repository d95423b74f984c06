// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "kernel/toolpath.h"
#include "post/arc_fit.h"
#include "post/dialect.h"

/// An exact arc cut into pieces that a control can be told. Lengths in units.
namespace dgt {

/// An arc of the tool path on the grid's scale.
struct ExactArc {
  ArcBalls arc;
  bool full_circle = false;
  long double sweep = 0;  ///< radians, 0…2π
};
[[nodiscard]] ExactArc exact_arc(const Move& move, const Grid& grid);

/// A stretch of an exact arc and its rounded ends. Its inner ends are points of the exact arc that
/// lie within half a unit of their grid points on each axis.
struct ArcPiece {
  GridPoint from;
  GridPoint to;
  ArcBalls exact;
  long double begin = 0;  ///< radians from the beginning of the whole arc
  long double end = 0;
};

/// A piece and what is written for it.
struct WrittenPiece {
  enum class Kind : std::uint8_t { Line, Arc, Nothing };
  Kind kind;
  ArcPiece piece;
  WrittenArc arc;        ///< of an Arc
  double deviation = 0;  ///< certified
};

/// The limits of a control's arcs, in units and radians.
struct ArcLimits {
  ArcForm form = ArcForm::Centre;
  long double sweep = 0;
  double mismatch = 0;
  long double least_radius = 0;      ///< of a centre-form arc
  bool counted = false;              ///< the control ends an arc by counting steps (post/three_b.h)
  std::int64_t largest = kMaxUnits;  ///< number of a counted arc
};

/// The pieces of an arc in order, joined in grid points.
[[nodiscard]] std::vector<WrittenPiece> written_pieces(const ExactArc& arc, const GridPoint& from,
                                                       const GridPoint& to,
                                                       const ArcLimits& limits);

}  // namespace dgt
