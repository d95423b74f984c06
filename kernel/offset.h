// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "kernel/chain.h"
#include "kernel/meet.h"

/// Robust equidistants: the boundary of all places that lie left of directed loops and at least a
/// distance away from them, islands and collapses included, every decision exact.
///
/// Nouns. The *raw curve* of a loop is its whole convolution with the circle of the offset: each
/// edge moved along its normals, and at each corner an arc about it that turns one edge's normal
/// into the next one's the short way, also where this runs backwards. It closes exactly. Its
/// *winding number* at a place counts (with signs) how the discs about that place meet the loop;
/// where no disc meets it, the number is that of the inside of the region. A *void loop* bounds a
/// place with that number which the loop nevertheless fills: it occurs when a part of the loop fits
/// into the disc.
namespace dgt {

/// A piece of a raw curve: an edge, moved, or one of up to three parts of the corner behind it.
class RawKey {
 public:
  static constexpr std::uint32_t kMaxEdges = 1U << 30U;

  RawKey() = default;
  /// Part 0 is the edge.
  RawKey(std::uint32_t edge, std::uint32_t part) : packed_(4 * edge + part) {}

  [[nodiscard]] std::uint32_t edge() const { return packed_ / 4; }
  [[nodiscard]] std::uint32_t part() const { return packed_ % 4; }

  friend bool operator==(RawKey, RawKey) = default;

 private:
  std::uint32_t packed_ = 0;
};

/// An edge of a result: on a line through its ends or on a circle.
struct OffsetPiece {
  Point from;
  Point to;
  bool is_line = true;
  RationalPoint centre;
  Rational radius;  ///< signed, positive counter-clockwise
  RawKey on;        ///< what it is a part of; of pieces joined, the first
};
struct OffsetLoop {
  std::vector<OffsetPiece> pieces;
  bool closed = true;
};

/// Loops and pieces smaller than this in both coordinates are what lies between ideal edges and
/// their rational stand-ins, and left out. Unit: mm.
inline constexpr double kOffsetResolution = 1e-9;

/// What lies about a corner of the contour on its outer side, where the equidistants of its edges
/// part. On its inner side they meet.
enum class OffsetCorner : std::uint8_t {
  Round,    ///< the arc about the corner: all places exactly at the distance
  Sharp,    ///< the equidistants themselves, lines and circles, prolonged until they meet
  Chamfer,  ///< the tangents at their ends, cut by the line that touches the arc at its middle
};

struct OffsetOptions {
  OffsetCorner corner = OffsetCorner::Round;
  /// A sharp corner farther from the contour's than this many distances, and one whose prolonged
  /// equidistants do not meet ahead, is round.
  double spike_limit = 4;
};

/// The reference engine: the raw curves as an exact arrangement, faces labelled by winding number,
/// the boundary read off the faces. Simple and slow: some 100 µs an edge.
///  (1) `distance` > 0 shrinks the region left of the loops, < 0 grows it.
///  (2) Every place of the region is at least |distance| away from the loops; with round corners,
///      every place left of them that is so belongs to it.
///  (3) Outer loops run counter-clockwise, holes clockwise: the region lies to the left.
/// Precondition (checked): the loops are closed; they may touch but not cross. An open chain is
/// offset by open_offset.
[[nodiscard]] std::vector<OffsetLoop> reference_offset(const std::vector<Chain>& loops,
                                                       const Rational& distance,
                                                       const OffsetOptions& options = {});

/// A vertex of a closed polyline in doubles, with the bulge of the edge to the next one (chain.h).
/// What it means is exact: the doubles are the numbers meant.
struct BulgePoint {
  double x = 0;
  double y = 0;
  double bulge = 0;
};
using BulgePolyline = std::vector<BulgePoint>;

/// How the production engine came to its decisions.
struct OffsetCounts {
  std::size_t strands = 0;    ///< pieces of the raw curves
  std::size_t pairs = 0;      ///< of these, whose boxes overlap
  std::size_t crossings = 0;  ///< of the raw curves
  std::size_t decisions = 0;  ///< pairs, orders and rays that doubles were asked about
  std::size_t fine = 0;       ///< of these, left to double-doubles
  std::size_t exact = 0;      ///< of these, left to the reference engine: then all of them are
  std::size_t torn = 0;       ///< loops that did not close: no decisions lead there but wrong ones
};

class OffsetSource;

/// A piece of a result in doubles.
struct RegionPiece {
  double x = 0;  ///< where it begins
  double y = 0;
  double radius = 0;  ///< positive counter-clockwise; 0: a segment. No arc is above half a turn
  RawKey on;          ///< what it is a part of
  RawKey cut, by;     ///< it begins where these cross; the same: where `cut` begins
};

/// What the production engine makes: loops in doubles, exact when asked.
class OffsetRegion {
 public:
  [[nodiscard]] std::size_t loops() const { return first_.size() - 1; }
  [[nodiscard]] std::span<const RegionPiece> loop(std::size_t i) const {
    return {pieces_.data() + first_[i], first_[i + 1] - first_[i]};
  }
  /// The same loops in exact points that round correctly.
  [[nodiscard]] std::vector<OffsetLoop> exact() const;
  /// Those before what is minute is left out and what goes on along one support is joined.
  [[nodiscard]] std::vector<OffsetLoop> exact_pieces() const;

  /// The result of the reference engine in this form.
  [[nodiscard]] static OffsetRegion of(std::vector<OffsetLoop> loops);
  /// Runs all loops the other way.
  void reverse();

 private:
  friend class OffsetEngine;
  void drop(const std::vector<bool>& which);
  [[nodiscard]] Circle circle_of(RawKey on) const;

  std::shared_ptr<const OffsetSource> source_;
  std::vector<OffsetLoop> exact_;  ///< when there is no source
  std::vector<RegionPiece> pieces_;
  std::vector<std::size_t> first_ = {0};
};

/// The production engine: winding numbers carried along the raw curve, crossings found through a
/// box tree in contour order, decisions in doubles with a proved bound, then in double-doubles.
/// Raw pieces that coincide at every distance, as where loops touch, are decided by vertices moved
/// a little. What is open even so sends the whole input to the reference engine. Same loops as
/// reference_offset.
[[nodiscard]] OffsetRegion production_offset(const std::vector<BulgePolyline>& loops,
                                             const Rational& distance,
                                             const OffsetOptions& options = {},
                                             OffsetCounts* counts = nullptr);
[[nodiscard]] std::vector<OffsetLoop> production_offset(const std::vector<Chain>& loops,
                                                        const Rational& distance,
                                                        const OffsetOptions& options = {},
                                                        OffsetCounts* counts = nullptr);

enum class OffsetEngineKind : std::uint8_t { Production, Reference };

/// The equidistant of an open chain: of all places at the distance from it, those that lie to its
/// left (distance > 0) or right, in its direction, without what gouges some other part of it. As
/// many open loops as that leaves, and closed ones where the chain all but closes.
/// Precondition (checked): the chain is open, the distance not 0.
[[nodiscard]] std::vector<OffsetLoop> open_offset(
    const Chain& chain, const Rational& distance, const OffsetOptions& options = {},
    OffsetEngineKind engine = OffsetEngineKind::Production);

/// mm², counter-clockwise positive, and mm; within a few units in the last place of the
/// coordinates.
[[nodiscard]] double area(const OffsetLoop& loop);
/// Arcs of at most half a turn.
[[nodiscard]] double area(const Chain& closed);
[[nodiscard]] double length(const OffsetLoop& loop);

/// Whether no edge of the loops comes nearer to `p` than `distance` ≥ 0; exact.
[[nodiscard]] bool keeps_distance(const std::vector<Chain>& loops, const RationalPoint& p,
                                  const Rational& distance);

}  // namespace dgt
