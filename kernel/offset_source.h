// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/offset.h"
#include "kernel/offset_raw.h"
#include "kernel/strand.h"

/// What the production engine offsets, in whatever precision a decision asks for. Internal to the
/// kernel.
namespace dgt {

/// ChainEdge in one precision, about the same exact edge.
template <class Real>
struct EnclosedEdge {
  EnclosedVector<Real> from, to;
  EnclosedVector<Real> start, end;  ///< left unit normals
  Enclosed<Real> radius;
  bool is_line = true;
  bool counter_clockwise = true;
};

/// The same in plain doubles, up to where the next edge begins: no more than the hot path reads.
/// (x, y) is off by less than 2⁻⁵² (|x| + |y|). The radius and the sense are those of an arc.
struct EdgeInDoubles {
  double x = 0;
  double y = 0;
  double start_x = 0;
  double start_y = 0;
  double end_x = 0;
  double end_y = 0;
  double normal_rad = 0;
  double radius = 0;
  double radius_rad = 0;
  bool is_line = true;
  bool counter_clockwise = true;
};

/// Exact edges are rational stand-ins: their normals lie within 2^−kStandInBits of the ideal ones.
inline constexpr double kStandIn = 0x1p-95;
static_assert(kStandInBits == 96);

/// Sine of the angle between normals up to which a joint is tangent. Doubles that say a tangent
/// joint are off by some 2⁻⁵⁰; corners that are meant are far above.
inline constexpr double kTangent = 0x1p-40;
/// Or up to which it turns an edge by no more than its vertices' own rounding to doubles may have
/// done: units of the vertex.
inline constexpr double kVertexRounding = 0x1p-50;
/// No more than this, though.
inline constexpr double kLargestRounding = 0x1p-30;

template <class Real>
[[nodiscard]] Enclosed<Real> magnitude(const Enclosed<Real>& a) {
  return coarse(a.mid) < 0 ? -a : a;
}

/// Vertices of a parted source are moved by no more than this, in mm: far below the distance at
/// which contacts part, far above what double-doubles leave open.
inline constexpr double kParting = 0x1p-74;
/// And by no more than this part of the edges about them.
inline constexpr double kPartingShare = 0x1p-56;

/// Which vertices: as they came, or those that decisions are made for, which differ when parted.
enum class Vertices : std::uint8_t { Given, Decisive };

/// How the normal goes on behind an edge.
enum class JointTurn : std::uint8_t { Tangent, Left, Right };

/// `normal` is that at the beginning, which a tangent joint shares with the edge before.
template <class Real>
[[nodiscard]] Strand<Real> moved(const EnclosedEdge<Real>& e, const EnclosedVector<Real>& normal,
                                 const Enclosed<Real>& distance) {
  Strand<Real> s;
  s.from = e.from + distance * normal;
  s.to = e.to + distance * e.end;
  s.is_line = e.is_line;
  if (!s.is_line) {
    s.centre = e.from + e.radius * e.start;
    s.radius = magnitude(e.radius - distance);
    // The normal turns the same way whatever the offset does to the radius.
    s.counter_clockwise = e.counter_clockwise;
  }
  return s;
}

template <class Real>
[[nodiscard]] Strand<Real> corner(const EnclosedEdge<Real>& e, const EnclosedEdge<Real>& next,
                                  JointTurn joint, const Enclosed<Real>& distance) {
  Strand<Real> s;
  s.is_line = false;
  s.centre = e.to;
  s.radius = distance;
  s.from = e.to + distance * e.end;
  s.to = e.to + distance * next.start;
  s.counter_clockwise = joint == JointTurn::Left;
  return s;
}

/// Directed loops in flat numbering: edge i of all. They stay as they came; doubles, double-doubles
/// and rationals are made from them when asked for.
class OffsetSource {
 public:
  /// Loops to shrink by `distance` > 0; `reversed`: as if they ran the other way.
  OffsetSource(const std::vector<BulgePolyline>& loops, Rational distance, bool reversed,
               const OffsetOptions& options = {});
  OffsetSource(const std::vector<Chain>& loops, Rational distance, bool reversed,
               const OffsetOptions& options = {});

  [[nodiscard]] std::size_t loops() const { return first_.size() - 1; }
  [[nodiscard]] std::uint32_t edges() const { return first_.back(); }
  /// The first edge of a loop; `loop` may be one behind the last.
  [[nodiscard]] std::uint32_t first(std::size_t loop) const { return first_[loop]; }
  [[nodiscard]] std::size_t loop_of(std::uint32_t edge) const;
  [[nodiscard]] std::uint32_t next(std::uint32_t edge) const;
  [[nodiscard]] std::uint32_t previous(std::uint32_t edge) const;

  /// Both ways along an open chain: the loop bounds nothing, and all about it is the region.
  [[nodiscard]] static OffsetSource about(const Chain& there_and_back, Rational distance,
                                          const OffsetOptions& options);
  [[nodiscard]] bool is_slit() const { return is_slit_; }

  /// The same loops with each vertex moved a little, its own way, for decisions: what coincides at
  /// every distance (corners about one vertex, edges along one line) no longer does. Loops stay
  /// closed, and what is a contact away from them stays so. Results are those of the vertices as
  /// they came.
  [[nodiscard]] OffsetSource parted() const;
  [[nodiscard]] bool is_parted() const { return parted_; }
  /// What the parting adds to the size of a vertex, mm, as far as errors of doubles go.
  [[nodiscard]] double slack() const { return parted_ ? 0x1p-20 : 0; }

  /// Whether doubles can follow the loops: chains may hold anything.
  [[nodiscard]] bool suits_doubles() const;
  /// About the area of a loop, mm², counter-clockwise positive; the sign is right wherever there is
  /// an area to speak of.
  [[nodiscard]] double area(std::size_t loop) const;

  [[nodiscard]] EdgeInDoubles in_doubles(std::uint32_t index) const {
    EdgeInDoubles e;
    in_doubles(index, e);
    return e;
  }
  /// The same made in place. Copies of what has just been written wait for it.
  void in_doubles(std::uint32_t index, EdgeInDoubles& e) const;
  [[nodiscard]] EnclosedEdge<DoubleDouble> edge(std::uint32_t index, Vertices vertices) const;
  [[nodiscard]] ChainEdge exact_edge(std::uint32_t index) const;
  /// The loops as rational chains, in the sense in which they are offset.
  [[nodiscard]] std::vector<Chain> exact_loops() const;

  /// What decisions are made for: 2^kContactExponent mm beyond the distance, so that what is in
  /// contact parts.
  template <class Real>
  [[nodiscard]] const Enclosed<Real>& decisive_distance() const;
  [[nodiscard]] const Rational& distance() const { return distance_; }
  [[nodiscard]] const OffsetOptions& options() const { return options_; }
  [[nodiscard]] const Enclosed<DoubleDouble>& fine_distance() const { return fine_distance_; }

  /// The joint behind edge `i`, `e`; both it and the next one in doubles are known already. An edge
  /// that doubles back on itself turns to the left.
  [[nodiscard]] JointTurn joint(std::uint32_t i, const EdgeInDoubles& e,
                                const EdgeInDoubles& next) const;
  /// Strands of a corner that the options make other than one arc; none where it is one.
  [[nodiscard]] std::vector<Strand<DoubleDouble>> corner_parts(
      std::uint32_t i, const Enclosed<DoubleDouble>& distance, Vertices vertices) const;
  /// The strand of an edge, or of the corner behind it, moved by `distance`.
  [[nodiscard]] Strand<DoubleDouble> strand(RawKey key, const Enclosed<DoubleDouble>& distance,
                                            Vertices vertices) const;
  /// What decisions are made about.
  [[nodiscard]] Strand<DoubleDouble> decisive_strand(RawKey key) const {
    return strand(key, decisive_fine_, Vertices::Decisive);
  }
  /// Whether the offset shrinks an arc to within kTangent of the distance about its centre. Its
  /// ends, shared with its neighbours, need not lie on what is left of its circle: it is its chord,
  /// then.
  [[nodiscard]] bool shrinks_to_chord(const EdgeInDoubles& e) const {
    return !e.is_line && std::fabs(e.radius - decisive_.mid) <= kTangent * decisive_.mid;
  }
  /// The exact raw piece; nothing where `distance` shrinks it to a point, or has no such part of a
  /// corner.
  [[nodiscard]] std::optional<RawPiece> exact_piece(RawKey key, const Rational& distance) const;
  /// Where it begins.
  [[nodiscard]] RationalPoint exact_beginning(RawKey key) const;

 private:
  void set_distance();
  [[nodiscard]] JointTurn joint(std::uint32_t i) const;
  /// The joint behind edge `i` by its exact normals, which are not one.
  [[nodiscard]] JointTurn sharp_joint(std::uint32_t i) const;
  /// Whether the edges about the end of edge `i` may turn so far by the rounding of their vertices.
  [[nodiscard]] bool turns_by_rounding(std::uint32_t i, double turn) const;
  /// How far the beginning of an edge, as it came, is moved.
  [[nodiscard]] CoarsePoint parting(std::uint32_t original) const;
  [[nodiscard]] CoarsePoint beginning(std::uint32_t original) const;
  /// Where the edge stands in the order in which it came.
  [[nodiscard]] std::uint32_t original(std::uint32_t edge) const;

  std::vector<BulgePoint> points_;  ///< one an edge, its beginning; or
  std::vector<ChainEdge> chain_edges_;
  std::vector<std::uint32_t> first_;
  Rational distance_;
  OffsetOptions options_;
  Enclosed<double> decisive_;
  Enclosed<DoubleDouble> decisive_fine_;
  Enclosed<DoubleDouble> fine_distance_;
  bool reversed_ = false;
  bool is_slit_ = false;
  bool parted_ = false;
};

inline JointTurn OffsetSource::joint(std::uint32_t i, const EdgeInDoubles& e,
                                     const EdgeInDoubles& next) const {
  const double turn = e.end_x * next.start_y - e.end_y * next.start_x;
  const double ahead = e.end_x * next.start_x + e.end_y * next.start_y;
  // Components up to 1 on both sides, and three roundings.
  const double rad = 2.1 * (e.normal_rad + next.normal_rad) + 0x1p-51;
  const double most = std::fabs(turn) + rad;
  if (most <= kLargestRounding && ahead > 0 && (most <= kTangent || turns_by_rounding(i, most)))
    return JointTurn::Tangent;
  if (std::fabs(turn) > rad) return turn > 0 ? JointTurn::Left : JointTurn::Right;
  return sharp_joint(i);
}

}  // namespace dgt
