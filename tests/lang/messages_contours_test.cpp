// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a person sees when a program is executed and something is wrong with it: the whole text, for
// every message of the evaluator. Here: contours as programmed.
#include <gtest/gtest.h>

#include "tests/lang/program.h"

namespace dgt {
namespace {

TEST(DgtMessagesOfContours, WordsAreChecked) {
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

TEST(DgtMessagesOfContours, ASelectorWithNothingToSelectIsAnError) {
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
K2 L1 I2
)")
                .messages(),
            R"(t.bgt:2:7: error: nothing follows that this selector could select on [DGT0405]
K2 L1 I2
      ^~
)");
}

TEST(DgtMessagesOfContours, AFilletNeedsAnElementBeforeIt) {
  EXPECT_EQ(CompiledProgram(R"(K1 X1 Y1 R5
)")
                .messages(),
            R"(t.bgt:1:10: error: R5 needs an element before it and one behind it [DGT0406]
K1 X1 Y1 R5
         ^~
)");
}

TEST(DgtMessagesOfContours, AChamferStandsBetweenLines) {
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
C1=X0 Y0 R5
K3 C1 V5 L1
)")
                .messages(),
            R"(t.bgt:3:4: error: a chamfer joins two lines; C1 and L1 are not [DGT0407]
K3 C1 V5 L1
   ^~    ~~
)");
}

TEST(DgtMessagesOfContours, ATangentJoinsCircles) {
  EXPECT_EQ(
      CompiledProgram(R"(L1=Y0
L2=X5
K4 L1 V L2
)")
          .messages(),
      R"(t.bgt:3:4: error: V without a number is the tangent of two circles; L1 and L2 are not [DGT0408]
K4 L1 V L2
   ^~   ~~
)");
}

TEST(DgtMessagesOfContours, DGoesAlongALine) {
  EXPECT_EQ(CompiledProgram(R"(C1=X0 Y0 R5
K5 X9 Y0 C1 D5
)")
                .messages(),
            R"(t.bgt:2:10: error: D goes along a line; C1 is a circle [DGT0409]
K5 X9 Y0 C1 D5
         ^~
)");
}

TEST(DgtMessagesOfContours, DStartsOnItsLine) {
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

TEST(DgtMessagesOfContours, TheCentreHasNoNormal) {
  EXPECT_EQ(CompiledProgram(R"(C1=X0 Y0 R5
K6 X0 Y0 C1
)")
                .messages(),
            R"(t.bgt:2:10: error: the centre of C1 has no normal on it [DGT0410]
K6 X0 Y0 C1
         ^~
)");
}

TEST(DgtMessagesOfContours, AFilletOfNoRadiusIsAnError) {
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

TEST(DgtMessagesOfContours, AnElementDoesNotMeetItself) {
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
K10 L1 L1
)")
                .messages(),
            R"(t.bgt:2:5: error: L1 and L1 are the same; they meet everywhere [DGT0321]
K10 L1 L1
    ^~ ~~
)");
}

TEST(DgtMessagesOfContours, ATangentPointIsNoArc) {
  EXPECT_EQ(CompiledProgram(R"(C1=X0 Y0 R5
L1=Y5.0005
L2=X20
G54 X-20 Y6
K1 L1 C-1 L1 L2
)")
                .messages(),
            R"(t.bgt:5:4: warning: L1 and C-1 miss each other by 0.0005 mm and were joined [DGT0506]
K1 L1 C-1 L1 L2
   ^~ ~~~
t.bgt:5:7: error: the arc along C-1 begins and ends in one point [DGT0415]
K1 L1 C-1 L1 L2
      ^~~
t.bgt:5:7: warning: C-1 and L1 miss each other by 0.0005 mm and were joined [DGT0506]
K1 L1 C-1 L1 L2
      ^~~ ~~
)");
}

TEST(DgtMessagesOfContours, AnArcCannotBeRapid) {
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

TEST(DgtMessagesOfContours, TwoLinesLeaveNoChoice) {
  EXPECT_EQ(CompiledProgram(R"(L1=Y0
L2=X5
K1 L1 I2 L2 L1
)")
                .messages(),
            R"(t.bgt:3:4: error: L1 and L2 leave no choice; the selector selects nothing [DGT0322]
K1 L1 I2 L2 L1
   ^~    ~~
)");
}

}  // namespace
}  // namespace dgt
