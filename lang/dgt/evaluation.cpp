// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/evaluation.h"

#include <fmt/format.h>

#include <algorithm>

namespace dgt::language {

std::string to_text(const ElementName& name) {
  return fmt::format("{}{}{}", name.letter, name.reversed ? "-" : "", name.number);
}

std::string millimetres(double value) { return fmt::format("{:.9g}", value); }

std::optional<ElementName> Evaluation::name_of(const Item& item) {
  if (!item.number.is_variable()) {
    return ElementName{item.letter, item.number.whole, item.number.minus};
  }
  const std::optional<Rational> number = value(item);
  if (!number) return std::nullopt;
  const bool negative = sgn(*number) < 0 || (sgn(*number) == 0 && item.number.minus);
  if (number->get_den() != 1 || abs(*number) > kMaxElementNumber) {
    bag.add({Message::BadElementNumber,
             item.range,
             {std::string(1, item.letter), to_short_decimal(*number)}});
    return std::nullopt;
  }
  if (negative && item.letter != 'L' && item.letter != 'C') {
    bag.add({Message::NothingToReverse, item.range, {std::string(1, item.letter)}});
    return std::nullopt;
  }
  const int whole = static_cast<int>(number->get_num().get_si());
  return ElementName{item.letter, negative ? -whole : whole, negative};
}

const ElementEntry* Evaluation::look_up(const Item& item, const ElementName& name) {
  const auto kind = static_cast<ElementKind>(name.letter);
  const ElementEntry* entry = elements.find(kind, name.number);
  const bool undefined = entry == nullptr || entry->state == ElementEntry::State::Undefined;
  if (undefined && !names_missing) {
    bag.add({Message::UndefinedElement,
             item.range,
             {to_text(ElementName{name.letter, name.number, false})}});
    elements.at(kind, name.number).state = ElementEntry::State::Unknown;
  }
  return undefined || entry->state == ElementEntry::State::Unknown ? nullptr : entry;
}

ElementPtr Evaluation::element(const Item& item, const ElementName& name) {
  if (look_up(item, name) == nullptr) return nullptr;
  ElementEntry& entry = elements.at(static_cast<ElementKind>(name.letter), name.number);
  if (!name.reversed) return entry.element;
  if (!entry.reversed) entry.reversed = std::make_shared<const Element>(reversed(*entry.element));
  return entry.reversed;
}

std::optional<KnownPoint> Evaluation::point(const Item& item) {
  if (item.is_inline_point) {
    const std::optional<Rational> x = variables.value(item.number);
    const std::optional<Rational> y = variables.value(item.second);
    if (!x || !y) return std::nullopt;
    return known_point(RationalPoint{*x, *y});
  }
  const std::optional<ElementName> name = name_of(item);
  const ElementEntry* const entry = name ? look_up(item, *name) : nullptr;
  if (entry == nullptr) return std::nullopt;
  return *entry->point;
}

std::optional<Selector> Evaluation::selector(const Item& item) {
  const std::optional<Rational> number = value(item);
  if (!number) return std::nullopt;
  if (number->get_den() != 1 || *number < 1 || *number > 6) {
    bag.add({Message::BadSelector, item.range, {to_short_decimal(*number)}});
    return std::nullopt;
  }
  static constexpr Selector kSelectors[] = {Selector::I1,       Selector::I2,
                                            Selector::GreaterX, Selector::GreaterY,
                                            Selector::SmallerX, Selector::SmallerY};
  return kSelectors[number->get_num().get_si() - 1];
}

bool Evaluation::is_caller(const SourceFile* owner) const {
  if (owner == nullptr || call_stack.size() < 2 || owner == call_stack.back()) return false;
  const auto holds = [&](const std::vector<const SourceFile*>& files) {
    return std::find(files.begin(), files.end(), owner) != files.end();
  };
  return holds(call_stack) || holds(definition_files);
}

}  // namespace dgt::language
