// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "lang/dgt/line_parser.h"

namespace dgt::language {
namespace {

constexpr std::string_view kOperandLetters = "LCPXYRDAMI";

std::string letters_of(const std::vector<Item>& operands) {
  std::string letters;
  for (const Item& item : operands) letters += item.letter;
  return letters;
}

// `P and R`, as `P, R`.
std::string listed(std::string_view letters) { return fmt::format("{}", fmt::join(letters, ", ")); }

}  // namespace

Statement::Body LineParser::parse_definition() {
  Definition definition;
  definition.kind = static_cast<ElementKind>(words_[0].letter);
  if (words_[0].minus && words_[0].form == NumberForm::Decimal) {
    fail({Message::NegativeTarget, words_[0].range, {std::string(1, words_[0].letter)}});
    ++at_;
  } else if (const std::optional<Item> target = parse_item(std::string_view("LCPO"))) {
    definition.target = *target;
  }
  while (!next_is(WordKind::Equals)) ++at_;
  ++at_;
  for (Item& item : parse_items(kOperandLetters)) {
    (item.letter == 'I' ? definition.selector : definition.operands).push_back(std::move(item));
  }
  join_coordinates(definition.operands, true);
  if (definition.selector.size() > 1) {
    fail({Message::SecondSelector, definition.selector[1].range, {}});
  }
  if (!broken_) choose_form(definition);
  return definition;
}

void LineParser::choose_form(Definition& definition) {
  const std::string letters = letters_of(definition.operands);
  if (letters.empty()) {
    fail({Message::EmptyDefinition, here(), {std::string(words_[0].range.text())}});
    return;
  }
  std::optional<FormMatch> match = match_form(definition.kind, letters);
  if (!match) {
    report_mismatch(definition, letters);
    return;
  }
  definition.match = *std::move(match);
  if (!definition.selector.empty() && !definition.match.form->takes_selector) {
    const Range range = definition.selector.front().range;
    fail({Message::UselessSelector,
          range,
          {std::string(definition.match.form->pattern)},
          {},
          FixIt{range, ""}});
  }
}

// The nearest forms say what is wrong. An operand that is missing is likelier than one too many:
// people forget.
void LineParser::report_mismatch(const Definition& definition, std::string_view letters) {
  if (letters.find('X') != std::string_view::npos && letters.find('Y') != std::string_view::npos) {
    const auto& operands = definition.operands;
    fail({Message::CoordinatesUnpaired, join(operands.front().range, operands.back().range), {}});
    return;
  }
  const FormMismatch mismatch = explain_mismatch(definition.kind, letters);
  std::string wanted;
  const FormMismatch::Candidate* surplus = nullptr;
  for (const FormMismatch::Candidate& candidate : mismatch.nearest) {
    if (candidate.surplus.empty()) {
      wanted += fmt::format("{}{} ({})", wanted.empty() ? "" : "; ", listed(candidate.missing),
                            candidate.form->pattern);
    } else if (candidate.missing.empty() && surplus == nullptr) {
      surplus = &candidate;
    }
  }
  if (!wanted.empty()) {
    fail({Message::MissingOperand, here(), {wanted}});
    return;
  }
  if (surplus != nullptr) {
    for (const std::size_t index : surplus->surplus) {
      const Item& item = definition.operands[index];
      fail({Message::SurplusOperand,
            item.range,
            {std::string(item.range.text()), std::string(surplus->form->pattern)}});
    }
    return;
  }
  std::string patterns;
  for (const Form& form : all_forms()) {
    if (form.result != definition.kind) continue;
    patterns += fmt::format("{}{}", patterns.empty() ? "" : ", ", form.pattern);
  }
  fail({Message::NoSuchForm,
        join(definition.operands.front().range, definition.operands.back().range),
        {std::string(1, static_cast<char>(definition.kind)), patterns}});
}

}  // namespace dgt::language
