// SPDX-License-Identifier: GPL-3.0-or-later
//
// Holes too many, holes too few, rows lost: what is found, everywhere.
#include <gtest/gtest.h>

#include <algorithm>

#include "device/before_start.h"
#include "device/compare.h"
#include "device/lettering.h"
#include "tests/device/tapes.h"

namespace dgt {
namespace {

using support::long_program;
using support::tape_of;

TapeFormat format_with(TapeStart start, const char* header, TapeChecksum checksum) {
  TapeFormat format;
  format.start = start;
  format.header = header;
  format.checksum = checksum;
  return format;
}

/// Flips every hole of the tape in turn; before the `%` the fault may be told as a strange run.
void expect_every_flip_is_found(const std::string& program, const TapeFormat& format) {
  Tape tape = tape_of(program, format);
  const DecodedTape whole = decode_tape(tape, format);
  ASSERT_FALSE(whole.is_damaged());
  for (std::size_t row = 0; row < tape.rows.size(); ++row) {
    for (unsigned track = 0; track < kTracks; ++track) {
      const Row before = tape.rows[row];
      tape.rows[row] = static_cast<Row>(before ^ 1U << track);
      const DecodedTape made = decode_tape(tape, format);
      ASSERT_TRUE(made.is_damaged()) << "row " << row << " track " << track + 1;
      if (row >= whole.program_begin) {
        ASSERT_TRUE(std::ranges::any_of(made.faults, [&](const TapeFault& fault) {
          return fault.kind == TapeFault::Kind::Parity && fault.row == row;
        })) << row;
      } else if (format.start == TapeStart::Percent) {
        ASSERT_EQ(made.text, whole.text) << row;
      }
      tape.rows[row] = before;
    }
  }
}

TEST(TapeDamage, EverySingleFlippedHoleOfALongTapeIsFoundInItsRow) {
  expect_every_flip_is_found(long_program(30), {});
}

TEST(TapeDamage, SoItIsWithLetteringAndChecksum) {
  expect_every_flip_is_found(long_program(8), format_with(TapeStart::Percent,
                                                          "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                          " +-./_()= A.B",
                                                          TapeChecksum::Line));
}

TEST(TapeDamage, SoItIsWithoutAStart) {
  expect_every_flip_is_found(long_program(8), format_with(TapeStart::None, "", TapeChecksum::None));
}

TEST(TapeDamage, SoItIsWhereTheProgramBringsItsStart) {
  expect_every_flip_is_found("%123\nG01 X1\nM02\n", {});
  expect_every_flip_is_found("%\nG01 X1\nM02\n%\n", {});
}

TEST(TapeDamage, OneDamagedRowShiftsNothing) {
  const std::string program = long_program(5);
  const Tape tape = tape_of(program);
  const DecodedTape whole = decode_tape(tape, {});
  for (std::size_t row = whole.program_begin + 3; row < whole.program_end; ++row) {
    if (kind_of(tape.rows[row]) != RowKind::Character) continue;
    Tape damaged = tape;
    damaged.rows[row] ^= 0x10;
    const DecodedTape made = decode_tape(damaged, {});
    ASSERT_EQ(made.faults.size(), 1U);
    std::string wanted = program;
    wanted.replace(made.faults[0].offset, 1, "\xEF\xBF\xBD");
    ASSERT_EQ(made.text, wanted) << row;
  }
}

Tape without_row(const Tape& tape, std::size_t lost) {
  Tape made;
  for (std::size_t row = 0; row < tape.rows.size(); ++row) {
    if (row != lost) made.rows.push_back(tape.rows[row]);
  }
  return made;
}
Tape with_row_twice(const Tape& tape, std::size_t twice) {
  Tape made;
  for (std::size_t row = 0; row < tape.rows.size(); ++row) {
    made.rows.push_back(tape.rows[row]);
    if (row == twice) made.rows.push_back(tape.rows[row]);
  }
  return made;
}

/// Calls `tell` with every tape in which two holes of one row are flipped: parity sees none of
/// them.
template <class Tell>
void for_each_double_flip(const Tape& tape, const Tell& tell) {
  for (std::size_t row = 0; row < tape.rows.size(); ++row) {
    for (unsigned a = 0; a < kTracks; ++a) {
      for (unsigned b = 0; b < a; ++b) {
        Tape damaged = tape;
        damaged.rows[row] = static_cast<Row>(tape.rows[row] ^ 1U << a ^ 1U << b);
        tell(damaged, row);
      }
    }
  }
}

TEST(TapeDamage, EveryDoubleFlipInARowIsFoundByComparison) {
  const Tape tape = tape_of(long_program(6), support::short_format());
  for_each_double_flip(tape, [&](const Tape& damaged, std::size_t row) {
    const TapeDifferences found = compare_rows(tape.rows, damaged.rows);
    ASSERT_GE(found.count, 1U) << row;
  });
}

TEST(TapeDamage, EveryDoubleFlipInARowIsFoundByTheChecksum) {
  TapeFormat format = support::short_format();
  format.checksum = TapeChecksum::Line;
  for_each_double_flip(tape_of(long_program(6), format), [&](const Tape& damaged, std::size_t row) {
    ASSERT_TRUE(decode_tape(damaged, format).is_damaged()) << row;
  });
}

TEST(TapeDamage, EveryRowLostOrDoubledIsFoundByTheChecksum) {
  TapeFormat format = support::short_format();
  format.checksum = TapeChecksum::Line;
  const Tape tape = tape_of(long_program(6), format);
  const DecodedTape whole = decode_tape(tape, format);
  for (std::size_t row = whole.program_begin; row < whole.program_end; ++row) {
    ASSERT_TRUE(decode_tape(without_row(tape, row), format).is_damaged()) << row;
    ASSERT_TRUE(decode_tape(with_row_twice(tape, row), format).is_damaged()) << row;
  }
}

TEST(TapeComparison, NamesTheRowThatIsLostDoubledOrChanged) {
  const Tape tape = tape_of(long_program(3), support::short_format());
  using Kind = RowDifference::Kind;
  const std::size_t begin = rows_in(30);
  const std::size_t end = tape.rows.size() - rows_in(30);
  for (std::size_t row = begin; row < end; ++row) {
    TapeDifferences found = compare_rows(tape.rows, without_row(tape, row).rows);
    ASSERT_EQ(found.count, 1U) << row;
    ASSERT_EQ(found.rows[0].kind, Kind::Missing);
    ASSERT_EQ(found.rows[0].wanted, tape.rows[row]);
    found = compare_rows(tape.rows, with_row_twice(tape, row).rows);
    ASSERT_EQ(found.count, 1U) << row;
    ASSERT_EQ(found.rows[0].kind, Kind::Extra);
    Tape other = tape;
    other.rows[row] ^= 0x03;
    found = compare_rows(tape.rows, other.rows);
    ASSERT_EQ(found.count, 1U) << row;
    ASSERT_EQ(found.rows[0], (RowDifference{Kind::Changed, row, row, tape.rows[row],
                                            static_cast<Row>(tape.rows[row] ^ 0x03)}));
  }
}

TEST(TapeComparison, PiecesThatAreMissingAreToldAsThose) {
  const Tape tape = tape_of(long_program(3), support::short_format());
  for (std::size_t length = 1; length <= kMostShift; ++length) {
    std::vector<Row> cut(tape.rows.begin(), tape.rows.begin() + 25);
    cut.insert(cut.end(), tape.rows.begin() + 25 + static_cast<std::ptrdiff_t>(length),
               tape.rows.end());
    TapeDifferences found = compare_rows(tape.rows, cut);
    ASSERT_EQ(found.count, length);
    ASSERT_EQ(found.rows[0].kind, RowDifference::Kind::Missing);
    found = compare_rows(cut, tape.rows);
    ASSERT_EQ(found.count, length);
    ASSERT_EQ(found.rows[0].kind, RowDifference::Kind::Extra);
  }
}

TEST(TapeComparison, BlankTapeAtTheEndsMakesNoDifference) {
  TapeFormat longer;
  longer.leader = 1000;
  EXPECT_EQ(compare_rows(tape_of("G0\n").rows, tape_of("G0\n", longer).rows).count, 0U);
  EXPECT_EQ(compare_rows({}, std::vector<Row>(10, kBlankRow)).count, 0U);
  EXPECT_EQ(compare_rows({}, tape_of("G0\n").rows).count, 7U);
  EXPECT_EQ(compare_rows(tape_of("G0\n").rows, {}).count, 7U);
}

// --- lettering ----------------------------------------------------------------------------------

TEST(Lettering, NoRowIsAStartOfProgram) {
  for (const Row row : lettering("0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ+-./_()=")) {
    EXPECT_EQ(row & 0x80, 0);
  }
}

TEST(Lettering, ReadsAsWritten) {
  // The F: seen with the three-hole edge down.
  const std::vector<Row> rows = lettering("F");
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[0], 0x7F);
  EXPECT_EQ(rows[1], 0x48);  // top and middle: tracks 7 and 4
  EXPECT_EQ(rows[4], 0x40);
  EXPECT_EQ(letter_in_holes(rows), 'F');
  EXPECT_TRUE(lettering("\xE4\xB8\xAD*").empty());
}

TEST(Lettering, AFlippedHoleNeverMakesAnotherText) {
  const std::string text = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ +-./_()= .-_/I1";
  std::vector<Row> rows = {0, 0, 0};
  for (const Row row : lettering(text)) rows.push_back(row);
  rows.insert(rows.end(), 3, kBlankRow);
  EXPECT_EQ(beginning_of(rows, BeforeStart::Checked).header, text);
  for (Row& row : rows) {
    for (unsigned track = 0; track < kTracks; ++track) {
      row = static_cast<Row>(row ^ 1U << track);
      const TapeBeginning found = beginning_of(rows, BeforeStart::Checked);
      EXPECT_TRUE(!found.stray.empty() || found.has_start) << text << found.header;
      row = static_cast<Row>(row ^ 1U << track);
    }
  }
}

}  // namespace
}  // namespace dgt
