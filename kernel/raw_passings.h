// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/box_tree.h"
#include "kernel/offset_source.h"
#include "kernel/quick_crossing.h"
#include "kernel/raw_curve.h"

namespace dgt {

/// Where raw curves cross, in the order met along them. A passing is two events, one on each of its
/// strands; the rank of an event is its place in the order. Internal to the kernel.
class RawPassings {
 public:
  /// Number 2i + side, of passing i.
  using Event = std::uint32_t;

  /// An event on its strand: its position (strand.h) and how far that may be off.
  struct Placed {
    double at;
    float rad;
    Event event;
  };

  RawPassings(const OffsetSource& source, const RawCurve& curve, OffsetCounts& counts)
      : source_(source), curve_(curve), counts_(counts) {}

  /// False when double-doubles leave something open. `tree` holds the boxes of the curve.
  [[nodiscard]] bool find(const BoxTree& tree);

  [[nodiscard]] const quick::Passing& passing(Event e) const { return passings_[e / 2]; }
  [[nodiscard]] std::uint32_t strand(Event e) const { return passing(e).strand[e % 2]; }
  /// The same passing on the other strand.
  [[nodiscard]] static Event twin(Event e) { return e ^ 1U; }

  /// Strand by strand, in the order met along each.
  [[nodiscard]] const std::vector<Placed>& order() const { return order_; }
  [[nodiscard]] std::uint32_t rank(Event e) const { return rank_[e]; }
  /// Of the first event on a strand, or of the one behind where there is none; `strand` may be one
  /// behind the last.
  [[nodiscard]] std::uint32_t first_rank(std::uint32_t strand) const { return first_[strand]; }

 private:
  bool find_crossings(const BoxTree& tree);
  bool cross_strands(std::uint32_t a, std::uint32_t b);
  bool sort_events();
  bool sort_along(std::span<Placed> events);
  bool sort_finely(std::span<Placed> events) const;
  [[nodiscard]] int order_about_cusp(Event e, Event f) const;
  [[nodiscard]] Strand<DoubleDouble> fine(std::uint32_t strand) const {
    return source_.decisive_strand(curve_[strand].key);
  }

  const OffsetSource& source_;
  const RawCurve& curve_;
  OffsetCounts& counts_;
  std::vector<quick::Passing> passings_;
  std::vector<Placed> order_;
  std::vector<std::uint32_t> rank_;   ///< of an event
  std::vector<std::uint32_t> first_;  ///< of each strand in the order, and one behind
};

}  // namespace dgt
