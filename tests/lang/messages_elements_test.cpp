// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a person sees when a program is executed and something is wrong with it: the whole text, for
// every message of the evaluator. Here: definitions, elements that are missing, selectors.
#include <gtest/gtest.h>

#include "tests/lang/program.h"

namespace dgt {
namespace {

TEST(DgtMessagesOfElements, AnUndefinedElementIsToldOnce) {
  EXPECT_EQ(CompiledProgram(R"(L1=L7 D5
L2=L7 D6
K1 L7 L-7
)")
                .messages(),
            R"(t.bgt:1:4: error: L7 is not defined here [DGT0308]
L1=L7 D5
   ^~
)");
}

TEST(DgtMessagesOfElements, AnElementThatFailedIsNotMissed) {
  EXPECT_EQ(CompiledProgram(R"(P1=X1 Y1
L1=P1 X1 Y1
L2=L1 D5
K1 L1 L2
)")
                .messages(),
            R"(t.bgt:2:4: error: P1 and X1Y1 lie in one place, 0 mm apart [DGT0311]
L1=P1 X1 Y1
   ^~~~~~~~
)");
}

TEST(DgtMessagesOfElements, TheWorldCannotBeDefined) {
  EXPECT_EQ(CompiledProgram(R"(O0=X1 Y1 A0
)")
                .messages(),
            R"(t.bgt:1:1: error: O0 is the world and cannot be defined [DGT0309]
O0=X1 Y1 A0
^~
)");
}

TEST(DgtMessagesOfElements, ASelectorHasSixValues) {
  EXPECT_EQ(CompiledProgram(R"(C1=X0 Y0 R5
L1=Y0
P1=I7 L1 C1
)")
                .messages(),
            R"(t.bgt:3:4: error: I7 is no selector; they are I1 to I6 [DGT0310]
P1=I7 L1 C1
   ^~
)");
}

TEST(DgtMessagesOfElements, CoincidentPointsMakeNoLine) {
  EXPECT_EQ(CompiledProgram(R"(P1=X1 Y1
P2=X1 Y1
L1=P1 P2
)")
                .messages(),
            R"(t.bgt:3:4: error: P1 and P2 lie in one place, 0 mm apart [DGT0311]
L1=P1 P2
   ^~~~~
)");
}

TEST(DgtMessagesOfElements, CollinearPointsMakeNoCircle) {
  EXPECT_EQ(CompiledProgram(R"(C2=X0 Y0 X1 Y1 X2 Y2
)")
                .messages(),
            R"(t.bgt:1:4: error: X0Y0, X1Y1 and X2Y2 lie on one line, to within 0 mm [DGT0312]
C2=X0 Y0 X1 Y1 X2 Y2
   ^~~~~~~~~~~~~~~~~
)");
}

TEST(DgtMessagesOfElements, ParallelLinesDoNotMeet) {
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
L2=Y5
P1=L1 L2
C1=L1 L2 R3
)")
                .messages(),
            R"(t.bgt:3:4: error: L1 and L2 are parallel, 5 mm apart [DGT0313]
P1=L1 L2
   ^~~~~
t.bgt:4:4: error: L1 and L2 are parallel, 5 mm apart [DGT0313]
C1=L1 L2 R3
   ^~~~~~~~
)");
}

TEST(DgtMessagesOfElements, OneLineTwiceMakesNoPoint) {
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
L3=Y0
P2=L1 L3
)")
                .messages(),
            R"(t.bgt:3:4: error: L1 and L3 are the same; they meet everywhere [DGT0321]
P2=L1 L3
   ^~~~~
)");
}

TEST(DgtMessagesOfElements, NoTangentLeadsFromAPointInside) {
  EXPECT_EQ(CompiledProgram(R"(C1=X0 Y0 R5
L1=X1 Y0 C1
)")
                .messages(),
            R"(t.bgt:2:4: error: X1Y0 lies 4 mm inside C1; no tangent leads from it [DGT0314]
L1=X1 Y0 C1
   ^~~~~~~~
)");
}

TEST(DgtMessagesOfElements, ConcentricCirclesHaveNoTangent) {
  EXPECT_EQ(CompiledProgram(R"(C1=X0 Y0 R5
C2=X0 Y0 R7
L2=C1 C2
)")
                .messages(),
            R"(t.bgt:3:4: error: C1 and C2 have one centre; their radii differ by 2 mm [DGT0315]
L2=C1 C2
   ^~~~~
)");
}

TEST(DgtMessagesOfElements, ACircleInsideAnotherHasNoCommonTangent) {
  EXPECT_EQ(
      CompiledProgram(R"(C1=X0 Y0 R5
C3=X1 Y0 R1
L3=C1 C3
P2=C1 C3
)")
          .messages(),
      R"(t.bgt:3:4: error: C1 and C3 have no common tangent in their directions; they are 3 mm too close [DGT0316]
L3=C1 C3
   ^~~~~
t.bgt:4:4: error: C1 and C3 do not meet; the gap is 3 mm [DGT0320]
P2=C1 C3
   ^~~~~
)");
}

TEST(DgtMessagesOfElements, NoCircleTouchesWhatIsTooFarAway) {
  EXPECT_EQ(
      CompiledProgram(R"(C1=X0 Y0 R5
L9=Y20
C4=L9 C1 R2
)")
          .messages(),
      R"(t.bgt:3:4: error: no such circle touches L9 and C1 in their directions; the gap is 19 mm [DGT0317]
C4=L9 C1 R2
   ^~~~~~~~
)");
}

TEST(DgtMessagesOfElements, EveryCircleTouchesTheSameLineTwice) {
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
C1=L1 L1 R3
)")
                .messages(),
            R"(t.bgt:2:4: error: L1 and L1 coincide; every such circle touches both [DGT0318]
C1=L1 L1 R3
   ^~~~~~~~
)");
}

TEST(DgtMessagesOfElements, ACircleNeedsARadius) {
  EXPECT_EQ(CompiledProgram(R"(C6=X0 Y0 R0
)")
                .messages(),
            R"(t.bgt:1:10: error: the radius of a circle cannot be 0 [DGT0319]
C6=X0 Y0 R0
         ^~
)");
}

TEST(DgtMessagesOfElements, ALineThatMissesACircleSaysByHowMuch) {
  EXPECT_EQ(CompiledProgram(R"(C1=X0 Y0 R5
L9=Y20
P3=L9 C1
)")
                .messages(),
            R"(t.bgt:3:4: error: L9 and C1 do not meet; the gap is 15 mm [DGT0320]
P3=L9 C1
   ^~~~~
)");
}

TEST(DgtMessagesOfElements, ASelectorOfEqualCoordinatesIsAnError) {
  EXPECT_EQ(
      CompiledProgram(R"(C1=X0 Y0 R5
L7=Y0
P6=Y> L7 C1
)")
          .messages(),
      R"(t.bgt:3:7: error: the points where L7 and C1 meet are equal in this coordinate; the selector cannot tell them apart [DGT0323]
P6=Y> L7 C1
      ^~~~~
)");
}

TEST(DgtMessagesOfElements, AnElementNumberFromAVariableIsChecked) {
  EXPECT_EQ(
      CompiledProgram(R"(N1=2.5
N2=-3
L1=LN1 D5
P1=X1 Y1
K1 PN2
LN2=X5
)")
          .messages(),
      R"(t.bgt:3:4: error: the number of 'L' must be whole and between 0 and 9999; 2.5 is not [DGT0205]
L1=LN1 D5
   ^~~
t.bgt:5:4: error: the minus reverses lines and circles; 'P' has no direction [DGT0206]
K1 PN2
   ^~~
t.bgt:6:1: error: an element is defined without a minus; reverse 'L' where it is used [DGT0301]
LN2=X5
^~~
)");
}

TEST(DgtMessagesOfElements, AreGivenInRussianToo) {
  EXPECT_EQ(CompiledProgram("L9=Y20\nC1=X0 Y0 R5\nP3=L9 C1").messages(Language::Russian),
            "t.bgt:3:4: error: L9 и C1 не пересекаются; зазор 15 мм [DGT0320]\n"
            "P3=L9 C1\n   ^~~~~\n");
}

}  // namespace
}  // namespace dgt
