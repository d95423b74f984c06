// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lang/dxf/drawing.h"

namespace dgt {

/// A segment, an arc or a whole circle of the drawing, in mm.
struct DxfPiece {
  RationalPoint from;
  RationalPoint to;
  std::optional<Circle> circle;  ///< the ends lie on it exactly; none: a segment
  Range place;

  [[nodiscard]] bool is_whole_circle() const { return circle && from == to; }
};
[[nodiscard]] DxfPiece reversed(const DxfPiece& piece);

/// What an entity comes to: pieces that follow each other exactly.
struct DxfStrand {
  std::vector<DxfPiece> pieces;
  bool closed = false;  ///< ends where it begins, because it is drawn so
  /// It has a direction of its own: all but arcs and circles, which always run counter-clockwise.
  bool directed = true;
  bool has_given_ends = true;  ///< as coordinates, not by an angle

  [[nodiscard]] const Range& place() const { return pieces.front().place; }
};
[[nodiscard]] DxfStrand reversed(const DxfStrand& strand);

enum class DxfUnit : std::uint8_t { Drawing, Millimetre, Inch };
enum class DxfOrder : std::uint8_t { InsideOut, File };
/// How closed contours run, where they are sorted: as drawn, or with the part on one side: on the
/// left, outer ones counter-clockwise and holes clockwise.
enum class DxfDirection : std::uint8_t { Drawn, PartLeft, PartRight };

struct DxfOptions {
  /// Read these layers alone, whether they are shown or not; empty: all that are shown.
  std::vector<std::string> layers = {};
  DxfUnit unit = DxfUnit::Drawing;
  /// Ends no farther apart are joined. The default is the tenth part of the coarsest control's
  /// unit: ends that a drawing program left apart by rounding lie nearer, real gaps do not. Unit:
  /// mm.
  Rational join_tolerance = Rational(1, 100);
  /// Ellipses and splines are cut as arcs that leave them by no more. The default is the unit of
  /// the finest controls. Unit: mm.
  Rational curve_tolerance = Rational(1, 1000);
  /// What is cut first: holes before what they lie in, or everything as it is drawn, one entity
  /// after the other; unset: the first, save for drawings of a path by `dgt plot`.
  std::optional<DxfOrder> order = std::nullopt;
  DxfDirection direction = DxfDirection::Drawn;
  /// How wide the tool cuts. Closed contours are moved by half of it, outer ones outward and holes
  /// inward. Unit: mm.
  Rational kerf_width = 0;
  bool apply_kerf = true;
  /// Moves, and entities that blocks put in place.
  std::uint64_t max_moves = 10'000'000;
};

/// The entities of the wanted layers as strands, blocks put in place, in the order of the file.
/// Tells what is left out.
[[nodiscard]] std::vector<DxfStrand> strands_of(const DxfDrawing& drawing, const SourceFile& file,
                                                const DxfOptions& options, DiagnosticBag& bag);

}  // namespace dgt
