// SPDX-License-Identifier: GPL-3.0-or-later
// The production engine. Its outline is `run` below:
//
//   raw curve in doubles → box tree in contour order → crossings of overlapping pieces, sorted
//   along each piece → winding number of each stretch between crossings → stretches with the wanted
//   number on the left, joined at crossings into loops.
//
// Decisions are made for a distance 2⁻⁷⁰ mm beyond the one asked for. That parts all that is in
// contact by design (a slot exactly as wide as the tool), and double-doubles, good to some 2⁻⁹⁰ mm,
// can tell. What they cannot tell coincides at every distance (corners about one vertex, edges
// along one line): then all is decided once more for vertices each moved its own way by 2⁻⁷⁴ mm,
// which parts that too and keeps a contact a contact. What is open still, the reference engine
// takes.
//
// Joints whose edges' normals agree within kTangent are tangent: one point, no corner. The raw
// curve then differs from the exact one by d·kTangent²/2 across and d·kTangent along, a sliver in
// which nothing that is meant takes place.
#include <algorithm>
#include <limits>
#include <optional>

#include "kernel/box_tree.h"
#include "kernel/offset_source.h"
#include "kernel/offset_voids.h"
#include "kernel/raw_curve.h"
#include "kernel/raw_passings.h"
#include "kernel/winding_numbers.h"

namespace dgt {

class OffsetEngine {
 public:
  OffsetEngine(std::shared_ptr<const OffsetSource> source, OffsetCounts& counts)
      : source_(std::move(source)),
        counts_(counts),
        curve_(*source_),
        tree_(curve_.size(),
              [this](std::size_t i) {
                const Bounds box = curve_.box(static_cast<std::uint32_t>(i));
                right_ = std::max(right_, box.max_x);
                return box;
              }),
        passings_(*source_, curve_, counts),
        numbers_(*source_, curve_, passings_, counts) {
    counts_.strands = curve_.size() - source_->loops();
  }

  /// Nothing when double-doubles leave something open.
  std::optional<OffsetRegion> run() {
    if (!passings_.find(tree_) || !numbers_.carry(tree_, right_)) return std::nullopt;
    std::optional<OffsetRegion> region = trace();
    if (region) region->drop(bounding_nothing(*region, *source_));
    return region;
  }

 private:
  /// Nothing when a loop does not close: the reference makes good what never should happen.
  std::optional<OffsetRegion> trace() {
    const int wanted = curve_.region_number();
    const auto& order = passings_.order();
    OffsetRegion region;
    region.source_ = source_;
    region.pieces_.reserve(curve_.size());
    std::vector<bool> used(order.size(), false);
    for (std::uint32_t first = 0; first < order.size(); ++first) {
      if (used[first] || numbers_.behind(first).left != wanted) continue;
      std::uint32_t begin = first;
      do {
        if (used[begin] || numbers_.behind(begin).left != wanted) {
          ++counts_.torn;
          return std::nullopt;
        }
        used[begin] = true;
        const std::uint32_t end = numbers_.behind(begin).end;
        add_stretch(region, begin, end);
        begin = passings_.rank(RawPassings::twin(order[end].event));
      } while (begin != first);
      region.first_.push_back(region.pieces_.size());
    }
    for (std::size_t loop = 0; loop < source_->loops(); ++loop) {
      if (passings_.first_rank(curve_.begin(loop)) != passings_.first_rank(curve_.end(loop)) ||
          numbers_.of_loop(loop) != wanted)
        continue;
      for (std::uint32_t s = curve_.begin(loop); s < curve_.end(loop); ++s) add_piece(region, s);
      region.first_.push_back(region.pieces_.size());
    }
    return region;
  }

  /// Between the events of two ranks.
  void add_stretch(OffsetRegion& region, std::uint32_t begin, std::uint32_t end) const {
    const std::uint32_t last = passings_.strand(passings_.order()[end].event);
    const RawPassings::Event event = passings_.order()[begin].event;
    std::uint32_t s = passings_.strand(event);
    RegionPiece& first = add_piece(region, s);
    const quick::Passing& m = passings_.passing(event);
    first.x = m.x;
    first.y = m.y;
    first.cut = curve_[m.strand[0]].key;
    first.by = curve_[m.strand[1]].key;
    bool once_round = s == last && end <= begin;
    while (s != last || once_round) {
      once_round = false;
      s = curve_.next(s);
      add_piece(region, s);
    }
  }

  RegionPiece& add_piece(OffsetRegion& region, std::uint32_t s) const {
    const RawStrand& k = curve_[s];
    const double radius = k.is_line ? 0 : k.counter_clockwise ? k.radius : -k.radius;
    return region.pieces_.emplace_back(RegionPiece{k.x, k.y, radius, k.key, k.key, k.key});
  }

  std::shared_ptr<const OffsetSource> source_;
  OffsetCounts& counts_;
  RawCurve curve_;
  double right_ = -std::numeric_limits<double>::infinity();
  BoxTree tree_;
  RawPassings passings_;
  WindingNumbers numbers_;
};

// --- from input to result -----------------------------------------------------------------------

namespace {

OffsetRegion by_reference(const std::shared_ptr<const OffsetSource>& source, OffsetCounts& counts) {
  counts.exact = counts.decisions;
  return OffsetRegion::of(
      reference_offset(source->exact_loops(), source->distance(), source->options()));
}

/// Nothing when the engine leaves something open.
std::optional<OffsetRegion> by_production(const std::shared_ptr<const OffsetSource>& source,
                                          OffsetCounts& counts) {
  if (sgn(source->distance()) == 0 || source->edges() >= RawKey::kMaxEdges ||
      !source->suits_doubles())
    return std::nullopt;
  if (auto region = OffsetEngine(source, counts).run()) return region;
  return OffsetEngine(std::make_shared<const OffsetSource>(source->parted()), counts).run();
}

template <class Loops>
OffsetRegion region_of(const Loops& loops, const Rational& distance, const OffsetOptions& options,
                       OffsetCounts& counts) {
  counts = {};
  if (loops.empty()) return {};
  const bool grows = sgn(distance) < 0;  // growing the region is shrinking what lies beyond it
  const auto source = std::make_shared<const OffsetSource>(loops, abs(distance), grows, options);
  std::optional<OffsetRegion> found = by_production(source, counts);
  OffsetRegion region = found ? *std::move(found) : by_reference(source, counts);
  if (grows) region.reverse();
  return region;
}

}  // namespace

OffsetRegion production_offset(const std::vector<BulgePolyline>& loops, const Rational& distance,
                               const OffsetOptions& options, OffsetCounts* counts) {
  OffsetCounts ignored;
  return region_of(loops, distance, options, counts ? *counts : ignored);
}

std::vector<OffsetLoop> production_offset(const std::vector<Chain>& loops, const Rational& distance,
                                          const OffsetOptions& options, OffsetCounts* counts) {
  OffsetCounts ignored;
  return region_of(loops, distance, options, counts ? *counts : ignored).exact();
}

std::vector<OffsetLoop> region_about(const Chain& there_and_back, const Rational& distance,
                                     const OffsetOptions& options) {
  OffsetCounts counts;
  const auto source =
      std::make_shared<const OffsetSource>(OffsetSource::about(there_and_back, distance, options));
  if (const auto found = by_production(source, counts)) return found->exact_pieces();
  return shrunk_by_reference({there_and_back}, distance, 0, options);
}

}  // namespace dgt
