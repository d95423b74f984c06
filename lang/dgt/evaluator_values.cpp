// SPDX-License-Identifier: GPL-3.0-or-later
//
// N and B variables: assignments, and texts put in place.
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
          bag_.add({Message::DivisionByZero, term.range, {to_text(term.number)}});
          return std::nullopt;
        }
        result /= *value;
    }
    if (height(result) > kMaxNumberBits) {
      bag_.add({Message::NumberTooLarge, term.range, {std::to_string(kMaxNumberBits)}});
      return std::nullopt;
    }
  }
  return result;
}

void Evaluator::set_number(int index, std::optional<Rational> value, const Range& place) {
  if (index == 0) return;  // a variable that does not exist, which has been reported
  Variables::NumberVariable& variable = shared_.variables.number(index);
  if (shared_.is_caller(variable.owner)) {
    if (variable.value == value) return;  // it stays the caller's
    const std::string name = "N" + std::to_string(index);
    bag_.add({Message::VariableClash,
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
    bag_.add({Message::NoSuchText, target.range, {to_short_decimal(*index)}});
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
  if (!expand(line.words, 0, words, texts)) {
    if (contours_.is_open()) contours_.mark_broken();
    return;
  }
  Splice& splice = splices_[&line];
  if (!splice.statement || splice.texts != texts) {
    DiagnosticBag faults;
    std::optional<Statement> parsed = parse_spliced(words, statement.broken, faults);
    splice.statement = parsed ? std::make_shared<const Statement>(*std::move(parsed)) : nullptr;
    splice.texts = std::move(texts);
    for (Diagnostic fault : faults.all()) {
      fault.notes.push_back({Message::TextUsedHere, statement.range, {}});
      bag_.add(std::move(fault));
    }
  }
  // Held here: a macro in the line may come back to it and put it together anew.
  if (const auto current = splice.statement) execute_simple(*current);
}

std::optional<int> Evaluator::text_index(const Word& word) {
  Item item;
  item.number = number_of(word);
  if (item.number.is_absent()) {
    bag_.add({Message::MissingNumber, word.range, {"B"}});
    return std::nullopt;
  }
  const std::optional<Rational> index = shared_.value(item);
  if (!index) return std::nullopt;
  if (index->get_den() == 1 && *index >= 1 && *index <= kVariableCount) {
    return static_cast<int>(index->get_num().get_si());
  }
  bag_.add({Message::NoSuchText, word.range, {to_short_decimal(*index)}});
  return std::nullopt;
}

// Appends `words` to `out`, every B replaced by its text. False when one cannot be had.
bool Evaluator::expand(const std::vector<Word>& words, std::uint32_t depth, std::vector<Word>& out,
                       std::vector<Variables::TextWords>& texts) {
  const std::uint32_t limit = shared_.options.bounds.text_depth;
  if (depth > limit) {
    stop(Message::TextsTooDeep, words.empty() ? Range{} : words.front().range, limit);
    return false;
  }
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
        bag_.add({Message::UndefinedText, word.range, {"B" + std::to_string(*index)}});
      }
      return false;
    }
    texts.push_back(text.words);
    if (out.size() + text.words->size() > kMaxWordsOfLine) {
      stop(Message::LineTooLong, word.range, kMaxWordsOfLine);
      return false;
    }
    if (!expand(*text.words, depth + 1, out, texts)) return false;
  }
  return true;
}

}  // namespace dgt::language
