// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/iso7.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace dgt {
namespace {

// Rows as the standard's charts print them, tracks from the left.
TEST(Iso7, RowsAreThoseOfTheChart) {
  EXPECT_EQ(holes_of(row_of('0')), "5 6");
  EXPECT_EQ(holes_of(row_of('1')), "1 5 6 8");
  EXPECT_EQ(holes_of(row_of('9')), "1 4 5 6");
  EXPECT_EQ(holes_of(row_of('A')), "1 7");
  EXPECT_EQ(holes_of(row_of('N')), "2 3 4 7");
  EXPECT_EQ(holes_of(row_of('Z')), "2 4 5 7");
  EXPECT_EQ(holes_of(row_of('%')), "1 3 6 8");
  EXPECT_EQ(holes_of(row_of(':')), "2 4 5 6");
  EXPECT_EQ(holes_of(row_of('/')), "1 2 3 4 6 8");
  EXPECT_EQ(holes_of(row_of('+')), "1 2 4 6");
  EXPECT_EQ(holes_of(row_of('-')), "1 3 4 6");
  EXPECT_EQ(holes_of(row_of('.')), "2 3 4 6");
  EXPECT_EQ(holes_of(row_of('(')), "4 6");
  EXPECT_EQ(holes_of(row_of(')')), "1 4 6 8");
  EXPECT_EQ(holes_of(row_of(' ')), "6 8");
  EXPECT_EQ(holes_of(kCarriageReturn), "1 3 4 8");
  EXPECT_EQ(holes_of(kLineFeed), "2 4");
  EXPECT_EQ(holes_of(kTab), "1 4");
  EXPECT_EQ(holes_of(kRubOut), "1 2 3 4 5 6 7 8");
  EXPECT_EQ(holes_of(kBlankRow), "");
}

TEST(Iso7, Each256RowValuesIsOfOneKind) {
  std::map<RowKind, int> counts;
  for (int value = 0; value < 256; ++value) {
    const auto row = static_cast<Row>(value);
    ++counts[kind_of(row)];
    int holes = 0;
    for (int track = 0; track < 8; ++track) holes += value >> track & 1;
    EXPECT_EQ(kind_of(row) == RowKind::Damaged, holes % 2 != 0) << value;
    EXPECT_EQ(row_of(code_of(row)) == row, holes % 2 == 0);
    EXPECT_EQ(kind_of(row) == RowKind::Character, holes % 2 == 0 && is_punchable(code_of(row)));
  }
  EXPECT_EQ(counts, (std::map<RowKind, int>{{RowKind::Blank, 1},
                                            {RowKind::RubOut, 1},
                                            {RowKind::LineFeed, 1},
                                            {RowKind::CarriageReturn, 1},
                                            {RowKind::Character, 65},
                                            {RowKind::Foreign, 59},
                                            {RowKind::Damaged, 128}}));
}

TEST(Iso7, NoTwoCodesShareARow) {
  std::set<Row> rows;
  for (int code = 0; code < 128; ++code) rows.insert(row_of(static_cast<char>(code)));
  EXPECT_EQ(rows.size(), 128U);
}

TEST(Iso7, TwoCodesDifferInTwoHolesAtLeast) {
  for (int a = 0; a < 128; ++a) {
    for (int b = 0; b < a; ++b) {
      EXPECT_GE(std::popcount(static_cast<unsigned>(row_of(static_cast<char>(a)) ^
                                                    row_of(static_cast<char>(b)))),
                2);
    }
  }
}

TEST(Iso7, EveryKindHasAName) {
  EXPECT_EQ(name_of(row_of('G')), "G");
  EXPECT_EQ(name_of(row_of(' ')), "SP");
  EXPECT_EQ(name_of(kTab), "HT");
  EXPECT_EQ(name_of(kLineFeed), "LF");
  EXPECT_EQ(name_of(kCarriageReturn), "CR");
  EXPECT_EQ(name_of(kBlankRow), "NUL");
  EXPECT_EQ(name_of(kRubOut), "DEL");
  EXPECT_EQ(name_of(row_of('g')), "g");
  EXPECT_EQ(name_of(row_of('\x1B')), "0x1B");
  EXPECT_EQ(name_of(0x01), "?");
}

}  // namespace
}  // namespace dgt
