// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/dump.h"

#include <fmt/format.h>

#include "lang/dgt/lexer.h"
#include "lang/dgt/line_parser.h"
#include "lang/dgt/parser.h"

namespace dgt::language {
namespace {

// Digits of a decimal are never cut: a source number has finitely many.
constexpr int kAllDigits = static_cast<int>(Lexer::kMaxDigits);

std::string joined(const std::vector<Word>& words) {
  std::string out;
  for (const Word& word : words) out += (out.empty() ? "" : " ") + to_text(word);
  return out;
}

std::string joined(const std::vector<Item>& items) {
  std::string out;
  for (const Item& item : items) out += " " + to_text(item);
  return out;
}

// Prints the body of a statement.
struct BodyPrinter {
  std::string operator()(const Definition& d) const {
    std::string out = fmt::format("definition {} =", to_text(d.target));
    out += joined(d.selector) + joined(d.operands);
    if (d.match.form != nullptr) out += fmt::format(" ({})", d.match.form->pattern);
    return out;
  }
  std::string operator()(const NumberAssignment& a) const {
    std::string out = fmt::format("number N{} = 0", a.variable);
    for (const auto& term : a.terms) {
      out += fmt::format(" {} {}", term.operation, to_text(term.number));
    }
    return out;
  }
  std::string operator()(const TextAssignment& a) const {
    return fmt::format("text {} = \"{}\"", to_text(a.target), a.words ? joined(*a.words) : "");
  }
  std::string operator()(const ContourStart& s) const {
    return fmt::format("contour {}{}", to_text(s.target), joined(s.items));
  }
  std::string operator()(const ItemLine& l) const {
    return (l.has_comma ? "items" : "words") + joined(l.items);
  }
  std::string operator()(const ForLoop& loop) const { return "for " + to_text(loop.count); }
  std::string operator()(const LoopEnd&) const { return "next"; }
  std::string operator()(const MacroCall& call) const {
    std::string out = fmt::format("macro {}", call.name.file ? call.name.text() : "");
    for (const auto& argument : call.arguments) out += " " + to_text(argument.number);
    return out;
  }
  std::string operator()(const DefinitionFile& f) const {
    return fmt::format("definitions {}", f.name.file ? f.name.text() : "");
  }
  std::string operator()(const SplicedLine& line) const { return "spliced " + joined(line.words); }
  std::string operator()(const Directive& d) const {
    return fmt::format("directive {} {}", d.key.text(), d.value.text());
  }
};

}  // namespace

std::string to_text(const Word& word) {
  switch (word.kind) {
    case WordKind::Letter:
      return word.letter + to_text(number_of(word));
    case WordKind::Number:
      return to_text(number_of(word));
    case WordKind::Selector:
      return fmt::format("{}{}", word.digits % 2 == 1 ? 'X' : 'Y', word.digits < 5 ? '>' : '<');
    case WordKind::Operator:
      return std::string(1, word.letter);
    case WordKind::For:
      return "FOR";
    case WordKind::Next:
      return "NEXT";
    case WordKind::Mac:
      return "MAC";
    case WordKind::Opr:
      return "OPR";
    case WordKind::Equals:
    case WordKind::Comma:
    case WordKind::QuoteOpen:
    case WordKind::QuoteClose:
    case WordKind::Name:
    case WordKind::Directive:
      break;
  }
  return std::string(word.range.text());
}

std::string to_text(const Number& number) {
  const std::string sign = number.minus ? "-" : "";
  switch (number.form) {
    case NumberForm::None:
      return "";
    case NumberForm::Variable:
      return fmt::format("{}N{}", sign, number.whole);
    case NumberForm::Decimal:
      break;
  }
  if (number.exact) return sign + to_short_decimal(*number.exact, kAllDigits);
  return fmt::format("{}{}", sign, number.whole);
}

std::string to_text(const Item& item) {
  if (item.is_inline_point) return "X" + to_text(item.number) + "Y" + to_text(item.second);
  return item.letter + to_text(item.number);
}

std::string print_words(const SourceFile& file) {
  DiagnosticBag ignored;
  Lexer lexer(file, ignored);
  Lexer::Line line;
  std::string out;
  for (int number = 1; lexer.next_line(line); ++number) {
    if (!line.words.empty()) out += fmt::format("{}: {}\n", number, joined(line.words));
  }
  return out;
}

std::string print_syntax(const SourceFile& file) {
  DiagnosticBag ignored;
  ProgramReader reader(file, ignored);
  std::string out;
  for (Program piece; reader.next(piece);) {
    std::size_t depth = 0;
    for (std::size_t i = 0; i < piece.statements.size(); ++i) {
      const Statement& statement = piece.statements[i];
      if (std::holds_alternative<LoopEnd>(statement.body)) --depth;
      out += fmt::format("{}{}: {}{}\n", std::string(2 * depth, ' '), statement.range.place().line,
                         std::visit(BodyPrinter{}, statement.body),
                         statement.broken ? " (broken)" : "");
      const ForLoop* const loop = std::get_if<ForLoop>(&statement.body);
      if (loop != nullptr && loop->end > i) ++depth;
    }
  }
  return out;
}

}  // namespace dgt::language
