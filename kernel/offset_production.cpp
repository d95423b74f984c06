// SPDX-License-Identifier: GPL-3.0-or-later
// The production engine. Its outline is `run` below:
//
//   raw curve in doubles → box tree in contour order → crossings of overlapping pieces, sorted
//   along each piece → winding number of each stretch between crossings → stretches with the wanted
//   number on the left, joined at crossings into loops.
//
// Consecutive pieces of a raw curve are tangent where they join and meet nowhere else, so they are
// never tested against each other. The number on the left of the curve changes at a crossing alone:
// a strand that comes from the right has its own left, with a number higher by one, behind it.
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
#include "kernel/check.h"
#include "kernel/offset_source.h"
#include "kernel/offset_voids.h"
#include "kernel/quick_crossing.h"
#include "kernel/raw_curve.h"

namespace dgt {
namespace {

using quick::Passing;
/// Each passing is two events, one on each strand: number 2i + side.
using Event = std::uint32_t;

/// How many times the angle at which a strand passes a cusp is larger than what all of them turn by
/// on the way from there, so that they count as straight.
constexpr double kStraightOn = 16;

/// An event on its strand: its position and how far that may be off.
struct Placed {
  double at;
  float rad;
  Event event;
};

/// The curve from one event to the next on the same loop.
struct Between {
  int left;           ///< the winding number to the left of it
  std::uint32_t end;  ///< the rank of the event where it ends
};

}  // namespace

class OffsetEngine {
 public:
  OffsetEngine(std::shared_ptr<const OffsetSource> source, OffsetCounts& counts)
      : source_(std::move(source)),
        counts_(counts),
        curve_(*source_),
        tree_(curve_.size(), [this](std::size_t i) {
          const Bounds box = curve_.box(static_cast<std::uint32_t>(i));
          right_ = std::max(right_, box.max_x);
          return box;
        }) {
    counts_.strands = curve_.size() - source_->loops();
  }

  /// Nothing when double-doubles leave something open.
  std::optional<OffsetRegion> run() {
    if (!find_crossings() || !sort_events() || !carry_numbers()) return std::nullopt;
    std::optional<OffsetRegion> region = trace();
    if (region) region->drop(bounding_nothing(*region, *source_));
    return region;
  }

 private:
  [[nodiscard]] Strand<DoubleDouble> fine(std::uint32_t strand) const {
    return source_->decisive_strand(curve_[strand].key);
  }

  // --- crossings --------------------------------------------------------------------------------

  bool find_crossings() {
    passings_.reserve(2 * curve_.size());
    bool decided = true;
    std::size_t pairs = 0;  // here the compiler keeps it in a register
    tree_.pairs([&, curve = &curve_](std::size_t i, std::size_t j) {
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

  bool cross_strands(std::uint32_t a, std::uint32_t b) {
    if (quick::cross(curve_, a, b, passings_)) return true;
    ++counts_.fine;
    const Crossings<DoubleDouble> finer = cross(fine(a), fine(b));
    if (finer.decided) add_passings(a, b, finer);
    return finer.decided;
  }

  void add_passings(std::uint32_t a, std::uint32_t b, const Crossings<DoubleDouble>& crossings) {
    const auto radius = [](const Enclosed<DoubleDouble>& e) {
      return rounded_up(e.rad + 0x1p-52 * e.size());
    };
    for (int i = 0; i < crossings.count; ++i) {
      const Crossing<DoubleDouble>& c = crossings.found[static_cast<std::size_t>(i)];
      passings_.push_back({c.at.x.hi,
                           c.at.y.hi,
                           {c.position[0].mid.hi, c.position[1].mid.hi},
                           {radius(c.position[0]), radius(c.position[1])},
                           {a, b},
                           static_cast<std::int8_t>(c.turn),
                           i == 1});
    }
  }

  // --- order along the curve --------------------------------------------------------------------

  [[nodiscard]] const Passing& passing(Event e) const { return passings_[e / 2]; }
  [[nodiscard]] std::uint32_t strand(Event e) const { return passing(e).strand[e % 2]; }
  static Event twin(Event e) { return e ^ 1U; }

  /// Events strand by strand, in the order met along each.
  bool sort_events() {
    first_event_.assign(curve_.size() + 1, 0);
    for (const Passing& m : passings_)
      for (const std::uint32_t s : m.strand) ++first_event_[s + 1];
    for (std::size_t s = 0; s < curve_.size(); ++s) first_event_[s + 1] += first_event_[s];
    order_.resize(2 * passings_.size());
    Event e = 0;
    for (const Passing& m : passings_) {
      for (const std::size_t side : {0U, 1U})
        order_[first_event_[m.strand[side]]++] = {m.along[side], m.along_rad[side], e++};
    }
    for (std::size_t s = curve_.size(); s > 0; --s) first_event_[s] = first_event_[s - 1];
    first_event_[0] = 0;
    for (std::size_t s = 0; s < curve_.size(); ++s) {
      const std::span<Placed> here{order_.data() + first_event_[s],
                                   first_event_[s + 1] - first_event_[s]};
      if (here.size() > 1 && !sort_along(here)) return false;
    }
    rank_.resize(order_.size());
    for (std::uint32_t k = 0; k < order_.size(); ++k) rank_[order_[k].event] = k;
    return true;
  }

  bool sort_along(std::span<Placed> events) {
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

  bool sort_finely(std::span<Placed> events) {
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
      const int order = order_at_cusp(placed[k - 1].coarse.event, placed[k].coarse.event);
      if (order == 0) return false;
      if (order > 0) continue;
      if (k > 1 && (placed[k].at - placed[k - 2].at).sign() <= 0) return false;
      std::swap(placed[k - 1], placed[k]);
    }
    for (std::size_t k = 0; k < placed.size(); ++k) events[k] = placed[k].coarse;
    return true;
  }

  /// Two strands that follow each other, with a cusp between, and a third that crosses both at a
  /// distance h from it: along the third, they lie (κ₁ − κ₂) h²/2 apart, which may be far too
  /// little to measure. Where all three run straight on for that h, their curvatures tell the order
  /// all the same: +1 when `e` comes before `f`,
  /// −1 when behind, 0 when this is not the case in hand.
  [[nodiscard]] int order_at_cusp(Event e, Event f) const {
    const std::uint32_t one = strand(twin(e));
    const std::uint32_t two = strand(twin(f));
    if (curve_.next(two) == one && curve_.next(one) != two) return -order_at_cusp(f, e);
    if (curve_.next(one) != two) return 0;
    const Strand<DoubleDouble> into = fine(one);
    const Strand<DoubleDouble> out = fine(two);
    const auto ahead = heading(out, out.from);
    if (dot(heading(into, into.to), ahead).sign() >= 0) return 0;
    // The first strand, seen from the cusp, runs backwards.
    const auto bend = curvature(out);
    const auto bend_back = curvature(into);
    if (!bend || !bend_back) return 0;
    const Strand<DoubleDouble> third = fine(strand(e));
    const auto third_bend = curvature(third);
    if (!third_bend) return 0;
    const auto through = heading(third, out.from);
    const Enclosed<DoubleDouble> across = cross(ahead, through);
    // All three run straight on as far as the third passes from the cusp.
    const double sine = across.size() / std::sqrt(length_squared(ahead) * length_squared(through));
    const Passing& m = passing(e);
    const double h =
        std::hypot(m.x - out.from.x.hi, m.y - out.from.y.hi) + 0x1p-48 * out.from.size();
    const double turned = h * (bend->size() + bend_back->size() + third_bend->size());
    if (!(sine > kStraightOn * turned + kTangent)) return 0;
    const int above = (-*bend_back - *bend).sign();  // +1: the first lies to the left of the second
    return -above * across.sign();
  }
  static double length_squared(const EnclosedVector<DoubleDouble>& v) {
    return v.x.hi * v.x.hi + v.y.hi * v.y.hi;
  }

  /// Along the strand, at a place on it.
  static EnclosedVector<DoubleDouble> heading(const Strand<DoubleDouble>& s,
                                              const EnclosedVector<DoubleDouble>& at) {
    if (s.is_line) return s.to - s.from;
    const EnclosedVector<DoubleDouble> left = turned_left(at - s.centre);
    return s.counter_clockwise ? left : -left;
  }
  /// Positive to the left; nothing when the radius may be 0.
  static std::optional<Enclosed<DoubleDouble>> curvature(const Strand<DoubleDouble>& s) {
    if (s.is_line) return Enclosed<DoubleDouble>{};
    if (s.radius.sign() <= 0) return std::nullopt;
    const Enclosed<DoubleDouble> bend = Enclosed<DoubleDouble>{1.0, 0} / s.radius;
    return s.counter_clockwise ? bend : -bend;
  }

  /// Where the events of a loop begin in the order.
  [[nodiscard]] std::uint32_t first_rank(std::size_t loop) const {
    return first_event_[curve_.begin(loop)];
  }
  /// And where they end.
  [[nodiscard]] std::uint32_t last_rank(std::size_t loop) const {
    return first_event_[curve_.end(loop)];
  }

  // --- winding numbers --------------------------------------------------------------------------

  /// Of the curve's left, going on along the strand. The second strand passes to the left of the
  /// first: going on along the first leaves its left.
  [[nodiscard]] int step(Event e) const { return e % 2 == 0 ? -passing(e).turn : passing(e).turn; }

  bool carry_numbers() {
    stretches_.resize(order_.size());
    loop_number_.resize(source_->loops());
    for (std::size_t loop = 0; loop < source_->loops(); ++loop) {
      const auto start = number_on(loop);
      if (!start) return false;
      const auto [probe, number] = *start;
      loop_number_[loop] = number;
      const std::uint32_t begin = first_rank(loop);
      const std::uint32_t count = last_rank(loop) - begin;
      if (count == 0) continue;
      const auto first = first_behind_middle(probe);
      if (!first) return false;
      int left = number;
      std::uint32_t k = *first == begin + count ? begin : *first;
      for (std::uint32_t n = 0; n < count; ++n) {
        left += step(order_[k].event);
        const std::uint32_t end = k + 1 == begin + count ? begin : k + 1;
        stretches_[k] = {left, end};
        k = end;
      }
      // Once round. Where not, the joined curve is not the exact one in something that matters.
      if (left != number) return false;
    }
    return true;
  }

  /// The rank of the first event behind the middle of the strand, which halves its chord.
  [[nodiscard]] std::optional<std::uint32_t> first_behind_middle(std::uint32_t strand) {
    const Strand<double> s = curve_.strand(strand);
    const EnclosedVector<double> chord = s.to - s.from;
    const Enclosed<double> middle = Enclosed<double>{0.5, 0} * dot(chord, chord);
    std::uint32_t k = first_event_[strand];
    for (; k < first_event_[strand + 1]; ++k) {
      const int behind = (Enclosed<double>{order_[k].at, order_[k].rad} - middle).sign();
      if (behind == 0) return std::nullopt;
      if (behind > 0) break;
    }
    return k;
  }

  struct Number {
    std::uint32_t strand;
    int left;
  };

  /// The winding number left of the middle of some strand of the loop, by a ray to the right.
  std::optional<Number> number_on(std::size_t loop) {
    const std::uint32_t begin = curve_.begin(loop);
    const std::uint32_t end = curve_.end(loop);
    constexpr std::uint32_t kTries = 12;
    for (std::uint32_t n = 0; n < kTries; ++n) {
      // Not at regular steps: contours repeat themselves.
      const std::uint32_t count = end - begin;
      const std::uint32_t probe =
          begin + static_cast<std::uint32_t>(std::uint64_t{count} * n / kTries + n) % count;
      ++counts_.decisions;
      if (!first_behind_middle(probe)) continue;
      if (const auto left = number_left_of<double>(probe)) return Number{probe, *left};
      ++counts_.fine;
      if (const auto left = number_left_of<DoubleDouble>(probe)) return Number{probe, *left};
    }
    return std::nullopt;
  }

  template <class Real>
  [[nodiscard]] Strand<Real> strand_in(std::uint32_t s) const {
    if constexpr (std::is_same_v<Real, double>)
      return curve_.strand(s);
    else
      return fine(s);
  }

  template <class Real>
  static std::optional<EnclosedVector<Real>> middle_of(const Strand<Real>& s) {
    const Enclosed<Real> half{Real(0.5), 0};
    if (s.is_line) return half * (s.from + s.to);
    const EnclosedVector<Real> chord = s.to - s.from;
    const Enclosed<Real> square = dot(chord, chord);
    if (square.sign() <= 0) return std::nullopt;
    const EnclosedVector<Real> out = (s.radius / root(square)) * turned_left(chord);
    return s.counter_clockwise ? s.centre - out : s.centre + out;
  }

  template <class Real>
  [[nodiscard]] std::optional<int> number_left_of(std::uint32_t probe) const {
    const Strand<Real> s = strand_in<Real>(probe);
    const auto middle = middle_of(s);
    if (!middle) return std::nullopt;
    Strand<Real> ray;
    ray.from = *middle;
    ray.to = {Real(right_ + 1), middle->y, middle->rad};
    // What the strand heads at its middle is its chord.
    const int heading = Enclosed<Real>{s.to.y - s.from.y, 2 * (s.from.rad + s.to.rad)}.sign();
    if (heading == 0) return std::nullopt;
    // The ray leaves to the right of a strand that heads up, to the left of one that heads down.
    int number = heading < 0 ? 0 : 1;
    bool decided = true;
    const double y = coarse(middle->y);
    const double slack = middle->rad + 0x1p-52 * std::fabs(y);
    const Bounds box{coarse(middle->x) - slack - 0x1p-52 * std::fabs(coarse(middle->x)), y - slack,
                     right_ + 1, y + slack};
    tree_.overlapping(box, [&](std::size_t i) {
      if (!decided) return;
      const auto other = static_cast<std::uint32_t>(i);
      const Crossings<Real> c =
          other == probe ? own_return(s, ray) : cross(ray, strand_in<Real>(other));
      decided = c.decided;
      for (int k = 0; k < c.count; ++k) number += c.found[static_cast<std::size_t>(k)].turn;
    });
    if (!decided) return std::nullopt;
    return number;
  }

  /// A ray that starts on an arc may meet it once more, mirrored in the vertical through its
  /// centre.
  template <class Real>
  static Crossings<Real> own_return(const Strand<Real>& arc, const Strand<Real>& ray) {
    if (arc.is_line) return {};
    const EnclosedVector<Real> out = arc.centre - ray.from;
    const Enclosed<Real> back{out.x, out.rad};
    if (back.sign() < 0) return {};
    EnclosedVector<Real> at = arc.centre;
    at.x = at.x + back.mid;
    at.y = ray.from.y;
    at.rad = (arc.centre.rad + out.rad + ray.from.rad + 0x1p-52 * at.size()) * kUp;
    const int on = crossing::on_arc(arc, at);
    if (on < 0) return {};
    if (on == 0 || back.sign() == 0) return crossing::undecided<Real>();
    Crossings<Real> result;
    result.add({at, {}, arc.counter_clockwise ? 1 : -1});
    return result;
  }

  // --- the result -------------------------------------------------------------------------------

  /// Nothing when a loop does not close: the reference makes good what never should happen.
  std::optional<OffsetRegion> trace() {
    const int wanted = curve_.region_number();
    OffsetRegion region;
    region.source_ = source_;
    region.pieces_.reserve(curve_.size());
    std::vector<bool> used(order_.size(), false);
    for (std::uint32_t first = 0; first < order_.size(); ++first) {
      if (used[first] || stretches_[first].left != wanted) continue;
      std::uint32_t begin = first;
      do {
        if (used[begin] || stretches_[begin].left != wanted) {
          ++counts_.torn;
          return std::nullopt;
        }
        used[begin] = true;
        const std::uint32_t end = stretches_[begin].end;
        add_stretch(region, begin, end);
        begin = rank_[twin(order_[end].event)];
      } while (begin != first);
      region.first_.push_back(region.pieces_.size());
    }
    for (std::size_t loop = 0; loop < source_->loops(); ++loop) {
      if (first_rank(loop) != last_rank(loop) || loop_number_[loop] != wanted) continue;
      for (std::uint32_t s = curve_.begin(loop); s < curve_.end(loop); ++s) add_piece(region, s);
      region.first_.push_back(region.pieces_.size());
    }
    return region;
  }

  /// Between the events of two ranks.
  void add_stretch(OffsetRegion& region, std::uint32_t begin, std::uint32_t end) const {
    const std::uint32_t last = strand(order_[end].event);
    std::uint32_t s = strand(order_[begin].event);
    RegionPiece& first = add_piece(region, s);
    const Passing& m = passing(order_[begin].event);
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
  std::vector<Passing> passings_;
  std::vector<Placed> order_;               ///< events along the curve
  std::vector<std::uint32_t> rank_;         ///< of an event in the order
  std::vector<std::uint32_t> first_event_;  ///< of each strand in the order, and one behind
  std::vector<Between> stretches_;          ///< behind the event of each rank
  std::vector<int> loop_number_;            ///< where each loop was probed
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
