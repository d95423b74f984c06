// SPDX-License-Identifier: GPL-3.0-or-later
//
// N and B variables: assignments, and texts put in place.
#include <algorithm>

#include "kernel/check.h"
#include "lang/dgt/dump.h"
#include "lang/dgt/evaluator.h"
#include "lang/dgt/parser.h"

namespace dgt::language {
namespace {

// A number that doubles its digits with every round of a loop would fill the memory long before a
// bound on statements stops it. In bits of numerator and denominator: far beyond any drawing.
constexpr std::size_t kMaxNumberBits = 1 << 16;

// Words of one line with its texts in place; texts that hold texts grow without measure.
constexpr std::size_t kMaxWordsOfLine = 1'000'000;

// A loop has its lines in the source, so none begins or ends in a text.
bool steers(const Statement* statement) {
  return statement != nullptr && (std::holds_alternative<ForLoop>(statement->body) ||
                                  std::holds_alternative<LoopEnd>(statement->body));
}

std::string text_name(int index) { return "B" + std::to_string(index); }

}  // namespace

void Evaluator::execute(const NumberAssignment& assignment, const Statement& statement) {
  set_number(assignment.variable, statement.broken ? std::nullopt : evaluate(assignment),
             statement.range);
}

// Strictly from left to right, exactly.
std::optional<Rational> Evaluator::evaluate(const NumberAssignment& assignment) {
  Rational result = 0;
  for (const NumberAssignment::Term& term : assignment.terms) {
    const std::optional<Rational> value = shared_.variables.value(term.number);
    if (!value) return std::nullopt;
    switch (term.operation) {
      case '+':
        result += *value;
        break;
      case '-':
        result -= *value;
        break;
      case '*':
        result *= *value;
        break;
      default:
        if (sgn(*value) == 0) {
          report_division(term);
          return std::nullopt;
        }
        result /= *value;
    }
    if (height(result) > kMaxNumberBits) {
      shared_.report({Message::NumberTooLarge, term.range, {std::to_string(kMaxNumberBits)}});
      return std::nullopt;
    }
  }
  return result;
}

void Evaluator::report_division(const NumberAssignment::Term& term) {
  if (!term.number.is_variable()) {
    shared_.report({Message::DivisionByZero, term.range, {to_text(term.number)}});
    return;
  }
  const std::string name = "N" + std::to_string(term.number.whole);
  Diagnostic fault{Message::DivisionByZero, term.range, {name + "=0"}};
  const Range& place = shared_.variables.number(term.number.whole).place;
  if (place.file) fault.notes.push_back({Message::SetHereBefore, place, {name}});
  shared_.report(std::move(fault));
}

void Evaluator::set_number(int index, std::optional<Rational> value, const Range& place) {
  if (index == 0) return;  // a variable that does not exist, which has been reported
  Variables::NumberVariable& variable = shared_.variables.number(index);
  if (shared_.is_caller(variable.owner)) {
    if (variable.value == value) return;  // it stays the caller's
    const std::string name = "N" + std::to_string(index);
    shared_.report({Message::VariableClash,
                    place,
                    {name},
                    {{Message::SetHereBefore, variable.place, {name}}}});
  }
  variable = {std::move(value), place, shared_.call_stack.back()};
}

void Evaluator::execute(const TextAssignment& assignment, bool broken) {
  const Item& target = assignment.target;
  if (target.letter == 0) return;  // nobody knows which text it was to be
  const std::optional<Rational> index = shared_.value(target);
  if (!index) return;
  if (index->get_den() != 1 || *index < 1 || *index > kVariableCount) {
    shared_.report({Message::NoSuchText, target.range, {to_short_decimal(*index)}});
    return;
  }
  Variables::TextVariable& text =
      shared_.variables.text(static_cast<int>(index->get_num().get_si()));
  text.failed = broken;
  text.words = broken ? nullptr : assignment.words;
}

// A line in a loop is put together again only when a text in it has changed.
void Evaluator::execute(const SplicedLine& line, const Statement& statement) {
  std::vector<Word> words;
  std::vector<Variables::TextWords> texts;
  std::vector<int> path;
  if (!expand(line.words, path, words, texts)) {
    if (contours_.is_open()) contours_.mark_broken();
    return;
  }
  Splice& splice = splices_[&line];
  if (!splice.statement || splice.texts != texts) {
    DiagnosticBag faults;
    std::optional<Statement> parsed = parse_spliced(words, statement.broken, faults);
    splice.statement = parsed ? std::make_shared<const Statement>(*std::move(parsed)) : nullptr;
    splice.texts = std::move(texts);
    shared_.expansion.push(Message::TextUsedHere, statement.range);
    if (!steers(splice.statement.get())) {
      for (const Diagnostic& fault : faults.all()) shared_.report(fault);
    }
    shared_.expansion.pop();
  }
  // Held here: a macro in the line may come back to it and put it together anew.
  const auto current = splice.statement;
  if (!current) return;
  shared_.expansion.push(Message::TextUsedHere, statement.range);
  if (steers(current.get())) {
    const std::string word = std::holds_alternative<ForLoop>(current->body) ? "FOR" : "NEXT";
    shared_.report({Message::Unexpected, current->range, {word}});
  }
  execute_simple(*current);
  shared_.expansion.pop();
}

std::optional<int> Evaluator::text_index(const Word& word) {
  Item item;
  item.number = number_of(word);
  if (item.number.is_absent()) {
    shared_.report({Message::MissingNumber, word.range, {"B"}});
    return std::nullopt;
  }
  const std::optional<Rational> index = shared_.value(item);
  if (!index) return std::nullopt;
  if (index->get_den() == 1 && *index >= 1 && *index <= kVariableCount) {
    return static_cast<int>(index->get_num().get_si());
  }
  shared_.report({Message::NoSuchText, word.range, {to_short_decimal(*index)}});
  return std::nullopt;
}

// Appends `words` to `out`, every B replaced by its text. False when one cannot be had.
bool Evaluator::expand(const std::vector<Word>& words, std::vector<int>& path,
                       std::vector<Word>& out, std::vector<Variables::TextWords>& texts) {
  for (const Word& word : words) {
    if (!word.is_letter('B')) {
      out.push_back(word);
      continue;
    }
    const std::optional<int> index = text_index(word);
    if (!index) return false;
    const Variables::TextVariable& text = shared_.variables.text(*index);
    if (!text.words) {
      if (!text.failed) {
        shared_.report({Message::UndefinedText, word.range, {text_name(*index)}});
      }
      return false;
    }
    if (holds_itself(word, *index, path)) return false;
    texts.push_back(text.words);
    if (out.size() + text.words->size() > kMaxWordsOfLine) {
      stop(Message::LineTooLong, word.range, kMaxWordsOfLine);
      return false;
    }
    path.push_back(*index);
    const bool complete = expand(*text.words, path, out, texts);
    path.pop_back();
    if (!complete) return false;
  }
  return true;
}

// A text in itself has no end, since nothing in it changes on the way; texts in texts have one.
bool Evaluator::holds_itself(const Word& word, int index, const std::vector<int>& path) {
  const auto first = std::find(path.begin(), path.end(), index);
  if (first != path.end()) {
    std::string circle;
    for (auto i = first; i != path.end(); ++i) circle += text_name(*i) + " → ";
    shared_.report(
        {Message::RecursiveText, word.range, {text_name(index), circle + text_name(index)}});
    return true;
  }
  const std::uint32_t limit = shared_.options.bounds.text_depth;
  if (path.size() < limit) return false;
  stop(Message::TextsTooDeep, word.range, limit);
  return true;
}

}  // namespace dgt::language
