// SPDX-License-Identifier: GPL-3.0-or-later
// The production engine. Its outline is `run` below:
//
//   raw curve in doubles → box tree in contour order → crossings of overlapping pieces, sorted along
//   each piece → winding number of each stretch between crossings → stretches with the wanted
//   number on the left, joined at crossings into loops.
//
// Consecutive pieces of a raw curve are tangent where they join and meet nowhere else, so they are
// never tested against each other. The number on the left of the curve changes at a crossing alone:
// a strand that comes from the right has its own left, with a number higher by one, behind it.
//
// Decisions are made for a distance 2⁻⁷⁰ mm beyond the one asked for. That parts all that is in
// contact by design (a slot exactly as wide as the tool), and double-doubles, good to some 2⁻⁹⁰ mm,
// can tell. What they cannot tell coincides at every distance, and the reference engine takes it.
//
// Joints whose edges' normals agree within kTangent are tangent: one point, no corner. The raw curve
// then differs from the exact one by d·kTangent²/2 across and d·kTangent along, a sliver in which
// nothing that is meant takes place.
#include <algorithm>
#include <limits>
#include <optional>

#include "kernel/box_tree.h"
#include "kernel/check.h"
#include "kernel/offset_source.h"
#include "kernel/offset_voids.h"

namespace dgt {
namespace {

/// A strand in doubles, as it is kept.
struct Kept {
  double from_x, from_y, to_x, to_y, centre_x, centre_y, radius;
  float ends_rad, centre_rad, radius_rad;
  float rise;  ///< no less than how far an arc rises above its chord
  RawKey key;
  bool is_line, counter_clockwise;
};

/// A float is nearest within 2⁻²⁴; below the normal ones, by less than the smallest of them.
float rounded_up(double value) {
  return static_cast<float>(value * (1 + 0x1p-22)) + std::numeric_limits<float>::min();
}

/// With c the chord, an arc of at most half a turn rises by c²/4 / (r + √(r² − c²/4)) ≤ c²/4r, and
/// by no more than r.
double rise_of(const Strand<double>& s) {
  if (s.is_line) return 0;
  const double wx = s.to.x - s.from.x;
  const double wy = s.to.y - s.from.y;
  const double most = s.radius.mid + s.radius.rad;
  const double least = s.radius.mid - s.radius.rad;
  const double reach = std::fabs(wx) + std::fabs(wy) + 2 * (s.from.rad + s.to.rad);
  if (4 * least * most <= reach * reach) return most;
  return reach * reach / (4 * least);
}

Kept keep(const Strand<double>& s, RawKey key) {
  return {s.from.x,
          s.from.y,
          s.to.x,
          s.to.y,
          s.centre.x,
          s.centre.y,
          s.radius.mid,
          rounded_up(std::max(s.from.rad, s.to.rad)),
          rounded_up(s.centre.rad),
          rounded_up(s.radius.rad),
          rounded_up(rise_of(s)),
          key,
          s.is_line,
          s.counter_clockwise};
}

Strand<double> strand_of(const Kept& k) {
  return {{k.from_x, k.from_y, k.ends_rad},
          {k.to_x, k.to_y, k.ends_rad},
          {k.centre_x, k.centre_y, k.centre_rad},
          {k.radius, k.radius_rad},
          k.is_line,
          k.counter_clockwise};
}

/// Whether two strands surely do not meet, since one lies to one side of the other's chord and
/// beyond its rise. Cross products of vectors no longer than S, whose coordinates are off by e, are
/// off by less than 4 S e and the roundings of two products and three sums of size S², 2⁻⁵⁰ S².
bool surely_apart(const Kept& a, const Kept& b) {
  const double ux = a.to_x - a.from_x;
  const double uy = a.to_y - a.from_y;
  const double vx = b.to_x - b.from_x;
  const double vy = b.to_y - b.from_y;
  const double wx = b.from_x - a.from_x;
  const double wy = b.from_y - a.from_y;
  const double u = std::fabs(ux) + std::fabs(uy);
  const double v = std::fabs(vx) + std::fabs(vy);
  const double size = u + v + std::fabs(wx) + std::fabs(wy);
  const double off = static_cast<double>(a.ends_rad) + b.ends_rad;
  const double error = size * (4.5 * off + 0x1p-49 * size);
  const double turn = ux * vy - uy * vx;
  const double rises = static_cast<double>(a.rise) + b.rise;

  const double b_from = ux * wy - uy * wx;
  const double b_to = b_from + turn;
  const double beside_a = u * rises + error;
  if (std::min(b_from, b_to) > beside_a || std::max(b_from, b_to) < -beside_a) return true;
  const double a_from = vy * wx - vx * wy;
  const double a_to = a_from - turn;
  const double beside_b = v * rises + error;
  return std::min(a_from, a_to) > beside_b || std::max(a_from, a_to) < -beside_b;
}

/// The hot spot of the engine, worth a body of its own.
[[gnu::flatten]] Crossings<double> cross_in_doubles(const Kept& a, const Kept& b) {
  return cross(strand_of(a), strand_of(b));
}

/// Two strands that cross. Each crossing is two events, one on each strand: number 2i + side.
struct Passing {
  double x, y;
  std::array<double, 2> along;
  std::array<float, 2> along_rad;
  std::array<std::uint32_t, 2> strand;
  std::int8_t turn;  ///< of the second against the first
  bool last;         ///< of the two crossings of these strands
};
using Event = std::uint32_t;

}  // namespace

class OffsetEngine {
 public:
  OffsetEngine(std::shared_ptr<const OffsetSource> source, OffsetCounts& counts)
      : source_(std::move(source)), counts_(counts) {}

  /// Nothing when double-doubles leave something open.
  std::optional<OffsetRegion> run() {
    lay_strands();
    if (!find_crossings() || !sort_events() || !carry_numbers()) return std::nullopt;
    OffsetRegion region = trace();
    region.drop(bounding_nothing(region, *source_));
    return region;
  }

 private:
  // --- the raw curve ----------------------------------------------------------------------------

  void lay_strands() {
    const OffsetSource& source = *source_;
    strands_.reserve(2 * source.edges());
    const Enclosed<double>& d = source.decisive_distance<double>();
    for (std::size_t loop = 0; loop < source.loops(); ++loop) {
      first_strand_.push_back(size());
      const std::uint32_t first = source.first(loop);
      const std::uint32_t end = source.first(loop + 1);
      std::array<EnclosedEdge<double>, 2> edges = {source.edge<double>(end - 1),
                                                   source.edge<double>(first)};
      const EnclosedEdge<double> first_edge = edges[1];
      Joint joint = source.joint(end - 1, edges[0], edges[1]);
      EnclosedVector<double> normal = joint == Joint::Tangent ? edges[0].end : edges[1].start;
      for (std::uint32_t i = first; i < end; ++i) {
        const EnclosedEdge<double>& e = edges[(i - first + 1) % 2];
        EnclosedEdge<double>& next = edges[(i - first) % 2];
        strands_.push_back(keep(moved(e, normal, d), RawKey(i, false)));
        next = i + 1 == end ? first_edge : source.edge<double>(i + 1);
        joint = source.joint(i, e, next);
        if (joint != Joint::Tangent)
          strands_.push_back(keep(corner(e, next, joint, d), RawKey(i, true)));
        normal = joint == Joint::Tangent ? e.end : next.start;
      }
    }
    first_strand_.push_back(size());
    counts_.strands = strands_.size();
  }

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(strands_.size()); }

  [[nodiscard]] std::uint32_t next_strand(std::uint32_t s) const {
    // Strands of one loop only follow each other.
    const std::uint32_t next = s + 1;
    const auto end = std::upper_bound(first_strand_.begin(), first_strand_.end(), s);
    return next == *end ? *(end - 1) : next;
  }

  [[nodiscard]] Strand<DoubleDouble> fine(std::uint32_t strand) const {
    return source_->strand(strands_[strand].key, source_->decisive_distance<DoubleDouble>());
  }

  // --- boxes ------------------------------------------------------------------------------------

  static Box box_of(const Kept& k) {
    const double out = (static_cast<double>(k.ends_rad) + k.centre_rad + k.radius_rad) * kUp;
    const auto grown = [](double size, double by) { return by + 0x1p-52 * std::fabs(size); };
    Box box{std::min(k.from_x, k.to_x), std::min(k.from_y, k.to_y), std::max(k.from_x, k.to_x),
            std::max(k.from_y, k.to_y)};
    if (!k.is_line) {
      // The arc reaches an extreme of its circle unless that lies surely to the chord's other side.
      const double sense = k.counter_clockwise ? 1 : -1;
      const double wx = sense * (k.to_x - k.from_x);
      const double wy = sense * (k.to_y - k.from_y);
      const double margin =
          2 * (std::fabs(wx) + std::fabs(wy) + out) * (out + 0x1p-50 * (k.radius + out)) +
          2 * out * k.radius;
      const double mx = k.centre_x - k.from_x;
      const double my = k.centre_y - k.from_y;
      // cross(w, c + r e − from) for the four directions e
      const double base = wx * my - wy * mx;
      if (base - wy * k.radius <= margin) box.max_x = std::max(box.max_x, k.centre_x + k.radius);
      if (base + wy * k.radius <= margin) box.min_x = std::min(box.min_x, k.centre_x - k.radius);
      if (base + wx * k.radius <= margin) box.max_y = std::max(box.max_y, k.centre_y + k.radius);
      if (base - wx * k.radius <= margin) box.min_y = std::min(box.min_y, k.centre_y - k.radius);
    }
    return {box.min_x - grown(box.min_x, out), box.min_y - grown(box.min_y, out),
            box.max_x + grown(box.max_x, out), box.max_y + grown(box.max_y, out)};
  }

  // --- crossings --------------------------------------------------------------------------------

  bool find_crossings() {
    tree_.emplace(strands_.size(), [&](std::size_t i) {
      const Box box = box_of(strands_[i]);
      right_ = std::max(right_, box.max_x);
      return box;
    });
    passings_.reserve(strands_.size());
    bool decided = true;
    tree_->pairs([&](std::size_t i, std::size_t j) {
      const auto a = static_cast<std::uint32_t>(i);
      const auto b = static_cast<std::uint32_t>(j);
      if (b == a + 1 ? next_strand(a) == b : closes(a, b)) return;
      ++counts_.pairs;
      if (decided) decided = cross_strands(a, b);
    });
    counts_.crossings = passings_.size();
    return decided;
  }

  /// Whether b, somewhere behind a, is the last strand of a loop that begins with a.
  [[nodiscard]] bool closes(std::uint32_t a, std::uint32_t b) const {
    const auto begin = std::lower_bound(first_strand_.begin(), first_strand_.end(), a);
    return begin != first_strand_.end() && *begin == a && begin[1] == b + 1;
  }

  bool cross_strands(std::uint32_t a, std::uint32_t b) {
    ++counts_.decisions;
    if (surely_apart(strands_[a], strands_[b])) return true;
    const Crossings<double> crossings = cross_in_doubles(strands_[a], strands_[b]);
    if (crossings.decided) {
      add_passings(a, b, crossings);
      return true;
    }
    ++counts_.fine;
    const Crossings<DoubleDouble> finer = cross(fine(a), fine(b));
    if (finer.decided) add_passings(a, b, finer);
    return finer.decided;
  }

  template <class Real>
  void add_passings(std::uint32_t a, std::uint32_t b, const Crossings<Real>& crossings) {
    const auto radius = [](const Enclosed<Real>& e) {
      return rounded_up(e.rad + 0x1p-52 * e.size());
    };
    for (int i = 0; i < crossings.count; ++i) {
      const Crossing<Real>& c = crossings.found[static_cast<std::size_t>(i)];
      passings_.push_back({coarse(c.at.x),
                           coarse(c.at.y),
                           {coarse(c.position[0].mid), coarse(c.position[1].mid)},
                           {radius(c.position[0]), radius(c.position[1])},
                           {a, b},
                           static_cast<std::int8_t>(c.turn),
                           i == 1});
    }
  }

  // --- order along the curve --------------------------------------------------------------------

  [[nodiscard]] const Passing& passing(Event e) const { return passings_[e / 2]; }
  [[nodiscard]] std::uint32_t strand(Event e) const { return passing(e).strand[e % 2]; }
  [[nodiscard]] double position(Event e) const { return passing(e).along[e % 2]; }
  [[nodiscard]] double radius(Event e) const { return passing(e).along_rad[e % 2]; }
  static Event twin(Event e) { return e ^ 1U; }

  /// Events strand by strand, in the order met along each.
  bool sort_events() {
    const std::size_t events = 2 * passings_.size();
    first_event_.assign(strands_.size() + 1, 0);
    for (const Passing& m : passings_)
      for (const std::uint32_t s : m.strand) ++first_event_[s + 1];
    for (std::size_t s = 0; s < strands_.size(); ++s) first_event_[s + 1] += first_event_[s];
    order_.resize(events);
    rank_.resize(events);
    for (Event e = 0; e < events; ++e) order_[first_event_[strand(e)]++] = e;
    for (std::size_t s = strands_.size(); s > 0; --s) first_event_[s] = first_event_[s - 1];
    first_event_[0] = 0;
    for (std::size_t s = 0; s < strands_.size(); ++s) {
      const std::span<Event> here{order_.data() + first_event_[s],
                                  first_event_[s + 1] - first_event_[s]};
      if (here.size() > 1 && !sort_along(here)) return false;
    }
    for (std::uint32_t k = 0; k < events; ++k) rank_[order_[k]] = k;
    return true;
  }

  bool sort_along(std::span<Event> events) {
    if (events.size() > 2)
      std::ranges::sort(events, {}, [&](Event e) { return position(e); });
    else if (position(events[0]) > position(events[1]))
      std::swap(events[0], events[1]);
    counts_.decisions += events.size() - 1;
    std::size_t open = 0;
    for (std::size_t k = 1; k < events.size(); ++k) {
      const double gap = position(events[k]) - position(events[k - 1]);
      if (!(gap > (radius(events[k]) + radius(events[k - 1])) * kUp)) ++open;
    }
    counts_.fine += open;
    return open == 0 || sort_finely(events);
  }

  bool sort_finely(std::span<Event> events) {
    struct Placed {
      Event event;
      Enclosed<DoubleDouble> at;
    };
    std::vector<Placed> placed;
    for (const Event e : events) {
      const Passing& m = passing(e);
      const Crossings<DoubleDouble> c = cross(fine(m.strand[0]), fine(m.strand[1]));
      // Of two roots, doubles may have found one alone inside both; then so do double-doubles.
      const std::size_t root = m.last ? 1 : 0;
      if (!c.decided || c.count <= static_cast<int>(root)) return false;
      placed.push_back({e, c.found[root].position[e % 2]});
    }
    std::ranges::sort(placed, [](const Placed& a, const Placed& b) {
      return (a.at - b.at).mid.hi < 0;
    });
    for (std::size_t k = 0; k < placed.size(); ++k) {
      events[k] = placed[k].event;
      if (k > 0 && (placed[k].at - placed[k - 1].at).sign() <= 0) return false;
    }
    return true;
  }

  /// Where the events of a loop begin in the order.
  [[nodiscard]] std::uint32_t first_rank(std::size_t loop) const {
    return first_event_[first_strand_[loop]];
  }
  [[nodiscard]] std::size_t loop_of(std::uint32_t strand) const {
    const auto behind = std::upper_bound(first_strand_.begin(), first_strand_.end(), strand);
    return static_cast<std::size_t>(behind - first_strand_.begin()) - 1;
  }
  /// The next event along the same loop.
  [[nodiscard]] Event next_event(Event e) const {
    const std::uint32_t k = rank_[e] + 1;
    const std::size_t loop = loop_of(strand(e));
    return order_[k == first_rank(loop + 1) ? first_rank(loop) : k];
  }

  // --- winding numbers --------------------------------------------------------------------------

  /// Of the curve's left, going on along the strand. The second strand passes to the left of the
  /// first: going on along the first leaves its left.
  [[nodiscard]] int step(Event e) const {
    return e % 2 == 0 ? -passing(e).turn : passing(e).turn;
  }

  bool carry_numbers() {
    left_after_.resize(order_.size());
    loop_number_.resize(source_->loops());
    for (std::size_t loop = 0; loop < source_->loops(); ++loop) {
      const auto start = number_on(loop);
      if (!start) return false;
      const auto [probe, number] = *start;
      loop_number_[loop] = number;
      const std::uint32_t begin = first_rank(loop);
      const std::uint32_t count = first_rank(loop + 1) - begin;
      if (count == 0) continue;
      const auto first = first_behind_middle(probe);
      if (!first) return false;
      int left = number;
      for (std::uint32_t n = 0; n < count; ++n) {
        const Event e = order_[begin + (*first - begin + n) % count];
        left += step(e);
        left_after_[e] = left;
      }
      // Once round: no crossing was missed.
      DGT_CHECK(left == number);
    }
    return true;
  }

  /// The rank of the first event behind the middle of the strand, which halves its chord.
  [[nodiscard]] std::optional<std::uint32_t> first_behind_middle(std::uint32_t strand) {
    const Strand<double> s = strand_of(strands_[strand]);
    const EnclosedVector<double> chord = s.to - s.from;
    const Enclosed<double> middle = Enclosed<double>{0.5, 0} * dot(chord, chord);
    std::uint32_t k = first_event_[strand];
    for (; k < first_event_[strand + 1]; ++k) {
      const Event e = order_[k];
      const int behind = (Enclosed<double>{position(e), radius(e)} - middle).sign();
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
    const std::uint32_t begin = first_strand_[loop];
    const std::uint32_t end = first_strand_[loop + 1];
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
      return strand_of(strands_[s]);
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
    const Box box{coarse(middle->x) - slack - 0x1p-52 * std::fabs(coarse(middle->x)), y - slack,
                  right_ + 1, y + slack};
    tree_->overlapping(box, [&](std::size_t i) {
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

  /// A ray that starts on an arc may meet it once more, mirrored in the vertical through its centre.
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

  /// The number of the region left of the loops (offset_raw.h), told by the loop of the widest box.
  [[nodiscard]] int region_number() const {
    std::size_t widest = 0;
    double width = -1;
    for (std::size_t loop = 0; loop < source_->loops(); ++loop) {
      double low = std::numeric_limits<double>::infinity();
      double high = -low;
      for (std::uint32_t i = source_->first(loop); i < source_->first(loop + 1); ++i) {
        const double x = source_->beginning(i).x;
        low = std::min(low, x);
        high = std::max(high, x);
      }
      if (high - low > width) {
        width = high - low;
        widest = loop;
      }
    }
    return source_->area(widest) < 0 ? 0 : 1;
  }

  // --- the result -------------------------------------------------------------------------------

  OffsetRegion trace() {
    const int wanted = region_number();
    OffsetRegion region;
    region.source_ = source_;
    std::vector<bool> used(order_.size(), false);
    for (const Event first : order_) {
      if (used[first] || left_after_[first] != wanted) continue;
      Event e = first;
      do {
        DGT_CHECK(!used[e] && left_after_[e] == wanted);
        used[e] = true;
        const Event end = next_event(e);
        add_stretch(region, e, end);
        e = twin(end);
      } while (e != first);
      region.first_.push_back(region.pieces_.size());
    }
    for (std::size_t loop = 0; loop < source_->loops(); ++loop) {
      if (first_rank(loop) != first_rank(loop + 1) || loop_number_[loop] != wanted) continue;
      for (std::uint32_t s = first_strand_[loop]; s < first_strand_[loop + 1]; ++s)
        add_piece(region, s);
      region.first_.push_back(region.pieces_.size());
    }
    return region;
  }

  void add_stretch(OffsetRegion& region, Event begin, Event end) const {
    const std::uint32_t last = strand(end);
    std::uint32_t s = strand(begin);
    RegionPiece& first = add_piece(region, s);
    const Passing& m = passing(begin);
    first.x = m.x;
    first.y = m.y;
    first.cut = strands_[m.strand[0]].key;
    first.by = strands_[m.strand[1]].key;
    bool once_round = s == last && rank_[end] <= rank_[begin];
    while (s != last || once_round) {
      once_round = false;
      s = next_strand(s);
      add_piece(region, s);
    }
  }

  RegionPiece& add_piece(OffsetRegion& region, std::uint32_t s) const {
    const Kept& k = strands_[s];
    RegionPiece piece{k.from_x, k.from_y, k.centre_x, k.centre_y, 0, k.key, k.key, k.key};
    if (!k.is_line) piece.radius = k.counter_clockwise ? k.radius : -k.radius;
    region.pieces_.push_back(piece);
    return region.pieces_.back();
  }

  std::shared_ptr<const OffsetSource> source_;
  OffsetCounts& counts_;
  std::vector<Kept> strands_;
  std::vector<std::uint32_t> first_strand_;  ///< of each loop, and one behind
  std::optional<BoxTree> tree_;
  double right_ = -std::numeric_limits<double>::infinity();
  std::vector<Passing> passings_;
  std::vector<Event> order_;                ///< events along the curve
  std::vector<std::uint32_t> rank_;         ///< of an event in the order
  std::vector<std::uint32_t> first_event_;  ///< of each strand in the order, and one behind
  std::vector<int> left_after_;             ///< number left of the stretch behind an event
  std::vector<int> loop_number_;            ///< where each loop was probed
};

// --- from input to result -------------------------------------------------------------------------

namespace {

OffsetRegion by_reference(const std::shared_ptr<const OffsetSource>& source,
                          OffsetCounts& counts) {
  counts.exact = counts.decisions;
  return OffsetRegion::of(reference_offset(source->exact_loops(), source->distance()));
}

template <class Loops>
OffsetRegion region_of(const Loops& loops, const Rational& distance, OffsetCounts& counts) {
  counts = {};
  if (loops.empty()) return {};
  const bool grows = sgn(distance) < 0;  // growing the region is shrinking what lies beyond it
  const auto source = std::make_shared<const OffsetSource>(loops, abs(distance), grows);
  std::optional<OffsetRegion> found;
  if (sgn(distance) != 0 && source->suits_doubles()) found = OffsetEngine(source, counts).run();
  OffsetRegion region = found ? *std::move(found) : by_reference(source, counts);
  if (grows) region.reverse();
  return region;
}

}  // namespace

OffsetRegion production_offset(const std::vector<BulgePolyline>& loops, const Rational& distance,
                               OffsetCounts* counts) {
  OffsetCounts ignored;
  return region_of(loops, distance, counts ? *counts : ignored);
}

std::vector<OffsetLoop> production_offset(const std::vector<Chain>& loops, const Rational& distance,
                                          OffsetCounts* counts) {
  OffsetCounts ignored;
  return region_of(loops, distance, counts ? *counts : ignored).exact();
}

}  // namespace dgt
