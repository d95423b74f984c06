// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a person sees when a program is executed and something is wrong with it: the whole text, for
// every message of the evaluator. Those of the lexer and the parser stand in their own tests.
#include <gtest/gtest.h>

#include "tests/lang/program.h"

namespace dgt {
namespace {

TEST(DgtMessages, AnUndefinedElementIsToldOnce) {
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

TEST(DgtMessages, AnElementThatFailedIsNotMissed) {
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

TEST(DgtMessages, TheWorldCannotBeDefined) {
  EXPECT_EQ(CompiledProgram(R"(O0=X1 Y1 A0
)")
                .messages(),
            R"(t.bgt:1:1: error: O0 is the world and cannot be defined [DGT0309]
O0=X1 Y1 A0
^~
)");
}

TEST(DgtMessages, ASelectorHasSixValues) {
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

TEST(DgtMessages, CoincidentPointsMakeNoLine) {
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

TEST(DgtMessages, CollinearPointsMakeNoCircle) {
  EXPECT_EQ(CompiledProgram(R"(C2=X0 Y0 X1 Y1 X2 Y2
)")
                .messages(),
            R"(t.bgt:1:4: error: X0Y0, X1Y1 and X2Y2 lie on one line, to within 0 mm [DGT0312]
C2=X0 Y0 X1 Y1 X2 Y2
   ^~~~~~~~~~~~~~~~~
)");
}

TEST(DgtMessages, ParallelLinesDoNotMeet) {
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

TEST(DgtMessages, OneLineTwiceMakesNoPoint) {
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

TEST(DgtMessages, NoTangentLeadsFromAPointInside) {
  EXPECT_EQ(CompiledProgram(R"(C1=X0 Y0 R5
L1=X1 Y0 C1
)")
                .messages(),
            R"(t.bgt:2:4: error: X1Y0 lies 4 mm inside C1; no tangent leads from it [DGT0314]
L1=X1 Y0 C1
   ^~~~~~~~
)");
}

TEST(DgtMessages, ConcentricCirclesHaveNoTangent) {
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

TEST(DgtMessages, ACircleInsideAnotherHasNoCommonTangent) {
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

TEST(DgtMessages, NoCircleTouchesWhatIsTooFarAway) {
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

TEST(DgtMessages, EveryCircleTouchesTheSameLineTwice) {
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
C1=L1 L1 R3
)")
                .messages(),
            R"(t.bgt:2:4: error: L1 and L1 coincide; every such circle touches both [DGT0318]
C1=L1 L1 R3
   ^~~~~~~~
)");
}

TEST(DgtMessages, ACircleNeedsARadius) {
  EXPECT_EQ(CompiledProgram(R"(C6=X0 Y0 R0
)")
                .messages(),
            R"(t.bgt:1:10: error: the radius of a circle cannot be 0 [DGT0319]
C6=X0 Y0 R0
         ^~
)");
}

TEST(DgtMessages, ALineThatMissesACircleSaysByHowMuch) {
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

TEST(DgtMessages, ASelectorOfEqualCoordinatesIsAnError) {
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

TEST(DgtMessages, AnElementNumberFromAVariableIsChecked) {
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

TEST(DgtMessages, WordsAreChecked) {
  EXPECT_EQ(CompiledProgram(R"(G5
G54
G0
F-1
T-2
M1.5
)")
                .messages(),
            R"(t.bgt:1:1: error: G5 is not known; there are G0 and G54 [DGT0401]
G5
^~
t.bgt:2:1: error: G54 needs a point behind it [DGT0402]
G54
^~~
t.bgt:3:1: error: G0 needs a point behind it [DGT0402]
G0
^~
t.bgt:4:1: error: F cannot be negative [DGT0403]
F-1
^~~
t.bgt:5:1: error: T cannot be negative [DGT0403]
T-2
^~~
t.bgt:6:1: error: the number of a technology command must be whole; 1.5 is not [DGT0404]
M1.5
^~~~
)");
}

TEST(DgtMessages, ASelectorWithNothingToSelectIsAnError) {
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
K2 L1 I2
)")
                .messages(),
            R"(t.bgt:2:7: error: nothing follows that this selector could select on [DGT0405]
K2 L1 I2
      ^~
)");
}

TEST(DgtMessages, AFilletNeedsAnElementBeforeIt) {
  EXPECT_EQ(CompiledProgram(R"(K1 X1 Y1 R5
)")
                .messages(),
            R"(t.bgt:1:10: error: R5 needs an element before it and one behind it [DGT0406]
K1 X1 Y1 R5
         ^~
)");
}

TEST(DgtMessages, AChamferStandsBetweenLines) {
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
C1=X0 Y0 R5
K3 C1 V5 L1
)")
                .messages(),
            R"(t.bgt:3:4: error: a chamfer joins two lines; C1 and L1 are not [DGT0407]
K3 C1 V5 L1
   ^~
)");
}

TEST(DgtMessages, ATangentJoinsCircles) {
  EXPECT_EQ(
      CompiledProgram(R"(L1=Y0
L2=X5
K4 L1 V L2
)")
          .messages(),
      R"(t.bgt:3:4: error: V without a number is the tangent of two circles; L1 and L2 are not [DGT0408]
K4 L1 V L2
   ^~
)");
}

TEST(DgtMessages, DGoesAlongALine) {
  EXPECT_EQ(CompiledProgram(R"(C1=X0 Y0 R5
K5 X9 Y0 C1 D5
)")
                .messages(),
            R"(t.bgt:2:10: error: D goes along a line; C1 is a circle [DGT0409]
K5 X9 Y0 C1 D5
         ^~
)");
}

TEST(DgtMessages, DStartsOnItsLine) {
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
G54 X0 Y3
K1 L1 D5
)")
                .messages(),
            R"(t.bgt:3:4: error: the tool stands 3 mm off L1, along which D is to go [DGT0417]
K1 L1 D5
   ^~
)");
}

TEST(DgtMessages, TheCentreHasNoNormal) {
  EXPECT_EQ(CompiledProgram(R"(C1=X0 Y0 R5
K6 X0 Y0 C1
)")
                .messages(),
            R"(t.bgt:2:10: error: the centre of C1 has no normal on it [DGT0410]
K6 X0 Y0 C1
         ^~
)");
}

TEST(DgtMessages, WStandsBeforeTheFirstElement) {
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
L2=X5
K7 L1 L2 W5
)")
                .messages(),
            R"(t.bgt:3:10: error: W stands once in a contour, before its first element [DGT0411]
K7 L1 L2 W5
         ^~
)");
}

TEST(DgtMessages, UCannotChangeAtAFillet) {
  EXPECT_EQ(
      CompiledProgram(R"(C1=X0 Y0 R5
C2=X20 Y0 R5
L1=Y5
G54 X-20 Y6
K1 W1 L1 C-1 U2 R1 C2
)")
          .messages(),
      R"(t.bgt:5:7: note: the offset lies to the left of L1, where the tool stands before it [DGT0504]
K1 W1 L1 C-1 U2 R1 C2
      ^~
t.bgt:5:17: error: U cannot change the offset where R1 joins elements smoothly [DGT0412]
K1 W1 L1 C-1 U2 R1 C2
                ^~
)");
}

TEST(DgtMessages, AFilletOfNoRadiusIsAnError) {
  EXPECT_EQ(
      CompiledProgram(R"(L1=Y0
L2=X5
K8 X1 Y1 L1 R0 L2 L1
)")
          .messages(),
      R"(t.bgt:3:13: error: R0 joins nothing: a fillet must not be 0, a chamfer must be greater than 0 [DGT0418]
K8 X1 Y1 L1 R0 L2 L1
            ^~
)");
}

TEST(DgtMessages, AnElementDoesNotMeetItself) {
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
K10 L1 L1
)")
                .messages(),
            R"(t.bgt:2:5: error: L1 and L1 are the same; they meet everywhere [DGT0321]
K10 L1 L1
    ^~
)");
}

TEST(DgtMessages, ATangentPointIsNoArc) {
  EXPECT_EQ(CompiledProgram(R"(C1=X0 Y0 R5
L1=Y5.0005
L2=X20
G54 X-20 Y6
K1 L1 C-1 L1 L2
)")
                .messages(),
            R"(t.bgt:5:4: warning: L1 and C-1 miss each other by 0.0005 mm and were joined [DGT0506]
K1 L1 C-1 L1 L2
   ^~
t.bgt:5:7: error: the arc along C-1 begins and ends in one point [DGT0415]
K1 L1 C-1 L1 L2
      ^~~
t.bgt:5:7: warning: C-1 and L1 miss each other by 0.0005 mm and were joined [DGT0506]
K1 L1 C-1 L1 L2
      ^~~
)");
}

TEST(DgtMessages, AnArcCannotBeRapid) {
  EXPECT_EQ(CompiledProgram(R"(C1=X0 Y0 R5
L1=Y0
K13 F0 X9 Y0 C1 L1
)")
                .messages(),
            R"(t.bgt:3:14: error: C1 is an arc, and F0 has made all moves rapid [DGT0416]
K13 F0 X9 Y0 C1 L1
             ^~
)");
}

TEST(DgtMessages, TheSideOfANegativeOffsetMustBeSaid) {
  EXPECT_EQ(
      CompiledProgram(R"(L1=Y0
L2=X5
L3=Y10
G54 X0 Y1
K2 W-1 L1 L2 L3
)")
          .messages(),
      R"(t.bgt:5:8: error: a negative W needs a side; write '@ offset-side left or right before the contour [DGT0414]
K2 W-1 L1 L2 L3
       ^~
)");
}

TEST(DgtMessages, TheSideIsUnknownWhenTheToolStandsOnTheElement) {
  EXPECT_EQ(
      CompiledProgram(R"(L1=Y0
L2=X5
L3=Y10
K1 W1 L1 L2 L3
)")
          .messages(),
      R"(t.bgt:4:7: error: the tool stands on L1, so nothing tells on which side the offset lies; write '@ offset-side left or right before the contour [DGT0413]
K1 W1 L1 L2 L3
      ^~
)");
}

TEST(DgtMessages, OffsetElementsThatMissSayTheGapAndTheLargestOffset) {
  EXPECT_EQ(CompiledProgram(R"(C1=X0 Y0 R5
L1=Y4.9
L2=X20
G54 X-20 Y6
K1 W0.5 L1 C1 L1 L2
)")
                .messages(),
            R"(t.bgt:5:9: error: moved by the offset, L1 and C1 miss each other by 0.9 mm [DGT0501]
K1 W0.5 L1 C1 L1 L2
        ^~
t.bgt:5:4: note: with W0.05 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W0.5 L1 C1 L1 L2
   ^~~~
t.bgt:5:9: note: the offset lies to the left of L1, where the tool stands before it [DGT0504]
K1 W0.5 L1 C1 L1 L2
        ^~
)");
}

TEST(DgtMessages, AnElementEatenSaysTheLargestOffset) {
  EXPECT_EQ(
      CompiledProgram(R"(L1=X0
L2=Y10
L3=X4
L4=Y0
G54 X2 Y5
K1 W2.5 L-1 L2 L3 L-4 L-1
)")
          .messages(),
      R"(t.bgt:6:9: note: the offset lies to the right of L-1, where the tool stands before it [DGT0505]
K1 W2.5 L-1 L2 L3 L-4 L-1
        ^~~
t.bgt:6:13: error: the offset eats L2, which lacks 1 mm [DGT0502]
K1 W2.5 L-1 L2 L3 L-4 L-1
            ^~
t.bgt:6:4: note: with W2 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W2.5 L-1 L2 L3 L-4 L-1
   ^~~~
t.bgt:6:19: error: the offset eats L-4, which lacks 1 mm [DGT0502]
K1 W2.5 L-1 L2 L3 L-4 L-1
                  ^~~
t.bgt:6:4: note: with W2 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W2.5 L-1 L2 L3 L-4 L-1
   ^~~~
)");
}

TEST(DgtMessages, AnArcWhoseEndsPassIsAnError) {
  EXPECT_EQ(
      CompiledProgram(R"(L1=X-1 Y-4.9 A-45
L2=X1 Y-4.9 A45
C1=X0 Y0 R5
G54 X0 Y5
K1 W3 X-4 Y3 L1 I2 C1 I2 L2 X4 Y3
)")
          .messages(),
      R"(t.bgt:5:14: note: the offset lies to the left of L1, where the tool stands before it [DGT0504]
K1 W3 X-4 Y3 L1 I2 C1 I2 L2 X4 Y3
             ^~
t.bgt:5:20: error: the offset eats the arc along C1: its ends pass each other [DGT0511]
K1 W3 X-4 Y3 L1 I2 C1 I2 L2 X4 Y3
                   ^~
t.bgt:5:4: note: with W2.172 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W3 X-4 Y3 L1 I2 C1 I2 L2 X4 Y3
   ^~
)");
}

TEST(DgtMessages, ATooWideToolGougesItsOwnContour) {
  EXPECT_EQ(
      CompiledProgram(R"(L1=X-20
L2=Y0
L3=X0
L4=X4
L5=X20
G54 X-15 Y5
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
)")
          .messages(),
      R"(t.bgt:7:9: note: the offset lies to the left of L1, where the tool stands before it [DGT0504]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
        ^~
t.bgt:7:15: error: on its way along L3 the tool cuts 0.2 mm deep into L-4, at X2.1 Y-10 [DGT0508]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
              ^~
t.bgt:7:4: note: with W2 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
   ^~~~
t.bgt:7:28: error: on its way along L-4 the tool cuts 0.2 mm deep into L2, at X1.9 Y0 [DGT0508]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
                           ^~~
t.bgt:7:4: note: with W2 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
   ^~~~
)");
}

TEST(DgtMessages, ALobeThatGrowsPastAFullTurnIsAnErrorWhereGougesAreAllowed) {
  EvaluateOptions options;
  options.gouge = GougePolicy::Warn;
  EXPECT_EQ(
      CompiledProgram(R"(L1=Y2
L2=Y-2
C1=X0 Y0 R7
C2=X14 Y0 R-5
G54 X14 Y0
K1 W2.001 L1 C2 L-2 C-1
)",
                      {}, options)
          .faults(),
      R"(t.bgt:6:14: error: with the offset C2 grows to a full circle; the tool does not fit between its neighbours [DGT0510]
K1 W2.001 L1 C2 L-2 C-1
             ^~
t.bgt:6:4: note: with W2 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W2.001 L1 C2 L-2 C-1
   ^~~~~~
t.bgt:6:17: warning: on its way along L-2 the tool cuts 0.002 mm deep into C2, at X9.41742431 Y0.001 [DGT0509]
K1 W2.001 L1 C2 L-2 C-1
                ^~~
t.bgt:6:4: note: with W2 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W2.001 L1 C2 L-2 C-1
   ^~~~~~
)");
}

TEST(DgtMessages, TwoLinesLeaveNoChoice) {
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
L2=X5
K1 L1 I2 L2 L1
)")
                .messages(),
            R"(t.bgt:3:4: error: L1 and L2 leave no choice; the selector selects nothing [DGT0322]
K1 L1 I2 L2 L1
   ^~
)");
}

TEST(DgtMessages, ALineAgainstItsDirectionIsWarnedOf) {
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
L2=X5
L3=Y10
G54 X0 Y1
K1 W1 L1 L2 L3
)")
                .messages(),
            R"(t.bgt:5:1: note: K1 is not closed: it ends 10 mm from where it began [DGT0513]
K1 W1 L1 L2 L3
^~
t.bgt:5:7: note: the offset lies to the left of L1, where the tool stands before it [DGT0504]
K1 W1 L1 L2 L3
      ^~
t.bgt:5:10: warning: L2 is cut against its direction, with the tool on its other side; L-2 is meant? [DGT0507]
K1 W1 L1 L2 L3
         ^~
         L-2
)");
}

TEST(DgtMessages, ALineWithoutItsCommaIsToldAndReadOn) {
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
L2=X5
L3=Y10
L4=X0
K1 L1 L2
L3 L4
L1 L2,
)")
                .messages(),
            R"(t.bgt:6:1: error: a line that goes on with a contour needs a comma [DGT0208]
L3 L4
^~~~~
     ,
)");
}

TEST(DgtMessages, ItemsNeedAContour) {
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
L1 L2,
L2 L1,
)")
                .messages(),
            R"(t.bgt:2:1: error: 'L1' belongs in a contour, and no contour is open here [DGT0209]
L1 L2,
^~
t.bgt:2:4: error: L2 is not defined here [DGT0308]
L1 L2,
   ^~
)");
}

TEST(DgtMessages, DivisionByZeroIsAnErrorAndItsResultIsNotMissed) {
  EXPECT_EQ(CompiledProgram(R"(N1=5/N2
L1=XN1
N3=N1+1
P1=L1 XN3 Y0
)")
                .messages(),
            R"(t.bgt:1:6: error: nothing can be divided by N2=0 [DGT0601]
N1=5/N2
     ^~
t.bgt:4:4: error: L1 is surplus for P=XY [DGT0304]
P1=L1 XN3 Y0
   ^~
)");
}

TEST(DgtMessages, LoopsRunAWholeNumberOfTimes) {
  EXPECT_EQ(
      CompiledProgram(R"(FOR 2.5
NEXT
FOR -1
NEXT
)")
          .messages(),
      R"(t.bgt:1:5: error: a loop runs a whole number of times, 0 or more; 2.5 is not [DGT0608]
FOR 2.5
    ^~~
t.bgt:3:5: error: a loop runs a whole number of times, 0 or more; -1 is not [DGT0608]
FOR -1
    ^~
)");
}

TEST(DgtMessages, TextsAreNumberedToThirty) {
  EXPECT_EQ(CompiledProgram(R"(B31="C1,"
B-1="L1,"
K1 B31
K5 B
)")
                .messages(),
            R"(t.bgt:1:1: error: there is no text B31; they are B1 to B30 [DGT0603]
B31="C1,"
^~~
t.bgt:2:1: error: there is no text B-1; they are B1 to B30 [DGT0603]
B-1="L1,"
^~~
t.bgt:3:4: error: there is no text B31; they are B1 to B30 [DGT0603]
K1 B31
   ^~~
t.bgt:4:4: error: 'B' needs a number [DGT0202]
K5 B
   ^
)");
}

TEST(DgtMessages, ATextMustHoldSomething) {
  EXPECT_EQ(CompiledProgram(R"(K2 B5
)")
                .messages(),
            R"(t.bgt:1:4: error: B5 holds no text here [DGT0604]
K2 B5
   ^~
)");
}

TEST(DgtMessages, ATextThatHoldsItselfIsStopped) {
  EXPECT_EQ(CompiledProgram(R"(B1="L1,B2,"
B2="B1,"
K4 B1
)")
                .messages(),
            R"(t.bgt:2:5: error: B1 holds itself: B1 → B2 → B1 [DGT0614]
B2="B1,"
    ^~
)");
}

TEST(DgtMessages, TextsThatGrowWithoutMeasureAreStopped) {
  EXPECT_EQ(
      CompiledProgram(R"(B1="X1 Y1,X1 Y1,X1 Y1,X1 Y1,X1 Y1,X1 Y1,X1 Y1,X1 Y1,X1 Y1,X1 Y1,"
B2="B1,B1,B1,B1,B1,B1,B1,B1,B1,B1,"
B3="B2,B2,B2,B2,B2,B2,B2,B2,B2,B2,"
B4="B3,B3,B3,B3,B3,B3,B3,B3,B3,B3,"
B5="B4,B4,B4,B4,B4,B4,B4,B4,B4,B4,"
B6="B5,B5,B5,B5,B5,B5,B5,B5,B5,B5,"
K4 B6
)")
          .messages(),
      R"(t.bgt:2:11: error: with its texts in place the line has more than 1000000 words [DGT0606]
B2="B1,B1,B1,B1,B1,B1,B1,B1,B1,B1,"
          ^~
)");
}

TEST(DgtMessages, AFaultInATextSaysWhereTheTextIsUsed) {
  EXPECT_EQ(CompiledProgram(R"(B2="L1 L,"
K3 B2
)")
                .messages(),
            R"(t.bgt:1:5: error: L1 is not defined here [DGT0308]
B2="L1 L,"
    ^~
t.bgt:2:1: note: the text is used here [DGT0607]
K3 B2
^~~~~
t.bgt:1:8: error: 'L' needs a number [DGT0202]
B2="L1 L,"
       ^
t.bgt:2:1: note: the text is used here [DGT0607]
K3 B2
^~~~~
)");
}

TEST(DgtMessages, NumbersThatGrowWithoutMeasureAreStopped) {
  EXPECT_EQ(CompiledProgram(R"(N1=2
FOR 40
N1=N1*N1
NEXT
)")
                .messages(),
            R"(t.bgt:3:7: error: the number takes more than 65536 bits [DGT0602]
N1=N1*N1
      ^~
t.bgt:2:1: note: in round 16 of this loop [DGT0615]
FOR 40
^~~~~~
)");
}

TEST(DgtMessages, DirectivesAreChecked) {
  EXPECT_EQ(CompiledProgram(R"('@ offset-side up
'@ kerf 5
)")
                .messages(),
            R"(t.bgt:1:16: error: 'up' is no side; write auto, left or right [DGT0613]
'@ offset-side up
               ^~
t.bgt:2:4: warning: there is no directive 'kerf'; offset-side is one [DGT0612]
'@ kerf 5
   ^~~~
)");
}

TEST(DgtMessages, FilesThatAreNotThereAreToldAndTheirNamesAreNotMissed) {
  EXPECT_EQ(
      CompiledProgram(R"(MAC NONE 1,
OPR none
P1=L99 L98
)")
          .messages(),
      R"(t.bgt:1:5: error: there is no macro NONE beside the program, in its folder mac or in the folders of the settings [DGT0701]
MAC NONE 1,
    ^~~~
t.bgt:2:5: error: there is no definition file none.bgt beside the program [DGT0703]
OPR none
    ^~~~
)");
}

TEST(DgtMessages, AnUnsavedProgramHasNoDefinitionFiles) {
  EXPECT_EQ(
      CompiledProgram(R"(OPR det
)",
                      {}, {}, false)
          .messages(),
      R"(t.bgt:1:5: error: the program has not been saved, so there is no folder to look in [DGT0704]
OPR det
    ^~~
)");
}

TEST(DgtMessages, ADefinitionFileHoldsDefinitionsOnly) {
  EXPECT_EQ(CompiledProgram(R"(OPR det
P1=L1 L2
)",
                            {
                                {"det.bgt", R"(L1=X5
N1=5
L2=Y5
)"},
                            })
                .messages(),
            R"(det.bgt:2:1: error: a definition file holds definitions only [DGT0705]
N1=5
^~~~
t.bgt:1:5: note: in the definition file det, read here [DGT0710]
OPR det
    ^~~
)");
}

TEST(DgtMessages, AMacroThatCallsItselfIsStopped) {
  EvaluateOptions options;
  options.bounds.macro_depth = 20;
  EXPECT_EQ(
      CompiledProgram(R"(MAC M 1,
)",
                      {
                          {"M.mac", R"(MAC M 1,
)"},
                      },
                      options)
          .messages(),
      R"(M.mac:1:5: error: macros call macros more than 20 deep; does one call itself? [DGT0702]
MAC M 1,
    ^
M.mac:1:5: note: in the macro M, called here [DGT0709]
MAC M 1,
    ^
M.mac:1:5: note: in the macro M, called here [DGT0709]
MAC M 1,
    ^
M.mac:1:5: note: in the macro M, called here [DGT0709]
MAC M 1,
    ^
M.mac:1:5: note: calls, loops and texts not shown here: 16 [DGT0711]
MAC M 1,
    ^
t.bgt:1:5: note: in the macro M, called here [DGT0709]
MAC M 1,
    ^
)");
}

TEST(DgtMessages, AMacroThatChangesTheProgramsNamesIsWarnedOf) {
  EXPECT_EQ(CompiledProgram(R"(L11=X5
N1=7
N2=20
OPR det
MAC KVAD 10,20,
MAC KVAD 30,20,
L11=X6
)",
                            {
                                {"KVAD.mac", R"(L11=XN1
P11=X5 Y5
N2=N1+1
)"},
                                {"det.bgt", R"(P11=X0 Y0
)"},
                            })
                .messages(),
            R"(t.bgt:5:10: warning: the macro changes N1 of the program that calls it [DGT0707]
MAC KVAD 10,20,
         ^~
t.bgt:2:1: note: N1 was set here [DGT0708]
N1=7
^~~~
KVAD.mac:1:1: warning: the macro changes L11 of the program that calls it [DGT0706]
L11=XN1
^~~
t.bgt:1:1: note: L11 was set here [DGT0708]
L11=X5
^~~
t.bgt:5:5: note: in the macro KVAD, called here [DGT0709]
MAC KVAD 10,20,
    ^~~~
KVAD.mac:2:1: warning: the macro changes P11 of the program that calls it [DGT0706]
P11=X5 Y5
^~~
det.bgt:1:1: note: P11 was set here [DGT0708]
P11=X0 Y0
^~~
t.bgt:5:5: note: in the macro KVAD, called here [DGT0709]
MAC KVAD 10,20,
    ^~~~
KVAD.mac:3:1: warning: the macro changes N2 of the program that calls it [DGT0707]
N2=N1+1
^~~~~~~
t.bgt:3:1: note: N2 was set here [DGT0708]
N2=20
^~~~~
t.bgt:5:5: note: in the macro KVAD, called here [DGT0709]
MAC KVAD 10,20,
    ^~~~
)");
}

TEST(DgtMessages, AFaultInAMacroIsToldOnce) {
  EXPECT_EQ(CompiledProgram(R"(FOR 3
MAC M 1,
NEXT
)",
                            {
                                {"M.mac", R"(L1=X1 A5
P1=L5 L6
)"},
                            })
                .messages(),
            R"(M.mac:1:9: error: the definition lacks Y (L=XYA L=PA) [DGT0303]
L1=X1 A5
        ^
t.bgt:2:5: note: in the macro M, called here [DGT0709]
MAC M 1,
    ^
M.mac:2:4: error: L5 is not defined here [DGT0308]
P1=L5 L6
   ^~
t.bgt:2:5: note: in the macro M, called here [DGT0709]
MAC M 1,
    ^
M.mac:2:7: error: L6 is not defined here [DGT0308]
P1=L5 L6
      ^~
t.bgt:2:5: note: in the macro M, called here [DGT0709]
MAC M 1,
    ^
)");
}

TEST(DgtMessages, LoopsInLoopsAreBounded) {
  EvaluateOptions options;
  options.bounds.loop_depth = 2;
  EXPECT_EQ(CompiledProgram(R"(FOR 2
FOR 2
FOR 2
NEXT
NEXT
NEXT
)",
                            {}, options)
                .messages(),
            R"(t.bgt:3:1: error: FOR stands in FOR more than 2 deep [DGT0609]
FOR 2
^~~~~
)");
}

TEST(DgtMessages, ExecutedLinesAreBounded) {
  EvaluateOptions options;
  options.bounds.statements = 100;
  EXPECT_EQ(
      CompiledProgram(R"(FOR 1000000000000
NEXT
)",
                      {}, options)
          .messages(),
      R"(t.bgt:2:1: error: more than 100 lines were executed; the program was stopped here [DGT0610]
NEXT
^~~~
t.bgt:1:1: note: in round 100 of this loop [DGT0615]
FOR 1000000000000
^~~~~~~~~~~~~~~~~
)");
}

TEST(DgtMessages, MovesAreBounded) {
  EvaluateOptions options;
  options.bounds.moves = 100;
  EXPECT_EQ(CompiledProgram(R"(FOR 1000
G0 X1 Y1
G0 X2 Y2
NEXT
)",
                            {}, options)
                .messages(),
            R"(t.bgt:2:1: error: the program makes more than 100 moves [DGT0611]
G0 X1 Y1
^~
t.bgt:1:1: note: in round 51 of this loop [DGT0615]
FOR 1000
^~~~~~~~
)");
}

TEST(DgtMessages, ItemsAreBoundedAsTheyCome) {
  EvaluateOptions options;
  options.bounds.moves = 100;
  EXPECT_EQ(CompiledProgram(R"(K1 X0 Y1
FOR 1000
X1 Y1,X2 Y2
NEXT
)",
                            {}, options)
                .messages(),
            R"(t.bgt:1:1: error: the program makes more than 100 moves [DGT0611]
K1 X0 Y1
^~
t.bgt:2:1: note: in round 50 of this loop [DGT0615]
FOR 1000
^~~~~~~~
)");
}

TEST(DgtMessages, GougesMayBeAllowed) {
  EvaluateOptions options;
  options.gouge = GougePolicy::Warn;
  EXPECT_EQ(CompiledProgram(R"(L1=X-20
L2=Y0
L3=X0
L4=X4
L5=X20
G54 X-15 Y5
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
)",
                            {}, options)
                .messages(),
            R"(t.bgt:7:1: note: K1 is not closed: it ends 40 mm from where it began [DGT0513]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
^~
t.bgt:7:9: note: the offset lies to the left of L1, where the tool stands before it [DGT0504]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
        ^~
t.bgt:7:15: warning: on its way along L3 the tool cuts 0.2 mm deep into L-4, at X2.1 Y-10 [DGT0509]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
              ^~
t.bgt:7:4: note: with W2 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
   ^~~~
t.bgt:7:28: warning: on its way along L-4 the tool cuts 0.2 mm deep into L2, at X1.9 Y0 [DGT0509]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
                           ^~~
t.bgt:7:4: note: with W2 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
   ^~~~
)");
}

TEST(DgtMessages, AreGivenInRussianToo) {
  EXPECT_EQ(CompiledProgram("L9=Y20\nC1=X0 Y0 R5\nP3=L9 C1").messages(Language::Russian),
            "t.bgt:3:4: error: L9 и C1 не пересекаются; зазор 15 мм [DGT0320]\n"
            "P3=L9 C1\n   ^~~~~\n");
}

}  // namespace
}  // namespace dgt
