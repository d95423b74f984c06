// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a person sees when a program is executed and something is wrong with it: the whole text, for
// every message of the evaluator. Here: macros and definition files.
#include <gtest/gtest.h>

#include "tests/lang/program.h"

namespace dgt {
namespace {

TEST(DgtMessagesOfFiles, FilesThatAreNotThereAreToldAndTheirNamesAreNotMissed) {
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

TEST(DgtMessagesOfFiles, AnUnsavedProgramHasNoDefinitionFiles) {
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

TEST(DgtMessagesOfFiles, ADefinitionFileHoldsDefinitionsOnly) {
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

TEST(DgtMessagesOfFiles, AMacroThatCallsItselfIsStopped) {
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

TEST(DgtMessagesOfFiles, AMacroThatChangesTheProgramsNamesIsWarnedOf) {
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

TEST(DgtMessagesOfFiles, AFaultInAMacroIsToldOnce) {
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

}  // namespace
}  // namespace dgt
