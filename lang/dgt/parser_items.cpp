// SPDX-License-Identifier: GPL-3.0-or-later
//
// Items: letters with their numbers, as they stand in definitions and contours.
#include <algorithm>

#include "lang/dgt/line_parser.h"

namespace dgt::language {
namespace {

bool is_element(char letter) {
  return std::string_view("LCPOK").find(letter) != std::string_view::npos;
}
// Elements that run one way, so that a minus turns them.
bool is_directed(char letter) { return letter == 'L' || letter == 'C'; }

}  // namespace

std::vector<Item> LineParser::parse_items(std::string_view letters) {
  std::vector<Item> items;
  items.reserve(words_.size() - at_);
  while (!at_end()) {
    if (next_is(WordKind::Comma)) {
      ++at_;
    } else if (std::optional<Item> item = parse_item(letters)) {
      items.push_back(*std::move(item));
    }
  }
  return items;
}

// Takes at least one word. A word with a fault is reported and gives nothing.
std::optional<Item> LineParser::parse_item(std::string_view letters) {
  const Word& w = word();
  ++at_;
  Item item;
  item.line = w.line;
  item.column = w.column;
  item.range = w.range;
  if (w.is(WordKind::Selector)) {
    item.letter = 'I';
    item.number = {NumberForm::Decimal, false, static_cast<std::int32_t>(w.digits), nullptr};
    return item;
  }
  if (!w.is(WordKind::Letter) || letters.find(w.letter) == std::string_view::npos) {
    report_unexpected(w);
    return std::nullopt;
  }
  if (!check_item_number(w)) return std::nullopt;
  item.letter = w.letter;
  item.number = number_of(w);
  return item;
}

bool LineParser::check_item_number(const Word& w) {
  const std::string letter(1, w.letter);
  if (w.form == NumberForm::None) {
    if (w.letter == 'V') return true;  // the tangent of two circles
    if (report_letter_for_zero(w)) return false;
    fail({Message::MissingNumber, w.range, {letter}});
    skip_spoiled_words();
    return false;
  }
  if (!is_element(w.letter)) return true;
  const std::string written(w.range.text());
  if (w.minus && !is_directed(w.letter)) {
    fail({Message::NothingToReverse,
          w.range,
          {letter},
          {},
          FixIt{w.range, letter + std::string(w.number().text())}});
    return false;
  }
  if (w.form != NumberForm::Decimal) return true;
  const Number number = number_of(w);
  if (number.exact || number.whole > kMaxElementNumber) {
    fail({Message::BadElementNumber, w.range, {letter, std::string(w.number().text())}});
    return false;
  }
  return true;
}

// `GO X5`, `X1O`: the letter O where a zero was meant. `w` has no number; words_[at_ - 1] is `w`.
bool LineParser::report_letter_for_zero(const Word& w) {
  const bool number_lost =
      !at_end() && word().is_letter('O') && touches(w, word()) && word().form == NumberForm::None;
  const bool behind_number = w.letter == 'O' && at_ >= 2 && touches(words_[at_ - 2], w) &&
                             words_[at_ - 2].form == NumberForm::Decimal;
  if (!number_lost && !behind_number) return false;
  const Word& first = number_lost ? w : words_[at_ - 2];
  const Word& letter = number_lost ? words_[at_++] : w;
  const Range range = join(first.range, letter.range);
  const std::string written(range.text());
  const std::string meant = written.substr(0, letter.range.begin - range.begin) + "0";
  fail({Message::LetterForZero, range, {written, meant}, {}, FixIt{letter.range, "0"}});
  return true;
}

// A fault in the line has often thrown its other words out of place: signs are not told then.
void LineParser::report_unexpected(const Word& w) {
  const std::string written(w.range.text());
  if (w.is(WordKind::Number)) return report_number(w);
  if (w.is(WordKind::QuoteOpen) || w.is(WordKind::QuoteClose)) return report_quote(w);
  const bool behind_number = at_ >= 2 && words_[at_ - 2].form != NumberForm::None;
  if (w.is(WordKind::Operator) && behind_number) {
    Range sum = w.range;
    for (; next_is(WordKind::Number) || next_is(WordKind::Operator); ++at_) {
      sum = join(sum, word().range);
    }
    fail({Message::ArithmeticOutsideN, sum, {std::string(sum.text())}});
    return;
  }
  if (w.is(WordKind::Equals) && broken_) return;
  fail({Message::Unexpected, w.range, {written}});
  if (!w.is(WordKind::Letter)) skip_spoiled_words();
}

// words_[at_ - 1] is `w`.
void LineParser::report_number(const Word& w) {
  const std::string written(w.range.text());
  const bool after_comma = at_ >= 3 && words_[at_ - 2].is(WordKind::Comma) &&
                           words_[at_ - 3].form == NumberForm::Decimal &&
                           touches(words_[at_ - 3], words_[at_ - 2]) && touches(words_[at_ - 2], w);
  if (after_comma) {
    fail({Message::DecimalComma,
          join(words_[at_ - 3].range, w.range),
          {std::string(words_[at_ - 3].number().text()) + "." + written},
          {},
          FixIt{words_[at_ - 2].range, "."}});
    return;
  }
  const bool after_equals = at_ >= 2 && words_[at_ - 2].is(WordKind::Equals);
  if (!broken_ || !after_equals) fail({Message::StrayNumber, w.range, {written}});
}

// A quote takes its text with it.
void LineParser::report_quote(const Word& w) {
  Range text = w.range;
  if (w.is(WordKind::QuoteOpen)) {
    while (!at_end() && !next_is(WordKind::QuoteClose)) ++at_;
    if (!at_end()) text = join(text, words_[at_++].range);
  }
  if (!broken_) fail({Message::TextOutsideB, text, {}});
}

// What can only belong to a word that was wrong: signs and numbers without a letter.
void LineParser::skip_spoiled_words() {
  while (next_is(WordKind::Number) || next_is(WordKind::Operator)) ++at_;
}

void join_coordinates(std::vector<Item>& items, bool any_order) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < items.size(); ++i, ++kept) {
    Item item = std::move(items[i]);
    const bool last = i + 1 == items.size();
    const bool x_first = !last && item.letter == 'X' && items[i + 1].letter == 'Y';
    const bool free = any_order || (kept > 0 && items[kept - 1].letter == 'G');
    const bool y_first = !last && free && item.letter == 'Y' && items[i + 1].letter == 'X';
    if (x_first || y_first) {
      Item& other = items[++i];
      item.letter = 'P';
      item.is_inline_point = true;
      item.range = join(item.range, other.range);
      item.second = std::move(other.number);
      if (y_first) std::swap(item.number, item.second);
    }
    items[kept] = std::move(item);
  }
  items.erase(items.begin() + static_cast<std::ptrdiff_t>(kept), items.end());
}

}  // namespace dgt::language
