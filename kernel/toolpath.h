// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kernel/meet.h"

/// The middle form between every front end and every back end: what the tool does, move by move, in
/// exact coordinates, each move with its place in the source and its part in the work.
namespace dgt {

using RationalPtr = std::shared_ptr<const Rational>;
[[nodiscard]] inline RationalPtr shared(Rational value) {
  return std::make_shared<const Rational>(std::move(value));
}

enum class MoveKind : std::uint8_t { Line, Arc, Rapid, Dwell, Code };

enum class Role : std::uint8_t {
  LeadIn,
  Contour,
  Fillet,
  Chamfer,
  Tangent,
  LeadOut,
  Position,
  Thread,
  Corner  ///< put in by the equidistant where it goes round an outer corner
};

/// Where a move was asked for. `file` counts into Toolpath::files; lines and columns from 1,
/// columns in characters; line 0: nowhere.
struct SourcePlace {
  std::uint32_t file = 0;
  std::uint32_t line = 0;
  std::uint32_t column = 0;

  friend bool operator==(const SourcePlace&, const SourcePlace&) = default;
};

/// One step of the tool.
struct Move {
  MoveKind kind = MoveKind::Line;
  Role role = Role::Contour;
  bool full_circle = false;  ///< an arc that ends where it began, once round
  SourcePlace source;
  Point from;
  Point to;          ///< equals `from` for dwells, codes and full circles
  Carrier carrier;   ///< the exact curve of an arc, and of a line cut along an element; else null
  RationalPtr z;     ///< height reached at the end, mm; null: unchanged
  RationalPtr feed;  ///< mm/min, modal value in force; null: never set
  RationalPtr seconds;  ///< of a dwell
  std::string code;     ///< of a code: `M7`, `S100`

  [[nodiscard]] bool cuts() const { return kind == MoveKind::Line || kind == MoveKind::Arc; }
  [[nodiscard]] bool travels() const { return cuts() || kind == MoveKind::Rapid; }
  /// The circle of an arc, with the sense of travel in the sign of its radius.
  [[nodiscard]] Circle circle() const { return std::get<Circle>(carrier.element()); }
};

/// Whether the move cuts the part itself: rapids, approaches and departures do not.
[[nodiscard]] bool is_part(const Move& move);

enum class Side : std::uint8_t { None, Left, Right };

/// One contour of a program: a stretch of Toolpath::moves and the same without the equidistant.
struct Contour {
  unsigned id = 0;
  Rational offset;         ///< W as programmed, mm
  Side side = Side::None;  ///< where the tool runs, seen along the elements; None: W = 0
  bool closed = false;
  std::size_t first = 0;  ///< the contour's moves are Toolpath::moves[first, last)
  std::size_t last = 0;
  /// The contour with W = 0; nothing where that is what the tool does. See programmed_moves().
  std::optional<std::vector<Move>> programmed;
};

struct Toolpath {
  std::vector<std::string> files;
  RationalPoint start;  ///< where the tool stands before the first move
  std::vector<Contour> contours;
  std::vector<Move> moves;
};

/// What the tool does for the contour, one of the path's.
[[nodiscard]] std::span<const Move> moves_of(const Toolpath& path, const Contour& contour);
/// The same without the equidistant, W = 0.
[[nodiscard]] std::span<const Move> programmed_moves(const Toolpath& path, const Contour& contour);

/// Whether an arc covers more than, exactly, or less than half a turn: +1, 0, −1. Exact.
[[nodiscard]] int half_turn_order(const Move& arc);

/// Degrees from start to end along the sense of travel, counter-clockwise positive; ±360 for a full
/// circle. Rounded to nearest from 96 bits.
[[nodiscard]] double sweep_degrees(const Move& arc);

/// Lengths in mm, summed in 128 bits and rounded once; heights count, from height 0 at the start.
struct Lengths {
  double cut = 0;
  double rapid = 0;
};
[[nodiscard]] Lengths lengths(std::span<const Move> moves);
/// In the plane.
[[nodiscard]] double length(const Move& move);

/// The printed form (the guide's internal form): one line a move, the same on every machine.
[[nodiscard]] std::string to_text(const Toolpath& path);

[[nodiscard]] const char* name_of(MoveKind kind);
[[nodiscard]] const char* name_of(Role role);
[[nodiscard]] const char* name_of(Side side);

}  // namespace dgt
