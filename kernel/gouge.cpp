// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/gouge.h"

#include <map>
#include <utility>

namespace dgt {
namespace {

std::vector<Bounds> boxes_of(const std::vector<CutPiece>& pieces) {
  std::vector<Bounds> boxes;
  boxes.reserve(pieces.size());
  for (const CutPiece& p : pieces) boxes.push_back(box_around(p.stretch));
  return boxes;
}

}  // namespace

const Rational& gouge_resolution() {
  static const Rational value(1, 100'000'000);
  return value;
}

Walls::Walls(std::vector<CutPiece> programmed, Rational tolerance)
    : pieces_(std::move(programmed)),
      allowed_(gouge_resolution() + tolerance),
      tree_(boxes_of(pieces_)) {
  gauges_.reserve(pieces_.size());
  for (const CutPiece& piece : pieces_) gauges_.push_back(gauge_of(piece));
  for (std::size_t i = 0; i < pieces_.size(); ++i) pieces_of_.emplace_back(pieces_[i].item, i);
  std::sort(pieces_of_.begin(), pieces_of_.end());
}

bool Walls::meant(std::size_t item, std::size_t wall) const {
  const auto first = std::lower_bound(pieces_of_.begin(), pieces_of_.end(), std::pair(item, 0UL));
  for (auto own = first; own != pieces_of_.end() && own->first == item; ++own)
    if (!crossings_inside(pieces_[own->second].stretch, pieces_[wall].stretch).empty()) return true;
  return false;
}

Walls::Gauge Walls::gauge_of(const CutPiece& piece) const {
  Gauge gauge{balls_of(piece.stretch), piece.reach - allowed_, {}};
  gauge.kept_ball = Ball(gauge.kept);
  return gauge;
}

bool Walls::too_near(const CutPiece& path, const Gauge& gauge, std::size_t wall) const {
  const Gauge& other = gauges_[wall];
  const Gauge& less = gauge.kept < other.kept ? gauge : other;
  if (sgn(less.kept) <= 0) return false;
  if (const auto certain = stages::filtered_nearer(gauge.balls, other.balls, less.kept_ball))
    return *certain;
  return comes_nearer(path.stretch, pieces_[wall].stretch, less.kept);
}

void Walls::cut_by(const CutPiece& path, const std::function<void(std::size_t)>& visit) const {
  if (sgn(path.reach) == 0) return;
  const Gauge gauge = gauge_of(path);
  const double reach = nearest_double(path.reach);  // the boxes have room for its rounding
  tree_.overlapping(gauge.balls.box.grown(reach), [&](std::size_t i) {
    if (too_near(path, gauge, i) && !meant(path.item, i)) visit(i);
  });
}

bool Walls::any_cut_by(const CutPiece& path) const {
  bool found = false;
  cut_by(path, [&](std::size_t) { found = true; });
  return found;
}

std::vector<Gouge> find_gouges(const std::vector<CutPiece>& path, const Walls& walls) {
  std::vector<Gouge> gouges;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> known;  // items → index
  for (std::size_t i = 0; i < path.size(); ++i) {
    walls.cut_by(path[i], [&](std::size_t j) {
      const CutPiece& wall = walls.pieces()[j];
      const Approach near = nearest(piece_of(path[i].stretch), piece_of(wall.stretch));
      const double reach = nearest_double(std::min(path[i].reach, wall.reach));
      const double depth = reach - near.distance;
      const auto pair = std::minmax(path[i].item, wall.item);
      const auto [at, fresh] = known.try_emplace(pair, gouges.size());
      if (fresh) gouges.emplace_back();
      Gouge& g = gouges[at->second];
      if (fresh || depth > g.depth) g = {i, j, depth, near.x, near.y};
    });
  }
  return gouges;
}

}  // namespace dgt
