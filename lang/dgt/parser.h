// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lang/dgt/lexer.h"
#include "lang/dgt/syntax.h"
#include "lang/text/diagnostic.h"

namespace dgt::language {

/// Parses a source piece by piece, so that a program of any length takes the memory of one of its
/// lines, or of its longest loop. Every fault is reported and the next line taken; a line with a
/// fault is given all the same, marked broken, so that what it was to make is not missed a second
/// time.
class ProgramReader {
 public:
  ProgramReader(const SourceFile& file, DiagnosticBag& bag)
      : file_(file), lexer_(file, bag), bag_(bag) {}

  [[nodiscard]] const SourceFile& file() const { return file_; }
  /// Replaces `piece` by the statements of the next line, or by a whole loop that stands in no
  /// other; false when there is none.
  [[nodiscard]] bool next(Program& piece);
  /// Appends all that is left.
  void read_rest(Program& program);

 private:
  [[nodiscard]] bool read_line(Program& program);
  void add_statement(std::span<const Word> words, Program& program);
  [[nodiscard]] bool close_loop(Program& program, LoopEnd& end, const Range& range);
  void give_up_open_loops(Program& program);

  const SourceFile& file_;
  Lexer lexer_;
  DiagnosticBag& bag_;
  Lexer::Line line_;
  std::vector<std::size_t> open_loops_;  ///< count into the statements of the piece
};

/// Parses a whole source.
[[nodiscard]] Program parse(const SourceFile& file, DiagnosticBag& bag);

/// Parses one line whose B texts have been put in place; `broken` says that an error in it has been
/// reported already. Nothing when the line is blank. A spliced line that still uses a text comes
/// back as SplicedLine.
[[nodiscard]] std::optional<Statement> parse_spliced(std::span<const Word> words, bool broken,
                                                     DiagnosticBag& bag);

}  // namespace dgt::language
