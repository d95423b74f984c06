// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/three_b/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "lang/nc/arc_check.h"
#include "lang/nc/path_builder.h"
#include "lang/nc/told_arc.h"
#include "lang/three_b/block.h"

namespace dgt {
namespace {

using three_b::Axis;
using three_b::Block;
using three_b::Cell;
using three_b::CountedEnd;

/// What CAM systems note behind a block is where the contour should be, and blocks in whole units
/// drift from there. More than this, in mm, is no rounding.
const Rational& noted_tolerance() {
  static const Rational kTolerance(1, 100);
  return kTolerance;
}

const char* name_of(Axis axis) { return axis == Axis::X ? "X" : "Y"; }

/// The half axis on which `place` lies.
const char* half_axis_of(const Cell& place) {
  if (place.y == 0) return place.x > 0 ? "+X" : "-X";
  return place.y > 0 ? "+Y" : "-Y";
}

class ThreeBReader {
 public:
  ThreeBReader(const SourceFile& file, const ThreeBOptions& options, DiagnosticBag& bag)
      : file_(file),
        options_(options),
        bag_(bag),
        blocks_(file, options.unit, bag),
        path_(file, file.line_count()),
        unit_(options.unit),
        tolerance_(units_of(options.end_tolerance)) {}

  NcProgram run() {
    while (blocks_.next(block_)) {
      tell_progress(options_.nc.on_progress, block_.line, file_.line_count());
      if (ended_) {
        report(Message::BehindTheEnd, whole_block());
        break;
      }
      execute();
      if (path_.size() > options_.nc.max_moves) {
        report(Message::TooManyMoves, whole_block(), {std::to_string(options_.nc.max_moves)});
        ended_ = true;
        break;
      }
    }
    finish();
    return path_.finish();
  }

 private:
  // --- messages

  [[nodiscard]] Range whole_block() const { return {&file_, block_.begin, block_.end}; }
  [[nodiscard]] Range way() const { return {&file_, block_.way_begin, block_.end}; }
  [[nodiscard]] SourcePlace place() const { return {0, block_.line, block_.column}; }
  [[nodiscard]] static SourcePlace place_of(const Range& range) {
    const Place place = range.place();
    return {0, place.line, place.column};
  }
  void report(Message message, const Range& range, std::vector<std::string> arguments = {}) {
    bag_.add({message, range, std::move(arguments)});
  }
  /// The word of Z contradicts its numbers; one quadrant would not.
  void refuse_quadrant(Message message, const char* axis, const char* kind, int quadrant) {
    const std::string meant = kind + std::to_string(quadrant);
    bag_.add({message,
              way(),
              {axis, meant, std::string(way().text())},
              {},
              FixIt{way(), meant, Certainty::Guess}});
  }

  void refuse_axis() {
    const Range axis{&file_, block_.axis_begin, block_.axis_end};
    const std::string counted = name_of(block_.axis);
    const std::string meant = name_of(block_.axis == Axis::X ? Axis::Y : Axis::X);
    bag_.add({Message::ThreeBCountedAcross,
              axis,
              {meant, counted},
              {},
              FixIt{axis, meant, Certainty::Guess}});
  }

  // --- lengths

  /// Whole units in a length, rounded down.
  [[nodiscard]] std::int64_t units_of(const Rational& millimetres) const {
    const Rational units = millimetres / options_.unit;
    const Integer whole = units.get_num() / units.get_den();
    return whole.fits_slong_p() ? whole.get_si() : std::numeric_limits<std::int64_t>::max();
  }
  [[nodiscard]] Length length(std::int64_t units) const {
    std::int64_t steps = 0;
    if (unit_.on_grid() && !__builtin_mul_overflow(units, unit_.steps(), &steps))
      return Length::of_steps(steps);
    return Length(Rational(static_cast<long>(units)) * options_.unit);
  }
  [[nodiscard]] Spot spot(const Cell& cell) const { return {length(cell.x), length(cell.y)}; }
  [[nodiscard]] std::string shown(std::int64_t units) const {
    return to_short_decimal(Rational(Rational(static_cast<long>(units)) * options_.unit));
  }

  // --- blocks

  void execute() {
    last_block_ = whole_block();
    switch (block_.kind) {
      case Block::Kind::Pause:
        return pause();
      case Block::Kind::End:
        ended_ = true;
        if (pending_.file != nullptr && !is_out_) path_.code("M0", place_of(pending_));
        return;
      case Block::Kind::Start:
        path_.start_at(noted(), place());
        noted_shift_ = Spot{};
        return;
      default:
        break;
    }
    if (pending_.file != nullptr) {
      is_out_ = !is_out_;
      if (is_out_) taken_out_ = pending_;
      pending_ = {};
    }
    if (block_.count == 0) return report(Message::ThreeBNowhere, whole_block());
    block_.kind == Block::Kind::Line ? line() : arc();
    compare_with_noted();
  }

  /// The first of two in a row waits for the second.
  void pause() {
    if (options_.pause == ThreeBPause::Rapid && pending_.file == nullptr) {
      pending_ = whole_block();
      return;
    }
    pending_ = {};
    path_.code("M0", place());
  }

  // --- lines

  void line() {
    if (const auto end = end_of_line()) {
      count_apart(*end);
      const Cell signs = three_b::signs_of(block_.quadrant);
      go(path_.at() + spot({signs.x * end->end.x, signs.y * end->end.y}));
    }
  }

  void go(const Spot& to) {
    if (is_out_) {
      path_.rapid(to, nullptr, place());
    } else {
      path_.line(to, nullptr, place());
    }
  }

  std::optional<CountedEnd> end_of_line() {
    Cell slope{block_.x, block_.y};
    const bool along_x = block_.axis == Axis::X;
    if (slope == Cell{}) {
      const bool is_of_x = block_.quadrant % 2 == 1;
      if (is_of_x != along_x) {
        report(Message::ThreeBAxisLacking, whole_block(), {std::string(way().text())});
        return std::nullopt;
      }
      (along_x ? slope.x : slope.y) = 1;
    } else if (slope.x == 0 || slope.y == 0) {
      const Cell signs = three_b::signs_of(block_.quadrant);
      const Cell direction{signs.x * slope.x, signs.y * slope.y};
      const int meant = three_b::quadrant_of(direction, true);
      if (meant != block_.quadrant) {
        refuse_quadrant(Message::ThreeBLineQuadrant, half_axis_of(direction), "L", meant);
        return std::nullopt;
      }
    }
    return counted(slope, along_x ? slope.x : slope.y);
  }

  std::optional<CountedEnd> counted(const Cell& slope, std::int64_t along) {
    if (along == 0) return refuse_axis(), std::nullopt;
    const bool is_said =
        along == block_.count || (block_.count % along == 0 && std::gcd(slope.x, slope.y) == 1);
    const auto end =
        is_said ? three_b::end_of_line(slope, block_.axis, block_.count) : std::nullopt;
    if (!end) {
      report(Message::ThreeBLineCount, whole_block(),
             {std::to_string(along), name_of(block_.axis), std::to_string(block_.count)});
      return std::nullopt;
    }
    if (end->apart <= std::max<std::int64_t>(1, tolerance_)) return end;
    const bool along_x = block_.axis == Axis::X;
    report(
        Message::ThreeBShorterAxis, whole_block(),
        {name_of(block_.axis), shown(end->apart), to_short_decimal(options_.end_tolerance),
         std::to_string(along_x ? end->end.y : end->end.x), name_of(along_x ? Axis::Y : Axis::X)});
    return std::nullopt;
  }

  // --- arcs

  void arc() {
    const Cell signs = three_b::signs_of(block_.quadrant);
    const three_b::CountedTurn turn{{signs.x * block_.x, signs.y * block_.y},
                                    block_.counter_clockwise,
                                    block_.axis,
                                    block_.count};
    ++path_.arcs().arcs;
    if (is_out_) {
      Diagnostic fault{Message::ThreeBArcWireOut, whole_block(), {}};
      fault.notes.push_back({Message::ThreeBTakenOut, taken_out_, {}});
      return bag_.add(std::move(fault));
    }
    if (block_.x < 2 && block_.y < 2) return report(Message::ThreeBNoCircle, whole_block());
    if (block_.x == 0 || block_.y == 0) {
      const int meant = three_b::quadrant_of(turn.begin, turn.counter_clockwise);
      if (meant != block_.quadrant) {
        return refuse_quadrant(Message::ThreeBArcQuadrant, half_axis_of(turn.begin),
                               turn.counter_clockwise ? "NR" : "SR", meant);
      }
    }
    const CountedEnd end = three_b::end_of_turn(turn);
    if (end.surplus > tolerance_) {
      return report(
          Message::ThreeBTooFar, whole_block(),
          {std::to_string(block_.count), std::to_string(three_b::steps_of_turn(turn.begin))});
    }
    if (end.apart > std::max<std::int64_t>(1, tolerance_)) {
      return report(
          Message::ThreeBEndOpen, whole_block(),
          {name_of(block_.axis), shown(end.apart), to_short_decimal(options_.end_tolerance)});
    }
    count_apart(end);
    run_arc(turn, end);
  }

  void run_arc(const three_b::CountedTurn& turn, const CountedEnd& end) {
    const Spot centre = spot({-turn.begin.x, -turn.begin.y});
    const Spot chord = spot({end.end.x - turn.begin.x, end.end.y - turn.begin.y});
    if (end.surplus > 0 && !(turn.begin == end.end)) add_arc({}, centre);
    add_arc(chord, centre);
  }

  void add_arc(const Spot& chord, const Spot& centre) {
    const Spot from = path_.at();
    const bool ccw = block_.counter_clockwise;
    const EndRadii radii = end_radii(chord, centre);
    if (!radii.equal) {
      path_.arcs().mismatches.push_back({whole_block(), std::fabs(radii.from - radii.to)});
      if (const auto middle = division_of(chord, centre, ccw)) {
        path_.arc(from + *middle, told_by_centre(from, *middle, centre, ccw), nullptr, place());
        return path_.arc(from + chord,
                         told_by_centre(from + *middle, chord - *middle, centre - *middle, ccw),
                         nullptr, place());
      }
    }
    path_.arc(from + chord, told_by_centre(from, chord, centre, ccw), nullptr, place());
  }

  /// Up to one unit is what steps are.
  void count_apart(const CountedEnd& end) {
    if (end.apart <= 1) return;
    const double distance =
        nearest_double(Rational(Rational(static_cast<long>(end.apart)) * options_.unit));
    std::vector<ArcSummary::Mismatch>& apart = path_.arcs().apart;
    apart.push_back({whole_block(), distance});
    if (apart.size() == 1 || end.apart > largest_apart_) {
      largest_apart_ = end.apart;
      worst_apart_ = apart.size() - 1;
    }
  }

  // --- what the file says of itself

  [[nodiscard]] Spot noted() const {
    return {length_of(block_.place.x, LengthUnit::Millimetre, file_.text()),
            length_of(block_.place.y, LengthUnit::Millimetre, file_.text())};
  }

  void compare_with_noted() {
    if (!block_.has_place || told_noted_ || bag_.has_errors()) return;
    const Spot said = noted();
    if (!noted_shift_) noted_shift_ = said - path_.at();
    const Spot at = path_.at() + *noted_shift_;
    const RationalPoint off = (said - at).exact();
    if (abs(off.x) <= noted_tolerance() && abs(off.y) <= noted_tolerance()) return;
    told_noted_ = true;
    const auto text = [](const Length& value) { return to_short_decimal(value.millimetres(), 6); };
    report(Message::ThreeBPlaceDiffers, whole_block(),
           {text(said.x), text(said.y), text(at.x), text(at.y)});
  }

  void finish() {
    const std::vector<ArcSummary::Mismatch>& apart = path_.arcs().apart;
    if (!apart.empty()) {
      report(Message::ThreeBEndsDiffer, apart[worst_apart_].block,
             {std::to_string(apart.size()), shown(largest_apart_)});
    }
    if (is_out_ && pending_.file == nullptr && !bag_.has_errors())
      report(Message::ThreeBWireOut, taken_out_);
    if (!ended_) report(Message::ThreeBEndLacking, last_block_);
  }

  const SourceFile& file_;
  const ThreeBOptions& options_;
  DiagnosticBag& bag_;
  three_b::BlockReader blocks_;
  PathBuilder path_;
  const Length unit_;
  const std::int64_t tolerance_;  ///< units

  Block block_;
  Range last_block_{&file_, 0, 0};
  bool ended_ = false;
  bool is_out_ = false;  ///< the wire
  Range taken_out_;      ///< by this D
  Range pending_;        ///< a D that nothing stands behind yet; no file: none
  std::int64_t largest_apart_ = 0;
  std::size_t worst_apart_ = 0;
  std::optional<Spot> noted_shift_;  ///< what is noted, from where the program is
  bool told_noted_ = false;
};

}  // namespace

NcProgram read_three_b(const SourceFile& file, const ThreeBOptions& options, DiagnosticBag& bag) {
  return ThreeBReader(file, options, bag).run();
}

}  // namespace dgt
