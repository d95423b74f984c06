// SPDX-License-Identifier: GPL-3.0-or-later
//
// What 3B means, block by block, and where controls that count steps end its arcs.
#include <gmock/gmock.h>

#include <cstdlib>
#include <random>
#include <string>

#include "lang/text/render.h"
#include "lang/three_b/counting.h"
#include "lang/three_b/reader.h"

namespace dgt {
namespace {

using three_b::Axis;
using three_b::Cell;
using three_b::CountedTurn;

/// The moves of a program as to_text() prints them, without places; or all that is told of it.
std::string read(std::string_view text, const ThreeBOptions& options = {}) {
  const SourceFile file("t.3b", text);
  DiagnosticBag bag;
  NcProgram program = read_three_b(file, options, bag);
  if (bag.has_errors()) return render(bag);
  for (Move& move : program.path.moves) move.source = {};
  return to_text(program.path);
}

/// And what is told of one that is good.
std::string told(std::string_view text, const ThreeBOptions& options = {}) {
  const SourceFile file("t.3b", text);
  DiagnosticBag bag;
  (void)read_three_b(file, options, bag);
  bag.sort();
  return render(bag);
}

constexpr const char* kStart = "start X0.000000 Y0.000000\n";

// --- blocks -------------------------------------------------------------------------------------

TEST(ThreeB, LinesRunIntoTheirQuadrant) {
  EXPECT_EQ(read("B17000B5000B17000GXL1\nB3000B7000B7000GYL2\nB2000B3000B3000GYL3\n"
                 "B3000B7000B7000GYL4\nDD\n"),
            "start X0.000000 Y0.000000\n1 line X17.000000 Y5.000000 contour\n"
            "2 line X14.000000 Y12.000000 contour\n3 line X12.000000 Y9.000000 contour\n"
            "4 line X15.000000 Y2.000000 contour\n");
}

TEST(ThreeB, LinesAlongAnAxisMayLeaveOutTheirNumbers) {
  const std::string square =
      "start X0.000000 Y0.000000\n1 line X5.000000 Y0.000000 contour\n"
      "2 line X5.000000 Y5.000000 contour\n3 line X0.000000 Y5.000000 contour\n"
      "4 line X0.000000 Y0.000000 contour\n";
  EXPECT_EQ(read("B5000B0B5000GXL1\nB0B5000B5000GYL2\nB5000B0B5000GXL3\nB0B5000B5000GYL4\nDD\n"),
            square);
  EXPECT_EQ(read("BBB5000GXL1\nBBB5000GYL2\nBBB5000GXL3\nB0B0B5000GYL4\nE\n"), square);
  EXPECT_EQ(read("B5000BB5000GXL1\nBB5000B5000GYL2\nB1BB5000GXL3\nBB1B5000GYL4\nDD\n"), square);
}

TEST(ThreeB, XAndYInLowestTermsMayBeASlope) {
  EXPECT_EQ(read("B1B1B10000GXL1\nB17B5B34000GXL4\nDD\n"),
            "start X0.000000 Y0.000000\n1 line X10.000000 Y10.000000 contour\n"
            "2 line X44.000000 Y0.000000 contour\n");
}

TEST(ThreeB, ATextbooksArcs) {
  // From (−2, 9) to (9, −2) about 0, through three quadrants, and back.
  EXPECT_EQ(read("B2000B9000B25440GYNR2\nB9000B2000B25440GXSR4\nDD\n"),
            "start X0.000000 Y0.000000\n"
            "1 arc X11.000000 Y-11.000000 centre X2.000000 Y-9.000000 radius 9.219544 sweep "
            "244.942385 contour\n"
            "2 arc X0.000000 Y0.000000 centre X2.000000 Y-9.000000 radius 9.219544 sweep "
            "-244.942385 contour\n");
}

TEST(ThreeB, ArcsOnAnAxisBeginInTheQuadrantTheyRunInto) {
  // A quarter from each half axis, both ways, and back: J is counted along the way of the end.
  for (const char* text :
       {"B5000B0B5000GXNR1\nB0B5000B5000GYSR1\nDD\n", "B0B5000B5000GYNR2\nB5000B0B5000GXSR2\nDD\n",
        "B5000B0B5000GXNR3\nB0B5000B5000GYSR3\nDD\n",
        "B0B5000B5000GYNR4\nB5000B0B5000GXSR4\nDD\n"}) {
    EXPECT_THAT(read(text), testing::AllOf(testing::HasSubstr("sweep 90.000000"),
                                           testing::HasSubstr("2 arc X0.000000 Y0.000000"),
                                           testing::HasSubstr("sweep -90.000000")))
        << text;
  }
}

TEST(ThreeB, ATurnThatIsNearlyWholeIsTakenInTwo) {
  EXPECT_EQ(read("B300B20B1200GYNR1\nDD\n"),
            "start X0.000000 Y0.000000\n1 arc X-0.600007 Y-0.038000 centre X-0.299940 Y-0.019996 "
            "radius 0.300606 sweep 179.619556 contour\n2 arc X0.000000 Y-0.004000 centre "
            "X-0.300060 Y-0.020003 radius 0.300486 sweep 179.619252 contour\n");
}

TEST(ThreeB, ACircleIsAWholeTurn) {
  EXPECT_EQ(read("B5000B0B20000GYNR1\nDD\n"),
            "start X0.000000 Y0.000000\n1 arc X0.000000 Y0.000000 centre X-5.000000 Y0.000000 "
            "radius 5.000000 sweep 360.000000 contour\n");
  EXPECT_EQ(read("B0B5000B20000GXSR1\nDD\n"),
            "start X0.000000 Y0.000000\n1 arc X0.000000 Y0.000000 centre X0.000000 Y-5.000000 "
            "radius 5.000000 sweep -360.000000 contour\n");
}

TEST(ThreeB, WhatCountsALittleMoreThanATurnRunsOnBehindIt) {
  // 4 √(300² + 20²) = 1202.66, and four times the extreme 301 is 1204.
  EXPECT_EQ(read("B300B20B1206GYNR1\nDD\n"),
            "start X0.000000 Y0.000000\n1 arc X0.000000 Y0.000000 centre X-0.300000 Y-0.020000 "
            "radius 0.300666 sweep 360.000000 contour\n2 arc X0.000000 Y0.002000 centre "
            "X-0.300000 Y0.001000 radius 0.300002 sweep 0.381970 contour\n");
  EXPECT_THAT(read("B300B20B1205GYNR1\nDD\n"),
              testing::AllOf(testing::HasSubstr("sweep 360.000000"),
                             testing::HasSubstr("2 arc X0.000000 Y0.001000")));
  EXPECT_THAT(read("B300B20B1204GYNR1\nDD\n"), testing::Not(testing::HasSubstr("2 arc")));
}

TEST(ThreeB, BlocksMayBeLabelledSpacedAndInAnyCase) {
  const std::string expected = std::string(kStart) +
                               "1 line X5.000000 Y0.000000 contour\n"
                               "2 line X5.000000 Y5.000000 contour\n";
  for (const char* text :
       {"B5000B0B5000GXL1\nB0B5000B5000GYL2\nDD\n",
        "N   1: B   5000 B      0 B   5000 GX   L1\r\nN   2: B 0 B 5000 B 5000 GY L2\r\nN   3: "
        "DD\r\n",
        "0001 B005000B000000B005000GXL1\r0002 B0B5000B5000GYL2\rDD\r",
        "1. b5000 b0 b5000 g x l 1\n2) b0b5000b5000gyl2\ne", "B5000B0B5000GXL1 B0B5000B5000GYL2 DD",
        "%\nB5000B0B5000GXL1;\n;\n\nB0B5000B5000GYL2\nEND\n%\x1A"})
    EXPECT_EQ(read(text), expected) << text;
}

TEST(ThreeB, TheTitleOfACamSystemSaysWhereTheProgramStarts) {
  const std::string program =
      "****************************************\n"
      "CAXAWEDM -Version 2.0 , Name : PLATE.3B\n"
      "Conner R=    0.00000 ,      Offset F=     0.10000 ,Length=      20.000 mm\n"
      "****************************************\n"
      "Start Point =     10.00000 ,     -5.50000        ;      X ,      Y\n"
      "N   1: B   5000 B      0 B   5000 GX   L1 ;   15.000 ,   -5.500\n"
      "N   2: B      0 B   5000 B   5000 GY   L2 ;   15.000 ,   -0.500\n"
      "N   3: DD\n";
  EXPECT_EQ(read(program),
            "start X10.000000 Y-5.500000\n1 line X15.000000 Y-5.500000 contour\n"
            "2 line X15.000000 Y-0.500000 contour\n");
  EXPECT_EQ(told(program), "");
}

TEST(ThreeB, NotedPlacesCountFromTheFirstWhenNothingSaysTheStart) {
  EXPECT_EQ(told("B5000B0B5000GXL1 ; 15.000, -5.5\nB0B5000B5000GYL2 ; 15.000, -0.5\nDD\n"), "");
  EXPECT_EQ(
      told("B5000B0B5000GXL1 ; 15.000, -5.5\nB0B5000B5000GYL2 ; 15.000, -0.55\nDD\n"),
      "t.3b:2:1: warning: this block is noted to end at X15 Y-0.55, and ends at X15 Y-0.5; no "
      "more than the first such difference is told [DGT1619]\n"
      "B0B5000B5000GYL2 ; 15.000, -0.55\n^~~~~~~~~~~~~~~~\n");
}

TEST(ThreeB, ALongNumberIsNoPlace) {
  EXPECT_EQ(told("B5000B0B5000GXL1 ; 5, 0\nBBB1000GXL1 ; 123456789012345678901, 0\nDD\n"), "");
}

TEST(ThreeB, ZerosBeforeANumberMayBeAny) {
  EXPECT_EQ(read("B0000000000000000000000005000B0B5000GXL1\nDD\n"),
            std::string(kStart) + "1 line X5.000000 Y0.000000 contour\n");
}

TEST(ThreeB, ABlockThatIsCutShortIsNoTitle) {
  EXPECT_THAT(read("BBB5000L1\nDD\n"), testing::HasSubstr("'BBB5000L1' is no block"));
  EXPECT_THAT(read("DDX\n"), testing::HasSubstr("'DDX' is no block"));
  EXPECT_EQ(read("Bracket 5\nDD\n"), kStart);
}

TEST(ThreeB, TheUnitIsASetting) {
  ThreeBOptions options;
  options.unit = Rational(1, 100);
  EXPECT_EQ(read("B500B0B500GXL1\nDD\n", options),
            std::string(kStart) + "1 line X5.000000 Y0.000000 contour\n");
  options.unit = Rational(1, 3);
  EXPECT_EQ(read("B3B0B3GXL1\nB1B0B1GXL1\nDD\n", options),
            std::string(kStart) +
                "1 line X1.000000 Y0.000000 contour\n2 line X1.333333 Y0.000000 contour\n");
}

// --- D ------------------------------------------------------------------------------------------

TEST(ThreeB, BetweenTwoDTheWireIsOut) {
  EXPECT_EQ(read("BBB1000GXL1\nD\nBBB2000GYL2\nBBB2000GXL1\nD\nBBB1000GXL1\nDD\n"),
            std::string(kStart) +
                "1 line X1.000000 Y0.000000 contour\n2 rapid X1.000000 Y2.000000 position\n"
                "3 rapid X3.000000 Y2.000000 position\n4 line X4.000000 Y2.000000 contour\n");
}

TEST(ThreeB, TwoDInARowStopTheMachine) {
  const std::string stopped = std::string(kStart) +
                              "1 line X1.000000 Y0.000000 contour\n2 code M0\n"
                              "3 line X2.000000 Y0.000000 contour\n";
  EXPECT_EQ(read("BBB1000GXL1\nD\nD\nBBB1000GXL1\nDD\n"), stopped);
  EXPECT_EQ(read("BBB1000GXL1\nD D\nBBB1000GXL1\nDD\n"), stopped);
  EXPECT_EQ(read("BBB1000GXL1\nD\nD\nD\nBBB1000GXL1\nD\nBBB1000GXL1\nD\nDD\n"),
            std::string(kStart) +
                "1 line X1.000000 Y0.000000 contour\n2 code M0\n"
                "3 rapid X2.000000 Y0.000000 position\n4 line X3.000000 Y0.000000 contour\n"
                "5 code M0\n");
}

TEST(ThreeB, DMayBeNothingButAStop) {
  ThreeBOptions options;
  options.pause = ThreeBPause::Stop;
  const char* const program = "BBB1000GXL1\nD\nB0B1000B1000GYSR1\nDD\n";
  EXPECT_EQ(read(program, options),
            std::string(kStart) +
                "1 line X1.000000 Y0.000000 contour\n2 code M0\n3 arc X2.000000 Y-1.000000 centre "
                "X1.000000 Y-1.000000 radius 1.000000 sweep -90.000000 contour\n");
  EXPECT_EQ(read(program),
            "t.3b:3:1: error: an arc while the wire is out; if D only stops the machine, say --set "
            "3b.pause=stop [DGT1615]\nB0B1000B1000GYSR1\n^~~~~~~~~~~~~~~~~\n"
            "t.3b:2:1: note: the wire is taken out here [DGT1616]\nD\n^\n");
}

// --- what is told -------------------------------------------------------------------------------

TEST(ThreeB, AWireThatStaysOutIsToldOnce) {
  EXPECT_EQ(
      told("BBB1000GXL1\nD\nBBB1000GXL1\nDD\n"),
      "t.3b:2:1: note: from this D to the end the wire is out, and the moves are rapids; if it "
      "only stops the machine, say --set 3b.pause=stop [DGT1617]\nD\n^\n");
  const char* const threaded = "BBB1000GXL1\nD\nBBB1000GXL1\nD\nDD\n";
  EXPECT_EQ(told(threaded), "");
  EXPECT_EQ(read(threaded), std::string(kStart) +
                                "1 line X1.000000 Y0.000000 contour\n"
                                "2 rapid X2.000000 Y0.000000 position\n");
}

TEST(ThreeB, BlocksThatControlsEndApartAreCounted) {
  // The real arc of a real program: √(50.1² + 0.1²) is rounded down by one control and up by the
  // other.
  const char* const program = "B 50100B 100B 100000 GY NR1\nB 50100B 100B 100000 GY NR3\nDD\n";
  EXPECT_EQ(
      told(program),
      "t.3b:1:1: note: blocks that controls end apart: 2; the largest distance, here, is 0.002 "
      "mm; read as a control that keeps nearest to the curve [DGT1611]\n"
      "B 50100B 100B 100000 GY NR1\n^~~~~~~~~~~~~~~~~~~~~~~~~~~\n");
  ThreeBOptions options;
  options.end_tolerance = Rational(1, 1000);
  EXPECT_THAT(told(program, options), testing::HasSubstr("up to 0.002 mm apart; 0.001 mm"));
}

TEST(ThreeB, AFileWithoutAnEndIsToldOf) {
  const std::string empty =
      "t.3b:1:1: warning: neither DD nor E ends the program; is the file whole? [DGT1618]\n";
  EXPECT_THAT(told(""), testing::StartsWith(empty));
  EXPECT_THAT(told("Bracket\n"), testing::StartsWith(empty));
  EXPECT_THAT(told("BBB1000GXL1\nB5"), testing::HasSubstr(empty));
}

TEST(ThreeB, TooManyMovesStopTheReader) {
  ThreeBOptions options;
  options.nc.max_moves = 2;
  EXPECT_EQ(told("BBB1GXL1\nBBB1GXL1\nBBB1GXL1\nBBB1GXL1\nDD\n", options),
            "t.3b:3:1: error: the program makes more than 2 moves [DGT0611]\n"
            "BBB1GXL1\n^~~~~~~~\n");
}

// --- counting -----------------------------------------------------------------------------------

/// A control as they were built first, step by step: by the sign of x² + y² − r².
Cell stepped_by_the_sign(const CountedTurn& turn) {
  int quadrant = three_b::quadrant_of(turn.begin, turn.counter_clockwise);
  std::int64_t x = std::llabs(turn.begin.x);
  std::int64_t y = std::llabs(turn.begin.y);
  const std::int64_t square = x * x + y * y;
  for (std::int64_t left = turn.count; left > 0;) {
    const bool x_falls = (quadrant % 2 == 1) == turn.counter_clockwise;
    std::int64_t& falling = x_falls ? x : y;
    std::int64_t& rising = x_falls ? y : x;
    if (falling == 0) {
      quadrant = (quadrant + (turn.counter_clockwise ? 0 : 2)) % 4 + 1;
      continue;
    }
    const bool falls = x * x + y * y >= square;
    falls ? --falling : ++rising;
    if ((falls == x_falls) == (turn.axis == Axis::X)) --left;
  }
  const Cell signs = three_b::signs_of(quadrant);
  return {signs.x * x, signs.y * y};
}

/// Where one that keeps beside the circle is, its counted coordinate taken step by step.
Cell stepped_beside(const CountedTurn& turn) {
  const bool along_x = turn.axis == Axis::X;
  const std::int64_t square = turn.begin.x * turn.begin.x + turn.begin.y * turn.begin.y;
  const auto root = [](std::int64_t n) {  // the nearest whole number, by trial
    std::int64_t r = 0;
    while (n > r * r + r) ++r;
    return r;
  };
  const std::int64_t extreme = root(square);
  std::int64_t along = along_x ? turn.begin.x : turn.begin.y;
  const std::int64_t aside = along_x ? turn.begin.y : turn.begin.x;
  const bool falls_above = along_x == turn.counter_clockwise;
  // At an extreme the way turns round before the next step.
  int step = aside == 0 ? 0 : ((aside > 0) == falls_above ? -1 : 1);
  for (std::int64_t left = turn.count; left > 0; --left) {
    if (along == extreme) step = -1;
    if (along == -extreme) step = 1;
    along += step;
  }
  const std::int64_t other = root(square - along * along) * ((step < 0) == falls_above ? 1 : -1);
  return along_x ? Cell{along, other} : Cell{other, along};
}

std::string shown(const CountedTurn& turn) {
  return std::to_string(turn.begin.x) + " " + std::to_string(turn.begin.y) +
         (turn.counter_clockwise ? " ccw " : " cw ") + (turn.axis == Axis::X ? "X " : "Y ") +
         std::to_string(turn.count);
}

void expect_end_as_stepped(const CountedTurn& turn) {
  const three_b::CountedEnd end = three_b::end_of_turn(turn);
  const Cell beside = stepped_beside(turn);
  const Cell sign = stepped_by_the_sign(turn);
  ASSERT_EQ(end.end.x, beside.x) << shown(turn);
  ASSERT_EQ(end.end.y, beside.y) << shown(turn);
  ASSERT_EQ(end.apart, std::max(std::llabs(sign.x - beside.x), std::llabs(sign.y - beside.y)))
      << shown(turn);
}

TEST(ThreeBCounting, EndsEveryArcOfSmallCirclesWhereControlsStep) {
  constexpr std::int64_t kSize = 9;
  std::size_t count = 0;
  for (std::int64_t x = -kSize; x <= kSize; ++x) {
    for (std::int64_t y = -kSize; y <= kSize; ++y) {
      if (x * x + y * y < 4) continue;
      for (const bool ccw : {true, false}) {
        for (const Axis axis : {Axis::X, Axis::Y}) {
          const std::int64_t turn = three_b::steps_of_turn({x, y});
          for (std::int64_t steps = 1; steps <= turn + 2; ++steps, ++count)
            expect_end_as_stepped({{x, y}, ccw, axis, steps});
        }
      }
    }
  }
  EXPECT_GT(count, 30000U);
}

TEST(ThreeBCounting, EndsRandomArcsWhereControlsStep) {
  std::mt19937 random(11);
  const auto whole = [&](std::int64_t least, std::int64_t most) {
    return std::uniform_int_distribution<std::int64_t>(least, most)(random);
  };
  for (int i = 0; i < 4000; ++i) {
    const Cell begin{whole(-700, 700), whole(-700, 700)};
    if (begin.x * begin.x + begin.y * begin.y < 4) continue;
    const std::int64_t steps = whole(1, three_b::steps_of_turn(begin));
    expect_end_as_stepped({begin, i % 2 == 0, i % 4 < 2 ? Axis::X : Axis::Y, steps});
  }
}

TEST(ThreeBCounting, AlongTheWayOfTheEndControlsAreNoMoreThanAUnitApart) {
  std::mt19937 random(3);
  const auto whole = [&](std::int64_t least, std::int64_t most) {
    return std::uniform_int_distribution<std::int64_t>(least, most)(random);
  };
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t r = whole(10, 1'000'000'000);
    // From an extreme, less than a quadrant: nothing turns on the way.
    const std::int64_t steps = whole(1, r * 7 / 10);
    const three_b::CountedEnd end = three_b::end_of_turn({{0, r}, true, Axis::X, steps});
    EXPECT_LE(end.apart, 1) << r << " " << steps;
    EXPECT_EQ(end.end.x, -steps);
  }
}

TEST(ThreeBCounting, TheLargestNumbersFit) {
  const std::int64_t most = 999'999'999'999'999'999;
  const three_b::CountedEnd end = three_b::end_of_turn({{most, most}, true, Axis::X, most});
  EXPECT_EQ(end.end.x, 0);
  EXPECT_EQ(end.end.y, 1'414'213'562'373'095'047);
  EXPECT_LE(end.apart, 1);
  EXPECT_FALSE(three_b::end_of_line({1, most}, Axis::X, most));
}

TEST(ThreeBCounting, LinesCountedAlongTheirShorterWayEndApart) {
  EXPECT_EQ(three_b::end_of_line({17000, 5000}, Axis::X, 17000)->apart, 0);
  EXPECT_EQ(three_b::end_of_line({17000, 5000}, Axis::Y, 5000)->apart, 4);
  EXPECT_EQ(three_b::end_of_line({10000, 1}, Axis::Y, 1)->apart, 10000);
  EXPECT_FALSE(three_b::end_of_line({17000, 5000}, Axis::X, 17001));
}

}  // namespace
}  // namespace dgt
