// SPDX-License-Identifier: GPL-3.0-or-later
//
// In doubles: what comes out is rounded to the grid of the control, and the verifier measures what
// the control makes of it.
#include "post/control_entry.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "kernel/part_crossing.h"

namespace dgt {
namespace {

using Kind = WriteFault::Kind;

/// Below, in mm, two places are one: far above the rounding of doubles, far below any unit.
constexpr double kOnePlace = 1e-9;
/// The lead may turn into the element by nearly half a turn; beyond, the place where they meet
/// moves by more than ten units for each that the lead is rounded by.
constexpr double kMostTurn = 170 * std::numbers::pi / 180;

struct Place {
  double x = 0;
  double y = 0;

  friend Place operator+(const Place& a, const Place& b) { return {a.x + b.x, a.y + b.y}; }
  friend Place operator-(const Place& a, const Place& b) { return {a.x - b.x, a.y - b.y}; }
  friend Place operator*(double k, const Place& a) { return {k * a.x, k * a.y}; }
};
double dot(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y; }
double cross(const Place& a, const Place& b) { return a.x * b.y - a.y * b.x; }
double length(const Place& a) { return std::hypot(a.x, a.y); }
Place place_of(const Point& p) { return {p.x(), p.y()}; }
Point point_of(const Place& p) { return Point(RationalPoint{Rational(p.x), Rational(p.y)}); }
/// From direction a to b, −π…π.
double turn(const Place& a, const Place& b) { return std::atan2(cross(a, b), dot(a, b)); }

/// The line or circle of a cut, with its sense of travel.
class Track {
 public:
  explicit Track(const Move& cut) : origin_(place_of(cut.from)) {
    if (cut.kind == MoveKind::Line) {
      const Place along = place_of(cut.to) - origin_;
      along_ = 1 / length(along) * along;
      return;
    }
    const Circle circle = cut.circle();
    origin_ = {nearest_double(circle.centre().x), nearest_double(circle.centre().y)};
    radius_ = std::fabs(nearest_double(circle.radius()));
    sense_ = circle.counter_clockwise() ? 1 : -1;
  }

  [[nodiscard]] Place foot(const Place& p) const {
    const Place off = p - origin_;
    if (is_line()) return origin_ + dot(off, along_) * along_;
    return origin_ + radius_ / length(off) * off;
  }
  [[nodiscard]] Place direction_at(const Place& p) const {
    if (is_line()) return along_;
    const Place off = 1 / length(p - origin_) * (p - origin_);
    return {-sense_ * off.y, sense_ * off.x};
  }
  /// Where the ray meets it nearest before `foot`; on a circle at most a quarter turn before.
  [[nodiscard]] std::optional<Place> met_by(const Place& from, const Place& way,
                                            const Place& foot) const {
    if (is_line()) return met_as_line(from, way, foot);
    const Place off = from - origin_;
    const double half = dot(off, way);
    const double under = half * half - dot(off, off) + radius_ * radius_;
    if (under < 0) return std::nullopt;
    std::optional<Place> nearest;
    double least = std::numbers::pi / 2;
    for (const double step : {-half - std::sqrt(under), -half + std::sqrt(under)}) {
      const Place met = from + step * way;
      const double before = sense_ * turn(met - origin_, foot - origin_);
      if (step <= 0 || before < -kOnePlace / radius_ || before > least) continue;
      least = before;
      nearest = met;
    }
    return nearest;
  }

 private:
  [[nodiscard]] bool is_line() const { return radius_ == 0; }

  [[nodiscard]] std::optional<Place> met_as_line(const Place& from, const Place& way,
                                                 const Place& foot) const {
    const double slope = cross(way, along_);
    if (slope == 0) return std::nullopt;
    const double step = cross(origin_ - from, along_) / slope;
    const Place met = from + step * way;
    if (step <= 0 || dot(foot - met, along_) < -kOnePlace) return std::nullopt;
    return met;
  }

  Place origin_;  ///< a place of the line, or the centre
  Place along_;
  double radius_ = 0;  ///< 0: a line
  double sense_ = 1;
};

class Entry {
 public:
  Entry(const WantedEntry& wanted, const Dialect& dialect)
      : wanted_(wanted),
        dialect_(dialect),
        track_(wanted.first),
        from_(place_of(wanted.from)),
        begin_(place_of(wanted.begin)),
        offset_(std::fabs(nearest_double(wanted.contour.offset))),
        unit_(nearest_double(dialect.unit)),
        to_tool_(wanted.left ? 1 : -1) {}

  tl::expected<Point, EntryFault> run() const {
    const Point foot = foot_on(wanted_.first, wanted_.begin, wanted_.first.from);
    // One unit more, for both ends are rounded.
    const double lead = length(place_of(foot) - from_);
    if (!(lead > offset_ + unit_)) return fault(Kind::LeadTooShort, lead, offset_);
    if (dialect_.kerf.entry == KerfEntry::Beside) return foot;
    const bool is_known = dialect_.kerf.entry == KerfEntry::Meets;
    if (!is_known && !wanted_.contour.closed) return fault(Kind::EntryUnknown);
    const double distance = length(begin_ - from_);
    if (!(distance > offset_ + unit_)) return fault(Kind::LeadTooShort, lead, 2 * offset_);
    const auto at = tangent(distance, place_of(foot));
    if (!at) return fault(Kind::EntryMissed);
    if (!is_known && !may_run_in(*at)) return fault(Kind::BeginsInCorner);
    return point_of(*at);
  }

 private:
  static tl::unexpected<EntryFault> fault(Kind kind, double measure = 0, double limit = 0) {
    return tl::unexpected(EntryFault{kind, measure, limit});
  }

  [[nodiscard]] std::optional<Place> tangent(double distance, const Place& foot) const {
    const double away = -to_tool_ * std::asin(offset_ / distance);
    const Place straight = 1 / distance * (begin_ - from_);
    const Place way{straight.x * std::cos(away) - straight.y * std::sin(away),
                    straight.x * std::sin(away) + straight.y * std::cos(away)};
    const auto at = track_.met_by(from_, way, foot);
    if (!at || !(length(*at - from_) > offset_ + unit_)) return std::nullopt;
    const double turned = to_tool_ * turn(way, track_.direction_at(*at));
    if (!(turned > 0) || turned > kMostTurn) return std::nullopt;
    return at;
  }

  /// Whether the tool may run to `begin` from beside `at`.
  [[nodiscard]] bool may_run_in(const Place& at) const {
    const Place along = track_.direction_at(at);
    const Place beside = at + to_tool_ * offset_ * Place{-along.y, along.x};
    return runs_on_equidistant(beside) || keeps_off(point_of(beside));
  }

  /// Whether the last of the equidistant comes in there.
  [[nodiscard]] bool runs_on_equidistant(const Place& beside) const {
    const Move& last = wanted_.last;
    if (!last.carrier.base) return false;
    const Place foot = Track(last).foot(beside);
    if (length(foot - beside) > kOnePlace || length(place_of(last.to) - begin_) > kOnePlace)
      return false;
    if (last.kind == MoveKind::Line)
      return length(begin_ - beside) <= length(begin_ - place_of(last.from));
    const Circle circle = last.circle();
    const Place centre{nearest_double(circle.centre().x), nearest_double(circle.centre().y)};
    const double sense = circle.counter_clockwise() ? 1 : -1;
    const double before = sense * turn(beside - centre, begin_ - centre);
    return before * 180 / std::numbers::pi <= std::fabs(sweep_degrees(last));
  }

  [[nodiscard]] bool keeps_off(const Point& beside) const {
    if (wanted_.first.kind != MoveKind::Line) return false;
    Toolpath tried;
    tried.start = wanted_.path.start;
    tried.contours = wanted_.path.contours;
    tried.moves = wanted_.path.moves;
    Contour& added = tried.contours.emplace_back(wanted_.contour);
    added.programmed.emplace();
    added.first = tried.moves.size();
    Move move;
    move.role = Role::LeadIn;
    move.from = wanted_.from;
    for (const Point& to : {beside, wanted_.begin}) {
      move.to = to;
      tried.moves.push_back(move);
      move.from = to;
    }
    added.last = tried.moves.size();
    for (const PartCrossing& crossing :
         find_part_crossings(tried, CrossingMoves::Leads, Rational(0)))
      if (crossing.move >= added.first) return false;
    return true;
  }

  const WantedEntry& wanted_;
  const Dialect& dialect_;
  Track track_;
  Place from_;
  Place begin_;
  double offset_;
  double unit_;
  double to_tool_;  ///< +1: the tool is on the left
};

}  // namespace

tl::expected<Point, EntryFault> control_entry(const WantedEntry& wanted, const Dialect& dialect) {
  return Entry(wanted, dialect).run();
}

Point foot_on(const Move& cut, const Point& at, const Point& beside) {
  const Place foot = Track(cut).foot(place_of(at));
  return length(foot - place_of(beside)) <= kOnePlace ? beside : point_of(foot);
}

}  // namespace dgt
