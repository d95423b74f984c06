// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/drawn_layer.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace dgt {
namespace {

void add(Box& box, const Box& other) {
  box.add(other.left, other.bottom);
  box.add(other.right, other.top);
}

}  // namespace

void DrawnLayer::add(const Move& move, std::uint32_t number) {
  const DrawnCurve curve = drawn(move);
  Entry entry{curve.from, curve.to, kStraight, number, move.source};
  if (curve.is_arc()) {
    entry.arc = static_cast<std::uint32_t>(arcs_.size());
    arcs_.push_back({curve.centre, curve.radius, curve.sweep});
  }
  entries_.push_back(entry);
}

void DrawnLayer::index() {
  index_boxes();
  index_centres();
  index_lines();
}

DrawnCurve DrawnLayer::operator[](std::size_t i) const {
  const Entry& entry = entries_[i];
  if (entry.arc == kStraight) return {entry.from, entry.to, {}, 0, 0};
  const Arc& arc = arcs_[entry.arc];
  return {entry.from, entry.to, arc.centre, arc.radius, arc.sweep};
}

std::size_t DrawnLayer::count_before(std::uint32_t number) const {
  const auto end = std::ranges::lower_bound(entries_, number, {}, &Entry::number);
  return static_cast<std::size_t>(end - entries_.begin());
}

std::span<const std::uint32_t> DrawnLayer::of_line(std::uint32_t file, std::uint32_t line) const {
  const auto place = [this](std::uint32_t i) {
    return std::tuple(entries_[i].source.file, entries_[i].source.line);
  };
  const auto found = std::ranges::equal_range(by_line_, std::tuple(file, line), {}, place);
  return {found.begin(), found.end()};
}

void DrawnLayer::index_boxes() {
  const auto groups = [](std::size_t count) { return (count + kGroup - 1) / kGroup; };
  if (entries_.empty()) return;
  Level level(groups(entries_.size()));
  for (std::size_t i = 0; i < entries_.size(); ++i)
    dgt::add(level[i / kGroup], box_around((*this)[i]));
  levels_.push_back(std::move(level));
  while (levels_.back().size() > 1) {
    const Level& below = levels_.back();
    Level above(groups(below.size()));
    for (std::size_t i = 0; i < below.size(); ++i) dgt::add(above[i / kGroup], below[i]);
    levels_.push_back(std::move(above));
  }
  box_ = levels_.back().front();
}

void DrawnLayer::index_centres() {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!is_arc(i)) continue;
    centres_.push_back({arcs_[entries_[i].arc].centre, static_cast<std::uint32_t>(i)});
  }
  const auto place = [](const Centre& c) { return std::tuple(c.at.x, c.at.y); };
  std::ranges::stable_sort(centres_, {}, place);
  const auto repeated = std::ranges::unique(centres_, {}, place);
  centres_.erase(repeated.begin(), repeated.end());
}

std::size_t DrawnLayer::first_centre(double left) const {
  const auto x = [](const Centre& c) { return c.at.x; };
  return static_cast<std::size_t>(std::ranges::lower_bound(centres_, left, {}, x) -
                                  centres_.begin());
}

void DrawnLayer::index_lines() {
  by_line_.resize(entries_.size());
  std::iota(by_line_.begin(), by_line_.end(), 0U);
  std::ranges::stable_sort(by_line_, {}, [this](std::uint32_t i) {
    return std::tuple(entries_[i].source.file, entries_[i].source.line);
  });
}

}  // namespace dgt
