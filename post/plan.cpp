// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "post/arc_pieces.h"
#include "post/program_text.h"

namespace dgt {
namespace {

using FaultKind = WriteFault::Kind;
using NoteKind = WriteNote::Kind;

double next_up(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }

/// The upper end of |exact − written|, which is known to be at most a half.
double error_bound(std::int64_t written, const Ball& exact) {
  const long double off =
      std::fabs(exact.mid - static_cast<long double>(written)) + exact.rad * (1 + 0x1p-60L);
  return std::min(0.5, next_up(static_cast<double>(off)));
}

class Planner {
 public:
  using Words = std::map<std::size_t, std::vector<std::string>>;

  Planner(const Toolpath& path, const Dialect& dialect, const Words& words)
      : path_(path),
        dialect_(dialect),
        words_(words),
        grid_(dialect.unit,
              dialect.positions == Positions::Absolute ? RationalPoint{} : path.start),
        limits_{
            dialect.arc_form,
            static_cast<long double>(dialect.max_arc_degrees) * std::numbers::pi_v<long double> /
                180,
            dialect.arc_form == ArcForm::Centre
                ? nearest_double(Rational(dialect.radius_mismatch / dialect.unit)) * (1 + 0x1p-50)
                : std::numeric_limits<double>::infinity(),
            nearest_double(Rational(dialect.least_radius / dialect.unit)),
            dialect.form == Form::ThreeB,
            largest_units(dialect)} {}

  Plan run(const OnProgress& on_progress) {
    decide_torch();
    begin();
    for (move_ = 0; move_ < path_.moves.size(); ++move_) {
      tell_progress(on_progress, move_, path_.moves.size());
      emit_words_before();
      write(path_.moves[move_]);
    }
    emit_words_before();
    switch_torch(false);
    return finish();
  }

 private:
  const Move& move() const { return path_.moves[move_]; }

  // --- faults, notes, blocks

  void fault(FaultKind kind, std::string code = {}) {
    const bool at_move = move_ < path_.moves.size();
    WriteFault& added = plan_.faults.emplace_back();
    added.kind = kind;
    added.move = move_;
    if (at_move) added.place = move().source;
    added.code = std::move(code);
  }

  void note_once(NoteKind kind, std::string value = {}) {
    auto& notes = plan_.report.notes;
    if (std::any_of(notes.begin(), notes.end(), [&](const auto& n) { return n.kind == kind; }))
      return;
    notes.push_back({kind, move_, move().source, std::move(value)});
  }

  Block& emit(BlockKind kind) {
    Block& block = plan_.blocks.emplace_back();
    block.kind = kind;
    block.move = move_;
    block.path.from = at_;
    block.path.to = at_;
    ++plan_.report.blocks;
    return block;
  }

  /// Lines of words, a block each.
  void emit_words(std::string_view words) {
    while (!words.empty()) {
      const std::size_t end = std::min(words.find('\n'), words.size());
      emit(BlockKind::Words).words = words.substr(0, end);
      words.remove_prefix(std::min(end + 1, words.size()));
    }
  }

  void emit_words_before() {
    const auto found = words_.find(move_);
    if (found == words_.end()) return;
    for (const std::string& line : found->second) emit_words(line);
  }

  // --- the torch

  void decide_torch() {
    switches_torch_ = dialect_.torch == TorchPolicy::Automatic;
    for (const Move& m : path_.moves)
      if (m.kind == MoveKind::Code && meaning_of(dialect_, m.code).torch != TorchAct::None)
        switches_torch_ = false;
  }

  /// The program's own code does it.
  void hear(TorchAct torch) {
    if (torch == TorchAct::Off) put_out_by_ = move_;
    if (torch == TorchAct::On) put_out_by_.reset();
  }

  /// Each code that puts the torch out before a cut is told once, at the code.
  void note_if_out() {
    if (!put_out_by_) return;
    const Move& code = path_.moves[*put_out_by_];
    plan_.report.notes.push_back(
        {NoteKind::CutsWithTorchOff, *put_out_by_, code.source, code.code});
    put_out_by_.reset();
  }

  void switch_torch(bool on) {
    if (on) note_if_out();
    if (!switches_torch_ || on == torch_is_on_) return;
    torch_is_on_ = on;
    emit_words(on ? dialect_.torch_on : dialect_.torch_off);
  }

  /// Words about several rapids in a row.
  void switch_rapids(bool on) {
    if (on == runs_rapid_) return;
    runs_rapid_ = on;
    emit_words(on ? dialect_.rapids_begin : dialect_.rapids_end);
  }

  // --- moves

  void begin() {
    move_ = path_.moves.size();
    const Point start(path_.start);
    exact_at_ = grid_.enclosure(start);
    const auto at = grid_.nearest(start);
    if (!at) return fault(FaultKind::OutOfRange);
    at_ = *at;
    record_position(at_, exact_at_);
    plan_.start = at_;
    if (!dialect_.rapid_to_start || path_.moves.empty()) return;
    emit(BlockKind::Rapid);
    ++plan_.report.rapids;
  }

  void write(const Move& m) {
    if (ended_ && m.travels()) {
      fault(FaultKind::MoveAfterEnd);
      ended_ = false;  // said once
    }
    switch (m.kind) {
      case MoveKind::Dwell:
        if (dialect_.dwell_word.empty()) return fault(FaultKind::DwellImpossible);
        emit(BlockKind::Dwell);
        return;
      case MoveKind::Code:
        return write_code(m.code);
      default:
        return travel(m);
    }
  }

  void write_code(const std::string& code) {
    const CodeMeaning meaning = meaning_of(dialect_, code);
    hear(meaning.torch);
    switch (meaning.kind) {
      case CodeMeaning::Kind::Unknown:
        return fault(FaultKind::UnknownCode, code);
      case CodeMeaning::Kind::Dropped:
        return note_once(NoteKind::PowerDropped);
      case CodeMeaning::Kind::End:
        ended_ = true;
        return;
      default:
        if (meaning.torch == TorchAct::On) switch_rapids(false);
        return emit_words(meaning.words);
    }
  }

  void travel(const Move& m) {
    const auto to = grid_.nearest(m.to);
    if (!to) return fault(FaultKind::OutOfRange);
    const std::int64_t from_height = height_;
    const bool rises = m.z && change_height(*m.z);
    if (m.cuts()) check_feed(m);
    if (m.kind == MoveKind::Arc) {
      write_arc(m, *to, from_height, rises);
    } else {
      write_straight(m, *to, rises);
    }
    at_ = *to;
    record_position(at_, exact_at_);
  }

  /// Whether there is a height to be written.
  bool change_height(const Rational& z) {
    if (!dialect_.writes_height) {
      fault(FaultKind::HeightImpossible);
      return false;
    }
    const auto height = grid_.nearest_height(z);
    if (!height) {
      fault(FaultKind::OutOfRange);
      return false;
    }
    const double off = error_bound(*height, grid_.enclosure(Ball(z)));
    height_error_ = std::max(height_error_, off);
    const bool rises = !height_known_ || *height != height_;
    height_known_ = true;
    height_ = *height;
    return rises;
  }

  void check_feed(const Move& m) {
    if (!dialect_.writes_feed) {
      if (m.feed) note_once(NoteKind::FeedDropped);
    } else if (dialect_.needs_feed && !m.feed && !dialect_.feed) {
      note_once(NoteKind::FeedDefaulted, to_short_decimal(dialect_.default_feed));
    }
  }

  void write_straight(const Move& m, const GridPoint& to, bool rises) {
    const BallPoint exact_to = grid_.enclosure(m.to);
    if (m.cuts()) record_deviation(deviation_of_line(at_, to, grid_.enclosure(m.from), exact_to));
    exact_at_ = exact_to;
    if (to == at_ && !rises) {
      ++plan_.report.dropped;
      return;
    }
    if (m.cuts()) switch_rapids(false);
    switch_torch(m.cuts());
    if (!m.cuts()) switch_rapids(true);
    Block& block = emit(m.cuts() ? BlockKind::Line : BlockKind::Rapid);
    block.path.to = to;
    block.has_height = rises;
    block.height = height_;
    ++(m.cuts() ? plan_.report.lines : plan_.report.rapids);
  }

  void write_arc(const Move& m, const GridPoint& to, std::int64_t from_height, bool rises) {
    const ExactArc arc = exact_arc(m, grid_);
    exact_at_ = arc.arc.to;
    if (!(arc.arc.radius.mid < static_cast<long double>(kMaxUnits)) &&
        !(sagitta_bound(arc.arc) < kLeastSagitta))
      return fault(FaultKind::OutOfRange);
    const auto pieces = written_pieces(arc, at_, to, limits_);
    if (pieces.size() > 1) ++plan_.report.arcs_divided;
    for (const WrittenPiece& piece : pieces) {
      const bool last = &piece == &pieces.back();
      write_piece(piece, last ? height_ : height_along(from_height, piece.piece.end / arc.sweep),
                  rises);
      if (!last) record_position(piece.piece.to, piece.piece.exact.to);
    }
  }

  /// On a helix, that far along.
  std::int64_t height_along(std::int64_t from, long double fraction) const {
    return from + std::llround(fraction * static_cast<long double>(height_ - from));
  }

  void write_piece(const WrittenPiece& piece, std::int64_t height, bool rises) {
    record_deviation(piece.deviation);
    WriteReport& report = plan_.report;
    if (piece.kind == WrittenPiece::Kind::Nothing && !rises) {
      ++report.dropped;
      return;
    }
    switch_rapids(false);
    switch_torch(true);
    const bool is_arc = piece.kind == WrittenPiece::Kind::Arc;
    Block& block = emit(is_arc ? BlockKind::Arc : BlockKind::Line);
    block.path = piece.arc;
    block.path.from = piece.piece.from;
    block.path.to = piece.piece.to;
    block.has_height = rises;
    block.height = height;
    ++(is_arc ? report.arcs : report.lines);
    if (!is_arc) ++report.arcs_as_lines;
  }

  // --- what is reported

  void record_deviation(double units) { deviation_ = std::max(deviation_, units); }

  void record_position(const GridPoint& written, const BallPoint& exact) {
    error_x_ = std::max(error_x_, error_bound(written.x, exact.x));
    error_y_ = std::max(error_y_, error_bound(written.y, exact.y));
  }

  Plan finish() {
    const double unit = next_up(nearest_double(dialect_.unit));
    const auto millimetres = [&](double units) { return units == 0 ? 0 : next_up(units * unit); };
    plan_.report.deviation = millimetres(deviation_);
    plan_.report.position_error_x = millimetres(error_x_);
    plan_.report.position_error_y = millimetres(error_y_);
    plan_.report.position_error_z = millimetres(height_error_);
    return std::move(plan_);
  }

  const Toolpath& path_;
  const Dialect& dialect_;
  const Words& words_;
  Grid grid_;
  ArcLimits limits_;

  std::size_t move_ = 0;
  GridPoint at_;
  BallPoint exact_at_;
  std::int64_t height_ = 0;  // before the first Z a tool is taken to be at 0
  bool height_known_ = false;
  bool switches_torch_ = false;
  bool torch_is_on_ = false;
  bool runs_rapid_ = false;
  std::optional<std::size_t> put_out_by_;  // the program's own code
  bool ended_ = false;

  double deviation_ = 0;  // these in units
  double error_x_ = 0;
  double error_y_ = 0;
  double height_error_ = 0;
  Plan plan_;
};

}  // namespace

Plan plan(const Toolpath& path, const Dialect& dialect,
          const std::map<std::size_t, std::vector<std::string>>& words,
          const OnProgress& on_progress) {
  return Planner(path, dialect, words).run(on_progress);
}

}  // namespace dgt
