// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops of which no two edges meet but neighbours in their joint cross nowhere; then the number
// left of a loop is the same all along it, and one ray a loop finds it. All others go through an
// arrangement.
#include "kernel/loop_fault.h"

#include <algorithm>

#include "kernel/box_tree.h"
#include "kernel/cgal/arrangement.h"
#include "kernel/offset_raw.h"
#include "kernel/stretch.h"

namespace dgt {
namespace {

/// Edges at least this far apart need no exact look. Unit: mm.
const Rational& clear() {
  static const Rational value = power_of_two(-40);
  return value;
}

/// Whether `p`, a place of the edge's line or circle, lies on the edge, which is no more than half
/// a turn: an arc lies to the right of its chord when it runs counter-clockwise.
bool lies_on(const ChainEdge& edge, const RationalPoint& p) {
  const Vector chord = edge.to - edge.from;
  if (!edge.is_line()) return sgn(cross(chord, p - edge.from)) * sgn(edge.radius) <= 0;
  const Rational along = dot(chord, p - edge.from);
  return sgn(along) >= 0 && along <= squared_length(chord);
}

/// The mirror image of `p` in the line through `a` along `v`.
RationalPoint mirrored(const RationalPoint& p, const RationalPoint& a, const Vector& v) {
  const Rational off = 2 * cross(v, p - a) / squared_length(v);
  return p - off * turned_left(v);
}

/// Whether two edges with the common end `joint` meet only there, or also in their other common
/// end. The second place of a line and a circle, or of two circles, is the joint's mirror image.
bool meet_in_joint_alone(const ChainEdge& a, const ChainEdge& b, const RationalPoint& joint) {
  if (a.is_line() && b.is_line()) {
    const Vector v = (a.from == joint ? a.to : a.from) - joint;
    const Vector w = (b.from == joint ? b.to : b.from) - joint;
    return sgn(cross(v, w)) != 0 || sgn(dot(v, w)) < 0;
  }
  RationalPoint second;
  if (a.is_line() || b.is_line()) {
    const ChainEdge& line = a.is_line() ? a : b;
    const ChainEdge& arc = a.is_line() ? b : a;
    second = mirrored(joint, arc.centre(), turned_left(line.to - line.from));
  } else {
    const Vector between = b.centre() - a.centre();
    if (sgn(squared_length(between)) == 0) return sgn(a.radius) == sgn(b.radius);
    second = mirrored(joint, a.centre(), between);
  }
  const auto is_end = [&](const ChainEdge& e) { return second == e.from || second == e.to; };
  return second == joint || (is_end(a) && is_end(b)) || !lies_on(a, second) || !lies_on(b, second);
}

struct BallVector {
  Ball x, y;
};
BallVector operator-(const BallVector& a, const BallVector& b) { return {a.x - b.x, a.y - b.y}; }
Ball cross(const BallVector& a, const BallVector& b) { return a.x * b.y - a.y * b.x; }
Ball dot(const BallVector& a, const BallVector& b) { return a.x * b.x + a.y * b.y; }
BallVector from_of(const StretchBalls& s) { return {s.from_x, s.from_y}; }
BallVector to_of(const StretchBalls& s) { return {s.to_x, s.to_y}; }
BallVector centre_of(const StretchBalls& s) { return {s.centre_x, s.centre_y}; }

/// `counter_clockwise` of an arc.
bool surely_off(const StretchBalls& edge, bool counter_clockwise, const BallVector& p) {
  const BallVector chord = to_of(edge) - from_of(edge);
  if (!edge.is_line) return cross(chord, p - from_of(edge)).sign() == (counter_clockwise ? 1 : -1);
  return dot(chord, p - from_of(edge)).sign() == -1 || dot(chord, p - to_of(edge)).sign() == 1;
}

/// meet_in_joint_alone() as far as balls can tell: false means nothing. The joint is the end of
/// `a`. Where the edges are tangent but for their last decimals, the second place is so near to
/// the joint that what lies between them does not count.
bool surely_meet_in_joint_alone(const StretchBalls& a, bool a_ccw, const StretchBalls& b,
                                bool b_ccw) {
  if (a.is_line && b.is_line)
    return cross(to_of(a) - from_of(a), to_of(b) - from_of(b)).sign().value_or(0) != 0;
  const StretchBalls& arc = a.is_line ? b : a;
  const StretchBalls& other = a.is_line ? a : b;
  BallVector axis =
      other.is_line ? to_of(other) - from_of(other) : centre_of(other) - centre_of(arc);
  if (other.is_line) axis = {-axis.y, axis.x};
  const BallVector joint = to_of(a);
  const auto off = divide(cross(axis, joint - centre_of(arc)), dot(axis, axis));
  if (!off) return false;
  const Ball twice = *off + *off;
  const BallVector second{joint.x + twice * axis.y, joint.y - twice * axis.x};
  const BallVector between = second - joint;
  static const Ball kMinute(Rational(kOffsetResolution) * Rational(kOffsetResolution) / 4);
  if ((dot(between, between) - kMinute).sign() == -1) return true;
  return surely_off(a, a_ccw, second) || surely_off(b, b_ccw, second);
}

class LoopEdges {
 public:
  explicit LoopEdges(const std::vector<Chain>& loops) : edges_(edges_of(loops)), tree_(boxes()) {}

  [[nodiscard]] bool surely_simple() const {
    bool simple = true;
    tree_.pairs(
        [&](std::size_t i, std::size_t j) { simple = simple && part(edges_[i], edges_[j]); });
    return simple;
  }

  /// The winding number about `p` of all loops but `own`; nothing where `p` lies on some chord.
  [[nodiscard]] std::optional<int> winding(const RationalPoint& p, std::size_t own) const {
    int number = 0;
    bool decided = true;
    const double x = nearest_double(p.x);
    const double y = nearest_double(p.y);
    const double slack = 1e-9 * (1 + std::fabs(x) + std::fabs(y));
    tree_.overlapping({x - slack, y - slack, right_, y + slack}, [&](std::size_t i) {
      const Edge& e = edges_[i];
      if (e.loop == own || !decided) return;
      const auto turns = turns_about(*e.edge, p);
      decided = turns.has_value();
      if (turns) number += *turns;
    });
    return decided ? std::optional(number) : std::nullopt;
  }

 private:
  struct Edge {
    const ChainEdge* edge;
    StretchBalls balls;
    std::size_t loop = 0;
    std::size_t index = 0;
    std::size_t count = 0;  ///< of the loop's edges
  };

  static StretchBalls balls_of(const ChainEdge& e) {
    const Element on = e.is_line() ? Element(Line::through(e.from, e.start))
                                   : Element(Circle(e.centre(), e.radius));
    return dgt::balls_of(Stretch{Point(e.from), Point(e.to), carrier(on)});
  }
  static std::vector<Edge> edges_of(const std::vector<Chain>& loops) {
    std::vector<Edge> edges;
    for (std::size_t l = 0; l < loops.size(); ++l) {
      const auto& of = loops[l].edges;
      for (std::size_t i = 0; i < of.size(); ++i)
        edges.push_back({&of[i], balls_of(of[i]), l, i, of.size()});
    }
    return edges;
  }
  [[nodiscard]] std::vector<Bounds> boxes() {
    std::vector<Bounds> all;
    all.reserve(edges_.size());
    for (const Edge& e : edges_) {
      all.push_back(e.balls.box);
      right_ = std::max(right_, e.balls.box.max_x);
    }
    return all;
  }

  /// Whether two edges surely have no place in common but the joints of neighbours.
  static bool part(const Edge& a, const Edge& b) {
    if (a.loop == b.loop) {
      const bool behind = (a.index + 1) % a.count == b.index;
      const bool before = (b.index + 1) % b.count == a.index;
      if (behind && !part_behind(a, b)) return false;
      if (before && !part_behind(b, a)) return false;
      if (behind || before) return true;
    }
    const auto nearer = stages::filtered_nearer(a.balls, b.balls, Ball(clear()));
    return nearer && !*nearer;
  }

  /// Of an edge and the one behind it.
  static bool part_behind(const Edge& a, const Edge& b) {
    return surely_meet_in_joint_alone(a.balls, sgn(a.edge->radius) > 0, b.balls,
                                      sgn(b.edge->radius) > 0) ||
           meet_in_joint_alone(*a.edge, *b.edge, a.edge->to);
  }

  /// What the edge adds to the winding number about `p`: its chord, by a ray to the right that
  /// takes in lower ends and not upper ones, and for an arc the segment between it and its chord.
  static std::optional<int> turns_about(const ChainEdge& e, const RationalPoint& p) {
    const Vector chord = e.to - e.from;
    const int side = sgn(cross(chord, p - e.from));
    const bool up = e.from.y <= p.y && p.y < e.to.y;
    const bool down = e.to.y <= p.y && p.y < e.from.y;
    int turns = up && side > 0 ? 1 : down && side < 0 ? -1 : 0;
    if (side == 0 && (up || down || !e.is_line())) return std::nullopt;
    if (e.is_line()) return turns;
    const int way = sgn(e.radius);
    const bool beyond_chord = side * way < 0;
    if (beyond_chord && squared_length(p - e.centre()) < e.radius * e.radius) turns += way;
    return turns;
  }

  std::vector<Edge> edges_;
  double right_ = -1e300;
  BoxTree tree_;
};

/// Whether the number left of each loop, none of which meets another, is the region's.
std::optional<LoopFault> find_wrong_nesting(const std::vector<Chain>& loops, const LoopEdges& edges,
                                            int wanted, bool& decided) {
  for (std::size_t l = 0; l < loops.size(); ++l) {
    std::optional<int> around;
    for (std::size_t i = 0; i < loops[l].edges.size() && !around; ++i)
      around = edges.winding(loops[l].edges[i].from, l);
    // A loop that runs back over itself has no side that an area could tell.
    const bool has_side = std::fabs(area(loops[l])) > kOffsetResolution;
    decided = decided && around && has_side;
    if (!around || !has_side) continue;
    const int left = *around + (area(loops[l]) > 0 ? 1 : 0);
    const RationalPoint& at = loops[l].edges.front().from;
    if (left != wanted)
      return LoopFault{LoopFault::Kind::Nesting, l, l, nearest_double(at.x), nearest_double(at.y)};
  }
  return std::nullopt;
}

std::size_t loop_of(const std::vector<Chain>& loops, RawKey key) {
  std::size_t edge = key.edge();
  std::size_t loop = 0;
  while (edge >= loops[loop].edges.size()) edge -= loops[loop++].edges.size();
  return loop;
}

}  // namespace

std::optional<LoopFault> find_loop_fault(const std::vector<Chain>& loops) {
  if (loops.empty()) return std::nullopt;
  const int wanted = number_of_region(loops);
  const LoopEdges edges(loops);
  bool decided = edges.surely_simple();
  if (decided) {
    const auto fault = find_wrong_nesting(loops, edges, wanted, decided);
    if (fault || decided) return fault;
  }
  const auto odd = cgal::find_odd_face(raw_curve(loops, 0, {}), wanted);
  if (!odd) return std::nullopt;
  const std::size_t loop = loop_of(loops, odd->one);
  const std::size_t other = loop_of(loops, odd->other);
  return LoopFault{odd->at_crossing ? LoopFault::Kind::Crossing : LoopFault::Kind::Nesting,
                   std::min(loop, other), std::max(loop, other), odd->x, odd->y};
}

}  // namespace dgt
