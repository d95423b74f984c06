// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "lang/nc/decimal.h"
#include "lang/text/diagnostic.h"
#include "lang/three_b/counting.h"

/// Blocks of 3B: from characters to numbers and words.
namespace dgt::three_b {

/// Coordinates in mm, as CAM systems note them behind a block or in their title.
struct NotedPlace {
  Decimal x;
  Decimal y;
};

struct Block {
  enum class Kind : std::uint8_t {
    Line,
    Arc,
    Pause,  ///< D
    End,    ///< DD, E
    Start   ///< a title's `Start Point = X , Y`; the place alone
  };
  Kind kind = Kind::Line;
  std::uint32_t line = 0;    ///< from 1
  std::uint32_t column = 0;  ///< in characters from 1
  std::uint32_t begin = 0;   ///< in the file's text
  std::uint32_t end = 0;

  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t count = 0;
  Axis axis = Axis::X;
  bool counter_clockwise = false;
  int quadrant = 1;
  std::uint32_t axis_begin = 0;  ///< of the X or Y of G, and where it ends
  std::uint32_t axis_end = 0;
  std::uint32_t way_begin = 0;  ///< of L1, SR1, NR1

  bool has_place = false;
  NotedPlace place;
};

/// Reads a file block by block. Labels, comments, titles, blanks and case end here. A line with a
/// fault is reported and left from there on.
class BlockReader {
 public:
  /// `unit` is what numbers count, for messages.
  BlockReader(const SourceFile& file, const Rational& unit, DiagnosticBag& bag);

  bool next(Block& block);

 private:
  bool begin_line(Block& block);
  bool read_title(Block& block);
  void read_label();
  bool read_block(Block& block);
  bool read_words(Block& block);
  bool read_number(std::int64_t& value);
  bool read_axis(Block& block);
  bool read_way(Block& block);
  bool read_stop(Block& block);
  void read_place(NotedPlace& place, bool& has_place);
  bool read_decimal(Decimal& number);
  char read_letter();
  [[nodiscard]] char letter_at(std::uint32_t at) const;
  void begin_block(Block& block);
  void skip_blanks();
  void skip_line();
  void refuse();
  void report(Message message, std::uint32_t begin, std::uint32_t end,
              std::vector<std::string> arguments);
  [[nodiscard]] char peek() const { return at_ < size_ ? text_[at_] : '\n'; }

  const SourceFile& file_;
  const Rational& unit_;
  DiagnosticBag& bag_;
  const char* text_;
  std::uint32_t size_;
  std::uint32_t at_ = 0;
  std::uint32_t line_ = 0;
  std::uint32_t line_begin_ = 0;
  std::uint32_t content_ = 0;  ///< where what is read now begins, its label included
  bool is_line_open_ = false;  ///< what stands behind a block on its line is still to be read
  bool began_ = false;         ///< there was a block; titles stand before it
};

}  // namespace dgt::three_b
