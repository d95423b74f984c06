// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/contour.h"

#include <algorithm>
#include <cmath>

#include "kernel/contour_legs.h"

namespace dgt {
namespace {

using Kind = ContourFault::Kind;

ContourFault fault(Kind kind, std::size_t item, double measure = 0) {
  ContourFault f{};
  f.kind = kind;
  f.item = item;
  f.measure = measure;
  return f;
}

bool any_offset(const ContourLegs& legs) {
  for (const Rational& step : legs.steps)
    if (sgn(step) != 0) return true;
  return false;
}

/// +1: W > 0 lies to the left of the elements, −1: to the right; 0 with a fault when nobody can
/// say.
int side_of_offset(const ContourLegs& legs, const ContourOptions& options, BuiltContour& out) {
  if (options.offset_side == OffsetSide::Left) return 1;
  if (options.offset_side == OffsetSide::Right) return -1;
  const UsedElement& first = *legs.first_element;
  if (sgn(legs.steps.front()) < 0) {
    out.faults.push_back(fault(Kind::SideOfNegative, first.item));
    return 0;
  }
  if (lies_on(*first.element, legs.tool_before)) {
    out.faults.push_back(fault(Kind::SideUnknown, first.item));
    return 0;
  }
  const int side = side_of(*first.element, legs.tool_before.exact());
  ContourNotice notice{ContourNotice::Kind::SideChosen, first.item};
  notice.side = side > 0 ? Side::Left : Side::Right;
  out.notices.push_back(notice);
  return side;
}

Shifts shifts_for(const ContourLegs& legs, int side) {
  Shifts shifts;
  for (const Rational& step : legs.steps)
    shifts.push_back(sgn(step) == 0 ? nullptr : shared(side * step));
  return shifts;
}

/// Motion along a line: +1 with its direction, −1 against it. Exact: both points lie on the line,
/// and correctly rounded doubles that differ are ordered as the exact coordinates.
int motion_along(const Line& line, const Point& from, const Point& to) {
  const UnitVector d = line.direction();
  const bool by_x = abs(d.x()) > abs(d.y());
  const double way = by_x ? to.x() - from.x() : to.y() - from.y();
  const int heading = by_x ? sgn(d.x()) : sgn(d.y());
  return way > 0 ? heading : way < 0 ? -heading : 0;
}

bool goes_nowhere(const Leg& leg, const Point& from, const Point& to) {
  return !leg.full_circle && indistinct(from, to);
}

/// Legs to moves for one set of shifts.
class Path {
 public:
  Path(const ContourLegs& legs, const Shifts& shifts, const ContourOptions& options,
       bool equidistant)
      : legs_(legs), shifts_(shifts), options_(options), equidistant_(equidistant) {}

  std::vector<Move> run() {
    // Which elements the offset eats is known before any joint is placed on them.
    for (const Leg& leg : legs_.legs)
      if (leg.travel == Leg::Travel::Along) check_survival(leg.element);
    for (const Joint& joint : legs_.joints) place(joint);
    if (!faults.empty()) return {};
    std::vector<Move> moves;
    moves.reserve(legs_.legs.size());
    stands_ = points_.front();
    for (const Leg& leg : legs_.legs) emit(leg, moves);
    return moves;
  }

  [[nodiscard]] const Point& end() const { return stands_; }

  std::vector<ContourFault> faults;
  std::vector<ContourNotice> notices;

 private:
  bool eaten(const UsedElement& used) const {
    const RationalPtr& shift = shifts_[used.step];
    const auto* circle = std::get_if<Circle>(used.element.get());
    return shift && circle && !circle->survives_offset(*shift);
  }

  void check_survival(const UsedElement& used) {
    if (!eaten(used)) return;
    const auto& circle = std::get<Circle>(*used.element);
    report(Kind::Eaten, used.item,
           nearest_double(Rational(abs(*shifts_[used.step]) - abs(circle.radius()))));
  }

  void place(const Joint& joint) {
    // Programmed joints are known; only the offset moves them.
    if (!equidistant_ || std::holds_alternative<FixedJoint>(joint.rule)) {
      points_.push_back(joint.programmed);
      return;
    }
    if (rests_on_eaten(joint)) {
      points_.push_back(joint.programmed);
      return;
    }
    PlacedJoint placed = place_joint(joint, shifts_, options_);
    if (placed.fault) {
      placed.fault->on_equidistant = true;
      faults.push_back(*placed.fault);
    }
    if (placed.notice) {
      placed.notice->on_equidistant = true;
      notices.push_back(*placed.notice);
    }
    points_.push_back(placed.at.value_or(joint.programmed));
  }

  /// An eaten element may only bound another: it is reported here then.
  bool rests_on_eaten(const Joint& joint) {
    const auto check = [this](const UsedElement& used) {
      if (!eaten(used)) return false;
      const bool known = std::any_of(faults.begin(), faults.end(), [&](const ContourFault& f) {
        return f.kind == Kind::Eaten && f.item == used.item;
      });
      if (!known) check_survival(used);
      return true;
    };
    return std::visit(
        [&](const auto& rule) {
          if constexpr (requires { rule.a; })
            return static_cast<bool>(check(rule.a) | check(rule.b));
          else if constexpr (requires { rule.on; })
            return check(rule.on);
          else
            return false;
        },
        joint.rule);
  }

  void emit(const Leg& leg, std::vector<Move>& moves) {
    if (leg.travel == Leg::Travel::Stop) {
      emit_stop(leg, moves);
      return;
    }
    const Point& to = points_[leg.to];
    const bool along = leg.travel == Leg::Travel::Along;
    const bool on_line = !along || std::holds_alternative<Line>(*leg.element.element);
    if (goes_nowhere(leg, stands_, to)) {
      if (!on_line) report(Kind::ZeroArc, leg.element.item);
      return;
    }
    Move& move = moves.emplace_back();
    move.kind = leg.rapid ? MoveKind::Rapid : on_line ? MoveKind::Line : MoveKind::Arc;
    move.role = leg.role;
    move.full_circle = leg.full_circle;
    move.from = stands_;
    move.to = to;
    if (along) move.carrier = {leg.element.element, shifts_[leg.element.step]};
    move.z = leg.z;
    move.feed = leg.feed;
    move.source = leg.place;
    if (along) check_motion(leg, move);
    stands_ = to;
  }

  void emit_stop(const Leg& leg, std::vector<Move>& moves) const {
    Move& move = moves.emplace_back();
    move.kind = leg.seconds ? MoveKind::Dwell : MoveKind::Code;
    move.from = move.to = stands_;
    move.seconds = leg.seconds;
    move.code = leg.code;
    move.source = leg.place;
  }

  /// The offset may turn a leg over: then it has eaten it, although all joints exist.
  void check_motion(const Leg& leg, const Move& move) {
    if (!equidistant_ || leg.full_circle) return;
    const Point& from = legs_.joints[leg.from].programmed;
    const Point& to = legs_.joints[leg.to].programmed;
    if (const auto* line = std::get_if<Line>(leg.element.element.get())) {
      const int now = motion_along(*line, move.from, move.to);
      const int programmed = indistinct(from, to) ? 1 : motion_along(*line, from, to);
      if (now != programmed) {
        report(Kind::Eaten, leg.element.item, dgt::length(move));
      } else if (now < 0) {
        ContourNotice notice{ContourNotice::Kind::AgainstDirection, leg.element.item};
        notice.on_equidistant = true;
        notices.push_back(notice);
      }
      return;
    }
    // The sweep changes continuously with the offset and by far less than half a turn, so a change
    // of more than half a turn is the jump of 360° at a sweep of 0.
    const auto& circle = std::get<Circle>(*leg.element.element);
    const double before = coarse_sweep(circle, from, to);
    const double after = coarse_sweep(circle, move.from, move.to);
    if (std::fabs(after - before) > 180) report(Kind::Eaten, leg.element.item, 0);
  }

  void report(Kind kind, std::size_t item, double measure = 0) {
    ContourFault f = fault(kind, item, measure);
    f.on_equidistant = equidistant_;
    faults.push_back(f);
  }

  const ContourLegs& legs_;
  const Shifts& shifts_;
  const ContourOptions& options_;
  bool equidistant_;
  std::vector<Point> points_;
  Point stands_;
};

// --- what would work --------------------------------------------------------------------------

/// The stretch of legs that a fault speaks of, with the joints between them.
ContourLegs stretch_of(const ContourLegs& legs, const ContourFault& f) {
  std::size_t first = legs.legs.size();
  std::size_t last = 0;
  for (std::size_t i = 0; i < legs.legs.size(); ++i) {
    const Leg& leg = legs.legs[i];
    const bool named = leg.travel == Leg::Travel::Along &&
                       (leg.element.item == f.item || leg.element.item == f.other);
    if (!named) continue;
    first = std::min(first, i);
    last = i;
  }
  if (first > last) {  // the elements only bound others
    first = 0;
    last = legs.legs.size() - 1;
  }
  ContourLegs part;
  part.steps = legs.steps;
  const std::size_t base = legs.legs[first].from;
  for (std::size_t j = base; j <= legs.legs[last].to; ++j) part.joints.push_back(legs.joints[j]);
  for (std::size_t i = first; i <= last; ++i) {
    Leg& leg = part.legs.emplace_back(legs.legs[i]);
    leg.from -= base;
    leg.to -= base;
  }
  return part;
}

/// The largest offset below the programmed one with which the stretch works: bisection over whole
/// steps, each tried exactly. The programmed contour works, so 0 does.
std::optional<Rational> largest_working_offset(const ContourLegs& legs, const ContourFault& f,
                                               int side, const ContourOptions& options) {
  const auto programmed =
      std::find_if(legs.steps.begin(), legs.steps.end(), [](const auto& s) { return sgn(s) != 0; });
  const Rational full = *programmed;
  ContourLegs part = stretch_of(legs, f);
  const auto works = [&](const Integer& steps) {
    const Rational scale = Rational(steps) / (kOffsetStepsPerMillimetre * abs(full));
    for (std::size_t i = 0; i < legs.steps.size(); ++i) part.steps[i] = scale * legs.steps[i];
    const Shifts shifts = shifts_for(part, side);
    Path path(part, shifts, options, true);
    path.run();
    return path.faults.empty();
  };
  Integer good = 0;
  Integer bad = nearest_integer(kOffsetStepsPerMillimetre * abs(full)) + 1;
  while (bad - good > 1) {
    const Integer middle = (good + bad) / 2;
    (works(middle) ? good : bad) = middle;
  }
  if (good == 0) return std::nullopt;
  const Rational found = Rational(good) / kOffsetStepsPerMillimetre;
  return sgn(full) < 0 ? Rational(-found) : found;
}

/// What is cut as part: without leads and rapids.
bool is_part(const Move& move) {
  if (!move.cuts()) return false;
  return move.role == Role::Contour || move.role == Role::Fillet || move.role == Role::Chamfer ||
         move.role == Role::Tangent;
}

/// Whether `p` lies on the stretch that `move` covers. The carrier is decided exactly; along it
/// doubles order points whose exact positions they round.
bool covers(const Move& move, const Point& p) {
  if (!move.carrier.base || !lies_on(move.carrier.element(), p)) return false;
  if (move.kind == MoveKind::Line) {
    const auto between = [](double a, double b, double x) {
      return std::min(a, b) <= x && x <= std::max(a, b);
    };
    return between(move.from.x(), move.to.x(), p.x()) && between(move.from.y(), move.to.y(), p.y());
  }
  const Circle circle = move.circle();
  return move.full_circle || std::fabs(coarse_sweep(circle, move.from, p)) <=
                                 std::fabs(coarse_sweep(circle, move.from, move.to));
}

/// Ends where it began, or meets its own first or last stretch: what lies beyond is lead.
bool is_closed(const std::vector<Move>& programmed) {
  const Move* first = nullptr;
  const Move* last = nullptr;
  for (const Move& move : programmed) {
    if (!is_part(move)) continue;
    if (!first) first = &move;
    last = &move;
  }
  if (!first) return false;
  if (first == last) return first->full_circle;
  return first->from == last->to || covers(*first, last->to) || covers(*last, first->from);
}

}  // namespace

BuiltContour build_contour(const std::vector<ContourItem>& items, ToolState& state,
                           const ContourOptions& options) {
  BuiltContour out;
  ContourLegs legs = lay_out(items, state, options);
  out.offset = legs.steps.front();
  out.notices = std::move(legs.notices);
  out.faults = std::move(legs.faults);

  const bool offset = any_offset(legs) && legs.first_element;
  int side = 0;
  if (offset) {
    side = side_of_offset(legs, options, out);
    const int of_w = side * (sgn(out.offset) < 0 ? -1 : 1);
    out.side = of_w > 0 ? Side::Left : of_w < 0 ? Side::Right : Side::None;
  }
  const Point end = legs.joints.back().programmed;
  if (out.faults.empty()) {
    const Shifts none(legs.steps.size());
    Path programmed(legs, none, options, false);
    out.programmed = programmed.run();
    out.faults = std::move(programmed.faults);
    out.closed = is_closed(out.programmed);
  }
  state.at = end;
  if (out.faults.empty() && !offset) {
    out.moves = out.programmed;
  } else if (out.faults.empty()) {
    const Shifts shifts = shifts_for(legs, side);
    Path equidistant(legs, shifts, options, true);
    out.moves = equidistant.run();
    out.faults = std::move(equidistant.faults);
    for (ContourFault& f : out.faults)
      f.largest_offset = largest_working_offset(legs, f, side, options);
    out.notices.insert(out.notices.end(), equidistant.notices.begin(), equidistant.notices.end());
    if (out.faults.empty()) state.at = equidistant.end();
  }
  for (const Move& move : out.moves) state.moved = state.moved || move.travels();
  return out;
}

}  // namespace dgt
