// SPDX-License-Identifier: GPL-3.0-or-later
//
// Takes the loops out of an equidistant, where the tool would cut into the programmed contour.
//
// Nouns. A *strand* is what a leg becomes when it is moved: from joint to joint where its
// neighbours meet, and where they do not (one of them is eaten or turned over) as far as the feet
// of the programmed ends. A leg that is eaten leaves none: all of it would be too near to itself.
// *Nodes* are the ends of strands and the places where strands meet. Between two nodes a strand is
// a *reach*: kept when the tool keeps its distance from the whole contour on it, exactly.
//
//   strands → nodes → which reaches are kept → from the beginning along kept reaches, over to
//   another strand where one's own is not kept any more → moves
//
// What is left has to be one run from the beginning to the end. Where it falls apart (a part of the
// work cannot be reached without cutting into another) nothing is guessed: the contour is refused.
#include <algorithm>
#include <cmath>
#include <map>

#include "kernel/contour_path.h"
#include "kernel/gouge.h"

namespace dgt {
namespace {

struct Strand {
  Stretch stretch;
  std::size_t leg = 0;
  Role role = Role::Contour;
  bool counts = true;              ///< false: lead, or a line run against its direction
  std::vector<std::size_t> nodes;  ///< in the order of travel
  std::vector<bool> kept;          ///< reach k runs from nodes[k] to nodes[k + 1]
};

struct ReachOf {
  std::size_t strand = 0;
  std::size_t reach = 0;
};

struct Ends {
  std::optional<Point> arrive;  ///< nothing: its elements do not meet
  std::optional<Point> leave;
  std::optional<Carrier> turn;
  bool outer = false;
};

class Trim {
 public:
  Trim(const ContourLegs& legs, const Shifts& shifts, const ContourOptions& options,
       const Walls& walls)
      : legs_(legs), shifts_(shifts), options_(options), walls_(walls) {}

  /// Nothing where the contour cannot be trimmed; `why` says so then.
  std::optional<std::vector<Move>> run() {
    if (!is_one_cut()) return std::nullopt;
    place_joints();
    find_spoilt_legs();
    lay_strands();
    if (strands_.empty()) {
      refuse(ContourFault::Kind::TrimNothing, 0, legs_.joints.front().programmed);
      return std::nullopt;
    }
    find_nodes();
    mark_lead();
    decide_reaches();
    if (!walk() || !is_whole()) return std::nullopt;
    return to_moves();
  }

  std::vector<ContourNotice> notices;
  ContourFault why{};
  Point end;

 private:
  // --- strands ----------------------------------------------------------------------------------

  [[nodiscard]] bool is_along(const Leg& leg) const { return leg.travel == Leg::Travel::Along; }

  /// The legs along elements follow each other without straight ones between them.
  bool is_one_cut() {
    const auto along = [this](const Leg& leg) { return is_along(leg); };
    const auto first = std::find_if(legs_.legs.begin(), legs_.legs.end(), along);
    const auto last = std::find_if(legs_.legs.rbegin(), legs_.legs.rend(), along).base();
    for (auto leg = first; leg < last; ++leg) {
      if (leg->travel != Leg::Travel::Straight && !leg->rapid) continue;
      refuse(ContourFault::Kind::TrimBroken, last[-1].element.item,
             legs_.joints[leg->from].programmed);
      return false;
    }
    return first != legs_.legs.end();
  }

  [[nodiscard]] bool is_eaten(const UsedElement& used) const {
    const RationalPtr& shift = shifts_[used.step];
    const auto* circle = std::get_if<Circle>(used.element.get());
    return shift && circle && !circle->survives_offset(*shift);
  }

  [[nodiscard]] bool rests_on_eaten(const Joint& joint) const {
    return std::visit(
        [&](const auto& rule) {
          if constexpr (requires { rule.a; }) {
            const bool first = is_eaten(rule.a);
            return is_eaten(rule.b) || first;
          } else if constexpr (requires { rule.on; }) {
            return is_eaten(rule.on);
          } else {
            return false;
          }
        },
        joint.rule);
  }

  void place_joints() {
    for (const Joint& joint : legs_.joints) {
      Ends& ends = ends_.emplace_back();
      if (std::holds_alternative<FixedJoint>(joint.rule)) {
        ends.arrive = ends.leave = joint.programmed;
        continue;
      }
      if (rests_on_eaten(joint)) continue;
      const PlacedJoint placed = place_joint(joint, shifts_, options_);
      ends.arrive = ends.leave = placed.at;
      ends.outer = is_outer_corner(joint, shifts_);
      if (!ends.outer) continue;
      const auto round = path_round(joint, shifts_, placed.at, options_);
      if (!round) continue;
      ends.arrive = joint.turn.begins ? round->end : round->begin;
      ends.leave = round->end;
      if (!joint.turn.begins) ends.turn = round->carrier;
    }
  }

  /// Whether the offset turns a leg over, its joints being where they are.
  [[nodiscard]] bool is_turned(const Leg& leg) const {
    const Point& from = legs_.joints[leg.from].programmed;
    const Point& to = legs_.joints[leg.to].programmed;
    const Point& now_from = *ends_[leg.from].leave;
    const Point& now_to = *ends_[leg.to].arrive;
    if (const auto* line = std::get_if<Line>(leg.element.element.get())) {
      const int now = motion_along(*line, now_from, now_to);
      return now != 0 && now != (indistinct(from, to) ? 1 : motion_along(*line, from, to));
    }
    const auto& circle = std::get<Circle>(*leg.element.element);
    return std::fabs(coarse_sweep(circle, now_from, now_to) - coarse_sweep(circle, from, to)) > 180;
  }

  void find_spoilt_legs() {
    std::vector<std::size_t> spoilt;
    for (std::size_t i = 0; i < legs_.legs.size(); ++i) {
      const Leg& leg = legs_.legs[i];
      if (!is_along(leg) || leg.full_circle) continue;
      const bool placed = ends_[leg.from].leave && ends_[leg.to].arrive;
      if (is_eaten(leg.element) || (placed && is_turned(leg))) spoilt.push_back(i);
    }
    // An outer corner stays as it is: what is beyond it does not concern the tool.
    for (const std::size_t i : spoilt) {
      for (const std::size_t joint : {legs_.legs[i].from, legs_.legs[i].to}) {
        const auto& rule = legs_.joints[joint].rule;
        const bool of_two =
            std::holds_alternative<CrossJoint>(rule) || std::holds_alternative<TangentJoint>(rule);
        if (of_two && !ends_[joint].outer) ends_[joint] = {};
      }
    }
  }

  /// The place on the moved element beside a place of the programmed one.
  [[nodiscard]] Point foot(const Leg& leg, std::size_t joint) const {
    return Point(foot_of_normal(moved(leg).element(), legs_.joints[joint].programmed));
  }
  [[nodiscard]] Carrier moved(const Leg& leg) const {
    return {leg.element.element, shifts_[leg.element.step]};
  }

  void lay_strands() {
    for (std::size_t i = 0; i < legs_.legs.size(); ++i) {
      const Leg& leg = legs_.legs[i];
      if (!is_along(leg)) continue;
      if (!is_eaten(leg.element)) lay(leg, i);
      const Ends& to = ends_[leg.to];
      if (to.turn) add({*to.arrive, *to.leave, *to.turn}, i, Role::Corner);
    }
  }

  void lay(const Leg& leg, std::size_t index) {
    const Carrier on = moved(leg);
    const Point from = ends_[leg.from].leave ? *ends_[leg.from].leave : foot(leg, leg.from);
    const Point to = ends_[leg.to].arrive ? *ends_[leg.to].arrive : foot(leg, leg.to);
    if (const auto* line = std::get_if<Line>(leg.element.element.get())) {
      const Point& was_from = legs_.joints[leg.from].programmed;
      const Point& was_to = legs_.joints[leg.to].programmed;
      const int was = indistinct(was_from, was_to) ? 1 : motion_along(*line, was_from, was_to);
      if (motion_along(*line, from, to) == was) add({from, to, on}, index, leg.role);
      if (!strands_.empty() && strands_.back().leg == index) strands_.back().counts = was > 0;
      return;
    }
    // An arc may pass a full turn when it is extended at both ends: part by part it does not.
    Point at = from;
    const auto go_to = [&](const Point& next) {
      if (!indistinct(at, next)) add({at, next, on}, index, leg.role);
      at = next;
    };
    if (ends_[leg.from].outer) go_to(foot(leg, leg.from));
    if (leg.full_circle || is_wide(leg)) go_to(middle(leg, on));
    if (ends_[leg.to].outer) go_to(foot(leg, leg.to));
    go_to(to);
  }

  [[nodiscard]] bool is_wide(const Leg& leg) const {
    return std::fabs(programmed_sweep(leg)) > 120;
  }
  [[nodiscard]] double programmed_sweep(const Leg& leg) const {
    const auto& circle = std::get<Circle>(*leg.element.element);
    if (leg.full_circle) return circle.counter_clockwise() ? 360 : -360;
    return coarse_sweep(circle, legs_.joints[leg.from].programmed, legs_.joints[leg.to].programmed);
  }
  /// About half-way along the arc, on it exactly.
  [[nodiscard]] Point middle(const Leg& leg, const Carrier& on) const {
    const Element element = on.element();
    const auto& circle = std::get<Circle>(element);
    const Point& from = legs_.joints[leg.from].programmed;
    const Point centre(circle.centre());
    const double start = std::atan2(from.y() - centre.y(), from.x() - centre.x()) * 180 / M_PI;
    const double half = std::round(start + programmed_sweep(leg) / 2);
    const UnitVector u = direction_of(Rational(half)).unit;
    return Point(circle.centre() + Rational(abs(circle.radius())) * u.vector());
  }

  void add(Stretch stretch, std::size_t leg, Role role) {
    if (indistinct(stretch.from, stretch.to)) return;
    Strand& strand = strands_.emplace_back();
    strand.stretch = std::move(stretch);
    strand.leg = leg;
    strand.role = role;
  }

  // --- nodes ------------------------------------------------------------------------------------

  std::size_t node(const Point& p) {
    for (const std::size_t known : nodes_at_[{p.x(), p.y()}])
      if (places_[known] == p) return known;
    // Ends of arcs are stand-ins of each other: nearer than the shortest leg is one place.
    for (auto at = nodes_at_.lower_bound({p.x() - kLegResolution, -HUGE_VAL});
         at != nodes_at_.end() && at->first.first <= p.x() + kLegResolution; ++at) {
      for (const std::size_t known : at->second)
        if (indistinct(places_[known], p)) return known;
    }
    places_.push_back(p);
    nodes_at_[{p.x(), p.y()}].push_back(places_.size() - 1);
    return places_.size() - 1;
  }

  void find_nodes() {
    std::vector<Bounds> boxes;
    for (Strand& s : strands_) {
      boxes.push_back(box_around(s.stretch));
      s.nodes = {node(s.stretch.from), node(s.stretch.to)};
    }
    const BoxTree tree(boxes);
    for (std::size_t i = 0; i < strands_.size(); ++i) {
      tree.overlapping(boxes[i], [&](std::size_t j) {
        if (j <= i) return;
        for (const Point& p : common_places(strands_[i].stretch, strands_[j].stretch)) {
          const std::size_t n = node(p);
          strands_[i].nodes.push_back(n);
          strands_[j].nodes.push_back(n);
        }
      });
    }
    for (Strand& s : strands_) sort_nodes(s);
  }

  /// Whether p comes before q on the way along the stretch.
  [[nodiscard]] static bool is_before(const Stretch& stretch, const Point& p, const Point& q) {
    if (const auto* line = std::get_if<Line>(stretch.carrier.base.get())) {
      const Vector d = line->direction().vector();
      return order_along(d, p, q) == order_along(d, stretch.from, stretch.to);
    }
    if (q == stretch.from || p == q) return false;
    return covers({stretch.from, q, stretch.carrier}, p);
  }

  void sort_nodes(Strand& s) {
    const std::size_t first = s.nodes[0];
    const std::size_t last = s.nodes[1];
    std::sort(s.nodes.begin(), s.nodes.end());
    s.nodes.erase(std::unique(s.nodes.begin(), s.nodes.end()), s.nodes.end());
    std::erase_if(s.nodes, [&](std::size_t n) { return n == first || n == last; });
    std::sort(s.nodes.begin(), s.nodes.end(), [&](std::size_t a, std::size_t b) {
      return a != b && is_before(s.stretch, places_[a], places_[b]);
    });
    s.nodes.insert(s.nodes.begin(), first);
    s.nodes.push_back(last);
  }

  /// What lies before or beyond the meeting of a contour with itself is lead.
  void mark_lead() {
    Strand& first = strands_.front();
    Strand& last = strands_.back();
    if (&first == &last || first.nodes.front() == last.nodes.back()) return;
    const auto on_first = std::find(first.nodes.begin(), first.nodes.end(), last.nodes.back());
    const auto on_last = std::find(last.nodes.begin(), last.nodes.end(), first.nodes.front());
    if (on_first != first.nodes.end())
      lead_before_ = static_cast<std::size_t>(on_first - first.nodes.begin());
    else if (on_last != last.nodes.end())
      lead_from_ = static_cast<std::size_t>(on_last - last.nodes.begin());
  }

  void decide_reaches() {
    for (std::size_t i = 0; i < strands_.size(); ++i) {
      Strand& s = strands_[i];
      const Leg& leg = legs_.legs[s.leg];
      for (std::size_t k = 0; k + 1 < s.nodes.size(); ++k) {
        const bool lead =
            (i == 0 && k < lead_before_) || (i + 1 == strands_.size() && k >= lead_from_);
        const CutPiece cut{{places_[s.nodes[k]], places_[s.nodes[k + 1]], s.stretch.carrier},
                           abs(legs_.steps[leg.element.step]),
                           leg.element.item};
        s.kept.push_back(lead || !s.counts || !walls_.any_cut_by(cut));
      }
      for (std::size_t k = 0; k < s.kept.size(); ++k) leaving_[s.nodes[k]].push_back({i, k});
    }
  }

  // --- the way ----------------------------------------------------------------------------------

  [[nodiscard]] bool is_kept(const ReachOf& r) const { return strands_[r.strand].kept[r.reach]; }
  [[nodiscard]] std::size_t end_of(const ReachOf& r) const {
    return strands_[r.strand].nodes[r.reach + 1];
  }
  [[nodiscard]] std::size_t item_of(const ReachOf& r) const {
    return legs_.legs[strands_[r.strand].leg].element.item;
  }

  bool walk() {
    ReachOf at;
    if (!is_kept(at)) return refuse(ContourFault::Kind::TrimStart, item_of(at), start());
    for (;;) {
      way_.push_back(at);
      const Strand& s = strands_[at.strand];
      const bool at_end = at.reach + 1 == s.kept.size();
      if (at_end && at.strand + 1 == strands_.size()) return true;
      const std::size_t n = end_of(at);
      // A closed contour comes back to its beginning by another strand when the last is cut off.
      if (n == strands_.back().nodes.back() && n == strands_.front().nodes.front()) return true;
      const auto next = next_of(at);
      if (!next) return refuse(ContourFault::Kind::TrimBroken, item_of(at), places_[n]);
      if (next->strand > at.strand + 1 || (next->strand != at.strand && !follows(at, *next)))
        note_cut(at, *next);
      at = *next;
    }
  }

  [[nodiscard]] const Point& start() const { return places_[strands_.front().nodes.front()]; }

  [[nodiscard]] bool follows(const ReachOf& a, const ReachOf& b) const {
    return b.strand == a.strand + 1 && b.reach == 0 &&
           a.reach + 1 == strands_[a.strand].kept.size();
  }

  /// Along one's own strand while that is kept, else to the strand that comes last of those that
  /// lead on: never back.
  [[nodiscard]] std::optional<ReachOf> next_of(const ReachOf& at) const {
    std::optional<ReachOf> best;
    const auto leaving = leaving_.find(end_of(at));
    if (leaving == leaving_.end()) return best;
    for (const ReachOf& r : leaving->second) {
      if (!is_kept(r) || r.strand < at.strand) continue;
      if (r.strand == at.strand) {
        if (r.reach == at.reach + 1) return r;
        continue;
      }
      if (!best || r.strand > best->strand) best = r;
    }
    return best;
  }

  void note_cut(const ReachOf& from, const ReachOf& to) {
    ContourNotice notice{ContourNotice::Kind::Trimmed, item_of(from), item_of(to)};
    const Point& p = places_[end_of(from)];
    notice.on_equidistant = true;
    notice.x = p.x();
    notice.y = p.y();
    notices.push_back(notice);
  }

  /// Whether no closed run of kept reaches is left beside the way.
  bool is_whole() {
    using Key = std::pair<std::size_t, std::size_t>;
    std::map<Key, bool> gone;  // between these nodes the tool comes by in this direction
    for (const ReachOf& r : way_) gone[{strands_[r.strand].nodes[r.reach], end_of(r)}] = true;
    std::vector<ReachOf> left;
    for (std::size_t i = 0; i < strands_.size(); ++i) {
      for (std::size_t k = 0; k < strands_[i].kept.size(); ++k) {
        const ReachOf r{i, k};
        if (is_kept(r) && !gone.count({strands_[i].nodes[k], end_of(r)})) left.push_back(r);
      }
    }
    for (bool pruned = true; pruned;) {  // what leads nowhere, or comes from nowhere, is no run
      std::map<std::size_t, int> leaves;
      std::map<std::size_t, int> arrives;
      for (const ReachOf& r : left) {
        ++leaves[strands_[r.strand].nodes[r.reach]];
        ++arrives[end_of(r)];
      }
      pruned =
          std::erase_if(left, [&](const ReachOf& r) {
            return !leaves.count(end_of(r)) || !arrives.count(strands_[r.strand].nodes[r.reach]);
          }) > 0;
    }
    if (left.empty()) return true;
    const ReachOf& r = left.front();
    return refuse(ContourFault::Kind::TrimSplits, item_of(r),
                  places_[strands_[r.strand].nodes[r.reach]]);
  }

  bool refuse(ContourFault::Kind kind, std::size_t item, const Point& at) {
    why.kind = kind;
    why.item = item;
    why.other = item;
    why.on_equidistant = true;
    why.x = at.x();
    why.y = at.y();
    return false;
  }

  // --- moves ------------------------------------------------------------------------------------

  std::vector<Move> to_moves() {
    std::vector<Move> moves;
    stands_ = *ends_.front().leave;
    std::size_t leg = 0;
    RationalPtr height;
    const auto catch_up = [&](std::size_t until) {
      for (; leg < until; ++leg) {
        const Leg& passed = legs_.legs[leg];
        if (passed.z) height = passed.z;
        if (!is_along(passed)) emit(passed, height, moves);
      }
    };
    for (std::size_t k = 0; k < way_.size(); ++k) {
      const Strand& s = strands_[way_[k].strand];
      catch_up(s.leg);
      if (legs_.legs[s.leg].z) height = legs_.legs[s.leg].z;
      const Point& to = places_[end_of(way_[k])];
      const bool goes_on = k > 0 && !moves.empty() && s.leg == strands_[way_[k - 1].strand].leg &&
                           s.role == moves.back().role && is_part(moves.back());
      if (goes_on) {
        moves.back().to = to;
        moves.back().full_circle =
            moves.back().kind == MoveKind::Arc && moves.back().from == moves.back().to;
      } else {
        emit(s, to, height, moves);
      }
      stands_ = to;
    }
    catch_up(legs_.legs.size());
    end = stands_;
    return moves;
  }

  void emit(const Strand& s, const Point& to, RationalPtr& height, std::vector<Move>& moves) {
    const Leg& leg = legs_.legs[s.leg];
    Move& move = moves.emplace_back();
    move.kind = s.stretch.carrier.is_line() ? MoveKind::Line : MoveKind::Arc;
    move.role = s.role;
    move.from = stands_;
    move.to = to;
    move.carrier = s.stretch.carrier;
    move.feed = leg.feed;
    move.z = std::exchange(height, nullptr);
    move.source = leg.place;
  }

  /// A stop, or a straight move before or behind the cut.
  void emit(const Leg& leg, RationalPtr& height, std::vector<Move>& moves) {
    const bool stop = leg.travel == Leg::Travel::Stop;
    const bool before = way_.empty() || leg.to <= first_joint();
    // The lead-in goes to where the cut begins, whatever its joint was meant to be.
    const Point to = stop                                ? stands_
                     : before && leg.to == first_joint() ? start()
                                                         : *ends_[leg.to].arrive;
    if (!stop && indistinct(stands_, to)) return;
    Move& move = moves.emplace_back();
    move.kind = stop ? (leg.seconds ? MoveKind::Dwell : MoveKind::Code)
                     : (leg.rapid ? MoveKind::Rapid : MoveKind::Line);
    move.role = leg.role;
    move.from = stands_;
    move.to = to;
    if (!stop) {
      move.feed = leg.feed;
      move.z = std::exchange(height, nullptr);
    }
    move.seconds = leg.seconds;
    move.code = leg.code;
    move.source = leg.place;
    stands_ = to;
  }

  [[nodiscard]] std::size_t first_joint() const { return legs_.legs[strands_.front().leg].from; }

  const ContourLegs& legs_;
  const Shifts& shifts_;
  const ContourOptions& options_;
  const Walls& walls_;
  std::vector<Ends> ends_;
  std::vector<Strand> strands_;
  std::vector<Point> places_;
  std::map<std::pair<double, double>, std::vector<std::size_t>> nodes_at_;
  std::map<std::size_t, std::vector<ReachOf>> leaving_;
  std::vector<ReachOf> way_;
  std::size_t lead_before_ = 0;
  std::size_t lead_from_ = static_cast<std::size_t>(-1);
  Point stands_;
};

}  // namespace

bool trim_gouges(const ContourLegs& legs, int side, const ContourOptions& options,
                 const Path& programmed, BuiltContour& out, Point& end) {
  const Shifts shifts = shifts_for(legs, side);
  const Walls walls = walls_of(legs, programmed, options, out);
  Trim trim(legs, shifts, options, walls);
  auto moves = trim.run();
  if (!moves) {
    out.faults.push_back(trim.why);
    return false;
  }
  out.moves = *std::move(moves);
  out.faults.clear();
  out.notices.insert(out.notices.end(), trim.notices.begin(), trim.notices.end());
  end = trim.end;
  return true;
}

}  // namespace dgt
