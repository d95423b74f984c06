// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/dgt_source.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "kernel/measure.h"
#include "lang/dgt/formatter.h"
#include "post/dgt.h"

namespace dgt {
namespace {

/// Nothing that is written here asks for files.
class NoFiles : public SourceLoader {
 public:
  std::optional<SourceText> load_macro(std::string_view) override { return std::nullopt; }
  std::optional<SourceText> load_definitions(std::string_view) override { return std::nullopt; }
  [[nodiscard]] bool has_folder() const override { return false; }
};

/// What was written, read again.
struct Reading {
  std::shared_ptr<const SourceFile> file;
  DiagnosticBag bag;
  CompileResult result;
};

Reading read_again(const std::string& text) {
  Reading reading;
  reading.file = std::make_shared<const SourceFile>("written.bgt", text);
  EvaluateOptions options;
  options.gouge = GougePolicy::Warn;  // what it was written from has been judged
  options.crossings = CrossingMoves::None;
  constexpr std::uint64_t kUnbounded = 1'000'000'000'000;
  options.bounds.statements = kUnbounded;
  options.bounds.moves = kUnbounded;
  NoFiles files;
  reading.result = compile(*reading.file, files, options, reading.bag);
  return reading;
}

/// How far the second move is from the first; nothing when it is another kind of move.
std::optional<double> distance(const Move& a, const Move& b) {
  if (a.kind != b.kind || a.full_circle != b.full_circle) return std::nullopt;
  if ((a.z != nullptr) != (b.z != nullptr) || (a.z && *a.z != *b.z)) return std::nullopt;
  if (a.feed && (!b.feed || *a.feed != *b.feed)) return std::nullopt;
  switch (a.kind) {
    case MoveKind::Code:
      if (dgt_code(a.code) != b.code) return std::nullopt;
      break;
    case MoveKind::Dwell:
      if (*a.seconds != *b.seconds) return std::nullopt;
      break;
    case MoveKind::Arc:
      if (a.circle().counter_clockwise() != b.circle().counter_clockwise()) return std::nullopt;
      break;
    default:
      break;
  }
  if (!a.travels()) return distance_bound(place_of(a.to), place_of(b.to));
  const BallPlace here = place_of(RationalPoint{0, 0});
  return frechet_bound(curve_of(a, here), curve_of(b, here));
}

/// The same of runs of moves.
std::optional<double> distance(std::span<const Move> a, std::span<const Move> b) {
  if (a.size() != b.size()) return std::nullopt;
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto one = distance(a[i], b[i]);
    if (!one || !(*one <= kDgtDeviation)) return std::nullopt;
    most = std::max(most, *one);
  }
  return most;
}

class DgtWriting {
 public:
  DgtWriting(const Toolpath& path, std::string title) : path_(path), title_(std::move(title)) {
    for (const Contour& contour : path.contours) {
      const bool has_width = sgn(contour.offset) != 0 && contour.side != Side::None;
      styles_.push_back(has_width ? DgtStyle::Offset : DgtStyle::Elements);
    }
  }

  DgtSource run() {
    // Each round says at least one contour more plainly.
    const std::size_t rounds = 4 * styles_.size() + 2;
    for (std::size_t round = 0; round < rounds; ++round) {
      text_ = to_dgt(path_, styles_, title_);
      if (!text_.faults.empty()) return refused(text_.faults);
      const Reading reading = read_again(text_.text);
      const bool changed = judge(reading);
      if (!changed) return finished(reading);
    }
    return finished({});
  }

 private:
  /// Makes styles plainer where the text does not say the path; whether any was.
  bool judge(const Reading& reading) {
    std::vector<bool> differs(styles_.size(), false);
    bool is_placed = true;
    for (const Diagnostic& diagnostic : reading.bag.all()) {
      const bool counts =
          diagnostic.severity() == Severity::Error || diagnostic.message == Message::GapJoined;
      if (counts) is_placed = mark(diagnostic.range.place().line, differs) && is_placed;
    }
    if (reading.result.path) compare(*reading.result.path, differs);
    const bool all = !is_placed;
    bool changed = false;
    for (std::size_t i = 0; i < styles_.size(); ++i) {
      styles_[i] = text_.contours[i].style;
      if ((all || differs[i]) && styles_[i] != DgtStyle::Points) {
        styles_[i] = static_cast<DgtStyle>(static_cast<int>(styles_[i]) + 1);
        changed = true;
      }
    }
    return changed;
  }

  /// Whether the line is one of a contour, which then differs.
  bool mark(std::size_t line, std::vector<bool>& differs) const {
    for (std::size_t i = 0; i < text_.contours.size(); ++i) {
      const DgtLines& lines = text_.contours[i];
      if (line < lines.first || line > lines.last) continue;
      differs[i] = true;
      return true;
    }
    return false;
  }

  void compare(const Toolpath& read, std::vector<bool>& differs) const {
    // A contour is found by its line, since one that says nothing makes none.
    for (std::size_t i = 0; i < path_.contours.size(); ++i) {
      const DgtLines& lines = text_.contours[i];
      const auto found = std::ranges::find_if(read.contours, [&](const Contour& contour) {
        const std::size_t line = read.moves[contour.first].source.line;
        return line >= lines.first && line <= lines.last;
      });
      const bool is_same =
          found != read.contours.end() &&
          distance(moves_of(path_, path_.contours[i]), moves_of(read, *found)).has_value();
      if (!is_same) differs[i] = true;
    }
  }

  static DgtSource refused(std::vector<WriteFault> faults) {
    DgtSource source;
    source.written.faults = std::move(faults);
    return source;
  }

  DgtSource finished(const Reading& reading) const {
    const auto deviation = reading.result.path
                               ? distance(std::span<const Move>(path_.moves),
                                          std::span<const Move>(reading.result.path->moves))
                               : std::nullopt;
    if (!deviation) return refused({first_difference(reading)});
    DgtSource source;
    DiagnosticBag bag;
    source.written.text = language::format(*reading.file, bag).value_or(text_.text);
    source.written.report.deviation = *deviation;
    source.written.report.blocks = path_.moves.size();
    source.contours = styles_.size();
    for (std::size_t i = 0; i < styles_.size(); ++i) {
      if (styles_[i] == DgtStyle::Points) ++source.by_points;
      if (sgn(path_.contours[i].offset) != 0 && !is_with_width(styles_[i])) ++source.without_width;
    }
    return source;
  }

  [[nodiscard]] WriteFault first_difference(const Reading& reading) const {
    WriteFault fault;
    fault.kind = WriteFault::Kind::OutOfRange;
    static const std::vector<Move> kNone;
    const std::vector<Move>& read = reading.result.path ? reading.result.path->moves : kNone;
    const std::size_t most = std::min(read.size(), path_.moves.size());
    while (fault.move < most) {
      const auto one = distance(path_.moves[fault.move], read[fault.move]);
      if (!one || !(*one <= kDgtDeviation)) break;
      ++fault.move;
    }
    if (fault.move < path_.moves.size()) {
      const Move& move = path_.moves[fault.move];
      fault.place = move.source;
      if (move.z) fault.kind = WriteFault::Kind::HeightImpossible;
    }
    return fault;
  }

  const Toolpath& path_;
  std::string title_;
  std::vector<DgtStyle> styles_;
  DgtText text_;
};

/// A comment is one line.
std::string in_one_line(std::string title) {
  std::erase_if(title, [](unsigned char c) { return c < ' '; });
  return title;
}

}  // namespace

DgtSource write_dgt(const Toolpath& path, const std::string& title) {
  return DgtWriting(path, in_one_line(title)).run();
}

}  // namespace dgt
