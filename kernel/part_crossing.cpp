// SPDX-License-Identifier: GPL-3.0-or-later
//
// A wall is a stretch of a programmed contour. A move to be looked at becomes a stretch too, on the
// rational line through its ends. Where the tool has a width the question is the gouge check's:
// does the stretch come nearer to the wall than the reach? Where it has none the stretch, less
// kArrival at both ends, has to keep off the wall by kTouch: above the cracks that contacts leave
// between two walls, and below the s²/2r by which a line that touches a circle of radius r has left
// it at s = kArrival, up to r = 500 km. So both are one exact question with two distances.
#include "kernel/part_crossing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "kernel/construct.h"
#include "kernel/contour_path.h"
#include "kernel/gouge.h"

namespace dgt {
namespace {

/// 2⁻⁶² mm; see above.
const Rational& touch() {
  static const Rational value = power_of_two(-62);
  return value;
}

struct Wall {
  Stretch stretch;
  StretchBalls balls;
  Rational reach;  ///< of the tool beside it, mm
  std::size_t contour = 0;
  std::size_t index = 0;  ///< into the contour's programmed moves
};

/// How far the tool keeps away from the part on a cut: the shift of its element.
Rational reach_of(const Move& cut) {
  return cut.carrier.shift ? Rational(abs(*cut.carrier.shift)) : Rational(0);
}

bool runs_backwards(const Move& move) {
  const auto* line = std::get_if<Line>(move.carrier.base.get());
  return line && motion_along(*line, move.from, move.to) < 0;
}

/// How far the tool keeps away from each element of a contour; where one is cut twice, the less.
class Reaches {
 public:
  Reaches(const Toolpath& path, const Contour& contour) {
    for (std::size_t i = contour.first; i < contour.last; ++i) {
      const Move& move = path.moves[i];
      if (!is_part(move) || !move.carrier.base) continue;
      Rational reach = reach_of(move);
      if (!least_ || reach < *least_) least_ = reach;
      const auto [at, fresh] = of_.try_emplace(move.carrier.base.get(), reach);
      if (!fresh && reach < at->second) at->second = std::move(reach);
    }
  }
  /// Blends may be elements of their own on either path: for these, the least of the contour.
  [[nodiscard]] Rational of(const Move& programmed) const {
    const auto known = of_.find(programmed.carrier.base.get());
    if (known != of_.end()) return known->second;
    return least_.value_or(0);
  }

 private:
  std::map<const Element*, Rational> of_;
  std::optional<Rational> least_;
};

void add_walls(const Toolpath& path, std::size_t contour, std::vector<Wall>& walls) {
  const Contour& of = path.contours[contour];
  const Reaches reaches(path, of);
  const bool is_offset = sgn(of.offset) != 0;
  const std::size_t before = walls.size();
  const auto programmed = programmed_moves(path, of);
  for (std::size_t i = 0; i < programmed.size(); ++i) {
    const Move& move = programmed[i];
    if (!is_part(move) || !move.carrier.base || (is_offset && runs_backwards(move))) continue;
    walls.push_back({stretch_of(move), {}, reaches.of(move), contour, i});
  }
  if (walls.size() < before + 2) return;
  Stretch& first = walls[before].stretch;
  Stretch& last = walls.back().stretch;
  if (first.from == last.to) return;
  if (covers(programmed[walls[before].index], last.to)) {
    first.from = last.to;
  } else if (covers(programmed[walls.back().index], first.from)) {
    last.to = first.from;
  }
}

/// A move as it is asked about.
struct Way {
  Stretch stretch;  ///< from end to end
  Stretch inside;   ///< less kArrival at both ends
};

/// Nothing for a move too short to have an inside.
std::optional<Way> way_of(const Move& move) {
  const RationalPoint from = rational_near(move.from);
  const RationalPoint to = rational_near(move.to);
  const Rational arrival(kArrival);
  if (squared_length(to - from) <= 16 * arrival * arrival) return std::nullopt;
  const auto line = line_through(known_point(from), known_point(to));
  const auto* const made = std::get_if<Constructed<Line>>(&line);
  if (made == nullptr) return std::nullopt;
  const Line& along = made->value;
  const Carrier on{ElementPtr(along), nullptr};
  const RationalPoint foot = along.foot(to);
  const Vector step = arrival * along.direction().vector();
  return Way{{Point(from), Point(foot), on}, {Point(from + step), Point(foot - step), on}};
}

class PartWalls {
 public:
  explicit PartWalls(const Toolpath& path) : walls_(walls_of(path)), tree_(boxes()) {
    double sum = 0;
    for (const Wall& wall : walls_) sum += extent(wall.balls.box);
    typical_ = walls_.empty() ? 1 : sum / static_cast<double>(walls_.size());
    for (const Wall& wall : walls_) widest_ = std::max(widest_, nearest_double(wall.reach));
  }

  /// Calls visit(wall, distance kept) for each wall that the move meets.
  template <class Visit>
  void met_by(const Way& way, const Rational& reach, const Rational& allowed, Visit&& visit) const {
    const StretchBalls full = balls_of(way.stretch);
    const StretchBalls inside = balls_of(way.inside);
    for (const std::size_t i : candidates(way, nearest_double(reach))) {
      const Wall& wall = walls_[i];
      const Rational kept = std::min(reach, wall.reach) - allowed;
      const bool has_width = sgn(kept) > 0;
      const Rational& distance = has_width ? kept : touch();
      if (nearer(has_width ? way.stretch : way.inside, has_width ? full : inside, wall, distance))
        visit(wall, has_width ? std::min(reach, wall.reach) : Rational(0));
    }
  }

 private:
  static double extent(const Bounds& box) {
    return std::hypot(box.max_x - box.min_x, box.max_y - box.min_y);
  }
  static std::vector<Wall> walls_of(const Toolpath& path) {
    std::vector<Wall> walls;
    for (std::size_t c = 0; c < path.contours.size(); ++c) add_walls(path, c, walls);
    for (Wall& wall : walls) wall.balls = balls_of(wall.stretch);
    return walls;
  }
  [[nodiscard]] std::vector<Bounds> boxes() const {
    std::vector<Bounds> all;
    all.reserve(walls_.size());
    for (const Wall& wall : walls_) all.push_back(wall.balls.box);
    return all;
  }

  static bool nearer(const Stretch& way, const StretchBalls& balls, const Wall& wall,
                     const Rational& distance) {
    const auto certain = stages::filtered_nearer(balls, wall.balls, Ball(distance));
    return certain ? *certain : comes_nearer(way, wall.stretch, distance);
  }

  /// The walls near a move. One box round a long slanting move would hold half the plate: it is
  /// asked for in parts not much longer than walls are.
  [[nodiscard]] std::vector<std::size_t> candidates(const Way& way, double reach) const {
    constexpr double kMostParts = 256;
    const Piece piece = piece_of(way.stretch);
    const double dx = piece.x1 - piece.x0;
    const double dy = piece.y1 - piece.y0;
    const double parts =
        std::clamp(std::ceil(std::hypot(dx, dy) / (8 * typical_)), 1.0, kMostParts);
    // Above the rounding of the parts' ends.
    const double slack =
        1e-9 * (1 + std::fabs(piece.x0) + std::fabs(piece.y0) + std::hypot(dx, dy));
    std::vector<std::size_t> near;
    for (double k = 0; k < parts; ++k) {
      const double x0 = piece.x0 + dx * (k / parts);
      const double y0 = piece.y0 + dy * (k / parts);
      const double x1 = piece.x0 + dx * ((k + 1) / parts);
      const double y1 = piece.y0 + dy * ((k + 1) / parts);
      const Bounds box{std::min(x0, x1), std::min(y0, y1), std::max(x0, x1), std::max(y0, y1)};
      tree_.overlapping(box.grown(std::min(reach, widest_) + slack),
                        [&](std::size_t i) { near.push_back(i); });
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return near;
  }

  std::vector<Wall> walls_;
  BoxTree tree_;
  double typical_ = 1;  ///< extent of a wall, mm
  double widest_ = 0;   ///< reach, mm
};

/// The reach of the tool on a lead: that of the cut it leads to, or away from.
Rational reach_beside(const Toolpath& path, const Contour& contour, std::size_t move) {
  for (std::size_t i = move + 1; i < contour.last; ++i)
    if (is_part(path.moves[i])) return reach_of(path.moves[i]);
  for (std::size_t i = move; i > contour.first; --i)
    if (is_part(path.moves[i - 1])) return reach_of(path.moves[i - 1]);
  return 0;
}

/// What is told of the walls that one move meets: each contour once.
class Crossings {
 public:
  Crossings(const Way& way, std::size_t index) : index_(index), piece_(piece_of(way.stretch)) {}

  void take(const Wall& wall, const Rational& kept) {
    const Approach near = nearest(piece_, piece_of(wall.stretch));
    PartCrossing found{index_, wall.contour, wall.index, 0, near.x, near.y};
    const bool has_width = sgn(kept) > 0;
    if (has_width) found.depth = nearest_double(kept) - near.distance;
    const double rank =
        has_width ? found.depth : -std::hypot(near.x - piece_.x0, near.y - piece_.y0);
    const auto [at, fresh] = found_.try_emplace(wall.contour, found, rank);
    if (!fresh && rank > at->second.second) at->second = {found, rank};
  }
  void append_to(std::vector<PartCrossing>& all) const {
    for (const auto& [contour, found] : found_) all.push_back(found.first);
  }

 private:
  std::size_t index_;
  Piece piece_;
  std::map<std::size_t, std::pair<PartCrossing, double>> found_;  // by contour
};

}  // namespace

std::vector<PartCrossing> find_part_crossings(const Toolpath& path, CrossingMoves which,
                                              const Rational& tolerance) {
  std::vector<PartCrossing> all;
  if (which == CrossingMoves::None || path.contours.empty()) return all;
  const PartWalls walls(path);
  const Rational allowed = gouge_resolution() + tolerance;
  std::size_t next = 0;  // the contour that holds the move, or comes after it
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    while (next < path.contours.size() && path.contours[next].last <= i) ++next;
    const Move& move = path.moves[i];
    const bool is_lead = move.cuts() && !is_part(move);
    const bool is_rapid = move.kind == MoveKind::Rapid && which == CrossingMoves::All;
    if (!is_lead && !is_rapid) continue;
    const auto way = way_of(move);
    if (!way) continue;
    const bool within = next < path.contours.size() && path.contours[next].first <= i;
    const Rational reach =
        is_lead && within ? reach_beside(path, path.contours[next], i) : Rational(0);
    Crossings crossings(*way, i);
    walls.met_by(*way, reach, allowed,
                 [&](const Wall& wall, const Rational& kept) { crossings.take(wall, kept); });
    crossings.append_to(all);
  }
  return all;
}

}  // namespace dgt
