// SPDX-License-Identifier: GPL-3.0-or-later
//
// What correct programs come to. The elements behind them are the kernel's business; these tests
// hold the order of things, the names and the places.
#include <gtest/gtest.h>

#include "tests/lang/program.h"

namespace dgt {
namespace {

std::string path(std::string_view text, MemoryLoader::Files files = {}) {
  return CompiledProgram(text, std::move(files)).path();
}

std::string elements(std::string_view text, MemoryLoader::Files files = {}) {
  const CompiledProgram program(text, std::move(files));
  EXPECT_EQ(program.faults(), "");
  return language::print_elements(program.result().elements);
}

TEST(Evaluator, AnEmptyProgramHasAnEmptyPath) {
  EXPECT_EQ(path(""), "start X0.000000 Y0.000000\n");
}

TEST(Evaluator, DefinesElementsOfEveryKind) {
  EXPECT_EQ(elements("L1=X10\nL2=Y-0.5\nC1=X1 Y2 R-3\nP1=L1 L2\nO1=P1 A30"),
            "L1: direction (0, -1) left normal distance 10\n"
            "L2: direction (1, 0) left normal distance -0.5\n"
            "C1: centre (1, 2) radius -3\n"
            "P1: (10, -0.5)\n"
            "O1: origin (10, -0.5) angle 30\n");
}

TEST(Evaluator, AMinusReversesInADefinition) {
  EXPECT_EQ(elements("L1=Y2\nL2=L-1 D10\nL3=L1 D10"),
            "L1: direction (1, 0) left normal distance 2\n"
            "L2: direction (-1, 0) left normal distance 8\n"
            "L3: direction (1, 0) left normal distance 12\n");
}

TEST(Evaluator, UnlikeOperandsMayStandInAnyOrder) {
  const std::string_view base = "C1=X0 Y0 R10\nL1=Y0\n";
  const std::string one = elements(std::string(base) + "C2=L1 R2 C1\nP1=L1 C1");
  EXPECT_EQ(elements(std::string(base) + "C2=C1 L1 R2\nP1=C1 L1"), one);
  EXPECT_EQ(elements(std::string(base) + "C2=R2 C1 L1\nP1=I1 C1 L1"), one);
  EXPECT_NE(elements(std::string(base) + "C2=I2 C1 L1 R2\nP1=L1 C1"), one);
}

TEST(Evaluator, ARedefinitionIsSeenByLaterUsesOnly) {
  EXPECT_EQ(elements("L1=Y2\nL2=L1 D1\nL1=Y5\nL3=L1 D1"),
            "L1: direction (1, 0) left normal distance 5\n"
            "L2: direction (1, 0) left normal distance 3\n"
            "L3: direction (1, 0) left normal distance 6\n");
}

TEST(Evaluator, AVariableMayNameAnElementAndItsSignReversesIt) {
  EXPECT_EQ(elements("N1=7\nN2=-7\nLN1=Y2\nL2=LN2 D1\nL3=L-N2 D1"),
            "L2: direction (-1, 0) left normal distance -1\n"
            "L3: direction (1, 0) left normal distance 3\n"
            "L7: direction (1, 0) left normal distance 2\n");
}

TEST(Evaluator, ArithmeticRunsFromLeftToRightExactly) {
  EXPECT_EQ(elements("N1=4\nN2=5\nN3=7\nN4=76\nN5=N1*N2+N2-N3/N4*76\nL1=XN5"),
            "L1: direction (0, -1) left normal distance 18\n");
  EXPECT_EQ(elements("N1=0.1+0.2-0.3\nN2=4*-2\nP1=XN1 YN2"), "P1: (0, -8)\n");
  EXPECT_EQ(elements("P1=XN9 Y-N9"), "P1: (0, 0)\n") << "0 until assigned";
}

TEST(Evaluator, LoopsRunTheirBodyAndNest) {
  EXPECT_EQ(elements("FOR 3\nN1=N1+1\nFOR 2\nN2=N2+N1\nNEXT\nNEXT\nFOR 0\nN1=100\nNEXT\n"
                     "P1=XN1 YN2"),
            "P1: (3, 12)\n");
  EXPECT_EQ(elements("N3=2\nFOR N3\nN1=N1+1\nLN1=YN1\nNEXT"),
            "L1: direction (1, 0) left normal distance 1\n"
            "L2: direction (1, 0) left normal distance 2\n");
}

TEST(Evaluator, MovesKnowTheirPlaces) {
  EXPECT_EQ(path("G54 X1 Y2\nL1=Y2\nL2=X5\nK7 X1 Y2 L1\nX9 Y9,\nG0 X0 Y0"),
            "start X1.000000 Y2.000000\n"
            "contour 7 offset 0 side none open\n"
            "1 line X9.000000 Y2.000000 contour  ; t.bgt:4:10\n"
            "2 line X9.000000 Y9.000000 lead-out  ; t.bgt:5:1\n"
            "3 rapid X0.000000 Y0.000000 position  ; t.bgt:6:1\n");
}

TEST(Evaluator, AContourGoesOnOverAssignmentsLoopsAndComments) {
  const std::string straight = path("K1 P1\nP1=X1 Y1\nK1 X1 Y1, X2 Y1\nX3 Y1,\nX4 Y1,");
  EXPECT_NE(straight.find("P1 is not defined"), std::string::npos);
  EXPECT_EQ(path("K1 X1 Y1\n\n' c\nN1=2\nB1=\"X9 Y9,\"\nFOR 2\nXN1 Y1,\nN1=N1+1\nNEXT\nB1"),
            "start X0.000000 Y0.000000\n"
            "contour 1 offset 0 side none open\n"
            "1 line X1.000000 Y1.000000 position  ; t.bgt:1:4\n"
            "2 line X2.000000 Y1.000000 contour  ; t.bgt:7:1\n"
            "3 line X3.000000 Y1.000000 contour  ; t.bgt:7:1\n"
            "4 line X9.000000 Y9.000000 contour  ; t.bgt:5:5\n");
}

TEST(Evaluator, AContourEndsAtADefinitionEvenWithCommas) {
  const CompiledProgram program("K1 X1 Y1\nC1=X0,Y0,R5\nX2 Y2,");
  EXPECT_EQ(program.faults(),
            "t.bgt:3:1: error: 'X2 Y2' belongs in a contour, and no contour is open here "
            "[DGT0209]\nX2 Y2,\n^~~~~\n"
            "t.bgt:2:1: note: the contour before ended here [DGT0419]\nC1=X0,Y0,R5\n"
            "^~~~~~~~~~~\n");
}

TEST(Evaluator, AContourEndsWithItsMacro) {
  const CompiledProgram program("MAC M\nX2 Y2,", {{"M.mac", "K1 X1 Y1"}});
  EXPECT_NE(program.faults().find("t.bgt:2:1: error: 'X2 Y2' belongs in a contour"),
            std::string::npos);
}

TEST(Evaluator, AnEmptyContourIsLegalAndMakesNothing) {
  EXPECT_EQ(path("K4"), "start X0.000000 Y0.000000\n");
}

TEST(Evaluator, WordLinesActAtOnce) {
  EXPECT_EQ(path("M7\nF100\nS5\nT1.5\nG54 X5 Y5\nG54 X1 Y1\nG0 X2 Y1 M8\nG54 X9 Y9\nG0 X9 Y9"),
            "start X1.000000 Y1.000000\n"
            "1 code M7  ; t.bgt:1:1\n"
            "2 code S5  ; t.bgt:3:1\n"
            "3 dwell 1.5 s  ; t.bgt:4:1\n"
            "4 rapid X2.000000 Y1.000000 position  ; t.bgt:7:1\n"
            "5 code M8  ; t.bgt:7:10\n"
            "6 rapid X9.000000 Y9.000000 thread  ; t.bgt:8:1\n");
}

TEST(Evaluator, ACommaInAWordLineOutsideAContourIsASeparator) {
  EXPECT_EQ(path("G54 X1, Y2"), "start X1.000000 Y2.000000\n");
}

TEST(Evaluator, FramesMoveWhatIsGivenInCoordinates) {
  EXPECT_EQ(path("P1=X1 Y0\nO1=X10 Y0 A90\nK1 P1 A90 P1 O1 P1 A90 P1 A-0 P1 O0 X5 Y5"),
            "start X0.000000 Y0.000000\n"
            "contour 1 offset 0 side none open\n"
            "1 line X1.000000 Y0.000000 position  ; t.bgt:3:4\n"
            "2 line X0.000000 Y1.000000 contour  ; t.bgt:3:11\n"
            "3 line X10.000000 Y1.000000 contour  ; t.bgt:3:17\n"
            "4 line X9.000000 Y0.000000 contour  ; t.bgt:3:24\n"
            "5 line X10.000000 Y1.000000 contour  ; t.bgt:3:31\n"
            "6 line X5.000000 Y5.000000 contour  ; t.bgt:3:37\n");
}

TEST(Evaluator, FramesHoldToTheEndOfTheirContour) {
  EXPECT_EQ(path("K1 A90 X1 Y0\nK2 X1 Y0"),
            "start X0.000000 Y0.000000\n"
            "contour 1 offset 0 side none open\n"
            "1 line X0.000000 Y1.000000 position  ; t.bgt:1:8\n"
            "contour 2 offset 0 side none open\n"
            "2 line X1.000000 Y0.000000 position  ; t.bgt:2:4\n");
}

TEST(Evaluator, TextsAreExpandedInPlaceAlsoInTexts) {
  EXPECT_EQ(elements("B1=\"X1 Y2,\"\nN4=2\nB2=\"BN5 R3,\"\nN5=1\nC1=BN4"),
            "C1: centre (1, 2) radius 3\n");
}

TEST(Evaluator, TextsHoldWhatTheyHoldWhenTheLineIsReached) {
  EXPECT_EQ(path("B1=\"X1 Y0,\"\nFOR 2\nK1 B1\nB1=\"X2 Y0,\"\nNEXT"),
            "start X0.000000 Y0.000000\n"
            "contour 1 offset 0 side none open\n"
            "1 line X1.000000 Y0.000000 position  ; t.bgt:1:5\n"
            "contour 1 offset 0 side none open\n"
            "2 line X2.000000 Y0.000000 position  ; t.bgt:4:5\n");
}

TEST(Evaluator, MacrosRunWithTheirArguments) {
  EXPECT_EQ(path("N9=4\nMAC Sq 1,-2.5,N9,\nG0 X0 Y0", {{"Sq.mac", "K1 XN1 YN2, XN3 Y-N3"}}),
            "start X0.000000 Y0.000000\n"
            "contour 1 offset 0 side none open\n"
            "1 line X1.000000 Y-2.500000 position  ; Sq.mac:1:4\n"
            "2 line X4.000000 Y-4.000000 contour  ; Sq.mac:1:13\n"
            "3 rapid X0.000000 Y0.000000 position  ; t.bgt:3:1\n");
}

TEST(Evaluator, AMacroIsReadOnceHoweverOftenItIsCalled) {
  const CompiledProgram program("FOR 5\nMAC M 1,\nNEXT\nMAC m 2,", {{"M.mac", "P1=XN1 Y0"}});
  EXPECT_EQ(program.messages(), "");
  EXPECT_EQ(program.loader().loads, 1);
}

TEST(Evaluator, AMacroMayEndItsRecursionWithALoopOfNoRounds) {
  EXPECT_EQ(path("MAC M 3,", {{"M.mac",
                               "G0 XN1 Y0\nN1=N1-1\nFOR N1\nN2=N1\nMAC M N1,\nN1=1\n"
                               "NEXT"}})
                .substr(0, 26),
            "start X0.000000 Y0.000000\n");
}

TEST(Evaluator, DefinitionFilesDefine) {
  EXPECT_EQ(elements("OPR det\nP1=L1 L2", {{"det.bgt", "' notes\nL1=X1\nL2=Y2"}}),
            "L1: direction (0, -1) left normal distance 1\n"
            "L2: direction (1, 0) left normal distance 2\n"
            "P1: (1, 2)\n");
}

TEST(Evaluator, TheSideIsADirectiveOrAnOption) {
  const std::string_view contour = "L1=Y0\nL2=X5\nL3=Y-5\nG54 X0 Y1\nK1 W1 L1 L2 L3\n";
  EXPECT_NE(path(contour).find("side left"), std::string::npos);
  EXPECT_NE(path("'@ offset-side right\n" + std::string(contour)).find("side right"),
            std::string::npos);
  EvaluateOptions options;
  options.offset_side = OffsetSide::Right;
  const CompiledProgram by_option(contour, {}, options);
  EXPECT_NE(by_option.path().find("side right"), std::string::npos);
}

TEST(Evaluator, ADirectiveInAMacroHoldsForTheMacro) {
  const CompiledProgram program("MAC M\nL1=Y0\nL2=X5\nL3=Y-5\nG54 X0 Y1\nK1 W1 L1 L2 L3",
                                {{"M.mac", "'@ offset-side right\nK2 X0 Y1"}});
  EXPECT_NE(program.path().find("side left"), std::string::npos);
}

TEST(Evaluator, NoPathComesFromAProgramWithAnError) {
  EXPECT_FALSE(CompiledProgram("G0 X5 Y5\nL1=L7 D5").result().path.has_value());
}

TEST(Evaluator, ABrokenLineKeepsItsContourOpen) {
  EXPECT_EQ(CompiledProgram("L1=Y0\nL2=X5\nK1 L1 L2\nL\nL1 L2,").messages(),
            "t.bgt:4:1: error: 'L' needs a number [DGT0202]\nL\n^\n");
}

}  // namespace
}  // namespace dgt
