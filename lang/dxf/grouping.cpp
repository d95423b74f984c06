// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dxf/grouping.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <unordered_map>

namespace dgt {
namespace {

/// A square of the plane half as wide as the distance: all of a square is one group, and what is
/// within the distance lies at most two squares away.
struct Cell {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
};
struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    return std::hash<std::int64_t>()(cell.x * 0x1f1f1f1f + cell.y);
  }
};

}  // namespace

Groups grouped(const std::vector<RationalPoint>& places, const std::vector<std::size_t>& members,
               const Rational& distance) {
  // A cell holds few unless the drawing is one blot, which then falls into more groups.
  constexpr std::size_t kMostCompared = 64;
  constexpr int kReach = 2;
  Groups groups(places.size());
  const double size = nearest_double(distance) / 2;
  // Coordinates reach 10⁹·1000 mm and distances down to 10⁻⁶: cells fit 64 bits.
  std::unordered_map<Cell, std::vector<std::size_t>, CellHash> cells;
  const auto cell_of = [&](std::size_t i) {
    const Spotted at = spotted(places[i]);
    return Cell{static_cast<std::int64_t>(std::floor(at.x / size)),
                static_cast<std::int64_t>(std::floor(at.y / size))};
  };
  for (const std::size_t i : members) cells[cell_of(i)].push_back(i);
  for (const std::size_t i : members) {
    const Cell own = cell_of(i);
    for (std::int64_t dx = -kReach; dx <= kReach; ++dx) {
      for (std::int64_t dy = -kReach; dy <= kReach; ++dy) {
        const auto found = cells.find({own.x + dx, own.y + dy});
        if (found == cells.end()) continue;
        const std::size_t most = std::min(found->second.size(), kMostCompared);
        for (std::size_t k = 0; k < most; ++k) {
          const std::size_t j = found->second[k];
          if (j != i && are_within(places[i], places[j], distance)) groups.unite(i, j);
        }
      }
    }
  }
  return groups;
}

const Rational& dxf_one_place() {
  static const Rational kOnePlace(1, 1'000'000);
  return kOnePlace;
}

Spotted spotted(const RationalPoint& p) { return {nearest_double(p.x), nearest_double(p.y)}; }

bool are_within(const RationalPoint& a, const RationalPoint& b, const Rational& distance) {
  return squared_length(b - a) <= distance * distance;
}

double distance_between(const RationalPoint& a, const RationalPoint& b) {
  const Spotted w = spotted(b - a);
  return std::hypot(w.x, w.y);
}

Groups::Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

std::size_t Groups::of(std::size_t i) {
  while (parent_[i] != i) {
    parent_[i] = parent_[parent_[i]];
    i = parent_[i];
  }
  return i;
}

void Groups::unite(std::size_t i, std::size_t j) {
  i = of(i);
  j = of(j);
  parent_[std::max(i, j)] = std::min(i, j);
}

}  // namespace dgt
