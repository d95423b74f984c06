// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/line_parser.h"

#include <algorithm>

#include "kernel/check.h"

namespace dgt::language {
namespace {

constexpr std::string_view kContourLetters = "LCPXYRVDZAOWUGFSTMI";

bool is_element_letter(char c) { return c == 'L' || c == 'C' || c == 'P' || c == 'O'; }

bool is_keyword(const Word& w) {
  return w.is(WordKind::For) || w.is(WordKind::Next) || w.is(WordKind::Mac) || w.is(WordKind::Opr);
}

// `N10 L1=Y0`, `10 L1=Y0`
bool is_numbered(std::span<const Word> words) {
  if (words.size() < 2) return false;
  const Word& first = words[0];
  const bool is_number = first.form == NumberForm::Decimal && !first.minus &&
                         (first.is(WordKind::Number) || first.is_letter('N'));
  return is_number && (words[1].is(WordKind::Letter) || is_keyword(words[1]));
}

// What the rest of a word that could not be read looks like.
bool is_leftover(Message message) {
  switch (message) {
    case Message::ExpectedValue:
    case Message::ExtraWords:
    case Message::StrayNumber:
    case Message::ArithmeticOutsideN:
      return true;
    default:
      return false;
  }
}

}  // namespace

std::size_t first_statement(std::span<const Word> words) {
  const bool uses_texts =
      std::any_of(words.begin(), words.end(), [](const Word& w) { return w.is_letter('B'); });
  for (std::size_t i = is_numbered(words) ? 2 : 1; i < words.size() && !uses_texts; ++i) {
    const Word& w = words[i];
    const bool has_equals = i + 1 < words.size() && words[i + 1].is(WordKind::Equals);
    const bool is_target = w.is(WordKind::Letter) && w.form != NumberForm::None &&
                           (w.letter == 'K' || (has_equals && i > 1 &&
                                                (is_element_letter(w.letter) || w.letter == 'N')));
    if (is_keyword(w) || is_target) return i;
  }
  return words.size();
}

void LineParser::fail(Diagnostic diagnostic) {
  if (diagnostic.severity() == Severity::Error) broken_ = true;
  if (unreadable_ && is_leftover(diagnostic.message)) return;
  bag_.add(std::move(diagnostic));
}

Statement LineParser::parse() {
  DGT_CHECK(!words_.empty());
  skip_line_number();
  Statement statement{parse_body(), join(words_.front().range, words_.back().range), false};
  statement.broken = broken_;
  return statement;
}

void LineParser::skip_line_number() {
  if (uses_texts() || !is_numbered(words_)) return;
  const Range& number = words_[0].range;
  fail({Message::LineNumber,
        number,
        {std::string(number.text())},
        {},
        FixIt{{number.file, number.begin, words_[1].range.begin}, ""}});
  words_ = words_.subspan(1);
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
  if (first.is_letter('B') && words_.size() > 1 && words_[1].is(WordKind::QuoteOpen)) {
    return parse_text_without_equals();
  }
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
