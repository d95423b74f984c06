// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/crossing_messages.h"

#include <algorithm>

#include "lang/dgt/evaluation.h"
#include "lang/text/column.h"

namespace dgt::language {
namespace {

/// A place to look at, to the micrometre.
std::string micrometres(double value) { return to_short_decimal(Rational(value), 3); }

class CrossingReporter {
 public:
  CrossingReporter(const Toolpath& path, const PathSources& sources, DiagnosticBag& bag)
      : path_(path), sources_(sources), bag_(bag) {}

  void report(const PartCrossing& crossing) {
    const Move& move = path_.moves[crossing.move];
    const Contour& contour = path_.contours[crossing.contour];
    const std::string name = "K" + std::to_string(contour.id);
    const std::string x = micrometres(crossing.x);
    const std::string y = micrometres(crossing.y);
    const Range range = word_at(move.source);
    const Range wall = word_at(programmed_moves(path_, contour)[crossing.wall].source);
    Diagnostic told{message_of(move, crossing), range, {name, x, y}};
    if (move.kind != MoveKind::Rapid) {
      told.arguments.insert(told.arguments.begin(), std::string(range.text()));
    }
    if (crossing.depth > 0) told.arguments.push_back(millimetres(crossing.depth));
    if (wall != range)
      told.notes.push_back({Message::CrossedHere, wall, {std::string(wall.text())}});
    bag_.add(std::move(told));
  }

 private:
  static Message message_of(const Move& move, const PartCrossing& crossing) {
    if (move.kind == MoveKind::Rapid) return Message::RapidCrosses;
    return crossing.depth > 0 ? Message::LeadCuts : Message::LeadCrosses;
  }

  [[nodiscard]] const SourceFile& file_of(const SourcePlace& place) const {
    const std::string& name = path_.files.at(place.file);
    const auto found = std::ranges::find_if(sources_.others,
                                            [&](const auto& file) { return file->name() == name; });
    return found == sources_.others.end() ? *sources_.program : **found;
  }

  /// The word that begins at a place: its sign, its letters, its number.
  [[nodiscard]] Range word_at(const SourcePlace& place) const {
    const SourceFile& file = file_of(place);
    const std::string_view line = file.line_text(place.line);
    const std::uint32_t start = file.line_start(place.line);
    const std::uint32_t begin = byte_at(file, place.line, place.column) - start;
    std::size_t end = begin;
    const auto skip = [&](std::string_view signs, auto&& also) {
      while (end < line.size() &&
             (signs.find(line[end]) != std::string_view::npos || also(line[end])))
        ++end;
    };
    const auto none = [](char) { return false; };
    skip("+-", none);
    skip("", [](char c) {
      return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
             static_cast<unsigned char>(c) >= 0x80;
    });
    skip("+-", none);
    skip("0123456789.", none);
    return {&file, start + begin, start + static_cast<std::uint32_t>(end)};
  }

  const Toolpath& path_;
  const PathSources& sources_;
  DiagnosticBag& bag_;
};

}  // namespace

void report_crossings(const Toolpath& path, const EvaluateOptions& options,
                      const PathSources& sources, DiagnosticBag& bag) {
  CrossingReporter reporter(path, sources, bag);
  for (const PartCrossing& crossing :
       find_part_crossings(path, options.crossings, options.join_tolerance))
    reporter.report(crossing);
}

}  // namespace dgt::language
