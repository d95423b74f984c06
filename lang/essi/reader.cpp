// SPDX-License-Identifier: GPL-3.0-or-later
//
// Subprograms come first in a program: they are kept as blocks and run at each call, in a frame
// that turns and scales them. The main program is executed as it is read.
#include "lang/essi/reader.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "kernel/angle.h"
#include "lang/essi/block.h"
#include "lang/nc/arc_check.h"
#include "lang/nc/path_builder.h"
#include "lang/nc/told_arc.h"

namespace dgt {
namespace {

using essi::Block;
using essi::Field;

constexpr std::int64_t kFirstSubprogram = 101;
constexpr std::int64_t kLastSubprogram = 30000;
constexpr std::size_t kMaxDepth = 5;
constexpr std::int64_t kLargestAngle = 3600;  // tenths of a degree
/// Turned by the sine and cosine on this grid, sums of any length stay short. Finer than the
/// stand-ins of elements.
constexpr int kTurnExponent = -128;

/// How a subprogram lies on the path.
struct Frame {
  std::int64_t tenths = 0;  ///< turned counter-clockwise by tenths of a degree
  Rational scale = 1;
  bool is_plain = true;
  Rational along_x = 1;  ///< where a step of X leads
  Rational along_y;

  [[nodiscard]] Frame turned(std::int64_t by, const Rational& scaled) const {
    Frame frame;
    frame.tenths = tenths + by;
    frame.scale = scale * scaled;
    frame.is_plain = frame.tenths % kLargestAngle == 0 && frame.scale == 1;
    if (frame.is_plain) return frame;
    const Rational degrees = Rational(static_cast<long>(frame.tenths)) / 10;
    const UnitVector x = direction_of(degrees, 2 - kTurnExponent).unit;
    frame.along_x = frame.scale * on_dyadic_grid(x.x(), kTurnExponent);
    frame.along_y = frame.scale * on_dyadic_grid(x.y(), kTurnExponent);
    return frame;
  }

  [[nodiscard]] RationalPoint place(const RationalPoint& v) const {
    return {along_x * v.x - along_y * v.y, along_y * v.x + along_x * v.y};
  }
  [[nodiscard]] Spot place(const Spot& v) const {
    if (is_plain) return v;
    const RationalPoint p = place(v.exact());
    return {Length(p.x), Length(p.y)};
  }
};

struct Subprogram {
  Range begin;
  std::vector<Block> blocks;
};

struct Call {
  std::int64_t number = 0;
  Range range;
};

class EssiReader {
 public:
  EssiReader(const SourceFile& file, const EssiOptions& options, DiagnosticBag& bag)
      : file_(file),
        options_(options),
        bag_(bag),
        blocks_(file, bag),
        path_(file, file.line_count()),
        is_guide_(options.dialect == EssiDialect::Guide),
        unit_(options.unit),
        unit_width_(options.unit),
        kerf_(options.nc.kerf_width) {}

  NcProgram run() {
    Block block;
    while (!stopped_ && blocks_.next(block)) {
      tell_progress(options_.nc.on_progress, block.line, file_.line_count());
      if (is_guide_ && is_definition(block)) continue;
      if (ended_) {
        report(Message::BehindTheEnd, range_of(block));
        break;
      }
      began_main_ = true;
      execute(block);
    }
    if (open_ != nullptr)
      report(Message::EssiUnclosed, open_->begin, {std::to_string(open_number_)});
    check_calls();
    dgt::report(path_.arcs(), bag_);
    return finish();
  }

 private:
  // --- messages

  [[nodiscard]] Range range_of(const Block& block) const {
    return {&file_, block.begin, block.end};
  }
  [[nodiscard]] Range range_of(const Field& field) const {
    return {&file_, field.begin, field.end};
  }
  void add(Diagnostic diagnostic) {
    if (diagnostic.severity() != Severity::Note) {
      for (auto call = calls_.rbegin(); call != calls_.rend(); ++call)
        diagnostic.notes.push_back(
            {Message::InSubprogram, call->range, {std::to_string(call->number)}});
    }
    bag_.add(std::move(diagnostic));
  }
  void report(Message message, const Range& range, std::vector<std::string> arguments = {}) {
    add({message, range, std::move(arguments)});
  }
  void refuse(const Field& field, Message message) {
    report(message, range_of(field), {std::string(range_of(field).text())});
  }

  // --- definitions

  /// Whether the block begins, ends or is part of a subprogram.
  bool is_definition(const Block& block) {
    if (block.is_mark() && block.number >= kFirstSubprogram && block.number <= kLastSubprogram) {
      block.fields[0].negative ? close(block) : open(block);
      return true;
    }
    if (open_ == nullptr) return false;
    open_->blocks.push_back(block);
    check_arc(block);
    return true;
  }

  void open(const Block& block) {
    const std::string number = std::to_string(block.number);
    if (open_ != nullptr) {
      report(Message::EssiNestedDefinition, range_of(block),
             {number, std::to_string(open_number_)});
    } else if (began_main_) {
      report(Message::EssiDefinedLate, range_of(block), {number});
    }
    const auto [entry, is_new] = subprograms_.try_emplace(block.number);
    if (!is_new) {
      Diagnostic fault{Message::EssiDefinedTwice, range_of(block), {number}};
      fault.notes.push_back({Message::EssiDefinedHere, entry->second.begin, {number}});
      add(std::move(fault));
    }
    entry->second = {range_of(block), {}};
    open_ = &entry->second;
    open_number_ = block.number;
  }

  void close(const Block& block) {
    if (open_ == nullptr || open_number_ != block.number) {
      Diagnostic fault{
          Message::EssiNothingToClose, range_of(block), {std::to_string(block.number)}};
      if (open_ != nullptr) {
        fault.notes.push_back(
            {Message::EssiDefinedHere, open_->begin, {std::to_string(open_number_)}});
      }
      add(std::move(fault));
    }
    open_ = nullptr;
  }

  /// An arc that is none is so in every call, and also without one.
  void check_arc(const Block& block) {
    if (block.has_number || block.count != 5) return;
    ArcSummary ignored;
    (void)read_arc(block, ignored);
  }

  /// Calls that are never run.
  void check_calls() {
    for (const auto& [number, subprogram] : subprograms_) {
      for (const Block& block : subprogram.blocks) {
        if (block.has_number && block.number >= kFirstSubprogram &&
            block.number <= kLastSubprogram && !subprograms_.contains(block.number))
          report(Message::EssiUnknownSubprogram, range_of(block), {std::to_string(block.number)});
      }
    }
  }

  // --- blocks

  void execute(const Block& block) {
    if (++executed_ > options_.nc.max_blocks || path_.size() > options_.nc.max_moves) {
      const bool blocks = executed_ > options_.nc.max_blocks;
      report(blocks ? Message::TooManyStatements : Message::TooManyMoves, range_of(block),
             {std::to_string(blocks ? options_.nc.max_blocks : options_.nc.max_moves)});
      stopped_ = true;
      return;
    }
    if (block.has_number) return execute_number(block);
    if (block.count == 2) return line(block);
    if (block.count == 5) return arc(block);
    report(Message::EssiSignLacking, range_of(block), {std::to_string(block.count)});
  }

  void execute_number(const Block& block) {
    if (is_guide_ && block.number >= kFirstSubprogram && block.number <= kLastSubprogram)
      return call(block);
    if (block.number >= kFirstSubprogram) {
      return report(Message::EssiNumberOutOfRange, range_of(block), {std::to_string(block.number)});
    }
    if (block.count > 1 || (block.count == 1 && is_guide_))
      return report(Message::EssiNoBlock, range_of(block), {std::string(range_of(block).text())});
    code(block);
  }

  [[nodiscard]] SourcePlace place_of(const Block& block) const {
    return {0, block.line, block.column};
  }

  /// A number of units as a length.
  [[nodiscard]] Length length(std::int64_t units) const {
    const Length& unit = unit_;
    std::int64_t steps = 0;
    if (unit.on_grid() && !__builtin_mul_overflow(units, unit.steps(), &steps))
      return Length::of_steps(steps);
    return Length(Rational(static_cast<long>(units)) * unit.millimetres());
  }
  [[nodiscard]] Spot vector(const Block& block, std::size_t first) const {
    return {length(block.fields[first].value), length(block.fields[first + 1].value)};
  }
  /// The end of a move, seen from where it begins.
  [[nodiscard]] Spot chord(const Block& block) const {
    const Spot said = vector(block, 0);
    return is_absolute_ ? said - path_.at() : said;
  }

  void line(const Block& block) {
    const Spot to = path_.at() + frame_.place(chord(block));
    if (to == path_.at()) return;
    if (torch_is_on_) {
      path_.line(to, nullptr, place_of(block));
    } else {
      path_.rapid(to, nullptr, place_of(block));
    }
  }

  // --- arcs

  struct Arc {
    Spot chord;
    Spot centre;  ///< by centre, seen from the beginning
    Length radius;
    bool is_by_radius = true;
    bool is_half_turn = false;
    bool major = false;
    bool counter_clockwise = true;
  };

  std::optional<Arc> read_arc(const Block& block, ArcSummary& summary) {
    const Field& sense = block.fields[4];
    if (sense.has_digits) return refuse(sense, Message::EssiSignWithDigits), std::nullopt;
    return is_guide_ ? read_radius_arc(block, summary) : read_centre_arc(block, summary);
  }

  std::optional<Arc> read_radius_arc(const Block& block, ArcSummary& summary) {
    const Field& radius = block.fields[2];
    const Field& size = block.fields[3];
    if (radius.negative) return report(Message::EssiRadiusNegative, range_of(radius)), std::nullopt;
    if (size.has_digits) return refuse(size, Message::EssiSignWithDigits), std::nullopt;
    Arc arc;
    arc.chord = vector(block, 0);
    arc.radius = length(radius.value);
    arc.major = !size.negative;
    arc.counter_clockwise = block.fields[4].negative;
    RadiusVerdict verdict = judge_radius(arc.chord, {arc.radius, unit_width_, false}, unit_width_,
                                         options_.nc, range_of(block), summary);
    const bool is_fault = verdict.message && verdict.message->severity() == Severity::Error;
    if (verdict.message) add(*std::move(verdict.message));
    if (is_fault) return std::nullopt;
    arc.is_half_turn = verdict.is_half_turn;
    return arc;
  }

  std::optional<Arc> read_centre_arc(const Block& block, ArcSummary& summary) {
    Arc arc;
    arc.is_by_radius = false;
    arc.chord = chord(block);
    arc.centre = vector(block, 2);
    const bool plus = !block.fields[4].negative;
    arc.counter_clockwise = plus == (options_.iso_plus == RotationSense::CounterClockwise);
    if (auto fault =
            fault_of_centre(arc.chord, arc.centre, options_.nc, range_of(block), summary)) {
      add(*std::move(fault));
      return std::nullopt;
    }
    return arc;
  }

  void arc(const Block& block) {
    const auto arc = read_arc(block, path_.arcs());
    if (!arc) return skip(block);
    const auto middle = arc->is_by_radius
                            ? std::nullopt
                            : division_of(arc->chord, arc->centre, arc->counter_clockwise);
    if (!middle) return run_arc(*arc, block);
    Arc half = *arc;
    half.chord = *middle;
    run_arc(half, block);
    half.chord = arc->chord - *middle;
    half.centre = arc->centre - *middle;
    run_arc(half, block);
  }

  /// After a fault the program is read on from where the arc should have ended.
  void skip(const Block& block) {
    path_.rapid(path_.at() + frame_.place(chord(block)), nullptr, place_of(block));
  }

  void run_arc(const Arc& arc, const Block& block) {
    const Spot from = path_.at();
    const Spot to = from + frame_.place(arc.chord);
    if (!torch_is_on_) dark_arcs_.push_back({path_.size(), range_of(block)});
    path_.arc(to, frame_.is_plain ? curve_of(arc, from) : placed(curve_of(arc, {}), from), nullptr,
              place_of(block));
  }

  static ElementPtr curve_of(const Arc& arc, const Spot& from) {
    if (!arc.is_by_radius)
      return told_by_centre(from, arc.chord, arc.centre, arc.counter_clockwise);
    if (arc.is_half_turn) return told_half_turn(from, arc.chord, arc.counter_clockwise);
    return told_by_radius(from, arc.chord, arc.radius, arc.major, arc.counter_clockwise);
  }

  [[nodiscard]] ElementPtr placed(const ElementPtr& arc, const Spot& from) const {
    const auto& circle = std::get<Circle>(*arc);
    return ElementPtr(
        Circle(from.exact() + frame_.place(circle.centre()), frame_.scale * circle.radius()));
  }

  // --- calls

  void call(const Block& block) {
    const auto found = subprograms_.find(block.number);
    if (found == subprograms_.end()) {
      return report(Message::EssiUnknownSubprogram, range_of(block),
                    {std::to_string(block.number)});
    }
    const auto counts = read_counts(block);
    if (!counts || !may_enter(block)) return;
    calls_.push_back({block.number, range_of(block)});
    const Frame outer = frame_;
    for (std::int64_t k = 1; k <= counts->repetitions && !stopped_; ++k) {
      frame_ = outer.turned(k * counts->tenths, counts->scale);
      run_once(found->second, block);
    }
    frame_ = outer;
    calls_.pop_back();
  }

  void run_once(const Subprogram& subprogram, const Block& block) {
    if (subprogram.blocks.empty() && ++executed_ > options_.nc.max_blocks) {
      execute(block);  // reports it
      return;
    }
    const std::size_t first = path_.size();
    for (const Block& inner : subprogram.blocks) {
      if (stopped_) break;
      execute(inner);
    }
    if (path_.size() > first)
      runs_.push_back({first, path_.size(), static_cast<long>(block.number), range_of(block)});
  }

  struct Counts {
    std::int64_t repetitions = 1;
    std::int64_t tenths = 0;  ///< counter-clockwise
    Rational scale = 1;
  };

  std::optional<Counts> read_counts(const Block& block) {
    Counts counts;
    if (block.count > 3) return refuse(block.fields[3], Message::EssiSurplus), std::nullopt;
    if (block.count > 0) {
      const Field& field = block.fields[0];
      if (field.negative || (field.has_digits && field.value < 1))
        return refuse(field, Message::EssiBadRepetition), std::nullopt;
      if (field.has_digits) counts.repetitions = field.value;
    }
    if (block.count > 1) {
      const Field& field = block.fields[1];
      if (field.value < -kLargestAngle || field.value > kLargestAngle)
        return refuse(field, Message::EssiBadAngle), std::nullopt;
      const bool ccw = options_.rotation == RotationSense::CounterClockwise;
      counts.tenths = ccw ? field.value : -field.value;
    }
    if (block.count > 2) {
      const Field& field = block.fields[2];
      if (field.negative || (field.has_digits && field.value < 1))
        return refuse(field, Message::EssiBadScale), std::nullopt;
      if (field.has_digits) {
        counts.scale = Rational(static_cast<long>(field.value)) * options_.scale_unit;
      }
    }
    return counts;
  }

  bool may_enter(const Block& block) {
    const auto same = [&](const Call& call) { return call.number == block.number; };
    const auto first = std::find_if(calls_.begin(), calls_.end(), same);
    if (first != calls_.end()) {
      std::string circle;
      for (auto call = first; call != calls_.end(); ++call)
        circle += std::to_string(call->number) + " → ";
      circle += std::to_string(block.number);
      report(Message::EssiRecursion, range_of(block), {std::to_string(block.number), circle});
      return false;
    }
    if (calls_.size() < kMaxDepth) return true;
    report(Message::EssiTooDeep, range_of(block),
           {std::to_string(calls_.size() + 1), std::to_string(kMaxDepth)});
    return false;
  }

  // --- codes

  void code(const Block& block) {
    if (!is_guide_ && iso_code(block)) return;
    if (block.count > 0)
      return report(Message::EssiNoBlock, range_of(block), {std::string(range_of(block).text())});
    switch (block.number) {
      case 29:
        return path_.switch_kerf(Side::Left, kerf_ / 2, range_of(block));
      case 30:
        return path_.switch_kerf(Side::Right, kerf_ / 2, range_of(block));
      case 38:
        return path_.switch_kerf(Side::None, 0, range_of(block));
      case 53:
        return switch_torch(true, block);
      case 54:
        return switch_torch(false, block);
      case 0:
        break;
      default:
        report(Message::EssiUnknownCode, range_of(block), {std::to_string(block.number)});
    }
    path_.code(std::to_string(block.number), place_of(block));
  }

  void switch_torch(bool on, const Block& block) {
    torch_is_on_ = on;
    torch_was_on_ = torch_was_on_ || on;
    path_.code(on ? "53" : "54", place_of(block));
  }

  /// Codes that only the ISO family has.
  bool iso_code(const Block& block) {
    switch (block.number) {
      case 5:
      case 6:
        return true;  // the speed of rapids: a move with the torch off is one here
      case 7:
        return switch_torch(true, block), true;
      case 8:
        return switch_torch(false, block), true;
      case 39:
        if (const auto v = value_of(block))
          path_.set_feed(shared(Rational(static_cast<long>(*v)) * feed_unit_));
        return true;
      case 40:
        if (const auto v = value_of(block)) kerf_ = length(*v).millimetres();
        return true;
      case 41:
        if (const auto v = value_of(block))
          path_.dwell(shared(Rational(static_cast<long>(*v), 10)), place_of(block));
        return true;
      case 63:
      case 64:
      case 99:
        ended_ = true;
        return true;
      case 70:
        unit_width_ = Rational(127, 500);  // a hundredth of an inch
        unit_ = Length(unit_width_);
        feed_unit_ = Rational(127, 5);
        return true;
      case 71:
        unit_width_ = options_.unit;
        unit_ = Length(unit_width_);
        feed_unit_ = 1;
        return true;
      case 81:
      case 82:
        is_absolute_ = block.number == 82;
        return true;
      default:
        return false;
    }
  }

  /// Of `39+1500`; not negative.
  std::optional<std::int64_t> value_of(const Block& block) {
    if (block.count == 1 && block.fields[0].has_digits && block.fields[0].value > 0)
      return block.fields[0].value;
    report(Message::EssiValueLacking, range_of(block), {std::to_string(block.number)});
    return std::nullopt;
  }

  // --- the end

  NcProgram finish() {
    NcProgram program = path_.finish();
    program.runs = std::move(runs_);
    std::vector<Move>& moves = program.path.moves;
    if (!torch_was_on_) {
      const auto travels = [](const Move& move) { return move.travels(); };
      const auto first = std::find_if(moves.begin(), moves.end(), travels);
      if (first == moves.end()) return program;
      report(Message::TorchNeverOn, {&file_, 0, 0});
      for (Move& move : moves) {
        if (move.kind != MoveKind::Rapid) continue;
        move.kind = MoveKind::Line;
        move.role = Role::Contour;
      }
      return program;
    }
    for (const auto& [index, range] : dark_arcs_) {
      Move& move = moves[index];
      move.kind = MoveKind::Rapid;
      move.role = Role::Position;
      move.full_circle = false;
      move.carrier = {};
      report(Message::ArcWithTorchOff, range);
    }
    return program;
  }

  const SourceFile& file_;
  const EssiOptions& options_;
  DiagnosticBag& bag_;
  essi::BlockReader blocks_;
  PathBuilder path_;
  const bool is_guide_;

  std::map<std::int64_t, Subprogram> subprograms_;
  Subprogram* open_ = nullptr;
  std::int64_t open_number_ = 0;
  bool began_main_ = false;
  bool ended_ = false;
  bool stopped_ = false;

  Frame frame_;
  std::vector<Call> calls_;
  std::vector<SubprogramRun> runs_;
  std::uint64_t executed_ = 0;

  Length unit_;
  Rational unit_width_;     ///< the same, mm
  Rational feed_unit_ = 1;  ///< mm/min
  Rational kerf_;           ///< mm, the whole width
  bool is_absolute_ = false;
  bool torch_is_on_ = false;
  bool torch_was_on_ = false;
  std::vector<std::pair<std::size_t, Range>> dark_arcs_;
};

}  // namespace

NcProgram read_essi(const SourceFile& file, const EssiOptions& options, DiagnosticBag& bag) {
  return EssiReader(file, options, bag).run();
}

}  // namespace dgt
