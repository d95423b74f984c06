// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/line_parser.h"

#include <algorithm>

#include "kernel/check.h"

namespace dgt::language {
namespace {

constexpr std::string_view kContourLetters = "LCPXYRVDZAOWUGFSTMI";

bool is_element_letter(char c) { return c == 'L' || c == 'C' || c == 'P' || c == 'O'; }

}  // namespace

void LineParser::fail(Diagnostic diagnostic) {
  if (diagnostic.severity() == Severity::Error) broken_ = true;
  bag_.add(std::move(diagnostic));
}

Statement LineParser::parse() {
  DGT_CHECK(!words_.empty());
  Statement statement{parse_body(), join(words_.front().range, words_.back().range), false};
  statement.broken = broken_;
  return statement;
}

bool LineParser::is_assignment_to(char letter) const {
  return words_.size() > 1 && words_[0].is_letter(letter) && words_[1].is(WordKind::Equals);
}

bool LineParser::uses_texts() const {
  return std::any_of(words_.begin(), words_.end(), [](const Word& w) { return w.is_letter('B'); });
}

Statement::Body LineParser::parse_body() {
  const Word& first = words_.front();
  if (first.is(WordKind::For)) return parse_for();
  if (first.is(WordKind::Next)) return parse_next();
  if (first.is(WordKind::Opr)) return parse_definition_file();
  if (is_assignment_to('B')) return parse_text_assignment();
  if (uses_texts()) return SplicedLine{{words_.begin(), words_.end()}};
  if (first.is(WordKind::Mac)) return parse_macro_call();
  if (is_assignment_to('N')) return parse_number_assignment();
  if (first.is_letter('K')) return parse_contour_start();
  if (first.is(WordKind::Letter) && is_element_letter(first.letter) &&
      is_assignment_to(first.letter)) {
    return parse_definition();
  }
  if (first.is_letter('N') && words_.size() > 1 && !words_[1].is(WordKind::Letter)) {
    return parse_number_without_equals();
  }
  return parse_item_line();
}

Statement::Body LineParser::parse_contour_start() {
  ContourStart start;
  const std::optional<Item> target = parse_item("K");
  if (target) start.target = *target;
  if (next_is(WordKind::Equals)) ++at_;  // the guide's own KVAD writes `K1=`
  start.items = parse_items(kContourLetters);
  join_coordinates(start.items, false);
  return start;
}

Statement::Body LineParser::parse_item_line() {
  ItemLine line;
  line.has_comma = std::any_of(words_.begin(), words_.end(),
                               [](const Word& w) { return w.is(WordKind::Comma); });
  line.items = parse_items(kContourLetters);
  join_coordinates(line.items, false);
  return line;
}

}  // namespace dgt::language
