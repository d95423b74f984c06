// SPDX-License-Identifier: GPL-3.0-or-later
// Loops of a result that bound nothing: slivers, and void loops (offset.h), which the winding
// number alone cannot tell. A void loop lies nearer than the distance to some edge, at each of its
// points; one point is held against the edges about it.
#include "kernel/offset_voids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "kernel/box_tree.h"
#include "kernel/offset_raw.h"
#include "kernel/offset_source.h"

namespace dgt {
namespace {

using Loop = std::span<const RegionPiece>;

constexpr Bounds kNowhere{
    std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

bool is_sliver(Loop loop) {
  Bounds box = kNowhere;
  for (const RegionPiece& p : loop) box = box.united({p.x, p.y, p.x, p.y});
  return box.max_x - box.min_x <= kOffsetResolution && box.max_y - box.min_y <= kOffsetResolution;
}

struct Place {
  double x, y;
};

/// The middle of a piece that ends in `to`.
Place middle(const RegionPiece& p, Place to) {
  const Place half{(p.x + to.x) / 2, (p.y + to.y) / 2};
  if (p.radius == 0) return half;
  // The arc rises to the right of its chord when it turns to the left, by c²/4 / (r + √(r² −
  // c²/4)).
  const double wx = to.x - p.x;
  const double wy = to.y - p.y;
  const double square = (wx * wx + wy * wy) / 4;
  const double r = std::fabs(p.radius);
  const double rise = square / (r + std::sqrt(std::max(0.0, r * r - square)));
  const double k = std::copysign(rise / (2 * std::sqrt(square)), p.radius);
  return {half.x + k * wy, half.y - k * wx};
}

/// The distance of a place from an edge of at most half a turn that ends in `to`.
double distance_from(const EdgeInDoubles& e, Place to, Place p) {
  const double wx = to.x - e.x;
  const double wy = to.y - e.y;
  const double ends =
      std::min(std::hypot(p.x - e.x, p.y - e.y), std::hypot(p.x - to.x, p.y - to.y));
  if (e.is_line) {
    const double t = (p.x - e.x) * wx + (p.y - e.y) * wy;
    const double square = wx * wx + wy * wy;
    if (t <= 0 || t >= square) return ends;
    return std::fabs(wx * (p.y - e.y) - wy * (p.x - e.x)) / std::sqrt(square);
  }
  const double cx = e.x + e.radius * e.start_x;
  const double cy = e.y + e.radius * e.start_y;
  const double r = std::fabs(e.radius);
  const double off = std::hypot(p.x - cx, p.y - cy);
  if (off == 0) return r;
  // Where the ray from the centre through p meets the circle, seen from the chord.
  const double k = r / off;
  const double side = wx * (cy + k * (p.y - cy) - e.y) - wy * (cx + k * (p.x - cx) - e.x);
  return (e.counter_clockwise ? side < 0 : side > 0) ? std::fabs(off - r) : ends;
}

Bounds box_of(const EdgeInDoubles& e, Place to) {
  const Bounds ends{std::min(e.x, to.x), std::min(e.y, to.y), std::max(e.x, to.x),
                    std::max(e.y, to.y)};
  // An arc of at most half a turn leaves its chord by no more than half of it.
  return e.is_line ? ends : ends.grown(0.5 * std::hypot(to.x - e.x, to.y - e.y));
}

class Edges {
 public:
  explicit Edges(const OffsetSource& source)
      : source_(source), tree_(source.edges(), [&](std::size_t i) {
          const auto edge = static_cast<std::uint32_t>(i);
          return box_of(source.in_doubles(edge), end_of(source, edge));
        }) {}

  /// Whether some edge, save those that `on` keeps its distance from, surely lies nearer than
  /// `reach`; nothing when one lies about there.
  [[nodiscard]] std::optional<bool> near(Place p, RawKey on, double reach) const {
    const std::uint32_t next = on.part() > 0 ? source_.next(on.edge()) : on.edge();
    bool nearer = false;
    bool about = false;
    tree_.overlapping(Bounds{p.x, p.y, p.x, p.y}.grown(reach), [&](std::size_t i) {
      if (i == on.edge() || i == next) return;
      const auto edge = static_cast<std::uint32_t>(i);
      const double off = distance_from(source_.in_doubles(edge), end_of(source_, edge), p) - reach;
      if (off < -kOffsetResolution)
        nearer = true;
      else if (off < kOffsetResolution)
        about = true;
    });
    if (nearer) return true;
    if (about) return std::nullopt;
    return false;
  }

 private:
  static Place end_of(const OffsetSource& source, std::uint32_t edge) {
    const EdgeInDoubles next = source.in_doubles(source.next(edge));
    return {next.x, next.y};
  }

  const OffsetSource& source_;
  BoxTree tree_;
};

/// Whether a whole component of the region may fit into the disc: only then does a number lie.
bool may_have_voids(const OffsetSource& source) {
  const double width = 2 * source.decisive_distance<double>().mid + kOffsetResolution;
  for (std::size_t loop = 0; loop < source.loops(); ++loop) {
    Bounds box = kNowhere;
    for (std::uint32_t i = source.first(loop); i < source.first(loop + 1); ++i) {
      const EdgeInDoubles e = source.in_doubles(i);
      box = box.united({e.x, e.y, e.x, e.y});
      if (std::max(box.max_x - box.min_x, box.max_y - box.min_y) > width) break;
    }
    if (std::max(box.max_x - box.min_x, box.max_y - box.min_y) <= width) return true;
  }
  return false;
}

bool is_void(Loop loop, const Edges& edges, const OffsetSource& source) {
  std::size_t longest = 0;
  double length = -1;
  const auto end = [&](std::size_t i) {
    const RegionPiece& next = loop[(i + 1) % loop.size()];
    return Place{next.x, next.y};
  };
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Place to = end(i);
    const double chord = std::hypot(to.x - loop[i].x, to.y - loop[i].y);
    if (chord <= length) continue;
    length = chord;
    longest = i;
  }
  const RegionPiece& piece = loop[longest];
  const Place p = middle(piece, end(longest));
  const auto near = edges.near(p, piece.on, source.decisive_distance<double>().mid);
  if (near) return *near;
  return !keeps_distance(source.exact_loops(), {Rational(p.x), Rational(p.y)},
                         source.distance() - Rational(kOffsetResolution));
}

}  // namespace

std::vector<bool> bounding_nothing(const OffsetRegion& region, const OffsetSource& source) {
  std::vector<bool> nothing(region.loops());
  std::optional<Edges> edges;
  if (may_have_voids(source)) edges.emplace(source);
  for (std::size_t i = 0; i < region.loops(); ++i)
    nothing[i] = is_sliver(region.loop(i)) || (edges && is_void(region.loop(i), *edges, source));
  return nothing;
}

}  // namespace dgt
