// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "lang/text/diagnostic.h"

/// Blocks of ESSI: from characters to signed fields.
namespace dgt::essi {

/// A sign and its digits; a sign alone is zero.
struct Field {
  bool negative = false;
  bool has_digits = false;
  std::int64_t value = 0;   ///< with its sign
  std::uint32_t begin = 0;  ///< in the file's text
  std::uint32_t end = 0;
};

/// One line: `<number>` and signed fields, or fields alone.
struct Block {
  static constexpr std::size_t kMaxFields = 6;  ///< one more than any block has

  std::uint32_t line = 0;    ///< from 1
  std::uint32_t column = 0;  ///< of its first sign or digit, from 1
  std::uint32_t begin = 0;   ///< in the file's text
  std::uint32_t end = 0;
  bool has_number = false;
  std::int64_t number = 0;
  std::size_t count = 0;  ///< of fields
  std::array<Field, kMaxFields> fields;

  /// `101+`: a number with one sign and nothing behind it.
  [[nodiscard]] bool is_mark() const { return has_number && count == 1 && !fields[0].has_digits; }
};

/// Reads a file block by block; blanks and blank lines end here. Lines with faults are reported
/// and left out.
class BlockReader {
 public:
  BlockReader(const SourceFile& file, DiagnosticBag& bag);

  /// The next line that holds a block.
  bool next(Block& block);

 private:
  bool read_line(Block& block);
  bool read_sign(bool& negative);
  bool read_digits(std::int64_t& value);
  void skip_blanks();
  void skip_line();
  void report(Message message, std::uint32_t begin, std::uint32_t end,
              std::vector<std::string> arguments);
  [[nodiscard]] char peek() const { return at_ < size_ ? text_[at_] : '\n'; }

  const SourceFile& file_;
  DiagnosticBag& bag_;
  const char* text_;
  std::uint32_t size_;
  std::uint32_t at_ = 0;
  std::uint32_t line_ = 0;
};

}  // namespace dgt::essi
