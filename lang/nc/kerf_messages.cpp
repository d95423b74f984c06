// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/nc/kerf_messages.h"

#include <fmt/format.h>

#include <algorithm>

#include "lang/text/column.h"

namespace dgt {
namespace {

using Fault = ContourFault::Kind;

std::string millimetres(double value) { return fmt::format("{:.6g}", value); }

}  // namespace

Range KerfMessages::block_of(std::size_t move) const {
  const SourcePlace& place = program_.path.moves[move].source;
  const std::string_view line = file_.line_text(place.line);
  const std::uint32_t start = file_.line_start(place.line);
  const std::uint32_t begin = byte_at(file_, place.line, place.column) - start;
  std::size_t end = std::min(line.find_first_of("(;", begin), line.size());
  while (end > begin && (line[end - 1] == ' ' || line[end - 1] == '\t')) --end;
  return {&file_, start + begin, start + static_cast<std::uint32_t>(end)};
}

std::string KerfMessages::text_of(std::size_t move) const {
  return std::string(block_of(move).text());
}

void KerfMessages::add(Diagnostic diagnostic, std::size_t move) {
  for (const SubprogramRun& run : program_.runs) {
    if (run.first <= move && move < run.last)
      diagnostic.notes.push_back({Message::InSubprogram, run.call, {std::to_string(run.number)}});
  }
  bag_.add(std::move(diagnostic));
}

void KerfMessages::report(Message message, std::size_t move, std::vector<std::string> arguments) {
  add({message, block_of(move), std::move(arguments)}, move);
}

void KerfMessages::report(const BuiltContour& built, std::size_t first) {
  for (const ContourFault& fault : built.faults) report(fault, first);
  for (const ContourNotice& notice : built.notices) report(notice, first);
}

/// Gaps that rounding in the program leaves between equidistants are no news.
void KerfMessages::report(const ContourNotice& notice, std::size_t first) {
  const std::size_t move = first + notice.item;
  if (notice.kind == ContourNotice::Kind::Trimmed) {
    add({Message::Trimmed,
         block_of(move),
         {text_of(move), text_of(first + notice.other), millimetres(notice.x),
          millimetres(notice.y)}},
        move);
    return;
  }
  const bool is_gouge = notice.kind == ContourNotice::Kind::Gouge;
  if (!is_gouge && notice.kind != ContourNotice::Kind::LongCorner) return;
  Diagnostic told = at_place(is_gouge ? Message::GougeAllowed : Message::LongCorner, move,
                             first + notice.other, notice.measure, notice.x, notice.y);
  if (!is_gouge) told.notes.push_back({Message::CornerChoice, told.range, {}});
  add(std::move(told), move);
}

void KerfMessages::report(const ContourFault& fault, std::size_t first) {
  Diagnostic diagnostic = told(fault, first);
  if (fault.largest_offset) {
    diagnostic.notes.push_back(
        {Message::KerfLargest, diagnostic.range, {to_short_decimal(*fault.largest_offset)}});
  }
  if (fault.round_works) diagnostic.notes.push_back({Message::CornerChoice, diagnostic.range, {}});
  add(std::move(diagnostic), first + fault.item);
}

Diagnostic KerfMessages::at_place(Message message, std::size_t move, std::size_t other,
                                  double measure, double x, double y) const {
  return {message,
          block_of(move),
          {text_of(move), text_of(other), millimetres(measure), millimetres(x), millimetres(y)}};
}

Diagnostic KerfMessages::told(const ContourFault& fault, std::size_t first) const {
  const std::size_t move = first + fault.item;
  const Range block = block_of(move);
  const std::string text = text_of(move);
  switch (fault.kind) {
    case Fault::Gouge:
      return at_place(Message::Gouge, move, first + fault.other, fault.measure, fault.x, fault.y);
    case Fault::Eaten:
      if (fault.measure > 0) return {Message::Eaten, block, {text, millimetres(fault.measure)}};
      return {Message::EatenToNothing, block, {text}};
    case Fault::ArcEaten:
    case Fault::ZeroArc:
      return {Message::ArcEaten, block, {text}};
    case Fault::Overrun:
      return {Message::Overrun, block, {text}};
    case Fault::TrimStart:
      return {Message::TrimStart, block, {text, millimetres(fault.x), millimetres(fault.y)}};
    case Fault::TrimBroken:
      return {Message::TrimBroken, block, {text, millimetres(fault.x), millimetres(fault.y)}};
    case Fault::TrimSplits:
      return {Message::TrimSplits, block, {text, millimetres(fault.x), millimetres(fault.y)}};
    case Fault::TrimNothing:
      return {Message::TrimNothing, block, {}};
    default:
      return {Message::KerfMisses,
              block,
              {text, text_of(first + fault.other), millimetres(fault.measure)}};
  }
}

}  // namespace dgt
