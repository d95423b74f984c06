// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a person sees when a program is executed and something is wrong with it: the whole text, for
// every message of the evaluator. Here: lines, variables, loops, texts and directives.
#include <gtest/gtest.h>

#include "tests/lang/program.h"

namespace dgt {
namespace {

TEST(DgtMessagesOfLines, ALineWithoutItsCommaIsToldAndReadOn) {
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

TEST(DgtMessagesOfLines, ItemsNeedAContour) {
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

TEST(DgtMessagesOfLines, DivisionByZeroIsAnErrorAndItsResultIsNotMissed) {
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

TEST(DgtMessagesOfLines, LoopsRunAWholeNumberOfTimes) {
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

TEST(DgtMessagesOfLines, TextsAreNumberedToThirty) {
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

TEST(DgtMessagesOfLines, ATextMustHoldSomething) {
  EXPECT_EQ(CompiledProgram(R"(K2 B5
)")
                .messages(),
            R"(t.bgt:1:4: error: B5 holds no text here [DGT0604]
K2 B5
   ^~
)");
}

TEST(DgtMessagesOfLines, AFaultInATextSaysWhereTheTextIsUsed) {
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

TEST(DgtMessagesOfLines, DirectivesAreChecked) {
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

TEST(DgtMessagesOfLines, ALoopWithoutRoundsIsWarnedOfNamesThatNoRoundFinds) {
  EXPECT_EQ(
      CompiledProgram(R"(L1=X0
FOR N1
L2=L1 D5
L3=L7 D5
K1 L1 C-12 L2 LN2 P1 O0,
NEXT
L7=Y5
)")
          .messages(),
      R"(t.bgt:4:4: warning: L7 is not defined here; nothing fails only because the loop runs 0 times [DGT0326]
L3=L7 D5
   ^~
t.bgt:7:1: note: L7 is defined only here, after its use [DGT0325]
L7=Y5
^~
t.bgt:5:7: warning: C12 is not defined here; nothing fails only because the loop runs 0 times [DGT0326]
K1 L1 C-12 L2 LN2 P1 O0,
      ^~~~
t.bgt:5:19: warning: P1 is not defined here; nothing fails only because the loop runs 0 times [DGT0326]
K1 L1 C-12 L2 LN2 P1 O0,
                  ^~
)");
}

TEST(DgtMessagesOfLines, ALoopWithoutRoundsIsNotAskedForWhatItsLinesOrAnotherRoundMayDefine) {
  const MemoryLoader::Files files{{"M.mac", "FOR 0\nL2=L7 D5\nNEXT"}};
  for (const char* program : {"FOR 0\nLN1=X5\nL2=L7 D5\nNEXT", "FOR 0\nMAC M\nL2=L7 D5\nNEXT",
                              "MAC M", "B1=\"L7=X5,\"\nFOR 0\nB1\nL2=L7 D5\nNEXT",
                              "FOR 2\nFOR N1\nL2=L7 D5\nNEXT\nL7=X5\nN1=1\nNEXT"}) {
    EXPECT_EQ(CompiledProgram(program, files).messages(), "") << program;
  }
}

}  // namespace
}  // namespace dgt
