// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "lang/nc/decimal.h"
#include "lang/text/diagnostic.h"

/// Blocks of G-code: from characters to words.
namespace dgt::gcode {

/// A G word in tenths, so that G41.1 is 411; an M word as it is.
struct CodeWord {
  int number = 0;
  std::uint32_t begin = 0;  ///< in the file's text
  std::uint32_t end = 0;
};

/// One line. Words other than G and M stand at most once.
struct Block {
  static constexpr std::size_t kMaxCodes = 16;

  std::uint32_t line = 0;     ///< from 1
  std::uint32_t begin = 0;    ///< of its first word but N; of the line when there is none
  std::uint32_t end = 0;      ///< of its last word
  std::uint32_t column = 0;   ///< of `begin`, in characters from 1
  std::uint32_t present = 0;  ///< a bit for each letter of `words`
  std::array<Decimal, 26> words;
  std::array<std::uint32_t, 26> letters;  ///< where each begins
  std::array<CodeWord, kMaxCodes> g, m;
  std::size_t g_count = 0;
  std::size_t m_count = 0;
  bool is_tape_mark = false;  ///< a line with % alone

  [[nodiscard]] bool has(char letter) const { return (present >> (letter - 'A') & 1) != 0; }
  [[nodiscard]] const Decimal& word(char letter) const {
    return words[static_cast<std::size_t>(letter - 'A')];
  }
  [[nodiscard]] bool empty() const { return present == 0 && g_count == 0 && m_count == 0; }
};

/// Reads a file block by block. Comments, N numbers, blanks and case end here; faults in words are
/// reported and the rest of the block is read.
class BlockReader {
 public:
  BlockReader(const SourceFile& file, DiagnosticBag& bag);

  /// The next line that holds anything.
  bool next(Block& block);

 private:
  void read_line(Block& block);
  bool read_special(Block& block);
  void read_foreign(Block& block);
  void read_word(Block& block, char letter, std::uint32_t begin);
  bool read_number(Decimal& number);
  void keep_code(Block& block, char letter, const Decimal& number, std::uint32_t begin);
  void skip_comment();
  void skip_to_blank();
  void skip_line();
  void note_begin(Block& block, std::uint32_t begin);
  [[nodiscard]] char peek() const { return at_ < size_ ? text_[at_] : '\n'; }
  [[nodiscard]] Range from(std::uint32_t begin) const { return {&file_, begin, at_}; }
  void report(Message message, const Range& range, std::vector<std::string> arguments = {});

  const SourceFile& file_;
  DiagnosticBag& bag_;
  const char* text_;
  std::uint32_t size_;
  std::uint32_t at_ = 0;
  std::uint32_t line_ = 0;
  std::uint32_t line_begin_ = 0;
  bool is_ascii_ = true;  ///< the line so far
  bool told_optional_ = false;
};

}  // namespace dgt::gcode
