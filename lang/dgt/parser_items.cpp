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
    const bool lone = w.is(WordKind::Letter) && w.form == NumberForm::None;
    const bool told = lone && (report_unknown_word(w) || report_letter_for_zero(w));
    if (!told) report_unexpected(w);
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
    if (report_unknown_word(w)) return false;
    if (w.letter == 'V') return true;  // the tangent of two circles
    if (report_letter_for_zero(w) || report_letter_for_one(w)) return false;
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
  report_letter_for_digit(join(first.range, letter.range), letter.range, '0');
  return true;
}

// `Xl0`, `Ll=Y5`: a small L where a one was meant. `w` has no number; words_[at_ - 1] is `w`.
bool LineParser::report_letter_for_one(const Word& w) {
  const bool is_small_l = !at_end() && word().is_letter('L') && touches(w, word()) &&
                          word().range.text().front() == 'l' && !word().minus;
  if (!is_small_l) return false;
  const Range letter{w.range.file, word().range.begin, word().range.begin + 1};
  report_letter_for_digit(join(w.range, word().range), letter, '1');
  ++at_;
  return true;
}

void LineParser::report_letter_for_digit(const Range& range, const Range& letter, char digit) {
  const std::string written(range.text());
  std::string meant = written;
  meant.replace(letter.begin - range.begin, letter.end - letter.begin, 1, digit);
  const std::string with(1, digit);
  fail({Message::LetterForDigit,
        range,
        {written, meant, std::string(letter.text()), with},
        {},
        FixIt{letter, with}});
}

// `CALL`: no three letters of the language stand side by side without a number. words_[at_ - 1] is
// `w`, which has none.
bool LineParser::report_unknown_word(const Word& w) {
  std::size_t end = at_;
  while (end < words_.size() && words_[end].is(WordKind::Letter) &&
         touches(words_[end - 1], words_[end]) && words_[end - 1].form == NumberForm::None) {
    ++end;
  }
  if (end - at_ < 2) return false;
  const Range range = join(w.range, words_[end - 1].range);
  at_ = end;
  fail({Message::UnknownWord, range, {std::string(range.text())}});
  return true;
}

// `-L1`. words_[at_ - 1] is the minus.
bool LineParser::report_misplaced_minus(const Word& minus) {
  const bool before_letter = minus.letter == '-' && next_is(WordKind::Letter) && !word().minus &&
                             word().form != NumberForm::None && touches(minus, word());
  if (!before_letter) return false;
  const Range range = join(minus.range, word().range);
  const std::string meant =
      std::string(1, word().letter).append("-").append(word().number().text());
  ++at_;
  fail({Message::MisplacedMinus, range, {meant}, {}, FixIt{range, meant}});
  return true;
}

// A fault in the line has often thrown its other words out of place: signs are not told then.
void LineParser::report_unexpected(const Word& w) {
  const std::string written(w.range.text());
  if (w.is(WordKind::Number)) return report_number(w);
  if (w.is(WordKind::QuoteOpen) || w.is(WordKind::QuoteClose)) return report_quote(w);
  if (w.is(WordKind::Operator) && report_misplaced_minus(w)) return;
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
  if (!w.is(WordKind::Letter) && unreadable_) return;  // what is left of something that was told
  fail({Message::Unexpected, w.range, {written}});
  if (!w.is(WordKind::Letter)) skip_spoiled_words();
}

// `X0,5`. words_[at_ - 1] is the number behind the comma.
void LineParser::report_decimal_comma() {
  const Word& whole = words_[at_ - 3];
  const Word& fraction = words_[at_ - 1];
  fail({Message::DecimalComma,
        join(whole.range, fraction.range),
        {std::string(whole.number().text()).append(".").append(fraction.range.text())},
        {},
        FixIt{words_[at_ - 2].range, "."}});
}

// words_[at_ - 1] is `w`. Numbers that follow without a letter are told with it.
void LineParser::report_number(const Word& w) {
  const bool after_comma =
      at_ >= 3 && words_[at_ - 2].is(WordKind::Comma) && words_[at_ - 3].is(WordKind::Letter) &&
      words_[at_ - 3].form == NumberForm::Decimal && !is_element(words_[at_ - 3].letter) &&
      touches(words_[at_ - 3], words_[at_ - 2]) && touches(words_[at_ - 2], w);
  if (after_comma) return report_decimal_comma();
  const bool after_equals = at_ >= 2 && words_[at_ - 2].is(WordKind::Equals);
  const bool known = broken_ && after_equals;
  Range range = w.range;
  for (std::size_t i = at_; i < words_.size(); ++i) {
    if (words_[i].is(WordKind::Comma)) continue;
    if (!words_[i].is(WordKind::Number)) break;
    range = join(range, words_[i].range);
    at_ = i + 1;
  }
  if (!known) fail({Message::StrayNumber, range, {std::string(range.text())}});
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
