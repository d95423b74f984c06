// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lang/dgt/syntax.h"
#include "lang/text/diagnostic.h"

namespace dgt::language {

/// Parses the words of one line. A fault is reported, the words it spoils are skipped, and the rest
/// of the line is read on, so that a line may show several independent faults.
class LineParser {
 public:
  /// `broken`: the lexer has already reported a fault in the line.
  LineParser(std::span<const Word> words, bool broken, DiagnosticBag& bag)
      : words_(words), unreadable_(broken), broken_(broken), bag_(bag) {}

  /// Precondition: there are words, none of them a directive.
  [[nodiscard]] Statement parse();

 private:
  // line_parser.cpp: what kind of line it is
  void skip_line_number();
  [[nodiscard]] Statement::Body parse_body();
  [[nodiscard]] bool is_assignment_to(char letter) const;
  [[nodiscard]] bool uses_texts() const;
  [[nodiscard]] Statement::Body parse_contour_start();
  [[nodiscard]] Statement::Body parse_item_line();
  // parser_definition.cpp
  [[nodiscard]] Statement::Body parse_definition();
  void choose_form(Definition& definition);
  void report_mismatch(const Definition& definition, std::string_view letters);
  // parser_program.cpp: variables, loops, files
  [[nodiscard]] Statement::Body parse_number_assignment();
  [[nodiscard]] Statement::Body parse_number_without_equals();
  [[nodiscard]] Statement::Body parse_text_assignment();
  [[nodiscard]] Statement::Body parse_text_without_equals();
  [[nodiscard]] Statement::Body parse_for();
  [[nodiscard]] Statement::Body parse_next();
  [[nodiscard]] Statement::Body parse_macro_call();
  [[nodiscard]] Statement::Body parse_definition_file();
  /// `5`, `-5`, `N1`, `-N1`: a number that stands without a letter.
  [[nodiscard]] std::optional<MacroCall::Argument> parse_bare_number();
  void expect_end();
  /// `,5` directly behind a number. Precondition: there are words before.
  [[nodiscard]] bool next_is_decimal_comma() const;

  // parser_items.cpp
  [[nodiscard]] std::vector<Item> parse_items(std::string_view letters);
  [[nodiscard]] std::optional<Item> parse_item(std::string_view letters);
  [[nodiscard]] bool check_item_number(const Word& word);
  [[nodiscard]] bool report_letter_for_zero(const Word& word);
  [[nodiscard]] bool report_letter_for_one(const Word& word);
  [[nodiscard]] bool report_unknown_word(const Word& word);
  [[nodiscard]] bool report_misplaced_minus(const Word& minus);
  void report_letter_for_digit(const Range& range, const Range& letter, char digit);
  void report_unexpected(const Word& word);
  void report_number(const Word& word);
  void report_decimal_comma();
  void report_quote(const Word& word);
  void skip_spoiled_words();

  [[nodiscard]] bool at_end() const { return at_ == words_.size(); }
  [[nodiscard]] const Word& word() const { return words_[at_]; }
  [[nodiscard]] bool next_is(WordKind kind) const { return !at_end() && word().is(kind); }
  /// Behind the last word read.
  [[nodiscard]] Range here() const { return behind(words_[at_ == 0 ? 0 : at_ - 1].range); }
  void fail(Diagnostic diagnostic);

  std::span<const Word> words_;
  const bool unreadable_;  // the lexer has found no word in some of it
  bool broken_;
  DiagnosticBag& bag_;
  std::size_t at_ = 0;
};

/// Whether nothing stands between the two.
[[nodiscard]] inline bool touches(const Word& a, const Word& b) {
  return a.range.file == b.range.file && a.range.end == b.range.begin;
}

/// How many of the words make the first statement of a line that holds several, which is an error
/// of its own; all of them otherwise.
[[nodiscard]] std::size_t first_statement(std::span<const Word> words);

/// Letters that end an inline point's first half: X and Y side by side become one item.
/// `any_order`: Y may come first; behind G it may always.
void join_coordinates(std::vector<Item>& items, bool any_order);

}  // namespace dgt::language
