// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lang/dgt/word.h"
#include "lang/text/diagnostic.h"

namespace dgt::language {

/// Cuts a DGT source into words, line by line, in one pass. Blanks, comments and the case of
/// letters are gone from what it gives; Cyrillic look-alikes and typographic signs have become what
/// they stand for, with one warning of either a line.
class Lexer {
 public:
  /// Digits of one number, more of which is an error: no length on a drawing has as many, and a
  /// file of nothing but digits must not become one number.
  static constexpr std::uint32_t kMaxDigits = 200;

  Lexer(const SourceFile& file, DiagnosticBag& bag);

  /// One line of words.
  struct Line {
    std::vector<Word> words;
    Range range;          ///< the whole line without its end
    bool broken = false;  ///< something in it was no word; an error has been reported
  };

  /// Replaces `line` by the next line of the file; false when there is none.
  [[nodiscard]] bool next_line(Line& line);

 private:
  struct Character;
  /// What was written otherwise than it is read.
  struct LookAlike {
    Range range;
    std::string latin;
  };

  [[nodiscard]] Character look(std::uint32_t at) const;
  [[nodiscard]] char byte(std::uint32_t at) const { return at < end_ ? text_[at] : '\0'; }
  [[nodiscard]] std::uint32_t skip_blanks(std::uint32_t at) const;
  [[nodiscard]] Range from(std::uint32_t begin) const { return {&file_, begin, at_}; }
  Word& push(WordKind kind, std::uint32_t begin);
  std::uint32_t column_of(std::uint32_t offset);

  void read_word();
  bool read_keyword();
  void read_letter(const Character& letter);
  void read_sign_and_number(Word& word);
  void read_decimal(Word& word);
  void read_name();
  void read_comment(const Character& apostrophe);
  bool read_unmarked_comment();
  bool read_foreign_comment();
  bool read_brackets();
  bool read_semicolon();
  void read_unit();
  [[nodiscard]] bool is_prose(std::uint32_t at) const;
  void report_comment(std::uint32_t begin);
  bool read_wrong_layout();
  void read_quote(const Character& quote);
  void close_open_quote();
  void report_unknown_characters();
  void note_look_alike(std::uint32_t begin, std::string_view latin);
  void report_look_alikes(Message message, std::vector<LookAlike>& found);
  void fail(Message message, Range range, std::vector<std::string> arguments);

  const SourceFile& file_;
  std::string_view text_;
  DiagnosticBag& bag_;
  std::uint32_t line_number_ = 0;
  std::uint32_t at_ = 0;          // the next byte
  std::uint32_t end_ = 0;         // of the line
  std::uint32_t counted_to_ = 0;  // columns are counted as words come, never twice
  std::uint32_t counted_columns_ = 1;
  bool in_quotes_ = false;
  Line* line_ = nullptr;
  std::vector<LookAlike> letters_;  // of the line
  std::vector<LookAlike> signs_;
};

}  // namespace dgt::language
