// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace dgt::language {

namespace {

// A digit too many, too few, or in the place of another, between numbers of which the longer has
// two digits at least: 1 and 2 are no slip.
bool is_one_slip_away(std::string_view a, std::string_view b) {
  if (a.size() < b.size()) std::swap(a, b);
  if (a.size() < 2 || a.size() > b.size() + 1) return false;
  const auto [at_a, at_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (at_a == a.end()) return false;
  const auto rest_b = at_b + (a.size() == b.size() ? 1 : 0);
  return std::equal(at_a + 1, a.end(), rest_b, b.end());
}

}  // namespace

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
    report({Message::BadElementNumber,
            item.range,
            {std::string(1, item.letter), to_short_decimal(*number)}});
    return std::nullopt;
  }
  if (negative && item.letter != 'L' && item.letter != 'C') {
    report({Message::NothingToReverse, item.range, {std::string(1, item.letter)}});
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
    report_undefined(Message::UndefinedElement, item, name);
    elements.at(kind, name.number).state = ElementEntry::State::Unknown;
  }
  return undefined || entry->state == ElementEntry::State::Unknown ? nullptr : entry;
}

void Evaluation::warn_if_undefined(const Item& item) {
  const ElementName name{item.letter, item.number.whole, item.number.minus};
  const ElementEntry* const entry =
      elements.find(static_cast<ElementKind>(name.letter), name.number);
  if (entry == nullptr || entry->state == ElementEntry::State::Undefined) {
    report_undefined(Message::UndefinedInSkippedLoop, item, name);
  }
}

// With the definition that was meant, where one can be told: the same name later in the program, or
// a name that is one slip of the finger away.
void Evaluation::report_undefined(Message message, const Item& item, const ElementName& name) {
  const std::string written = to_text(ElementName{name.letter, name.number, false});
  Diagnostic fault{message, item.range, {written}};
  if (bag.error_count() > DiagnosticBag::kMaxKept) return report(std::move(fault));  // not shown
  if (std::optional<Note> later = defined_later(item, name)) {
    fault.notes.push_back(*std::move(later));
  } else if (const std::optional<ElementName> similar = similar_name(name)) {
    const ElementEntry& entry =
        *elements.find(static_cast<ElementKind>(similar->letter), similar->number);
    fault.notes.push_back({Message::SimilarName,
                           entry.place,
                           {to_text(ElementName{similar->letter, similar->number, false})}});
    if (!item.number.is_variable()) {
      fault.fix_it = FixIt{item.range, to_text(*similar), Certainty::Guess};
    }
  }
  report(std::move(fault));
}

// The sources are read a second time for this, once each, so that no program without such a fault
// pays for it.
std::optional<Note> Evaluation::defined_later(const Item& item, const ElementName& name) {
  for (const SourceFile* const file : call_stack) {
    auto places = definition_places_.find(file);
    if (places == definition_places_.end()) {
      places = definition_places_.emplace(file, DefinitionPlaces(*file)).first;
    }
    if (const auto target = places->second.first_outside(item.range, name.letter, name.number)) {
      const std::string written = to_text(ElementName{name.letter, name.number, false});
      return Note{Message::DefinedLater, *target, {written}};
    }
  }
  return std::nullopt;
}

// The one defined element of the kind whose number has a digit more, less or other; nothing when
// there are several.
std::optional<ElementName> Evaluation::similar_name(const ElementName& name) const {
  const std::vector<ElementEntry>& all = elements.all(static_cast<ElementKind>(name.letter));
  std::optional<ElementName> found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].state != ElementEntry::State::Defined) continue;
    if (!is_one_slip_away(std::to_string(name.number), std::to_string(i))) continue;
    if (found) return std::nullopt;
    found = ElementName{name.letter, static_cast<int>(i), name.reversed};
  }
  return found;
}

ElementPtr Evaluation::element(const Item& item, const ElementName& name) {
  if (look_up(item, name) == nullptr) return nullptr;
  ElementEntry& entry = elements.at(static_cast<ElementKind>(name.letter), name.number);
  if (!name.reversed) return entry.element;
  if (!entry.reversed) entry.reversed = ElementPtr(reversed(*entry.element));
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
    report({Message::BadSelector, item.range, {to_short_decimal(*number)}});
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
