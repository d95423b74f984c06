// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/nc/kerf.h"

#include <optional>
#include <utility>

#include "lang/nc/kerf_messages.h"
#include "lang/nc/kerf_run.h"
#include "lang/nc/path_builder.h"

namespace dgt {
namespace {

/// Cuts in one row under one kerf, with the dwells and codes among them and at their ends.
struct Run {
  std::size_t first = 0;  ///< moves [first, last) of the program
  std::size_t last = 0;
  const KerfSwitch* kerf = nullptr;  ///< null: none
};

bool is_offset(const KerfSwitch* kerf) {
  return kerf != nullptr && kerf->side != Side::None && sgn(kerf->offset) != 0;
}

bool are_same(const KerfSwitch* a, const KerfSwitch* b) {
  if (a == nullptr || b == nullptr) return a == b;
  return a->side == b->side && a->offset == b->offset;
}

/// What rounding does to a program, in steps of its numbers: its places and those that the tool is
/// held against are off by up to 0.71 each, and its arcs by somewhat more in their middle.
constexpr int kRoundedGouge = 2;

class KerfPath {
 public:
  KerfPath(const SourceFile& file, NcProgram& program, const ContourOptions& options,
           DiagnosticBag& bag, KerfLead lead)
      : program_(program),
        lead_(lead),
        moves_(program.path.moves),
        options_(options),
        bag_(bag),
        messages_(file, program, bag) {
    out_.files = program.path.files;
    out_.start = program.path.start;
    at_ = Point(out_.start);
    options_.gouge_tolerance += kRoundedGouge * program.step;
  }

  Toolpath run() {
    check_switches();
    std::size_t i = 0;
    while (i < moves_.size()) {
      if (moves_[i].kind == MoveKind::Rapid) {
        add(moves_[i++]);
        continue;
      }
      std::size_t end = i;
      while (end < moves_.size() && moves_[end].kind != MoveKind::Rapid) ++end;
      add_group(i, end);
      i = end;
    }
    return std::move(out_);
  }

 private:
  // --- which kerf is in force

  [[nodiscard]] const KerfSwitch* kerf_at(std::size_t move) {
    while (next_switch_ < program_.kerf.size() && program_.kerf[next_switch_].move <= move)
      ++next_switch_;
    const KerfSwitch* const kerf = next_switch_ == 0 ? nullptr : &program_.kerf[next_switch_ - 1];
    return is_offset(kerf) ? kerf : nullptr;
  }

  void check_switches() {
    bool told_width = false;
    for (std::size_t i = 0; i < program_.kerf.size(); ++i) {
      const KerfSwitch& kerf = program_.kerf[i];
      if (kerf.side == Side::None) continue;
      const bool is_last = i + 1 == program_.kerf.size();
      const std::size_t end = is_last ? moves_.size() : program_.kerf[i + 1].move;
      bool cuts = false;
      for (std::size_t m = kerf.move; m < end && !cuts; ++m) cuts = moves_[m].cuts();
      if (!cuts) bag_.add({Message::KerfWithoutCut, kerf.block, {text_of(kerf.block)}});
      if (sgn(kerf.offset) == 0 && !std::exchange(told_width, true))
        bag_.add({Message::KerfWithoutWidth, kerf.block, {text_of(kerf.block)}});
    }
  }
  static std::string text_of(const Range& range) { return std::string(range.text()); }

  // --- what lies between two rapids

  void add_group(std::size_t first, std::size_t last) {
    const std::vector<Run> runs = runs_of(first, last);
    if (runs.empty()) {
      for (std::size_t i = first; i < last; ++i) add(moves_[i]);
      return;
    }
    for (std::size_t i = 1; i < runs.size(); ++i) {
      if (runs[i - 1].kerf == nullptr || runs[i].kerf == nullptr) continue;
      messages_.report(Message::KerfChangesInCut, runs[i].first, {text_of(runs[i].kerf->block)});
      return;
    }
    for (const Run& run : runs) add_run(run, &run == &runs.front());
  }

  std::vector<Run> runs_of(std::size_t first, std::size_t last) {
    std::vector<Run> runs;
    for (std::size_t i = first; i < last; ++i) {
      if (!moves_[i].cuts()) continue;
      const KerfSwitch* const kerf = kerf_at(i);
      if (runs.empty()) {
        runs.push_back({first, last, kerf});
      } else if (!are_same(kerf, runs.back().kerf)) {
        runs.back().last = i;
        runs.push_back({i, last, kerf});
      }
    }
    return runs;
  }

  void add_run(const Run& run, bool is_first) {
    const auto begin = moves_.begin();
    std::vector<Move> programmed(begin + static_cast<std::ptrdiff_t>(run.first),
                                 begin + static_cast<std::ptrdiff_t>(run.last));
    mark_leads(programmed);
    if (run.kerf == nullptr) {
      append(programmed, nullptr, is_first, run);
      return;
    }
    KerfRun made{programmed, run.first, run.kerf, at_, std::nullopt};
    if (is_first) made.rapid = rapid_under(*run.kerf, run.first);
    if (made.rapid) made.at = out_.moves.back().from;
    KerfEquidistant equidistant(options_, messages_);
    const auto built =
        lead_ == KerfLead::Moved ? equidistant.moved(made) : equidistant.led(made, lead_);
    // With a fault nothing is written; the rest is checked.
    append(made.programmed, built ? &*built : nullptr, is_first, run);
  }

  /// The rapid before a run, if it is the first that travels under its kerf.
  std::optional<Move> rapid_under(const KerfSwitch& kerf, std::size_t first) const {
    if (first == 0 || moves_[first - 1].kind != MoveKind::Rapid || kerf.move >= first)
      return std::nullopt;
    for (std::size_t i = kerf.move; i + 1 < first; ++i)
      if (moves_[i].travels()) return std::nullopt;
    if (moves_[first - 1].from == moves_[first - 1].to) return std::nullopt;
    return moves_[first - 1];
  }

  /// The run behind what there is, joined to it.
  void append(std::vector<Move>& programmed, const BuiltContour* built, bool is_first,
              const Run& run) {
    std::vector<Move> moves = built != nullptr ? built->moves : programmed;
    lead(moves, is_first, run);
    std::vector<Contour> found = contours_of(programmed);
    if (found.empty()) return;
    Contour contour = std::move(found.front());
    const auto begin = programmed.begin();
    contour.programmed.emplace(begin + static_cast<std::ptrdiff_t>(contour.first),
                               begin + static_cast<std::ptrdiff_t>(contour.last));
    contour.id = static_cast<unsigned>(out_.contours.size() + 1);
    if (built != nullptr) {
      contour.offset = built->offset;
      contour.side = built->side;
      contour.closed = contour.closed || built->closed;
    }
    contour.first = out_.moves.size();
    for (const Move& move : moves) out_.moves.push_back(move);
    contour.last = out_.moves.size();
    // Codes and dwells at the ends are the program's, not the contour's.
    while (!out_.moves[contour.first].cuts()) ++contour.first;
    while (!out_.moves[contour.last - 1].cuts()) --contour.last;
    out_.contours.push_back(std::move(contour));
    at_ = out_.moves.back().to;
  }

  void lead(std::vector<Move>& moves, bool is_first, const Run& run) {
    const Point& begin = moves.front().from;
    if (begin == at_ || out_.moves.empty()) {
      if (out_.moves.empty() && !(begin == Point(out_.start))) add_rapid(begin, run);
      return;
    }
    Move& before = out_.moves.back();
    if (is_first && before.kind == MoveKind::Rapid) {
      before.to = begin;
      return;
    }
    if (is_first) return add_rapid(begin, run);
    // Inside a row of cuts a straight one leads over: the last before the kerf, or the first
    // behind.
    Move* last = &before;
    while (!last->cuts() && last != &out_.moves.front()) --last;
    if (run.kerf != nullptr && last->kind == MoveKind::Line) {
      last->to = begin;
      for (Move* stop = last + 1; stop <= &before; ++stop) stop->from = stop->to = begin;
      return;
    }
    for (Move& move : moves) {
      if (!move.cuts()) {
        move.from = move.to = at_;
        continue;
      }
      if (run.kerf == nullptr && move.kind == MoveKind::Line) {
        move.from = at_;
      } else {
        messages_.report(Message::KerfNeedsLine, run.first);
      }
      return;
    }
  }

  void add_rapid(const Point& to, const Run& run) {
    Move move;
    move.kind = MoveKind::Rapid;
    move.role = Role::Position;
    move.from = out_.moves.empty() ? Point(out_.start) : at_;
    move.to = to;
    move.source = moves_[run.first].source;
    out_.moves.push_back(std::move(move));
    at_ = to;
  }

  void add(const Move& move) {
    out_.moves.push_back(move);
    Move& added = out_.moves.back();
    if (out_.moves.size() > 1) added.from = at_;
    if (!added.travels()) added.to = added.from;
    at_ = added.to;
  }

  NcProgram& program_;
  const KerfLead lead_;
  const std::vector<Move>& moves_;
  ContourOptions options_;
  DiagnosticBag& bag_;
  KerfMessages messages_;
  std::size_t next_switch_ = 0;
  Toolpath out_;
  Point at_;
};

}  // namespace

Toolpath with_kerf(const SourceFile& file, NcProgram program, const ContourOptions& options,
                   DiagnosticBag& bag, KerfLead lead) {
  if (!program.kerf.empty()) return KerfPath(file, program, options, bag, lead).run();
  program.path.contours = contours_of(program.path.moves);
  return std::move(program.path);
}

}  // namespace dgt
