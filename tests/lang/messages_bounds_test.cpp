// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a person sees when a program is executed and something is wrong with it: the whole text, for
// every message of the evaluator. Here: the bounds of what a program may ask for.
#include <gtest/gtest.h>

#include "tests/lang/program.h"

namespace dgt {
namespace {

TEST(DgtMessagesOfBounds, ATextThatHoldsItselfIsStopped) {
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

TEST(DgtMessagesOfBounds, TextsThatGrowWithoutMeasureAreStopped) {
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

TEST(DgtMessagesOfBounds, NumbersThatGrowWithoutMeasureAreStopped) {
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

TEST(DgtMessagesOfBounds, LoopsInLoopsAreBounded) {
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

TEST(DgtMessagesOfBounds, ExecutedLinesAreBounded) {
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

TEST(DgtMessagesOfBounds, MovesAreBounded) {
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

TEST(DgtMessagesOfBounds, ItemsAreBoundedAsTheyCome) {
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

}  // namespace
}  // namespace dgt
