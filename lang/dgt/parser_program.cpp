// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines that steer the program: variables, loops, macros, definition files.
#include "lang/dgt/line_parser.h"

namespace dgt::language {
namespace {

// The index of an N word; 0 when it is none.
std::uint8_t variable_index(const Word& w) {
  const bool plain = w.is_letter('N') && w.form == NumberForm::Decimal && !w.minus &&
                     w.scale == 0 && w.digits >= 1 && w.digits <= kVariableCount;
  return plain ? static_cast<std::uint8_t>(w.digits) : std::uint8_t{0};
}

std::string written(const Word& w) { return std::string(w.range.text()); }

}  // namespace

std::optional<MacroCall::Argument> LineParser::parse_bare_number() {
  bool minus = false;
  Range range = at_end() ? here() : word().range;
  if (next_is(WordKind::Operator) && (word().letter == '-' || word().letter == '+')) {
    minus = word().letter == '-';
    ++at_;
  }
  MacroCall::Argument argument;
  if (next_is(WordKind::Number)) {
    argument.number = number_of(word());
  } else if (!at_end() && word().is_letter('N')) {
    const std::uint8_t variable = variable_index(word());
    if (variable == 0) {
      fail({Message::NoSuchVariable, word().range, {written(word())}});
      ++at_;
      return std::nullopt;
    }
    argument.number.form = NumberForm::Variable;
    argument.number.whole = variable;
  } else {
    fail({Message::ExpectedValue, at_end() ? here() : word().range, {}});
    return std::nullopt;
  }
  argument.number.minus = minus;
  argument.range = join(range, word().range);
  ++at_;
  return argument;
}

bool LineParser::next_is_decimal_comma() const {
  return at_ + 1 < words_.size() && word().is(WordKind::Comma) &&
         words_[at_ + 1].is(WordKind::Number) && words_[at_ - 1].form == NumberForm::Decimal &&
         touches(words_[at_ - 1], word()) && touches(word(), words_[at_ + 1]);
}

void LineParser::expect_end() {
  if (at_end()) return;
  if (next_is_decimal_comma()) {
    at_ += 2;
    report_decimal_comma();
    return expect_end();
  }
  const Range rest = join(word().range, words_.back().range);
  Diagnostic extra{Message::ExtraWords, rest, {std::string(rest.text())}};
  if (words_.size() - at_ == 1 && next_is(WordKind::Comma)) extra.fix_it = FixIt{rest, ""};
  fail(std::move(extra));
  at_ = words_.size();
}

Statement::Body LineParser::parse_number_assignment() {
  NumberAssignment assignment;
  const Word& target = words_[0];
  assignment.variable = variable_index(target);
  if (assignment.variable == 0) fail({Message::NoSuchVariable, target.range, {written(target)}});
  at_ = 2;
  char operation = '+';
  for (;;) {
    const std::optional<MacroCall::Argument> value = parse_bare_number();
    if (!value) return assignment;
    assignment.terms.push_back({operation, value->number, value->range});
    if (!next_is(WordKind::Operator)) break;
    operation = word().letter;
    ++at_;
  }
  expect_end();
  return assignment;
}

// `N1 5`, `N1+5`
Statement::Body LineParser::parse_number_without_equals() {
  NumberAssignment assignment;
  assignment.variable = variable_index(words_[0]);
  fail({Message::MissingEquals,
        words_[0].range,
        {written(words_[0])},
        {},
        FixIt{behind(words_[0].range), "="}});
  return assignment;
}

// `B1="…,"`: the words between the quotes are kept as they are; what they mean shows where they are
// used.
Statement::Body LineParser::parse_text_assignment() {
  TextAssignment assignment;
  if (const std::optional<Item> target = parse_item("B")) assignment.target = *target;
  at_ = 2;
  if (!next_is(WordKind::QuoteOpen)) {
    if (!broken_) fail({Message::ExpectedText, at_end() ? here() : word().range, {}});
    return assignment;
  }
  ++at_;
  std::vector<Word> words;
  for (; !at_end() && !next_is(WordKind::QuoteClose); ++at_) words.push_back(word());
  if (!at_end()) {
    if (words.empty() || !words.back().is(WordKind::Comma)) {
      const Range quote = word().range;
      fail({Message::TextWithoutComma,
            quote,
            {},
            {},
            FixIt{{quote.file, quote.begin, quote.begin}, ","}});
    }
    ++at_;
    expect_end();
  }
  assignment.words = std::make_shared<const std::vector<Word>>(std::move(words));
  return assignment;
}

// `B1 "…,"`
Statement::Body LineParser::parse_text_without_equals() {
  TextAssignment assignment;
  const Range target = words_[0].range;
  if (const std::optional<Item> item = parse_item("B")) assignment.target = *item;
  fail({Message::MissingEquals, target, {written(words_[0])}, {}, FixIt{behind(target), "="}});
  return assignment;
}

Statement::Body LineParser::parse_for() {
  ForLoop loop;
  ++at_;
  if (const std::optional<MacroCall::Argument> count = parse_bare_number()) {
    loop.count = count->number;
    loop.count_range = count->range;
    expect_end();
  }
  return loop;
}

Statement::Body LineParser::parse_next() {
  ++at_;
  expect_end();
  return LoopEnd{};
}

Statement::Body LineParser::parse_macro_call() {
  MacroCall call;
  ++at_;
  if (!next_is(WordKind::Name)) {
    fail({Message::ExpectedName, here(), {"MAC"}});
    return call;
  }
  call.name = word().range;
  ++at_;
  while (!at_end()) {
    const std::optional<MacroCall::Argument> argument = parse_bare_number();
    if (!argument) return call;
    call.arguments.push_back({argument->number, argument->range});
    if (!next_is(WordKind::Comma)) {
      fail({Message::ArgumentWithoutComma, argument->range, {}, {}, FixIt{here(), ","}});
      if (!at_end() && !next_is(WordKind::Number) && !next_is(WordKind::Operator)) return call;
    } else {
      ++at_;
    }
  }
  if (call.arguments.size() > kVariableCount) {
    fail({Message::TooManyArguments,
          call.arguments[kVariableCount].range,
          {std::to_string(kVariableCount)}});
    call.arguments.resize(kVariableCount);
  }
  return call;
}

Statement::Body LineParser::parse_definition_file() {
  DefinitionFile file;
  ++at_;
  if (!next_is(WordKind::Name)) {
    fail({Message::ExpectedName, here(), {"OPR"}});
    return file;
  }
  file.name = word().range;
  ++at_;
  expect_end();
  return file;
}

}  // namespace dgt::language
