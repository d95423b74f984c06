// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tapes as pictures.
#include <gmock/gmock.h>

#include <regex>

#include "device/drawing.h"
#include "device/join.h"
#include "device/picture.h"
#include "tests/device/tapes.h"

namespace dgt {
namespace {

using support::long_program;
using support::tape_of;
using ::testing::HasSubstr;

TEST(Picture, ShowsHolesFeedAndCharacters) {
  EXPECT_EQ(to_picture({{kBlankRow, kStartOfProgram, kLineFeed, 0x01, kRubOut}, {{2, "torn"}}}),
            R"(___________
|     .   |
|o o  .o o|  %
~~~~~~~~~~~  gap: torn
|    o. o |  LF
|     .  o|  ?
|ooooo.ooo|  DEL
___________
)");
}

TEST(Picture, AllRowValuesAndGapsAreReadBack) {
  Tape tape;
  for (int value = 0; value < 256; ++value) tape.rows.push_back(static_cast<Row>(value));
  tape.gaps = {{0, "first"}, {7, "one"}, {7, "two"}, {256, "last: \xD0\xB0"}};
  const auto read = from_picture(to_picture(tape));
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, tape);
  EXPECT_TRUE(is_picture(to_picture(tape)));
  EXPECT_FALSE(is_picture("_____"));
}

TEST(Picture, APartHoldsItsRowsAndGaps) {
  const Tape tape{{1, 2, 3, 4, 5}, {{1, "a"}, {4, "b"}}};
  const auto read = from_picture(to_picture(tape, {1, 4}));
  EXPECT_EQ(*read, (Tape{{2, 3, 4}, {{0, "a"}, {3, "b"}}}));
  EXPECT_EQ(from_picture(to_picture(tape, {9, 4}))->rows.size(), 0U);
}

TEST(Picture, EditedByHandItIsReadAsFarAsItIsOne) {
  EXPECT_EQ(from_picture("# mine\r\n|O*  o.   |  whatever\r\n\r\n__\r\n~\r\n")->rows,
            (std::vector<Row>{0xC8}));
  const auto fault = from_picture("___________\n|     .   |\n|    .   |\n");
  ASSERT_FALSE(fault);
  EXPECT_EQ(fault.error().begin, 24U);
  EXPECT_EQ(fault.error().end, 34U);
  EXPECT_FALSE(from_picture("|x    .   |"));
  EXPECT_FALSE(from_picture("nonsense"));
}

// ISO 1154: feed holes 9.96 mm from the edge beside tracks 1 to 3, tracks 2.54 mm apart, the
// feed holes between tracks 3 and 4.
TEST(Drawing, IsTrueToTheStandard) {
  const TapeDrawing drawing = draw_tape({{kRubOut, kBlankRow}, {}});
  ASSERT_EQ(drawing.strips.size(), 1U);
  const DrawnStrip& strip = drawing.strips[0];
  EXPECT_DOUBLE_EQ(strip.length, 5.08);
  ASSERT_EQ(strip.code.size(), 8U);
  ASSERT_EQ(strip.feed.size(), 2U);
  const double edge = strip.y + 25.4;
  const double wanted[] = {2.34, 4.88, 7.42, 12.5, 15.04, 17.58, 20.12, 22.66};
  for (std::size_t track = 0; track < 8; ++track) {
    EXPECT_NEAR(edge - strip.code[track].y, wanted[track], 1e-9);
    EXPECT_NEAR(strip.code[track].x, strip.x + 1.27, 1e-9);
  }
  EXPECT_NEAR(edge - strip.feed[1].y, 9.96, 1e-9);
  EXPECT_NEAR(strip.feed[1].x - strip.feed[0].x, 2.54, 1e-9);
}

TEST(Drawing, SvgHoldsEveryHoleInMillimetres) {
  const Tape tape = tape_of(long_program(4));
  const std::string svg = to_svg(draw_tape(tape));
  std::size_t holes = 0;
  for (const Row row : tape.rows) holes += static_cast<std::size_t>(std::popcount(row));
  const auto count = [&](const char* pattern) {
    const std::regex circle(pattern);
    return static_cast<std::size_t>(
        std::distance(std::sregex_iterator(svg.begin(), svg.end(), circle), {}));
  };
  EXPECT_EQ(count("<circle cx=\"[0-9.]+\" cy=\"[0-9.]+\" r=\"0.915\"/>"), holes);
  EXPECT_EQ(count("<circle cx=\"[0-9.]+\" cy=\"[0-9.]+\" r=\"0.585\"/>"), tape.rows.size());
  EXPECT_THAT(svg, HasSubstr("width=\"264mm\""));
  EXPECT_THAT(svg, HasSubstr(">101 · 254.00 mm<"));
}

TEST(Distances, AreExactHundredths) {
  EXPECT_EQ(millimetres_to(0), "0.00");
  EXPECT_EQ(millimetres_to(1), "2.54");
  EXPECT_EQ(millimetres_to(2), "5.08");
  EXPECT_EQ(millimetres_to(1'000'000), "2540000.00");
}

// --- two readings of one tape -------------------------------------------------------------------

TEST(Joining, AReadingThatStoppedAnywhereIsGoneOnWith) {
  const Tape tape = tape_of(long_program(12));
  const std::size_t program = rows_in(500);
  for (std::size_t stop = program + kLeastOverlap; stop < tape.rows.size(); stop += 7) {
    for (const std::size_t from : {std::size_t{0}, std::size_t{50}, program - 3}) {
      const auto at = [&](std::size_t row) {
        return tape.rows.begin() + static_cast<std::ptrdiff_t>(row);
      };
      const Tape kept{{at(0), at(stop)}, {{stop, "stopped"}}};
      const Tape again{{at(from), tape.rows.end()}, {}};
      const auto joined = join_readings(kept, again);
      ASSERT_TRUE(joined) << stop << " " << from;
      ASSERT_EQ(*joined, tape);
    }
  }
}

TEST(Joining, WhatFitsTwiceOrNotAtAllIsRefused) {
  const std::string line(40, 'A');
  const Tape kept{tape_of(line).rows, {}};
  Tape cut = kept;
  cut.rows.resize(rows_in(500) + 3 + 30);
  cut.gaps = {{cut.rows.size(), "stopped"}};
  Tape again{{kept.rows.begin() + static_cast<std::ptrdiff_t>(rows_in(500)) + 5, kept.rows.end()},
             {}};
  EXPECT_EQ(join_readings(cut, again).error(), JoinFault::Ambiguous);
  EXPECT_EQ(join_readings(cut, tape_of(long_program(3))).error(), JoinFault::NoOverlap);
  EXPECT_EQ(join_readings({{1, 2, 3}, {}}, kept).error(), JoinFault::NoOverlap);
}

TEST(Joining, GapsOfBothReadingsStay) {
  const Tape tape = tape_of(long_program(6));
  Tape kept{{tape.rows.begin(), tape.rows.begin() + 300}, {{210, "noise"}, {300, "stopped"}}};
  Tape again = tape;
  again.gaps = {{100, "before"}, {350, "again"}};
  const auto joined = join_readings(kept, again);
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->rows, tape.rows);
  EXPECT_EQ(joined->gaps, (std::vector<Gap>{{210, "noise"}, {350, "again"}}));
}

}  // namespace
}  // namespace dgt
