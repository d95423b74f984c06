// SPDX-License-Identifier: GPL-3.0-or-later
//
// The moves of the exact path are taken one after the other. The *front* holds every stop of the
// program that may be the end of the moves so far; each move leads from the front before it to a
// new one. Where the new one would be empty something is wrong: the likeliest reading is taken,
// reported, and followed in two ways, with the program back on the path (absolute positions) and
// with all that follows displaced alike (increments).
#include "apps/driver/path_match.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dgt {
namespace {

/// Stops of the program that are tried for one exact stop.
constexpr std::size_t kMostPieces = 4096;
/// The same behind a fault.
constexpr std::size_t kMostProbed = 64;
/// A stop this many units away is still taken for the one meant.
constexpr double kFarUnits = 25;
/// What leaving out a move has to be better by, in units, to be the likelier reading of a fault.
constexpr double kOmission = 2;

/// The moves that travel in the plane, by their indices.
std::vector<std::size_t> travelling(const std::vector<Move>& moves) {
  std::vector<std::size_t> indices;
  indices.reserve(moves.size());
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const Move& move = moves[i];
    if (move.travels() && (move.full_circle || !(move.from == move.to))) indices.push_back(i);
  }
  return indices;
}

/// A stop of the program that may end the moves so far.
struct State {
  std::size_t stop = 0;       ///< travelling moves of the program done
  std::size_t before = 0;     ///< index of the state it was reached from
  std::size_t displaced = 0;  ///< index into the displacements
  double deviation = 0;
  double slack = 0;  ///< how far the stop lies beyond its limit, mm
};

/// How far a stop may be off on each axis.
struct StopReach {
  explicit StopReach(Rational most)
      : exact(std::move(most)),
        value(nearest_double(exact)),
        diagonal(std::nextafter(value * std::sqrt(2.0), 2 * value)) {}
  Rational exact;
  double value;
  double diagonal;  ///< the corner of that box lies this far away
};

class Matcher {
 public:
  Matcher(const Toolpath& program, const Toolpath& exact, const MatchOptions& options)
      : program_(program),
        exact_(exact),
        options_(options),
        unit_(nearest_double(options.unit)),
        limit_(nearest_double(options.limit)),
        half_{options.unit / 2},
        loose_{options.limit},
        written_(travelling(program.moves)),
        meant_(travelling(exact.moves)) {}

  PathMatch run() {
    begin();
    fronts_.push_back(0);
    states_.push_back({0, 0, 0, 0, start_slack_});
    bool lost = false;
    for (done_ = 0; done_ < meant_.size() && !lost; ++done_) {
      tell_progress(options_.on_progress, done_, meant_.size());
      const std::size_t front = fronts_.back();
      const std::size_t end = states_.size();
      fronts_.push_back(end);
      curve_ = curve_of(move(done_), {});
      for (std::size_t s = front; s < end; ++s) advance(s);
      if (states_.size() == end) lost = !explain(front, end);
    }
    finish(lost);
    return std::move(match_);
  }

 private:
  const Move& move(std::size_t meant) const { return exact_.moves[meant_[meant]]; }
  const Move& written(std::size_t stop) const { return program_.moves[written_[stop]]; }

  const StopReach& reach() const { return reach(done_); }
  const StopReach& reach(std::size_t meant) const {
    const auto& led = options_.offset_by_control;
    return !led.empty() && meant < meant_.size() && led[meant_[meant]] ? loose_ : half_;
  }

  // --- where the program begins

  void begin() {
    const Point origin{program_.start};
    const bool fits = is_near(Point(program_.start), Point(exact_.start), {});
    // A program of increments knows no place of its own and is read from X0 Y0.
    if (!fits && program_.start == RationalPoint{}) match_.shift = exact_.start;
    displacements_.push_back(match_.shift);
    shifts_.push_back(place_of(match_.shift));
    if (fits || program_.start == RationalPoint{}) return;
    MatchFault fault{};
    fault.kind = MatchFault::Kind::Start;
    fault.dx = origin.x() - nearest_double(exact_.start.x);
    fault.dy = origin.y() - nearest_double(exact_.start.y);
    match_.faults.push_back(fault);
    start_slack_ = std::hypot(fault.dx, fault.dy);
  }

  // --- stops

  /// |a + shift − b| ≤ the reach on one axis, exactly; p and q are the two in doubles.
  bool is_near_on_axis(double p, double q, const Rational& shift, const Point& a, const Point& b,
                       OneRoot ExactPoint::*axis) const {
    const double moved = sgn(shift) == 0 ? 0 : nearest_double(shift);
    const double off = std::fabs(p + moved - q);
    // Each number is the nearest to its exact value, and so is each sum.
    const double doubt = (std::fabs(p) + std::fabs(q) + std::fabs(moved)) * 0x1p-50 + 0x1p-60;
    if (off + doubt <= reach().value) return true;
    if (off - doubt > reach().value) return false;
    const OneRoot at = a.exact().*axis + shift;
    const OneRoot meant = b.exact().*axis;
    return compare(at, meant + reach().exact) <= 0 && compare(at + reach().exact, meant) >= 0;
  }

  bool is_near(const Point& p, const Point& q, const RationalPoint& shift) const {
    return is_near_on_axis(p.x(), q.x(), shift.x, p, q, &ExactPoint::x) &&
           is_near_on_axis(p.y(), q.y(), shift.y, p, q, &ExactPoint::y);
  }

  Point stop_of(std::size_t stop) const {
    return stop == 0 ? Point(program_.start) : written(stop - 1).to;
  }

  bool same_kind(const Move& p, const Move& q) const {
    return !options_.tells_cuts || p.cuts() == q.cuts();
  }

  // --- one move on

  /// All the stops that may end the move, from the state `from`.
  void advance(std::size_t from) {
    const State state = states_[from];
    const Move& meant = move(done_);
    const RationalPoint& shift = displacements_[state.displaced];
    const double limit = limit_ + state.slack;
    leave_out(state, from, limit);
    CurveSpot spot{curve_.from, 0};
    double worst = 0;
    for (std::size_t k = 1; k <= kMostPieces && state.stop + k <= written_.size(); ++k) {
      const Move& piece = written(state.stop + k - 1);
      if (!same_kind(piece, meant)) return;
      const Curve curve = curve_of(piece, shifts_[state.displaced]);
      const bool is_end = is_near(piece.to, meant.to, shift);
      if (is_end) {
        const double bound =
            std::max(worst, frechet_bound(curve, part(curve_, spot, {curve_.to, 1})));
        if (bound <= limit) states_.push_back({state.stop + k, from, state.displaced, bound, 0});
        if (!may_go_on(state.stop + k, meant.to)) return;
      }
      const auto next = stop_beside(curve.to, spot, reach().diagonal);
      if (!next) return;
      worst = std::max(worst, frechet_bound(curve, part(curve_, spot, *next)));
      if (!(worst <= limit)) return;
      spot = *next;
    }
  }

  void leave_out(const State& state, std::size_t from, double limit) {
    const RationalPoint& shift = displacements_[state.displaced];
    if (!is_near(stop_of(state.stop), move(done_).to, shift)) return;
    const double bound = frechet_bound(resting(state), curve_);
    if (bound <= limit) states_.push_back({state.stop, from, state.displaced, bound, state.slack});
  }

  /// A program that stays where it is.
  Curve resting(const State& state) const {
    Curve curve;
    curve.from = curve.to = place_of(stop_of(state.stop)) + shifts_[state.displaced];
    return curve;
  }

  /// Whether the next stop may be the end as well: it is at most a unit away then.
  bool may_go_on(std::size_t stop, const Point& end) const {
    if (stop >= written_.size()) return false;
    const Point& next = written(stop).to;
    const Point& here = stop_of(stop);
    const double far = unit_ * 1.5;
    return (std::fabs(next.x() - here.x()) <= far && std::fabs(next.y() - here.y()) <= far) ||
           (move(done_).full_circle && here == end);
  }

  /// The place of the exact move beside a stop inside it.
  std::optional<CurveSpot> stop_beside(const BallPlace& at, const CurveSpot& last,
                                       double limit) const {
    const long double along = progress(curve_, at);
    if (along < last.along || along >= 1) return std::nullopt;
    auto beside = foot(curve_, at);
    if (!beside || distance_bound(at, *beside) > limit) return std::nullopt;
    return CurveSpot{*std::move(beside), along};
  }

  // --- what is wrong

  /// A reading of the program where no proper one is left.
  struct Reading {
    double score = std::numeric_limits<double>::infinity();
    std::size_t from = 0;  ///< state
    std::size_t pieces = 0;
    double dx = 0, dy = 0;
    double deviation = 0;
    std::size_t first_off = 0;  ///< pieces up to the first stop beside the path; 0: none
  };

  /// Reports it and puts the states to go on from into the front; false when there are none.
  bool explain(std::size_t front, std::size_t end) {
    if (match_.faults.size() >= kMaxMatchFaults) return false;
    Reading best;
    for (std::size_t s = front; s < end; ++s) probe(s, best);
    if (!(best.score < std::numeric_limits<double>::infinity())) {
      report_lost(states_[front]);
      return false;
    }
    report(best);
    go_on(best);
    return true;
  }

  void probe(std::size_t from, Reading& best) const {
    const State state = states_[from];
    Reading reading;
    reading.from = from;
    weigh(reading, state, resting(state), kOmission, best);
    CurveSpot spot{curve_.from, 0};
    double worst = 0;
    for (std::size_t k = 1; k <= kMostProbed && state.stop + k <= written_.size(); ++k) {
      const Move& piece = written(state.stop + k - 1);
      if (!same_kind(piece, move(done_))) return;
      const Curve curve = curve_of(piece, shifts_[state.displaced]);
      reading.pieces = k;
      reading.deviation = std::max(worst, frechet_bound(curve, part(curve_, spot, {curve_.to, 1})));
      weigh(reading, state, curve, piece.kind == move(done_).kind && k == 1 ? 0 : 0.25, best);
      const auto next = stop_beside(curve.to, spot, kFarUnits * unit_);
      if (!next) return;
      if (reading.first_off == 0 && distance_bound(curve.to, next->at) > reach().diagonal)
        reading.first_off = k;
      worst = std::max(worst, frechet_bound(curve, part(curve_, spot, *next)));
      spot = *next;
    }
  }

  void weigh(Reading reading, const State& state, const Curve& last, double handicap,
             Reading& best) const {
    if (reading.pieces == 0) reading.deviation = frechet_bound(last, curve_);
    reading.dx = static_cast<double>(last.to.x.mid - curve_.to.x.mid);
    reading.dy = static_cast<double>(last.to.y.mid - curve_.to.y.mid);
    const double off = std::max(std::fabs(reading.dx), std::fabs(reading.dy)) / unit_;
    // A single block of the right kind is believed wherever it goes, once.
    const bool is_plain =
        reading.pieces == 1 && state.slack == 0 && written(state.stop).kind == move(done_).kind;
    if (off > kFarUnits && !is_plain) return;
    reading.score = off + reading.deviation / unit_ + handicap;
    if (reading.score < best.score) best = reading;
  }

  void report(const Reading& reading) {
    const State& state = states_[reading.from];
    MatchFault fault{};
    fault.exact = meant_[done_];
    std::size_t stop = state.stop + std::max<std::size_t>(reading.pieces, 1);
    if (reading.first_off != 0) stop = state.stop + reading.first_off;
    stop = std::min(stop, written_.size());
    const bool is_off = !is_near(stop_of(state.stop + reading.pieces), move(done_).to,
                                 displacements_[state.displaced]);
    fault.kind = is_off ? MatchFault::Kind::Displaced : MatchFault::Kind::Deviates;
    fault.dx = reading.dx;
    fault.dy = reading.dy;
    fault.measure = reading.deviation;
    const std::size_t last = stop == 0 ? 0 : stop - 1;
    fault.last = written_.empty() ? 0 : written_[last];
    fault.first = is_off ? written_[earliest(reading, last)] : fault.last;
    match_.faults.push_back(fault);
  }

  /// The least whole number of units by which the stop has to move back on each axis.
  RationalPoint whole_units(const Reading& reading) const {
    const State& state = states_[reading.from];
    const RationalPoint& shift = displacements_[state.displaced];
    const Point at = stop_of(state.stop + reading.pieces);
    const Point& meant = move(done_).to;
    return {whole_units(reading.dx, shift.x, at.x(), meant.x(), at, meant, &ExactPoint::x),
            whole_units(reading.dy, shift.y, at.y(), meant.y(), at, meant, &ExactPoint::y)};
  }

  Rational whole_units(double off, const Rational& shift, double p, double q, const Point& at,
                       const Point& meant, OneRoot ExactPoint::*axis) const {
    const Rational step = off < 0 ? Rational(-options_.unit) : options_.unit;
    const Integer about(std::floor(std::fabs(off) / unit_));
    Rational units = step * Rational(about > 0 ? Integer(about - 1) : about);
    while (!is_near_on_axis(p, q, shift - units, at, meant, axis)) units += step;
    return units;
  }

  /// An increment that is wrong shows at the first stop that is not half-way between two grid
  /// points, or not inside a divided arc. Goes back to the first stop that may be displaced as
  /// well.
  std::size_t earliest(const Reading& reading, std::size_t last) const {
    const RationalPoint units = whole_units(reading);
    if (units == RationalPoint{}) return last;
    const State& state = states_[reading.from];
    const RationalPoint back = displacements_[state.displaced] - units;
    const BallPlace shift = place_of(back);
    while (last > state.stop) {
      const BallPlace at = place_of(stop_of(last)) + shift;
      const auto beside = foot(curve_, at);
      if (!beside || distance_bound(at, *beside) > reach().diagonal) return last;
      --last;
    }
    std::size_t s = reading.from;
    for (std::size_t meant = done_; meant > 0 && last > 0; --meant) {
      const State& before = states_[s];
      if (before.stop != last || !is_near(stop_of(last), move(meant - 1).to, back) ||
          is_rounded_away(stop_of(last), units))
        return last;
      last = states_[before.before].stop;
      s = before.before;
    }
    return last;
  }

  /// Of two places half a unit away from the one meant, writers take the one further from the
  /// origin: `at` is that, and not `at` − `units`.
  static bool is_rounded_away(const Point& at, const RationalPoint& units) {
    const auto larger = [](double p, const Rational& by) {
      return sgn(by) == 0 || (p > 0) == (sgn(by) > 0);
    };
    return larger(at.x(), units.x) && larger(at.y(), units.y);
  }

  void go_on(const Reading& reading) {
    const State state = states_[reading.from];
    const std::size_t stop = state.stop + reading.pieces;
    const double off = std::hypot(reading.dx, reading.dy);
    states_.push_back({stop, reading.from, state.displaced, reading.deviation, off});
    const RationalPoint units = whole_units(reading);
    if (units == RationalPoint{}) return;
    const RationalPoint displaced = displacements_[state.displaced] - units;
    const auto known = std::find(displacements_.begin(), displacements_.end(), displaced);
    const auto index = static_cast<std::size_t>(known - displacements_.begin());
    if (known == displacements_.end()) {
      displacements_.push_back(displaced);
      shifts_.push_back(place_of(displaced));
    }
    states_.push_back({stop, reading.from, index, reading.deviation, 0});
  }

  void report_lost(const State& state) {
    MatchFault fault{};
    fault.exact = meant_[done_];
    fault.kind = MatchFault::Kind::Lost;
    if (state.stop >= written_.size()) {
      fault.kind = MatchFault::Kind::Ended;
    } else if (!same_kind(written(state.stop), move(done_))) {
      fault.kind = MatchFault::Kind::WrongKind;
    }
    if (!written_.empty())
      fault.first = fault.last = written_[std::min(state.stop, written_.size() - 1)];
    match_.faults.push_back(fault);
  }

  // --- the end

  void finish(bool lost) {
    if (lost) fronts_.pop_back();
    std::size_t best = fronts_.back();
    for (std::size_t s = best; s < states_.size(); ++s)
      if (states_[s].stop > states_[best].stop) best = s;
    const std::size_t matched = fronts_.size() - 1;
    match_.is_complete = !lost && states_[best].stop == written_.size();
    if (!lost && !match_.is_complete) {
      MatchFault fault{};
      fault.kind = MatchFault::Kind::Surplus;
      fault.exact = exact_.moves.size();
      fault.first = fault.last = written_[states_[best].stop];
      match_.faults.push_back(fault);
    }
    trace(best, matched);
  }

  void trace(std::size_t s, std::size_t matched) {
    match_.moves.resize(matched);
    for (std::size_t m = matched; m > 0; --m) {
      const State& state = states_[s];
      const std::size_t before = states_[state.before].stop;
      MatchedMove& one = match_.moves[m - 1];
      one.exact = meant_[m - 1];
      one.deviation = state.deviation;
      one.first = before < written_.size() ? written_[before] : program_.moves.size();
      one.last = state.stop > before ? written_[state.stop - 1] + 1 : one.first;
      const BallPlace off = place_of(stop_of(state.stop)) + shifts_[0] - place_of(move(m - 1).to);
      one.error_x = error_bound(off.x);
      one.error_y = error_bound(off.y);
      if (state.displaced == 0 && state.slack == 0) {  // decided exactly already
        one.error_x = std::min(one.error_x, reach(m - 1).value);
        one.error_y = std::min(one.error_y, reach(m - 1).value);
      }
      s = state.before;
    }
  }

  static double error_bound(const Ball& off) {
    const auto bound = static_cast<double>(std::fabs(off.mid) + off.rad * 2);
    return std::nextafter(bound, std::numeric_limits<double>::infinity());
  }

  const Toolpath& program_;
  const Toolpath& exact_;
  const MatchOptions& options_;
  const double unit_;
  const double limit_;
  const StopReach half_;
  const StopReach loose_;
  const std::vector<std::size_t> written_;
  const std::vector<std::size_t> meant_;

  PathMatch match_;
  double start_slack_ = 0;
  std::size_t done_ = 0;             ///< moves of the exact path, of those that travel
  Curve curve_;                      ///< of the next
  std::vector<std::size_t> fronts_;  ///< where in states_ each begins
  std::vector<State> states_;
  std::vector<RationalPoint> displacements_;  ///< added to the program; the first is the shift
  std::vector<BallPlace> shifts_;             ///< the same
};

}  // namespace

PathMatch match(const Toolpath& program, const Toolpath& exact, const MatchOptions& options) {
  return Matcher(program, exact, options).run();
}

}  // namespace dgt
