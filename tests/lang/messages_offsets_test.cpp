// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a person sees when a program is executed and something is wrong with it: the whole text, for
// every message of the evaluator. Here: contours with an offset.
#include <gtest/gtest.h>

#include "tests/lang/program.h"

namespace dgt {
namespace {

TEST(DgtMessagesOfOffsets, WStandsBeforeTheFirstElement) {
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

TEST(DgtMessagesOfOffsets, UCannotChangeAtAFillet) {
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

TEST(DgtMessagesOfOffsets, TheSideOfANegativeOffsetMustBeSaid) {
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

TEST(DgtMessagesOfOffsets, TheSideIsUnknownWhenTheToolStandsOnTheElement) {
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

TEST(DgtMessagesOfOffsets, OffsetElementsThatMissSayTheGapAndTheLargestOffset) {
  EXPECT_EQ(CompiledProgram(R"(C1=X0 Y0 R5
L1=Y4.9
L2=X20
G54 X-20 Y6
K1 W0.5 L1 C1 L1 L2
)")
                .messages(),
            R"(t.bgt:5:9: error: moved by the offset, L1 and C1 miss each other by 0.9 mm [DGT0501]
K1 W0.5 L1 C1 L1 L2
        ^~ ~~
t.bgt:5:4: note: with W0.05 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W0.5 L1 C1 L1 L2
   ^~~~
t.bgt:5:9: note: the offset lies to the left of L1, where the tool stands before it [DGT0504]
K1 W0.5 L1 C1 L1 L2
        ^~
)");
}

TEST(DgtMessagesOfOffsets, AnElementEatenSaysTheLargestOffset) {
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

TEST(DgtMessagesOfOffsets, AnArcWhoseEndsPassIsAnError) {
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

TEST(DgtMessagesOfOffsets, ATooWideToolGougesItsOwnContour) {
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
              ^~           ~~~
t.bgt:7:4: note: with W2 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
   ^~~~
t.bgt:7:15: note: L3 takes part in more such cuts of this contour [DGT0518]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
              ^~
t.bgt:7:28: error: on its way along L-4 the tool cuts 0.2 mm deep into L2, at X1.9 Y0 [DGT0508]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
           ~~              ^~~
t.bgt:7:4: note: with W2 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
   ^~~~
)");
}

TEST(DgtMessagesOfOffsets, ALobeThatGrowsPastAFullTurnIsAnErrorWhereGougesAreAllowed) {
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
             ~~ ^~~
t.bgt:6:4: note: with W2 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W2.001 L1 C2 L-2 C-1
   ^~~~~~
)");
}

TEST(DgtMessagesOfOffsets, ALineAgainstItsDirectionIsWarnedOf) {
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

TEST(DgtMessagesOfOffsets, ALongCornerIsWarnedOfWithItsPlace) {
  EXPECT_EQ(
      CompiledProgram(R"(L1=Y0
P1=X20 Y0
P2=X0 Y2
L2=P1 P2
L3=X0
G54 X10 Y-5
K1 W0.5 X10 L1 L2 L3
)")
          .faults(),
      R"(t.bgt:7:13: warning: past the corner of L1 and L2 the tool runs 10.037399 mm out, to X30.0249378 Y-0.5, before it turns [DGT0520]
K1 W0.5 X10 L1 L2 L3
            ^~ ~~
t.bgt:7:13: note: the setting corner = round or chamfer goes round it near the part [DGT0521]
K1 W0.5 X10 L1 L2 L3
            ^~
)");
}

TEST(DgtMessagesOfOffsets, ALongCornerMayBeCutShort) {
  EvaluateOptions options;
  options.corner = CornerStyle::Chamfer;
  const CompiledProgram program(R"(L1=Y0
P1=X20 Y0
P2=X0 Y2
L2=P1 P2
L3=X0
G54 X10 Y-5
K1 W0.5 X10 L1 L2 L3
)",
                                {}, options);
  EXPECT_EQ(program.faults(), "");
  EXPECT_NE(program.path().find(" corner  ; t.bgt:7:16\n"), std::string::npos) << program.path();
}

TEST(DgtMessagesOfOffsets, ALoopLeftOutIsToldWithItsPlace) {
  EvaluateOptions options;
  options.gouge = GougePolicy::Trim;
  EXPECT_EQ(
      CompiledProgram(R"(L1=X-20
L2=Y0
L3=X-2
L4=Y-8
L5=X2
L6=X20
P1=X-10 Y10
P2=X0 Y-4
G54 X-10 Y10
K1 W3 L1 L2 L3 L4 L-5 L2 L-6
)",
                      {}, options)
          .faults(),
      R"(t.bgt:10:10: warning: between L2 and L2 the tool does not fit; it goes over at X1 Y3, and what lies between stays uncut [DGT0522]
K1 W3 L1 L2 L3 L4 L-5 L2 L-6
         ^~           ~~
)");
}

TEST(DgtMessagesOfOffsets, ACutThatBeginsInAGougeCannotBeTrimmed) {
  EvaluateOptions options;
  options.gouge = GougePolicy::Trim;
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
L2=X20
L3=Y20
L4=X0
P1=X10 Y10
G54 X10 Y10
K1 W11 P1 L1 L-2 L-3 L4 L1 P1
)",
                            {}, options)
                .faults(),
            R"(t.bgt:7:11: error: the offset eats L1, which lacks 1 mm [DGT0502]
K1 W11 P1 L1 L-2 L-3 L4 L1 P1
          ^~
t.bgt:7:4: note: with W10 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W11 P1 L1 L-2 L-3 L4 L1 P1
   ^~~
t.bgt:7:11: error: the contour cannot be trimmed: where the cut begins, at X10 Y11 beside L1, the tool already cuts in; begin elsewhere [DGT0523]
K1 W11 P1 L1 L-2 L-3 L4 L1 P1
          ^~
t.bgt:7:14: error: the offset eats L-2, which lacks 2 mm [DGT0502]
K1 W11 P1 L1 L-2 L-3 L4 L1 P1
             ^~~
t.bgt:7:4: note: with W10 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W11 P1 L1 L-2 L-3 L4 L1 P1
   ^~~
t.bgt:7:18: error: the offset eats L-3, which lacks 2 mm [DGT0502]
K1 W11 P1 L1 L-2 L-3 L4 L1 P1
                 ^~~
t.bgt:7:4: note: with W10 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W11 P1 L1 L-2 L-3 L4 L1 P1
   ^~~
t.bgt:7:22: error: the offset eats L4, which lacks 2 mm [DGT0502]
K1 W11 P1 L1 L-2 L-3 L4 L1 P1
                     ^~
t.bgt:7:4: note: with W10 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W11 P1 L1 L-2 L-3 L4 L1 P1
   ^~~
t.bgt:7:25: error: the offset eats L1, which lacks 1 mm [DGT0502]
K1 W11 P1 L1 L-2 L-3 L4 L1 P1
                        ^~
t.bgt:7:4: note: with W10 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W11 P1 L1 L-2 L-3 L4 L1 P1
   ^~~
)");
}

TEST(DgtMessagesOfOffsets, ACircleEatenWholeLeavesNothingToTrim) {
  EvaluateOptions options;
  options.gouge = GougePolicy::Trim;
  EXPECT_EQ(
      CompiledProgram(R"(C1=X0 Y0 R2
P1=X1 Y0
G54 X1 Y0
K1 W3 P1 C1 P1
)",
                      {}, options)
          .faults(),
      R"(t.bgt:4:1: error: the contour cannot be trimmed: the tool fits nowhere along it [DGT0526]
K1 W3 P1 C1 P1
^~
t.bgt:4:10: error: the offset eats C1, which lacks 1 mm [DGT0502]
K1 W3 P1 C1 P1
         ^~
t.bgt:4:4: note: with W1.999 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W3 P1 C1 P1
   ^~
)");
}

TEST(DgtMessagesOfOffsets, AContourThatLeavesItsElementsOnTheWayCannotBeTrimmed) {
  EvaluateOptions options;
  options.gouge = GougePolicy::Trim;
  EXPECT_EQ(
      CompiledProgram(R"(L1=X-20
L2=Y0
L3=X-2
L4=Y-8
L5=X2
L6=X20
P1=X-10 Y10
P2=X0 Y-4
G54 X-10 Y10
K1 W3 L1 L2 L3 Y-8 Y-8 L-5 L2 L-6
)",
                      {}, options)
          .faults(),
      R"(t.bgt:10:13: error: on its way along L3 the tool cuts 2 mm deep into L-5, at X1 Y-8 [DGT0508]
K1 W3 L1 L2 L3 Y-8 Y-8 L-5 L2 L-6
            ^~         ~~~
t.bgt:10:4: note: with W2 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W3 L1 L2 L3 Y-8 Y-8 L-5 L2 L-6
   ^~
t.bgt:10:13: note: L3 takes part in more such cuts of this contour [DGT0518]
K1 W3 L1 L2 L3 Y-8 Y-8 L-5 L2 L-6
            ^~
t.bgt:10:24: error: on its way along L-5 the tool cuts 2 mm deep into L2, at X-1 Y0 [DGT0508]
K1 W3 L1 L2 L3 Y-8 Y-8 L-5 L2 L-6
         ~~            ^~~
t.bgt:10:4: note: with W2 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W3 L1 L2 L3 Y-8 Y-8 L-5 L2 L-6
   ^~
t.bgt:10:28: error: the contour cannot be trimmed: beside L2, at X-2 Y-8, no way leads on [DGT0524]
K1 W3 L1 L2 L3 Y-8 Y-8 L-5 L2 L-6
                           ^~
)");
}

TEST(DgtMessagesOfOffsets, APartThatCannotBeReachedForbidsTrimming) {
  EvaluateOptions options;
  options.gouge = GougePolicy::Trim;
  EXPECT_EQ(
      CompiledProgram(R"(L1=Y2
L2=Y-2
C1=X0 Y0 R7
C2=X14 Y0 R5
C3=X-14 Y0 R5
P1=X17 Y0
G54 X14 Y0
K1 W3 P1 C2 L-1 C3 L2 C2 P1
)",
                      {}, options)
          .faults(),
      R"(t.bgt:8:13: error: on its way along L-1 the tool cuts 2 mm deep into C3, at X-9.41742431 Y-1 [DGT0508]
K1 W3 P1 C2 L-1 C3 L2 C2 P1
            ^~~ ~~
t.bgt:8:4: note: with W2 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W3 P1 C2 L-1 C3 L2 C2 P1
   ^~
t.bgt:8:13: note: L-1 takes part in more such cuts of this contour [DGT0518]
K1 W3 P1 C2 L-1 C3 L2 C2 P1
            ^~~
t.bgt:8:17: error: the contour cannot be trimmed: it falls apart, and the part beside C3, at X-12.2679492 Y-1, would stay uncut [DGT0525]
K1 W3 P1 C2 L-1 C3 L2 C2 P1
                ^~
t.bgt:8:20: error: on its way along L2 the tool cuts 2 mm deep into C2, at X9.41742431 Y1 [DGT0508]
K1 W3 P1 C2 L-1 C3 L2 C2 P1
         ~~        ^~
t.bgt:8:4: note: with W2 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W3 P1 C2 L-1 C3 L2 C2 P1
   ^~
t.bgt:8:20: note: L2 takes part in more such cuts of this contour [DGT0518]
K1 W3 P1 C2 L-1 C3 L2 C2 P1
                   ^~
)");
}

TEST(DgtMessagesOfOffsets, GougesMayBeAllowed) {
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
              ^~           ~~~
t.bgt:7:4: note: with W2 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
   ^~~~
t.bgt:7:15: note: L3 takes part in more such cuts of this contour [DGT0518]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
              ^~
t.bgt:7:28: warning: on its way along L-4 the tool cuts 0.2 mm deep into L2, at X1.9 Y0 [DGT0509]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
           ~~              ^~~
t.bgt:7:4: note: with W2 this stretch still works; that is the largest such W, in steps of 0.001 mm [DGT0503]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
   ^~~~
t.bgt:7:28: warning: on its way to L-4 the tool cuts 0.2 mm deep into K1, at X1.9 Y-10 [DGT0530]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
                           ^~~
t.bgt:7:15: note: there the contour runs along L3 [DGT0533]
K1 W2.1 L1 L2 L3 Y-10 Y-10 L-4 L2 L-5
              ^~
)");
}

// Sample 2P with two minus signs forgotten: no single one of them cures it.
TEST(DgtMessagesOfOffsets, OneSlipInALoopIsOneGouge) {
  EXPECT_EQ(
      CompiledProgram(R"(L1=Y2
L2=Y-2
C1=X0 Y0 R7
C2=X14 Y0 R-5
G54 X14 Y0
K1 W0.2 L1 C2 L-2 C1
FOR 5
N1=N1-60
AN1, L1 C2 L-2 C1
NEXT
A-0, L1 C2
)")
          .messages(),
      R"(t.bgt:6:9: note: the offset lies outside the closed contour, on the side of L1 where the tool stands before it [DGT0515]
K1 W0.2 L1 C2 L-2 C1
        ^~
t.bgt:6:19: error: on its way along C1 the tool cuts 0.2 mm deep into L-2, at X1.72627249 Y-6.98999165 [DGT0508]
K1 W0.2 L1 C2 L-2 C1
                  ^~
t.bgt:9:12: note: L-2 stands here [DGT0421]
AN1, L1 C2 L-2 C1
           ^~~
t.bgt:6:19: note: C1 takes part in more such cuts of this contour [DGT0518]
K1 W0.2 L1 C2 L-2 C1
                  ^~
)");
}

// The same in the loop alone: the one word that is at fault is told, whatever it cuts into.
TEST(DgtMessagesOfOffsets, TheMinusForgottenInALoopIsFound) {
  EXPECT_EQ(
      CompiledProgram(R"(L1=Y2
L2=Y-2
C1=X0 Y0 R7
C2=X14 Y0 R-5
G54 X14 Y0
K1 W0.2 L1 C2 L-2 C-1
FOR 5
N1=N1-60
AN1, L1 C2 L2 C-1
NEXT
A-0, L1 C2
)")
          .messages(),
      R"(t.bgt:6:9: note: the offset lies inside the closed contour, on the side of L1 where the tool stands before it [DGT0514]
K1 W0.2 L1 C2 L-2 C-1
        ^~
t.bgt:6:15: error: on its way along L-2 the tool cuts 0.2 mm deep into C-1, at X6.76461381 Y-1.8 [DGT0508]
K1 W0.2 L1 C2 L-2 C-1
              ^~~
t.bgt:9:15: note: C-1 stands here [DGT0421]
AN1, L1 C2 L2 C-1
              ^~~
t.bgt:9:12: note: with L-2 here the tool cuts into nothing [DGT0517]
AN1, L1 C2 L2 C-1
           ^~
)");
}

const char* const kSquare = R"(L1=X0
L2=Y0
L3=X10
L4=Y10
)";

TEST(DgtMessagesOfOffsets, ALeadThroughThePartCutsIntoIt) {
  EXPECT_EQ(
      CompiledProgram(std::string(kSquare) + R"(P1=X15 Y5
G54 P1
K1 W0.1 L1 L2 L-3 L-4 L1 L2
)")
          .messages(),
      R"(t.bgt:7:9: note: the offset lies inside the closed contour, on the side of L1 where the tool stands before it [DGT0514]
K1 W0.1 L1 L2 L-3 L-4 L1 L2
        ^~
t.bgt:7:12: warning: on its way to L2 the tool cuts 0.1 mm deep into K1, at X10 Y3.356 [DGT0530]
K1 W0.1 L1 L2 L-3 L-4 L1 L2
           ^~
t.bgt:7:15: note: there the contour runs along L-3 [DGT0533]
K1 W0.1 L1 L2 L-3 L-4 L1 L2
              ^~~
)");
}

TEST(DgtMessagesOfOffsets, ALeadOutThroughThePartCutsIntoIt) {
  EXPECT_EQ(
      CompiledProgram(std::string(kSquare) + R"(P1=X-5 Y-5
P2=X5 Y15
G54 P1
K1 W0.1 L1 L2 L-3 L-4 L1 L2 P2
)")
          .faults(),
      R"(t.bgt:8:29: warning: on its way to P2 the tool cuts 0.1 mm deep into K1, at X5 Y0 [DGT0530]
K1 W0.1 L1 L2 L-3 L-4 L1 L2 P2
                            ^~
t.bgt:8:12: note: there the contour runs along L2 [DGT0533]
K1 W0.1 L1 L2 L-3 L-4 L1 L2 P2
           ^~
)");
}

TEST(DgtMessagesOfOffsets, WithoutAnOffsetLeadsCutAcross) {
  EXPECT_EQ(CompiledProgram(std::string(kSquare) + R"(P1=X15 Y5
P2=X5 Y15
G54 P1
K1 L1 L2 L-3 L-4 L1 L2 P2
)")
                .faults(),
            R"(t.bgt:8:7: warning: on its way to L2 the tool cuts across K1 at X10 Y3.333 [DGT0531]
K1 L1 L2 L-3 L-4 L1 L2 P2
      ^~
t.bgt:8:10: note: there the contour runs along L-3 [DGT0533]
K1 L1 L2 L-3 L-4 L1 L2 P2
         ^~~
t.bgt:8:24: warning: on its way to P2 the tool cuts across K1 at X5 Y10 [DGT0531]
K1 L1 L2 L-3 L-4 L1 L2 P2
                       ^~
t.bgt:8:14: note: there the contour runs along L-4 [DGT0533]
K1 L1 L2 L-3 L-4 L1 L2 P2
             ^~~
)");
}

TEST(DgtMessagesOfOffsets, ARapidOverAPartIsAWarningThatASettingTakesAway) {
  const std::string program = std::string(kSquare) + R"(P1=X-5 Y-5
P2=X15 Y5
G54 P1
K1 W0.1 L1 L2 L-3 L-4 L1 L2
G0 P2
)";
  EXPECT_EQ(
      CompiledProgram(program).faults(),
      R"(t.bgt:9:1: warning: the rapid goes across K1 at X0.196 Y0; the setting crossings = leads allows that [DGT0532]
G0 P2
^~
t.bgt:8:12: note: there the contour runs along L2 [DGT0533]
K1 W0.1 L1 L2 L-3 L-4 L1 L2
           ^~
)");
  EvaluateOptions leads;
  leads.crossings = CrossingMoves::Leads;
  EXPECT_EQ(CompiledProgram(program, {}, leads).faults(), "");
}

TEST(DgtMessagesOfOffsets, ACheckOfAVeryLongProgramSaysWhatItDoesNotLookFor) {
  EvaluateOptions check;
  check.purpose = Purpose::Check;
  EXPECT_EQ(
      CompiledProgram(R"(P1=X-5 Y-5
P2=X15 Y5
FOR 5001
G0 P1
G0 P2
NEXT
)",
                      {}, check)
          .messages(),
      R"(t.bgt:1:1: note: the program makes more than 10000 moves; whether approaches and rapids go over a part is looked at when it is compiled [DGT0534]
P1=X-5 Y-5
^
)");
}

TEST(DgtMessagesOfOffsets, ACheckSeesTheCrossingsThatACompilationSees) {
  EvaluateOptions check;
  check.purpose = Purpose::Check;
  const std::string program =
      std::string(kSquare) + "P1=X15 Y5\nG54 P1\nK1 L1 L2 L-3 L-4 L1 L2 P1\n";
  const CompiledProgram checked(program, {}, check);
  EXPECT_EQ(checked.messages(), CompiledProgram(program).messages());
  ASSERT_TRUE(checked.result().path);
  EXPECT_TRUE(checked.result().path->moves.empty());
}

}  // namespace
}  // namespace dgt
