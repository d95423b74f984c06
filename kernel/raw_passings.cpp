// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/raw_passings.h"

#include <algorithm>

#include "kernel/cusp_order.h"

namespace dgt {
namespace {

using quick::Passing;

void add(std::uint32_t a, std::uint32_t b, const Crossings<DoubleDouble>& crossings,
         std::vector<Passing>& found) {
  const auto radius = [](const Enclosed<DoubleDouble>& e) {
    return rounded_up(e.rad + 0x1p-52 * e.size());
  };
  for (int i = 0; i < crossings.count; ++i) {
    const Crossing<DoubleDouble>& c = crossings.found[static_cast<std::size_t>(i)];
    found.push_back({c.at.x.hi,
                     c.at.y.hi,
                     {c.position[0].mid.hi, c.position[1].mid.hi},
                     {radius(c.position[0]), radius(c.position[1])},
                     {a, b},
                     static_cast<std::int8_t>(c.turn),
                     i == 1});
  }
}

}  // namespace

bool RawPassings::find(const BoxTree& tree) { return find_crossings(tree) && sort_events(); }

/// Consecutive pieces of a raw curve are tangent where they join and meet nowhere else: they are
/// never tested against each other.
bool RawPassings::find_crossings(const BoxTree& tree) {
  passings_.reserve(2 * curve_.size());
  bool decided = true;
  std::size_t pairs = 0;  // here the compiler keeps it in a register
  tree.pairs([&, curve = &curve_](std::size_t i, std::size_t j) {
    const auto a = static_cast<std::uint32_t>(i);
    const auto b = static_cast<std::uint32_t>(j);
    if (curve->adjacent(a, b)) return;
    ++pairs;
    if (decided && !curve->surely_apart(a, b)) decided = cross_strands(a, b);
  });
  counts_.pairs = pairs;
  counts_.decisions += pairs;
  counts_.crossings = passings_.size();
  return decided;
}

bool RawPassings::cross_strands(std::uint32_t a, std::uint32_t b) {
  if (quick::cross(curve_, a, b, passings_)) return true;
  ++counts_.fine;
  const Crossings<DoubleDouble> finer = cross(fine(a), fine(b));
  if (finer.decided) add(a, b, finer, passings_);
  return finer.decided;
}

bool RawPassings::sort_events() {
  first_.assign(curve_.size() + 1, 0);
  for (const Passing& m : passings_)
    for (const std::uint32_t s : m.strand) ++first_[s + 1];
  for (std::size_t s = 0; s < curve_.size(); ++s) first_[s + 1] += first_[s];
  order_.resize(2 * passings_.size());
  Event e = 0;
  for (const Passing& m : passings_) {
    for (const std::size_t side : {0U, 1U})
      order_[first_[m.strand[side]]++] = {m.along[side], m.along_rad[side], e++};
  }
  for (std::size_t s = curve_.size(); s > 0; --s) first_[s] = first_[s - 1];
  first_[0] = 0;
  for (std::size_t s = 0; s < curve_.size(); ++s) {
    const std::span<Placed> here{order_.data() + first_[s], first_[s + 1] - first_[s]};
    if (here.size() > 1 && !sort_along(here)) return false;
  }
  rank_.resize(order_.size());
  for (std::uint32_t k = 0; k < order_.size(); ++k) rank_[order_[k].event] = k;
  return true;
}

bool RawPassings::sort_along(std::span<Placed> events) {
  constexpr std::size_t kFew = 24;
  if (events.size() > kFew) {
    std::ranges::sort(events, {}, &Placed::at);
  } else {
    for (std::size_t k = 1; k < events.size(); ++k) {
      if (events[k - 1].at <= events[k].at) continue;
      const Placed e = events[k];
      std::size_t to = k;
      do {
        events[to] = events[to - 1];
      } while (--to > 0 && events[to - 1].at > e.at);
      events[to] = e;
    }
  }
  counts_.decisions += events.size() - 1;
  std::size_t open = 0;
  for (std::size_t k = 1; k < events.size(); ++k) {
    const double gap = events[k].at - events[k - 1].at;
    if (!(gap > (static_cast<double>(events[k].rad) + events[k - 1].rad) * kUp)) ++open;
  }
  counts_.fine += open;
  return open == 0 || sort_finely(events);
}

bool RawPassings::sort_finely(std::span<Placed> events) const {
  struct FinelyPlaced {
    Placed coarse;
    Enclosed<DoubleDouble> at;
  };
  std::vector<FinelyPlaced> placed;
  for (const Placed& e : events) {
    const Passing& m = passing(e.event);
    const Crossings<DoubleDouble> c = cross(fine(m.strand[0]), fine(m.strand[1]));
    // Of two roots, doubles may have found one alone inside both; then so do double-doubles.
    const std::size_t root = m.last ? 1 : 0;
    if (!c.decided || c.count <= static_cast<int>(root)) return false;
    placed.push_back({e, c.found[root].position[e.event % 2]});
  }
  std::ranges::sort(placed, {},
                    [](const FinelyPlaced& p) { return std::pair(p.at.mid.hi, p.at.mid.lo); });
  for (std::size_t k = 1; k < placed.size(); ++k) {
    if ((placed[k].at - placed[k - 1].at).sign() > 0) continue;
    const int order = order_about_cusp(placed[k - 1].coarse.event, placed[k].coarse.event);
    if (order == 0) return false;
    if (order > 0) continue;
    if (k > 1 && (placed[k].at - placed[k - 2].at).sign() <= 0) return false;
    std::swap(placed[k - 1], placed[k]);
  }
  for (std::size_t k = 0; k < placed.size(); ++k) events[k] = placed[k].coarse;
  return true;
}

/// On one strand, events of two others that follow each other, out of or into a cusp
/// (cusp_order.h).
int RawPassings::order_about_cusp(Event e, Event f) const {
  const std::uint32_t one = strand(twin(e));
  const std::uint32_t two = strand(twin(f));
  if (curve_.next(two) == one && curve_.next(one) != two) return -order_about_cusp(f, e);
  if (curve_.next(one) != two) return 0;
  return order_at_cusp(fine(one), fine(two), fine(strand(e)), {passing(e).x, passing(e).y});
}

}  // namespace dgt
