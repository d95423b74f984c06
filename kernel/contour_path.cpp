// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/contour_path.h"

#include <algorithm>
#include <cmath>

#include "kernel/stretch.h"

namespace dgt {
namespace {

using Kind = ContourFault::Kind;

bool goes_nowhere(const Leg& leg, const Point& from, const Point& to) {
  return !leg.full_circle && indistinct(from, to);
}

}  // namespace

// Exact: both points lie on the line,
// and correctly rounded doubles that differ are ordered as the exact coordinates.
int motion_along(const Line& line, const Point& from, const Point& to) {
  const UnitVector d = line.direction();
  const bool by_x = abs(d.x()) > abs(d.y());
  const double way = by_x ? to.x() - from.x() : to.y() - from.y();
  const int heading = by_x ? sgn(d.x()) : sgn(d.y());
  return way > 0 ? heading : way < 0 ? -heading : 0;
}

Shifts shifts_for(const ContourLegs& legs, int side) {
  Shifts shifts;
  for (const Rational& step : legs.steps)
    shifts.push_back(sgn(step) == 0 ? nullptr : shared(side * step));
  return shifts;
}

std::vector<Move> Path::run() {
  // Which elements the offset eats is known before any joint is placed on them.
  for (const Leg& leg : legs_.legs)
    if (leg.travel == Leg::Travel::Along) check_survival(leg.element);
  for (const Joint& joint : legs_.joints) place(joint);
  if (!faults.empty()) return {};
  std::vector<Move> moves;
  moves.reserve(legs_.legs.size());
  stands_ = places_.front().leave;
  for (const Leg& leg : legs_.legs) emit(leg, moves);
  return moves;
}

bool Path::eaten(const UsedElement& used) const {
  const RationalPtr& shift = shifts_[used.step];
  const auto* circle = std::get_if<Circle>(used.element.get());
  return shift && circle && !circle->survives_offset(*shift);
}

void Path::check_survival(const UsedElement& used) {
  if (!eaten(used)) return;
  const auto& circle = std::get<Circle>(*used.element);
  report(Kind::Eaten, used.item,
         nearest_double(Rational(abs(*shifts_[used.step]) - abs(circle.radius()))));
}

void Path::place(const Joint& joint) {
  // Programmed joints are known; only the offset moves them.
  if (!equidistant_ || std::holds_alternative<FixedJoint>(joint.rule)) {
    places_.push_back({joint.programmed, joint.programmed});
    return;
  }
  if (rests_on_eaten(joint)) {
    places_.push_back({joint.programmed, joint.programmed});
    return;
  }
  if (is_outer_corner(joint, shifts_)) return place_corner(joint);
  PlacedJoint placed = place_joint(joint, shifts_, options_);
  if (placed.fault) {
    placed.fault->on_equidistant = true;
    faults.push_back(*placed.fault);
  }
  if (placed.notice) {
    placed.notice->on_equidistant = true;
    notices.push_back(*placed.notice);
  }
  const Point at = placed.at.value_or(joint.programmed);
  places_.push_back({at, at});
}

void Path::place_corner(const Joint& joint) {
  PlacedJoint placed = place_joint(joint, shifts_, options_);
  if (auto round = path_round(joint, shifts_, placed.at, options_)) {
    const bool begins = joint.turn.begins;
    places_.push_back({begins ? round->end : round->begin, round->end,
                       begins ? std::nullopt : std::optional(round->carrier)});
    return;
  }
  const Point at = placed.at.value_or(joint.programmed);
  places_.push_back({at, at});
  if (placed.fault) {
    placed.fault->on_equidistant = true;
    placed.fault->round_works = true;  // as far as this corner goes
    faults.push_back(*placed.fault);
  }
  if (placed.notice) {
    placed.notice->on_equidistant = true;
    notices.push_back(*placed.notice);
  }
  if (placed.fault || joint.turn.begins || !is_long_corner(joint, shifts_, at, options_)) return;
  const auto& rule = std::get<CrossJoint>(joint.rule);
  ContourNotice notice{ContourNotice::Kind::LongCorner, rule.a.item, rule.b.item};
  notice.measure = std::hypot(at.x() - joint.programmed.x(), at.y() - joint.programmed.y());
  notice.on_equidistant = true;
  notice.x = at.x();
  notice.y = at.y();
  notices.push_back(notice);
}

/// An eaten element may only bound another: it is reported here then.
bool Path::rests_on_eaten(const Joint& joint) {
  const auto check = [this](const UsedElement& used) {
    if (!eaten(used)) return false;
    const bool known = std::any_of(faults.begin(), faults.end(), [&](const ContourFault& f) {
      return f.kind == Kind::Eaten && f.item == used.item;
    });
    if (!known) check_survival(used);
    return true;
  };
  const auto check_both = [&](const UsedElement& a, const UsedElement& b) {
    const bool first = check(a);
    return check(b) || first;  // both are reported
  };
  return std::visit(
      [&](const auto& rule) {
        if constexpr (requires { rule.a; })
          return check_both(rule.a, rule.b);
        else if constexpr (requires { rule.on; })
          return check(rule.on);
        else
          return false;
      },
      joint.rule);
}

void Path::emit(const Leg& leg, std::vector<Move>& moves) {
  if (leg.travel == Leg::Travel::Stop) {
    emit_stop(leg, moves);
    return;
  }
  const Point& to = places_[leg.to].arrive;
  const bool along = leg.travel == Leg::Travel::Along;
  const bool on_line = !along || std::holds_alternative<Line>(*leg.element.element);
  // An arc whose ends come together by growing has become a full turn: the tool just fits.
  const bool full_turn = !on_line && goes_nowhere(leg, stands_, to) && grows(leg);
  if (goes_nowhere(leg, stands_, to) && !full_turn) {
    if (!on_line) report(Kind::ZeroArc, leg.element.item);
    return emit_turn(leg, moves);
  }
  Move& move = moves.emplace_back();
  move.kind = leg.rapid ? MoveKind::Rapid : on_line ? MoveKind::Line : MoveKind::Arc;
  move.role = leg.role;
  move.full_circle = leg.full_circle || full_turn;
  move.from = stands_;
  move.to = full_turn ? stands_ : to;
  if (along) move.carrier = {leg.element.element, shifts_[leg.element.step]};
  move.z = leg.z;
  move.feed = leg.feed;
  move.source = leg.place;
  if (along) check_motion(leg, move);
  stands_ = move.to;
  leg_of_move.push_back(static_cast<std::size_t>(&leg - legs_.legs.data()));
  emit_turn(leg, moves);
}

/// Round the corner at the end of a leg. It belongs to the word behind it, which makes the corner.
void Path::emit_turn(const Leg& leg, std::vector<Move>& moves) {
  const Place& place = places_[leg.to];
  if (!place.turn || leg.travel != Leg::Travel::Along) return;
  const Leg* const next = beside(leg, +1);
  Move& move = moves.emplace_back();
  move.kind = place.turn->is_line() ? MoveKind::Line : MoveKind::Arc;
  move.role = Role::Corner;
  move.from = stands_;
  move.to = place.leave;
  move.carrier = *place.turn;
  move.feed = leg.feed;
  move.source = next ? next->place : leg.place;
  stands_ = move.to;
  leg_of_move.push_back(static_cast<std::size_t>(&leg - legs_.legs.data()));
}

/// Whether the arc of a leg would vanish by growing to a full turn rather than by shrinking.
bool Path::grows(const Leg& leg) const {
  const Point& from = legs_.joints[leg.from].programmed;
  const Point& to = legs_.joints[leg.to].programmed;
  if (!equidistant_ || indistinct(from, to)) return false;
  return std::fabs(coarse_sweep(std::get<Circle>(*leg.element.element), from, to)) > 180;
}

void Path::emit_stop(const Leg& leg, std::vector<Move>& moves) {
  leg_of_move.push_back(static_cast<std::size_t>(&leg - legs_.legs.data()));
  Move& move = moves.emplace_back();
  move.kind = leg.seconds ? MoveKind::Dwell : leg.z ? MoveKind::Line : MoveKind::Code;
  move.from = move.to = stands_;
  move.z = leg.z;
  if (leg.z) move.feed = leg.feed;
  move.seconds = leg.seconds;
  move.code = leg.code;
  move.source = leg.place;
}

/// The offset may turn a leg over: then it has eaten it, although all joints exist.
void Path::check_motion(const Leg& leg, const Move& move) {
  if (!equidistant_) return check_blends(leg, move);
  if (move.full_circle) return;
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
  if (std::fabs(after - before) > 180)
    report(std::fabs(before) > 180 ? Kind::Overrun : Kind::ArcEaten, leg.element.item);
}

void Path::report(Kind kind, std::size_t item, double measure) {
  ContourFault f{};
  f.kind = kind;
  f.item = item;
  f.measure = measure;
  f.on_equidistant = equidistant_;
  faults.push_back(f);
}

bool covers(const Move& move, const Point& p) {
  return move.carrier.base && lies_on(move.carrier.element(), p) && covers(stretch_of(move), p);
}

}  // namespace dgt
