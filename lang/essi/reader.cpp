// SPDX-License-Identifier: GPL-3.0-or-later
//
// Subprograms come first in a program: they are kept as blocks and run at each call, in a frame
// that turns and scales them. The main program is executed as it is read.
#include "lang/essi/reader.h"

#include <algorithm>
#include <string>
#include <utility>

#include "lang/essi/arc.h"
#include "lang/essi/frame.h"
#include "lang/essi/subprograms.h"
#include "lang/nc/arc_check.h"
#include "lang/nc/path_builder.h"

namespace dgt {
namespace {

using essi::Block;

class EssiReader {
 public:
  EssiReader(const SourceFile& file, const EssiOptions& options, DiagnosticBag& bag)
      : file_(file),
        options_(options),
        bag_(bag),
        messages_(file, bag),
        blocks_(file, bag),
        path_(file, file.line_count()),
        is_guide_(options.dialect == EssiDialect::Guide),
        unit_(options.unit),
        kerf_(options.nc.kerf_width) {}

  NcProgram run() {
    Block block;
    while (!stopped_ && blocks_.next(block)) {
      tell_progress(options_.nc.on_progress, block.line, file_.line_count());
      if (is_guide_ && subprograms_.take(block, began_main_)) {
        check_arc(block);
        continue;
      }
      if (ended_) {
        report(Message::BehindTheEnd, block);
        break;
      }
      began_main_ = true;
      execute(block);
    }
    subprograms_.check();
    dgt::report(path_.arcs(), bag_);
    return finish();
  }

 private:
  void report(Message message, const Block& block, std::vector<std::string> arguments = {}) {
    messages_.report(message, messages_.range_of(block), std::move(arguments));
  }

  // --- blocks

  void execute(const Block& block) {
    if (++executed_ > options_.nc.max_blocks || path_.size() > options_.nc.max_moves) {
      const bool blocks = executed_ > options_.nc.max_blocks;
      report(blocks ? Message::TooManyStatements : Message::TooManyMoves, block,
             {std::to_string(blocks ? options_.nc.max_blocks : options_.nc.max_moves)});
      stopped_ = true;
      return;
    }
    if (block.has_number) return execute_number(block);
    if (block.count == 2) return line(block);
    if (block.count == 5) return arc(block);
    report(Message::EssiSignLacking, block, {std::to_string(block.count)});
  }

  void execute_number(const Block& block) {
    if (is_guide_ && essi::is_subprogram(block.number)) return call(block);
    if (block.number >= essi::kFirstSubprogram)
      return report(Message::EssiNumberOutOfRange, block, {std::to_string(block.number)});
    if (block.count > 1 || (block.count == 1 && is_guide_))
      return messages_.refuse(block, Message::EssiNoBlock);
    code(block);
  }

  [[nodiscard]] SourcePlace place_of(const Block& block) const {
    return {0, block.line, block.column};
  }

  /// The end of a move, seen from where it begins.
  [[nodiscard]] Spot chord(const Block& block) const {
    const Spot said = unit_.way(block, 0);
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

  /// An arc that is none is so in every call of its subprogram, and also without one.
  void check_arc(const Block& block) {
    if (block.has_number || block.count != 5) return;
    ArcSummary ignored;
    (void)read_arc(block, ignored);
  }

  std::optional<essi::Arc> read_arc(const Block& block, ArcSummary& summary) {
    return essi::read_arc(block, chord(block), unit_, options_, messages_, summary);
  }

  void arc(const Block& block) {
    const auto arc = read_arc(block, path_.arcs());
    if (!arc) return skip(block);
    const auto middle = arc->is_by_radius
                            ? std::nullopt
                            : division_of(arc->chord, arc->centre, arc->counter_clockwise);
    if (!middle) return run_arc(*arc, block);
    essi::Arc half = *arc;
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

  void run_arc(const essi::Arc& arc, const Block& block) {
    const Spot from = path_.at();
    const Spot to = from + frame_.place(arc.chord);
    if (!torch_is_on_) dark_arcs_.push_back({path_.size(), messages_.range_of(block)});
    path_.arc(to, frame_.is_plain() ? curve_of(arc, from) : placed(curve_of(arc, {}), from),
              nullptr, place_of(block));
  }

  [[nodiscard]] ElementPtr placed(const ElementPtr& arc, const Spot& from) const {
    return ElementPtr(frame_.place(std::get<Circle>(*arc), from));
  }

  // --- calls

  void call(const Block& block) {
    const essi::Subprogram* const subprogram = subprograms_.called_by(block);
    if (subprogram == nullptr) return;
    const auto words = essi::read_call(block, options_, messages_);
    if (!words || !may_enter(block, messages_)) return;
    messages_.calls.push_back({block.number, messages_.range_of(block)});
    const essi::Frame outer = frame_;
    for (std::int64_t k = 1; k <= words->repetitions && !stopped_; ++k) {
      frame_ = outer.turned(k * words->tenths, words->scale);
      run_once(*subprogram, block);
    }
    frame_ = outer;
    messages_.calls.pop_back();
  }

  void run_once(const essi::Subprogram& subprogram, const Block& block) {
    if (subprogram.blocks.empty() && ++executed_ > options_.nc.max_blocks) {
      execute(block);  // reports it
      return;
    }
    const std::size_t first = path_.size();
    for (const Block& inner : subprogram.blocks) {
      if (stopped_) break;
      execute(inner);
    }
    if (path_.size() > first) {
      runs_.push_back(
          {first, path_.size(), static_cast<long>(block.number), messages_.range_of(block)});
    }
  }

  // --- codes

  void code(const Block& block) {
    if (!is_guide_ && iso_code(block)) return;
    if (block.count > 0) return messages_.refuse(block, Message::EssiNoBlock);
    switch (block.number) {
      case 29:
        return path_.switch_kerf(Side::Left, kerf_ / 2, messages_.range_of(block));
      case 30:
        return path_.switch_kerf(Side::Right, kerf_ / 2, messages_.range_of(block));
      case 38:
        return path_.switch_kerf(Side::None, 0, messages_.range_of(block));
      case 53:
        return switch_torch(true, block);
      case 54:
        return switch_torch(false, block);
      case 0:
        break;
      default:
        report(Message::EssiUnknownCode, block, {std::to_string(block.number)});
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
        if (const auto v = value_of(block)) kerf_ = unit_.length(*v).millimetres();
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
        unit_ = essi::Unit(Rational(127, 500));  // a hundredth of an inch
        feed_unit_ = Rational(127, 5);
        return true;
      case 71:
        unit_ = essi::Unit(options_.unit);
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
    report(Message::EssiValueLacking, block, {std::to_string(block.number)});
    return std::nullopt;
  }

  // --- the end

  NcProgram finish() {
    NcProgram program = path_.finish();
    program.runs = std::move(runs_);
    program.step = unit_.width();
    std::vector<Move>& moves = program.path.moves;
    if (!torch_was_on_) {
      const auto travels = [](const Move& move) { return move.travels(); };
      const auto first = std::find_if(moves.begin(), moves.end(), travels);
      if (first == moves.end()) return program;
      messages_.report(Message::TorchNeverOn, {&file_, 0, 0});
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
      messages_.report(Message::ArcWithTorchOff, range);
    }
    return program;
  }

  const SourceFile& file_;
  const EssiOptions& options_;
  DiagnosticBag& bag_;
  essi::Messages messages_;
  essi::BlockReader blocks_;
  PathBuilder path_;
  const bool is_guide_;

  essi::Subprograms subprograms_{messages_};
  bool began_main_ = false;
  bool ended_ = false;
  bool stopped_ = false;

  essi::Frame frame_;
  std::vector<SubprogramRun> runs_;
  std::uint64_t executed_ = 0;

  essi::Unit unit_;
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
