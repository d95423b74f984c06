// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dxf/chaining.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "lang/dxf/grouping.h"
#include "lang/dxf/joints.h"
#include "lang/dxf/overlaps.h"

namespace dgt {
namespace {

std::string millimetres(double value) { return fmt::format("{:.6g}", value); }

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

class Chaining {
 public:
  Chaining(std::vector<DxfStrand> strands, const DxfOptions& options, DiagnosticBag& bag)
      : strands_(std::move(strands)), options_(options), bag_(bag) {}

  std::vector<DxfContour> run() {
    remove_duplicates(strands_, bag_);
    report_overlaps(strands_, bag_);
    find_places();
    link_places();
    link_free_ends();
    for (std::size_t i = 0; i < strands_.size(); ++i) {
      if (!used_[i]) walk(i);
    }
    joining_.tell_gaps(bag_);
    return std::move(contours_);
  }

 private:
  // End 2i is where strand i begins, 2i + 1 where it ends.
  [[nodiscard]] const RationalPoint& place(std::size_t end) const {
    const DxfStrand& strand = strands_[end / 2];
    return end % 2 == 0 ? strand.pieces.front().from : strand.pieces.back().to;
  }
  static std::size_t other_end(std::size_t end) { return end ^ 1U; }

  void find_places() {
    const std::size_t count = 2 * strands_.size();
    used_.assign(strands_.size(), false);
    link_.assign(count, kNone);
    std::vector<RationalPoint> places;
    std::vector<std::size_t> members;
    places.reserve(count);
    for (std::size_t end = 0; end < count; ++end) {
      places.push_back(place(end));
      if (!strands_[end / 2].closed) members.push_back(end);
    }
    places_ = std::move(places);
    Groups groups = grouped(places_, members, std::min(dxf_one_place(), at_least_nothing()));
    for (const std::size_t end : members) ends_at_[groups.of(end)].push_back(end);
    for (const auto& [group, ends] : ends_at_)
      for (const std::size_t end : ends) group_of_[end] = group;
  }
  /// Grouping needs a distance; nothing that is drawn is nearer than this and not the same.
  [[nodiscard]] Rational at_least_nothing() const {
    static const Rational kNothing(1, 1'000'000'000);
    return std::max(options_.join_tolerance, kNothing);
  }

  void link(std::size_t a, std::size_t b) {
    link_[a] = b;
    link_[b] = a;
  }

  void link_places() {
    std::size_t branches = 0;
    const std::vector<std::size_t>* most = nullptr;
    for (const auto& [group, ends] : ends_at_) {
      if (ends.size() == 2) link(ends[0], ends[1]);
      if (ends.size() <= 2) continue;
      ++branches;
      if (most == nullptr || ends.size() > most->size()) most = &ends;
    }
    if (most == nullptr) return;
    const Spotted at = spotted(places_[most->front()]);
    bag_.add({Message::DxfBranch,
              strands_[most->front() / 2].place(),
              {std::to_string(branches), std::to_string(most->size()), millimetres(at.x),
               millimetres(at.y)}});
  }

  /// Ends that are alone at their places, within the tolerance of each other.
  void link_free_ends() {
    std::vector<std::size_t> free;
    for (const auto& [group, ends] : ends_at_)
      if (ends.size() == 1) free.push_back(ends.front());
    std::ranges::sort(free);
    Groups groups = grouped(places_, free, at_least_nothing());
    std::map<std::size_t, std::vector<std::size_t>> found;
    for (const std::size_t end : free) found[groups.of(end)].push_back(end);
    std::size_t crowds = 0;
    std::size_t crowded = 0;
    std::vector<std::size_t> open;
    for (const auto& [group, ends] : found) {
      const bool is_pair = ends.size() == 2 && can_join(ends[0], ends[1]);
      if (is_pair) {
        link(ends[0], ends[1]);
        continue;
      }
      if (ends.size() > 2 && crowds++ == 0) crowded = ends.front();
      open.insert(open.end(), ends.begin(), ends.end());
    }
    if (crowds > 0) {
      bag_.add({Message::DxfCrowd,
                strands_[crowded / 2].place(),
                {std::to_string(crowds), millimetres(nearest_double(options_.join_tolerance))}});
    }
    if (!open.empty()) tell_open(open);
  }
  /// A single segment, or short arc, does not close on itself.
  [[nodiscard]] bool can_join(std::size_t a, std::size_t b) const {
    if (a / 2 != b / 2) return true;
    const DxfStrand& strand = strands_[a / 2];
    if (strand.pieces.size() > 1) return true;
    const DxfPiece& piece = strand.pieces.front();
    if (!piece.circle) return false;
    const Vector from = piece.from - piece.circle->centre();
    const Vector to = piece.to - piece.circle->centre();
    return (sgn(cross(from, to)) > 0) != piece.circle->counter_clockwise();
  }

  /// Open ends, with the smallest gap between two of them: the tolerance that would close it.
  void tell_open(const std::vector<std::size_t>& open) {
    double smallest = std::numeric_limits<double>::infinity();
    std::size_t where = open.front();
    std::vector<std::pair<Spotted, std::size_t>> sorted;
    for (const std::size_t end : open) sorted.emplace_back(spotted(places_[end]), end);
    std::ranges::sort(sorted, {}, [](const auto& entry) { return entry.first.x; });
    // Along x no farther than the best so far, and few are looked at from each.
    constexpr std::size_t kMostCompared = 64;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      for (std::size_t j = i + 1; j < std::min(sorted.size(), i + kMostCompared); ++j) {
        const double dx = sorted[j].first.x - sorted[i].first.x;
        if (dx > smallest) break;
        if (sorted[i].second / 2 == sorted[j].second / 2) continue;
        const double gap = std::hypot(dx, sorted[j].first.y - sorted[i].first.y);
        if (gap < smallest) {
          smallest = gap;
          where = std::min(sorted[i].second, sorted[j].second);
        }
      }
    }
    const Spotted at = spotted(places_[where]);
    const Range range = strands_[where / 2].place();
    const std::string count = std::to_string(open.size());
    if (std::isinf(smallest)) {
      bag_.add({Message::DxfOpen, range, {count, millimetres(at.x), millimetres(at.y)}});
    } else {
      bag_.add({Message::DxfGap,
                range,
                {count, millimetres(smallest), millimetres(at.x), millimetres(at.y),
                 to_short_decimal(options_.join_tolerance)}});
    }
  }

  // --- contours

  void walk(std::size_t first) {
    if (strands_[first].closed) {
      used_[first] = true;
      joining_.add(std::move(strands_[first]));
      contours_.push_back(joining_.finish());
      return;
    }
    // Back to where the contour begins, or once round.
    std::size_t begin = 2 * first;
    bool is_round = false;
    while (link_[begin] != kNone && !is_round) {
      const std::size_t before = other_end(link_[begin]);
      is_round = before / 2 == first;
      if (!is_round) begin = before;
    }
    if (is_round) begin = 2 * first;
    std::vector<std::size_t> entries;  // the ends at which its strands are entered
    for (std::size_t end = begin; end != kNone && !used_[end / 2]; end = link_[other_end(end)]) {
      used_[end / 2] = true;
      entries.push_back(end);
    }
    // At a place where more ends meet a contour may well end where it began.
    const std::size_t last = other_end(entries.back());
    const bool closed = is_round || (group_of_[begin] == group_of_[last] && begin != last);
    if (runs_backward(entries)) turn_round(entries, is_round);
    for (const std::size_t end : entries) {
      DxfStrand& strand = strands_[end / 2];
      joining_.add(end % 2 == 0 ? std::move(strand) : reversed(strand));
    }
    if (closed) joining_.close();
    contours_.push_back(joining_.finish());
    if (contours_.back().pieces.empty()) contours_.pop_back();
  }

  /// Whether the first directed strand, in the file's order, is entered at its end.
  [[nodiscard]] bool runs_backward(const std::vector<std::size_t>& entries) const {
    std::size_t first = kNone;
    for (const std::size_t end : entries) {
      const bool is_earlier = first == kNone || end / 2 < first / 2;
      if (strands_[end / 2].directed && is_earlier) first = end;
    }
    return first != kNone && first % 2 == 1;
  }

  /// A closed contour keeps its first strand.
  static void turn_round(std::vector<std::size_t>& entries, bool is_round) {
    std::ranges::reverse(entries);
    for (std::size_t& end : entries) end = other_end(end);
    if (is_round) std::ranges::rotate(entries, entries.end() - 1);
  }

  std::vector<DxfStrand> strands_;
  const DxfOptions& options_;
  DiagnosticBag& bag_;
  std::vector<RationalPoint> places_;
  std::map<std::size_t, std::vector<std::size_t>> ends_at_;
  std::unordered_map<std::size_t, std::size_t> group_of_;
  std::vector<std::size_t> link_;
  std::vector<bool> used_;
  Joining joining_;
  std::vector<DxfContour> contours_;
};

/// Strands one behind the other.
class DrawnOrder {
 public:
  DrawnOrder(const DxfOptions& options, DiagnosticBag& bag)
      : tolerance_(options.join_tolerance), bag_(bag) {}

  std::vector<DxfContour> run(std::vector<DxfStrand> strands) {
    for (DxfStrand& strand : strands) add(std::move(strand));
    flush();
    joining_.tell_gaps(bag_);
    return std::move(contours_);
  }

 private:
  void add(DxfStrand strand) {
    if (joining_.empty()) return begin(std::move(strand));
    if (const auto entered = entered_here(strand)) return go_on(*entered);
    if (first_may_turn_) {
      joining_.turn_round();
      if (const auto entered = entered_here(strand)) return go_on(*entered);
      joining_.turn_round();
    }
    flush();
    begin(std::move(strand));
  }

  void begin(DxfStrand strand) {
    first_may_turn_ = !strand.directed && !strand.closed;
    joining_.add(std::move(strand));
  }
  void go_on(const DxfStrand& strand) {
    first_may_turn_ = false;
    joining_.add(strand);
  }

  /// The strand as it goes on from where the path stands; nothing when it does not.
  [[nodiscard]] std::optional<DxfStrand> entered_here(const DxfStrand& strand) const {
    const RationalPoint& at = joining_.end();
    if (strand.pieces.front().is_whole_circle()) return circle_from(strand, at);
    const bool begins_here = are_within(at, strand.pieces.front().from, tolerance_);
    if (strand.directed || begins_here) return begins_here ? std::optional(strand) : std::nullopt;
    if (!are_within(at, strand.pieces.back().to, tolerance_)) return std::nullopt;
    return reversed(strand);
  }

  /// Once round from there; two circles cannot both be turned to meet.
  [[nodiscard]] std::optional<DxfStrand> circle_from(const DxfStrand& strand,
                                                     const RationalPoint& at) const {
    if (joining_.ends_in_circle()) return std::nullopt;
    const Circle& circle = *strand.pieces.front().circle;
    const Vector out = at - circle.centre();
    if (sgn(out.x) == 0 && sgn(out.y) == 0) return std::nullopt;
    const RationalPoint begin =
        circle.centre() + abs(circle.radius()) * direction_of(out).unit.vector();
    if (!are_within(at, begin, tolerance_)) return std::nullopt;
    DxfStrand turned = strand;
    turned.pieces.front().from = turned.pieces.front().to = begin;
    turned.closed = false;
    return turned;
  }

  void flush() {
    if (joining_.empty()) return;
    DxfContour contour = joining_.finish();
    if (!contour.pieces.empty()) contours_.push_back(std::move(contour));
  }

  Rational tolerance_;
  DiagnosticBag& bag_;
  Joining joining_;
  bool first_may_turn_ = false;
  std::vector<DxfContour> contours_;
};

}  // namespace

std::vector<DxfContour> chained(std::vector<DxfStrand> strands, const DxfOptions& options,
                                DiagnosticBag& bag) {
  return Chaining(std::move(strands), options, bag).run();
}

std::vector<DxfContour> in_drawn_order(std::vector<DxfStrand> strands, const DxfOptions& options,
                                       DiagnosticBag& bag) {
  return DrawnOrder(options, bag).run(std::move(strands));
}

}  // namespace dgt
