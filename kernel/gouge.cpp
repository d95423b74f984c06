// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/gouge.h"

#include <cmath>
#include <map>
#include <utility>

namespace dgt {
namespace {

std::vector<Box> boxes_of(const std::vector<CutPiece>& pieces) {
  std::vector<Box> boxes;
  boxes.reserve(pieces.size());
  for (const CutPiece& p : pieces) boxes.push_back(box_of(p.piece));
  return boxes;
}

/// The size of the largest coordinate: rounding errors are a fraction of it.
double largest(const Box& box) {
  return std::max(
      {std::fabs(box.min_x), std::fabs(box.min_y), std::fabs(box.max_x), std::fabs(box.max_y)});
}

}  // namespace

double gouge_depth(const CutPiece& path, const CutPiece& programmed, Approach& where) {
  const double reach = std::min(path.reach, programmed.reach);
  if (reach == 0) return 0;
  where = nearest(path.piece, programmed.piece);
  return reach - where.distance;
}

std::vector<Gouge> find_gouges(const std::vector<CutPiece>& path,
                               const std::vector<CutPiece>& programmed, double tolerance) {
  const std::vector<Box> path_boxes = boxes_of(path);
  std::vector<Box> programmed_boxes = boxes_of(programmed);
  double size = 0;
  for (const Box& box : path_boxes) size = std::max(size, largest(box));
  // Above 10⁸ mm the rounding of the measures themselves outgrows the resolution.
  const double allowed = std::max(kGougeResolution, size * 0x1p-44) + tolerance;
  const BoxTree tree(std::move(programmed_boxes));

  std::map<std::size_t, std::vector<std::size_t>> programmed_of;  // item → stretches; on demand
  const auto meant = [&](std::size_t item, const Piece& other) {
    if (programmed_of.empty()) {
      for (std::size_t j = 0; j < programmed.size(); ++j)
        programmed_of[programmed[j].item].push_back(j);
    }
    const auto own = programmed_of.find(item);
    return own != programmed_of.end() &&
           std::any_of(own->second.begin(), own->second.end(), [&](std::size_t j) {
             return cross_inside(programmed[j].piece, other, kGougeResolution);
           });
  };

  std::vector<Gouge> gouges;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> known;  // items → index
  for (std::size_t i = 0; i < path.size(); ++i) {
    tree.overlapping(path_boxes[i].grown(path[i].reach), [&](std::size_t j) {
      Approach where;
      const double depth = gouge_depth(path[i], programmed[j], where);
      if (depth <= allowed || meant(path[i].item, programmed[j].piece)) return;
      const auto pair = std::minmax(path[i].item, programmed[j].item);
      const auto [at, fresh] = known.try_emplace(pair, gouges.size());
      if (fresh) gouges.emplace_back();
      Gouge& g = gouges[at->second];
      if (depth > g.depth) g = {i, j, depth, where.x, where.y};
    });
  }
  return gouges;
}

}  // namespace dgt
