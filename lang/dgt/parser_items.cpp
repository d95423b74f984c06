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

bool touches(const Word& a, const Word& b) {
  return a.range.file == b.range.file && a.range.end == b.range.begin;
}

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

void LineParser::report_unexpected(const Word& w) {
  const std::string written(w.range.text());
  if (w.is(WordKind::Number)) {
    // words_[at_ - 1] is w.
    const bool after_comma = at_ >= 3 && words_[at_ - 2].is(WordKind::Comma) &&
                             words_[at_ - 3].form == NumberForm::Decimal &&
                             touches(words_[at_ - 3], words_[at_ - 2]) &&
                             touches(words_[at_ - 2], w);
    if (after_comma) {
      const Range comma = words_[at_ - 2].range;
      fail({Message::DecimalComma,
            join(words_[at_ - 3].range, w.range),
            {std::string(words_[at_ - 3].number().text()) + "." + written},
            {},
            FixIt{comma, "."}});
    } else {
      fail({Message::StrayNumber, w.range, {written}});
    }
    return;
  }
  fail({Message::Unexpected, w.range, {written}});
  if (!w.is(WordKind::Letter)) skip_spoiled_words();
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
    const bool y_first = !last && any_order && item.letter == 'Y' && items[i + 1].letter == 'X';
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
