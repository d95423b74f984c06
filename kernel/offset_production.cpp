// SPDX-License-Identifier: GPL-3.0-or-later
// The production engine. Its outline is `run` below:
//
//   raw curve in balls → box tree in contour order → crossings of overlapping pieces, sorted along
//   each piece → winding number of each stretch between crossings → stretches with the wanted
//   number on the left, joined at crossings into loops.
//
// Consecutive pieces of a raw curve are tangent where they join and meet nowhere else, so they are
// never tested against each other. The number on the left of the curve changes at a crossing alone:
// a strand that comes from the right has its own left, with a number higher by one, behind it.
//
// A decision that a ball leaves open throws Open, and the reference engine takes the input: for
// parts whose edges do not coincide by design that is rare, and the answer is right either way.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "kernel/box_tree.h"
#include "kernel/cgal/raw_crossing.h"
#include "kernel/check.h"
#include "kernel/offset.h"
#include "kernel/offset_raw.h"

namespace dgt {
namespace {

struct Open {};  ///< a decision that balls cannot make

struct BallVector {
  Ball x, y;
};
BallVector operator+(const BallVector& a, const BallVector& b) { return {a.x + b.x, a.y + b.y}; }
BallVector operator-(const BallVector& a, const BallVector& b) { return {a.x - b.x, a.y - b.y}; }
BallVector operator*(const Ball& k, const BallVector& a) { return {k * a.x, k * a.y}; }
Ball dot(const BallVector& a, const BallVector& b) { return a.x * b.x + a.y * b.y; }
Ball cross(const BallVector& a, const BallVector& b) { return a.x * b.y - a.y * b.x; }
BallVector balls(const Vector& v) { return {Ball(v.x), Ball(v.y)}; }

int certain_sign(const Ball& b) {
  const auto sign = b.sign();
  if (!sign || *sign == 0) throw Open{};
  return *sign;
}

/// One piece of a raw curve. Arcs cover at most half a turn.
struct Strand {
  BallVector from, to;
  bool is_line = true;
  BallVector centre;
  Ball radius;  ///< not negative
  bool ccw = true;
  std::size_t loop = 0;
  std::size_t edge = 0;
  bool corner = false;  ///< behind the edge
};

/// What exact points are worked out from, long after the engine has gone.
struct Source {
  std::vector<Chain> loops;
  Rational distance;

  [[nodiscard]] RawPiece piece(std::size_t loop, std::size_t edge, bool corner) const {
    const auto& edges = loops[loop].edges;
    const ChainEdge& next = edges[(edge + 1) % edges.size()];
    return corner ? raw_corner(edges[edge], next, distance).value()
                  : raw_edge(edges[edge], distance).value();
  }
};

/// A crossing as one of its two strands sees it.
struct Event {
  std::size_t strand = 0;
  Ball along;            ///< rises along the strand
  int step = 0;          ///< of the winding number, going on along the strand
  std::size_t twin = 0;  ///< the same crossing on the other strand
  BallVector at;
};

class Engine {
 public:
  Engine(const std::vector<Chain>& loops, const Rational& distance, OffsetCounts& counts)
      : source_(std::make_shared<const Source>(Source{loops, distance})),
        loops_(source_->loops),
        distance_(source_->distance),
        counts_(counts) {}

  std::vector<OffsetLoop> run() {
    const int wanted = number_of_region(loops_);
    lay_strands();
    find_crossings();
    sort_events();
    carry_numbers();
    return trace(wanted);
  }

 private:
  // --- the raw curve ----------------------------------------------------------------------------

  void lay_strands() {
    const Ball d(distance_);
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      const auto& edges = loops_[i].edges;
      first_strand_.push_back(strands_.size());
      for (std::size_t k = 0; k < edges.size(); ++k) {
        const ChainEdge& next = edges[(k + 1) % edges.size()];
        add_edge(edges[k], d, i, k);
        add_corner(edges[k], next, d, i, k);
      }
      if (strands_.size() == first_strand_.back()) throw Open{};
    }
    first_strand_.push_back(strands_.size());
  }

  void add_edge(const ChainEdge& edge, const Ball& d, std::size_t loop, std::size_t k) {
    Strand s;
    s.loop = loop;
    s.edge = k;
    s.is_line = edge.is_line();
    s.from = balls(edge.from) + d * balls(edge.start.vector());
    s.to = balls(edge.to) + d * balls(edge.end.vector());
    if (!s.is_line) {
      if (edge.radius == distance_) return;  // shrunk to its centre
      s.centre = balls(edge.from) + Ball(edge.radius) * balls(edge.start.vector());
      s.radius = Ball(edge.radius) - d;
      if (certain_sign(s.radius) < 0) s.radius = -s.radius;
      s.ccw = sgn(edge.radius) > 0;
      if (certain_sign(cross(s.from - s.centre, s.to - s.centre)) != (s.ccw ? 1 : -1)) throw Open{};
    }
    strands_.push_back(s);
  }

  void add_corner(const ChainEdge& edge, const ChainEdge& next, const Ball& d, std::size_t loop,
                  std::size_t k) {
    if (edge.end == next.start) return;
    Strand s;
    s.loop = loop;
    s.edge = k;
    s.corner = true;
    s.is_line = false;
    s.centre = balls(edge.to);
    s.radius = d;
    const BallVector u = balls(edge.end.vector());
    const BallVector v = balls(next.start.vector());
    s.from = s.centre + d * u;
    s.to = s.centre + d * v;
    s.ccw = certain_sign(cross(u, v)) > 0;
    strands_.push_back(s);
  }

  [[nodiscard]] std::size_t next_strand(std::size_t s) const {
    const std::size_t loop = strands_[s].loop;
    return s + 1 == first_strand_[loop + 1] ? first_strand_[loop] : s + 1;
  }

  // --- boxes
  // --------------------------------------------------------------------------------------

  static Box box_of(const Strand& s) {
    // Outward by a double's rounding beyond the balls' own radii.
    const auto low = [](const Ball& b) {
      return std::nextafter(static_cast<double>(b.mid - b.rad),
                            -std::numeric_limits<double>::max());
    };
    const auto high = [](const Ball& b) {
      return std::nextafter(static_cast<double>(b.mid + b.rad), std::numeric_limits<double>::max());
    };
    Box box{std::min(low(s.from.x), low(s.to.x)), std::min(low(s.from.y), low(s.to.y)),
            std::max(high(s.from.x), high(s.to.x)), std::max(high(s.from.y), high(s.to.y))};
    if (s.is_line) return box;
    const auto may_reach = [&](long double dx, long double dy) {
      const BallVector v{Ball(dx, 0), Ball(dy, 0)};
      const auto off = [](const Ball& b) { return b.mid + b.rad < 0; };  // certainly outside
      const Ball after = cross(s.from - s.centre, v);
      const Ball before = cross(v, s.to - s.centre);
      return s.ccw ? !off(after) && !off(before) : !off(-after) && !off(-before);
    };
    if (may_reach(1, 0)) box.max_x = std::max(box.max_x, high(s.centre.x + s.radius));
    if (may_reach(-1, 0)) box.min_x = std::min(box.min_x, low(s.centre.x - s.radius));
    if (may_reach(0, 1)) box.max_y = std::max(box.max_y, high(s.centre.y + s.radius));
    if (may_reach(0, -1)) box.min_y = std::min(box.min_y, low(s.centre.y - s.radius));
    return box;
  }

  // --- crossings
  // ------------------------------------------------------------------------------------

  void find_crossings() {
    std::vector<Box> boxes;
    boxes.reserve(strands_.size());
    for (const Strand& s : strands_) boxes.push_back(box_of(s));
    for (const Box& box : boxes) right_ = std::max(right_, box.max_x);
    tree_.emplace(boxes);
    for (std::size_t a = 0; a < strands_.size(); ++a) {
      tree_->overlapping(boxes[a], [&](std::size_t b) {
        if (b <= a || next_strand(a) == b || next_strand(b) == a) return;
        ++counts_.pairs;
        cross_strands(strands_[a], strands_[b],
                      [&](const BallVector& at) { add_events(a, b, at); });
      });
    }
  }

  /// Calls visit for each place where the two cross inside both. Throws where that is open.
  template <class Visit>
  static void cross_strands(const Strand& a, const Strand& b, Visit&& visit) {
    if (a.is_line && b.is_line)
      cross_lines(a, b, visit);
    else if (a.is_line)
      cross_line_arc(a, b, visit);
    else if (b.is_line)
      cross_line_arc(b, a, visit);
    else
      cross_arcs(a, b, visit);
  }

  /// +1 inside, −1 outside, of what has non-negative signs inside; open when none is surely
  /// negative and one is undecided.
  static int verdict(std::initializer_list<Ball> signs) {
    bool open = false;
    for (const Ball& b : signs) {
      const auto sign = b.sign();
      if (sign && *sign < 0) return -1;
      if (!sign || *sign == 0) open = true;
    }
    if (open) throw Open{};
    return 1;
  }
  static bool surely_outside(std::initializer_list<Ball> signs) {
    return std::any_of(signs.begin(), signs.end(), [](const Ball& b) { return b.mid + b.rad < 0; });
  }

  template <class Visit>
  static void cross_lines(const Strand& a, const Strand& b, Visit&& visit) {
    const BallVector u = a.to - a.from;
    const BallVector v = b.to - b.from;
    const Ball b0 = cross(u, b.from - a.from);
    const Ball b1 = cross(u, b.to - a.from);
    if (same_side(b0, b1)) return;
    const Ball a0 = cross(v, a.from - b.from);
    const Ball a1 = cross(v, a.to - b.from);
    if (same_side(a0, a1)) return;
    certain_sign(b0);
    certain_sign(b1);
    certain_sign(a0);
    certain_sign(a1);
    const auto t = divide(a0, a0 - a1);
    if (!t) throw Open{};
    visit(a.from + *t * u);
  }
  static bool same_side(const Ball& a, const Ball& b) {
    const auto sa = a.sign();
    const auto sb = b.sign();
    return sa && sb && *sa == *sb && *sa != 0;
  }

  /// Non-negative signs mean: the direction v from the centre lies in the arc's sector.
  static std::array<Ball, 2> sector(const Strand& arc, const BallVector& v) {
    const Ball after = cross(arc.from - arc.centre, v);
    const Ball before = cross(v, arc.to - arc.centre);
    return arc.ccw ? std::array{after, before} : std::array{-after, -before};
  }

  template <class Visit>
  static void cross_line_arc(const Strand& line, const Strand& arc, Visit&& visit) {
    const BallVector u = line.to - line.from;
    const Ball square = dot(u, u);
    const BallVector c = arc.centre - line.from;
    const Ball h = cross(u, c);  // distance of the centre times |u|
    const Ball reach = arc.radius * arc.radius * square - h * h;
    const auto sign = reach.sign();
    if (sign && *sign < 0) return;
    const auto foot = divide(dot(u, c), square);
    if (!foot) throw Open{};
    if (!sign || *sign == 0) {
      // In contact or nearly: it matters only where both are.
      const BallVector near = line.from + *foot * u - arc.centre;
      const auto [after, before] = sector(arc, near);
      if (surely_outside({*foot, Ball(1, 0) - *foot, after, before})) return;
      throw Open{};
    }
    const auto root = sqrt(reach);
    const auto half = root ? divide(*root, square) : std::nullopt;
    if (!half) throw Open{};
    for (const Ball& t : {*foot - *half, *foot + *half}) {
      const BallVector at = line.from + t * u;
      const auto [after, before] = sector(arc, at - arc.centre);
      if (verdict({t, Ball(1, 0) - t, after, before}) > 0) visit(at);
    }
  }

  template <class Visit>
  static void cross_arcs(const Strand& a, const Strand& b, Visit&& visit) {
    const BallVector v = b.centre - a.centre;
    const Ball square = dot(v, v);
    const Ball sum = a.radius + b.radius;
    const Ball difference = a.radius - b.radius;
    const Ball outside = sum * sum - square;
    const Ball inside = square - difference * difference;
    if (surely_outside({outside, inside})) return;
    const Ball half(0.5L, 0);
    const auto k = divide(half * (square + difference * sum), square);
    if (!k) throw Open{};
    const auto sign_out = outside.sign();
    const auto sign_in = inside.sign();
    if (!sign_out || *sign_out == 0 || !sign_in || *sign_in == 0) {
      const BallVector near = *k * v;
      const auto sa = sector(a, near);
      const auto sb = sector(b, near - v);
      if (surely_outside({sa[0], sa[1], sb[0], sb[1]})) return;
      throw Open{};
    }
    // (r1/|v|)² − k² = (sum² − v²)(v² − difference²) / 4v⁴
    const auto root = sqrt(outside * inside);
    const auto s = root ? divide(half * *root, square) : std::nullopt;
    if (!s) throw Open{};
    const BallVector left{-v.y, v.x};
    for (const Ball& off : {-*s, *s}) {
      const BallVector from_a = *k * v + off * left;
      const auto sa = sector(a, from_a);
      const auto sb = sector(b, from_a - v);
      if (verdict({sa[0], sa[1], sb[0], sb[1]}) > 0) visit(a.centre + from_a);
    }
  }

  static BallVector tangent(const Strand& s, const BallVector& at) {
    if (s.is_line) return s.to - s.from;
    const BallVector v = at - s.centre;
    return s.ccw ? BallVector{-v.y, v.x} : BallVector{v.y, -v.x};
  }

  /// A number that rises along the strand: the projection on a line, and on an arc of at most half
  /// a turn minus the cosine from its beginning.
  static Ball position(const Strand& s, const BallVector& at) {
    if (s.is_line) return dot(s.to - s.from, at - s.from);
    return -dot(s.from - s.centre, at - s.centre);
  }

  void add_events(std::size_t a, std::size_t b, const BallVector& at) {
    ++counts_.crossings;
    // b comes from the right of a when it turns left against it: going on along a one leaves its
    // left.
    const int step = certain_sign(cross(tangent(strands_[a], at), tangent(strands_[b], at)));
    const std::size_t i = events_.size();
    events_.push_back({a, position(strands_[a], at), -step, i + 1, at});
    events_.push_back({b, position(strands_[b], at), step, i, at});
  }

  // --- order along the curve
  // ------------------------------------------------------------------------

  void sort_events() {
    order_.resize(events_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = i;
    std::sort(order_.begin(), order_.end(), [&](std::size_t i, std::size_t j) {
      const Event& a = events_[i];
      const Event& b = events_[j];
      return a.strand != b.strand ? a.strand < b.strand : a.along.mid < b.along.mid;
    });
    rank_.resize(events_.size());
    for (std::size_t k = 0; k < order_.size(); ++k) {
      rank_[order_[k]] = k;
      if (k == 0) continue;
      const Event& a = events_[order_[k - 1]];
      const Event& b = events_[order_[k]];
      if (a.strand == b.strand && certain_sign(b.along - a.along) < 0) throw Open{};
    }
    // Where each loop's events begin in the order.
    first_event_.assign(loops_.size() + 1, order_.size());
    for (std::size_t k = order_.size(); k-- > 0;)
      first_event_[strands_[events_[order_[k]].strand].loop] = k;
    for (std::size_t i = loops_.size(); i-- > 0;)
      if (first_event_[i] == order_.size()) first_event_[i] = first_event_[i + 1];
  }

  [[nodiscard]] std::size_t loop_of(std::size_t event) const {
    return strands_[events_[event].strand].loop;
  }
  /// The next event along the same loop.
  [[nodiscard]] std::size_t next_event(std::size_t event) const {
    const std::size_t loop = loop_of(event);
    const std::size_t k = rank_[event] + 1;
    return order_[k == first_event_[loop + 1] ? first_event_[loop] : k];
  }

  // --- winding numbers
  // ------------------------------------------------------------------------------

  void carry_numbers() {
    left_after_.resize(events_.size());
    loop_number_.resize(loops_.size());
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      std::size_t probe = 0;
      int number = number_at_some_strand(i, probe);
      if (first_event_[i] == first_event_[i + 1]) {
        loop_number_[i] = number;
        continue;
      }
      // `number` holds at the middle of the strand `probe`: find the first event behind it.
      std::size_t k = first_event_[i];
      while (k < first_event_[i + 1] && !behind_middle(order_[k], probe)) ++k;
      const std::size_t count = first_event_[i + 1] - first_event_[i];
      for (std::size_t n = 0; n < count; ++n, ++k) {
        const std::size_t event = order_[first_event_[i] + (k - first_event_[i]) % count];
        number += events_[event].step;
        left_after_[event] = number;
      }
    }
  }

  [[nodiscard]] static BallVector middle(const Strand& s) {
    const Ball half(0.5L, 0);
    const BallVector chord = half * (s.from + s.to);
    if (s.is_line) return chord;
    const BallVector out = chord - s.centre;
    const auto length = sqrt(dot(out, out));
    const auto scale = length ? divide(s.radius, *length) : std::nullopt;
    if (!scale) throw Open{};
    return s.centre + *scale * out;
  }

  [[nodiscard]] bool behind_middle(std::size_t event, std::size_t strand) const {
    const Event& e = events_[event];
    if (e.strand != strand) return e.strand > strand;
    return certain_sign(e.along - position(strands_[strand], middle(strands_[strand]))) > 0;
  }

  /// The winding number left of the middle of some strand of the loop, by a ray to the right.
  int number_at_some_strand(std::size_t loop, std::size_t& probe) const {
    const std::size_t begin = first_strand_[loop];
    const std::size_t end = first_strand_[loop + 1];
    constexpr std::size_t kTries = 8;
    for (std::size_t n = 0; n < kTries; ++n) {
      probe = begin + n * (end - begin) / kTries;
      try {
        return number_left_of(probe);
      } catch (const Open&) {
        if (n + 1 == kTries) throw;
      }
    }
    throw Open{};
  }

  int number_left_of(std::size_t strand) const {
    const Strand& s = strands_[strand];
    Strand ray;
    ray.from = middle(s);
    ray.to = {Ball(static_cast<long double>(right_) + 1, 0), ray.from.y};
    int number = 0;
    const auto count = [&](const Strand& t, const BallVector& at) {
      number += certain_sign(tangent(t, at).y);
    };
    const Box box = box_of(ray);
    tree_->overlapping(box, [&](std::size_t i) {
      const Strand& t = strands_[i];
      if (i == strand) {
        count_own_return(t, ray.from, number);
        return;
      }
      cross_strands(ray, t, [&](const BallVector& at) { count(t, at); });
    });
    // The ray leaves to the right of a strand that heads up, to the left of one that heads down.
    return certain_sign(tangent(s, ray.from).y) < 0 ? number : number + 1;
  }

  /// A ray that starts on an arc may meet it once more, mirrored in the vertical through its
  /// centre.
  static void count_own_return(const Strand& arc, const BallVector& start, int& number) {
    if (arc.is_line) return;
    const Ball back = arc.centre.x - start.x;
    if (certain_sign(back) < 0) return;
    const BallVector at{arc.centre.x + back, start.y};
    const auto [after, before] = sector(arc, at - arc.centre);
    if (verdict({after, before}) > 0) number += certain_sign(tangent(arc, at).y);
  }

  // --- the result
  // -----------------------------------------------------------------------------------

  std::vector<OffsetLoop> trace(int wanted) {
    std::vector<OffsetLoop> result;
    std::vector<bool> used(events_.size(), false);
    for (const std::size_t first : order_) {
      if (used[first] || left_after_[first] != wanted) continue;
      OffsetLoop& loop = result.emplace_back();
      std::size_t event = first;
      do {
        DGT_CHECK(!used[event] && left_after_[event] == wanted);
        used[event] = true;
        const std::size_t end = next_event(event);
        add_stretch(loop, event, end);
        event = events_[end].twin;
      } while (event != first);
    }
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      if (first_event_[i] != first_event_[i + 1] || loop_number_[i] != wanted) continue;
      OffsetLoop& loop = result.emplace_back();
      for (std::size_t s = first_strand_[i]; s < first_strand_[i + 1]; ++s)
        add_piece(loop, s, end_of(s, true), end_of(s, false));
    }
    return result;
  }

  /// A point that balls place and that `exact` can work out.
  static Point point_at(const BallVector& at, std::function<ExactPoint()> exact) {
    const auto x = at.x.nearest_double();
    const auto y = at.y.nearest_double();
    if (x && y) return Point::on_demand(*x, *y, std::move(exact));
    return Point(exact());
  }

  [[nodiscard]] Point end_of(std::size_t strand, bool beginning) const {
    const Strand& s = strands_[strand];
    return point_at(beginning ? s.from : s.to,
                    [source = source_, loop = s.loop, edge = s.edge, corner = s.corner, beginning] {
                      const RawPiece raw = source->piece(loop, edge, corner);
                      return ExactPoint(beginning ? raw.from : raw.to);
                    });
  }

  [[nodiscard]] Point place_of(std::size_t event) const {
    const Event& e = events_[event];
    const std::size_t other = events_[e.twin].strand;
    const double x = static_cast<double>(e.at.x.mid);
    const double y = static_cast<double>(e.at.y.mid);
    // Of the two places where the supports meet, the one near the ball.
    return point_at(e.at, [source = source_, a = key(std::min(e.strand, other)),
                           b = key(std::max(e.strand, other)), x, y] {
      const auto places = cgal::support_crossings(source->piece(a.loop, a.edge, a.corner),
                                                  source->piece(b.loop, b.edge, b.corner));
      const auto far = [&](const ExactPoint& p) {
        return std::hypot(nearest_double(p.x) - x, nearest_double(p.y) - y);
      };
      return *std::min_element(places.begin(), places.end(),
                               [&](const auto& p, const auto& q) { return far(p) < far(q); });
    });
  }
  struct Key {
    std::size_t loop;
    std::size_t edge;
    bool corner;
  };
  [[nodiscard]] Key key(std::size_t strand) const {
    const Strand& s = strands_[strand];
    return {s.loop, s.edge, s.corner};
  }

  void add_stretch(OffsetLoop& loop, std::size_t begin, std::size_t end) const {
    Point from = place_of(begin);
    std::size_t strand = events_[begin].strand;
    bool once_round = events_[end].strand == strand && rank_[end] <= rank_[begin];
    while (strand != events_[end].strand || once_round) {
      once_round = false;
      const Point to = end_of(strand, false);
      add_piece(loop, strand, from, to);
      from = to;
      strand = next_strand(strand);
    }
    add_piece(loop, strand, from, place_of(end));
  }

  void add_piece(OffsetLoop& loop, std::size_t strand, const Point& from, const Point& to) const {
    OffsetPiece piece;
    piece.from = from;
    piece.to = to;
    const Strand& s = strands_[strand];
    piece.is_line = s.is_line;
    if (!s.is_line) {
      const ChainEdge& edge = loops_[s.loop].edges[s.edge];
      piece.centre = s.corner ? edge.to : edge.centre();
      piece.radius = s.corner ? distance_ : Rational(abs(edge.radius - distance_));
      if (!s.ccw) piece.radius = -piece.radius;
    }
    loop.pieces.push_back(std::move(piece));
  }

  std::shared_ptr<const Source> source_;
  const std::vector<Chain>& loops_;
  const Rational& distance_;
  OffsetCounts& counts_;
  std::vector<Strand> strands_;
  std::vector<std::size_t> first_strand_;  ///< of each loop, and one behind
  std::optional<BoxTree> tree_;
  double right_ = -std::numeric_limits<double>::infinity();
  std::vector<Event> events_;
  std::vector<std::size_t> order_;        ///< events along the curve
  std::vector<std::size_t> rank_;         ///< of an event in the order
  std::vector<std::size_t> first_event_;  ///< of each loop in the order, and one behind
  std::vector<int> left_after_;           ///< number left of the stretch behind an event
  std::vector<int> loop_number_;          ///< of loops without events
};

}  // namespace

std::vector<OffsetLoop> production_offset(const std::vector<Chain>& loops, const Rational& distance,
                                          OffsetCounts* counts) {
  OffsetCounts ignored;
  OffsetCounts& counted = counts ? *counts : ignored;
  counted = {};
  if (loops.empty()) return {};
  if (sgn(distance) == 0) {
    counted.by_reference = true;
    return reference_offset(loops, distance);
  }
  if (sgn(distance) < 0) {  // growing the region is shrinking what lies beyond it
    std::vector<OffsetLoop> result = production_offset(reversed(loops), -distance, &counted);
    reverse_loops(result);
    return result;
  }
  try {
    std::vector<OffsetLoop> result = Engine(loops, distance, counted).run();
    drop_void_loops(result, loops, distance);
    return result;
  } catch (const Open&) {
    counted.by_reference = true;
    return reference_offset(loops, distance);
  }
}

}  // namespace dgt
