// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/parser.h"

#include <gtest/gtest.h>

#include "lang/dgt/dump.h"
#include "lang/text/render.h"

namespace dgt::language {
namespace {

std::string syntax(std::string_view text) {
  const SourceFile file("t.bgt", text);
  DiagnosticBag bag;
  (void)parse(file, bag);
  EXPECT_EQ(render(bag), "");
  return print_syntax(file);
}

std::string faults(std::string_view text) {
  const SourceFile file("t.bgt", text);
  DiagnosticBag bag;
  const Program program = parse(file, bag);
  return render(bag);
}

TEST(Parser, ReadsDefinitions) {
  EXPECT_EQ(syntax("L 1=Y-2"), "1: definition L1 = Y-2 (L=Y)\n");
  EXPECT_EQ(syntax("C2=X14 Y0 R-5"), "1: definition C2 = X14Y0 R-5 (C=XYR C=PR)\n");
  EXPECT_EQ(syntax("C12=X5,Y7,X6,Y8 X7 Y0"),
            "1: definition C12 = X5Y7 X6Y8 X7Y0 (C=XYXYXY C=PPP)\n");
  EXPECT_EQ(syntax("C2 = I2 L1 R10 C1"), "1: definition C2 = I2 L1 R10 C1 (C=LRC C=ILRC)\n");
  EXPECT_EQ(syntax("P1 = L1 X> C1"), "1: definition P1 = I3 L1 C1 (P=LC P=ILC)\n");
  EXPECT_EQ(syntax("C1 = P1 M10 A 30 R5"), "1: definition C1 = P1 M10 A30 R5 (C=PMAR)\n");
  EXPECT_EQ(syntax("O1=X43 Y65 A20"), "1: definition O1 = X43Y65 A20 (O=XYA O=PA)\n");
  EXPECT_EQ(syntax("LN1=X-N2"), "1: definition LN1 = X-N2 (L=X)\n");
  EXPECT_EQ(syntax("P1=Y5 X7"), "1: definition P1 = X7Y5 (P=XY)\n");
}

TEST(Parser, ReadsContours) {
  EXPECT_EQ(syntax("K1 W 0.2 L1 C2 L-2 C-1\nA-60, L1 C2 L-2 C-1.\nG0 X14 Y0"),
            "1: contour K1 W0.2 L1 C2 L-2 C-1\n2: items A-60 L1 C2 L-2 C-1\n"
            "3: words G0 X14Y0\n");
  EXPECT_EQ(syntax("K1= W 3 P 11G 0 L11V 6 L12"), "1: contour K1 W3 P11 G0 L11 V6 L12\n");
  EXPECT_EQ(syntax("K4"), "1: contour K4\n");
  EXPECT_EQ(syntax("K1 L1 X10 X20 Y5 C1 V C2"), "1: contour K1 L1 X10 X20Y5 C1 V C2\n");
}

TEST(Parser, ReadsVariablesAndTexts) {
  EXPECT_EQ(syntax("N5=N1*N2+N2-N3/-4"), "1: number N5 = 0 + N1 * N2 + N2 - N3 / -4\n");
  EXPECT_EQ(syntax("B1=\"C2 P4 L5,\"\nK3 W3 B1,"),
            "1: text B1 = \"C2 P4 L5 ,\"\n2: spliced K3 W3 B1 ,\n");
}

TEST(Parser, ReadsLoopsMacrosFilesAndDirectives) {
  EXPECT_EQ(syntax("FOR 5\nFOR N1\nN1=N1-60\nNEXT\nNEXT\nMAC KVAD 10,-N2,\nOPR det1opr\n"
                   "K1 ' c\n'@ offset-side  right  "),
            "1: for 5\n  2: for N1\n    3: number N1 = 0 + N1 - 60\n  4: next\n5: next\n"
            "6: macro KVAD 10 -N2\n7: definitions det1opr\n8: contour K1\n"
            "9: directive offset-side right\n");
}

TEST(Parser, ADirectiveBehindALineHoldsForIt) {
  EXPECT_EQ(syntax("K1 '@ offset-side left"), "1: directive offset-side left\n1: contour K1\n");
}

TEST(ParserFaults, MissingNumber) {
  EXPECT_EQ(faults("K1 L C2 R - C-"),
            "t.bgt:1:4: error: 'L' needs a number [DGT0202]\nK1 L C2 R - C-\n   ^\n"
            "t.bgt:1:9: error: 'R' needs a number [DGT0202]\nK1 L C2 R - C-\n        ^\n"
            "t.bgt:1:13: error: 'C' needs a number [DGT0202]\nK1 L C2 R - C-\n            ^\n");
}

TEST(ParserFaults, StrayNumberAndDecimalComma) {
  EXPECT_EQ(faults("L1=X0,5"),
            "t.bgt:1:4: error: a comma separates items, it is no decimal point; 0.5 is meant? "
            "[DGT0204]\nL1=X0,5\n   ^~~~\n     .\n");
  EXPECT_EQ(faults("L1=X1 000"),
            "t.bgt:1:7: error: no letter stands before 000 [DGT0203]\n"
            "L1=X1 000\n      ^~~\n");
}

TEST(ParserFaults, NumbersOfElements) {
  EXPECT_EQ(faults("K1 L1.5 C10000 P-1 O-2"),
            "t.bgt:1:4: error: the number of 'L' must be whole and between 0 and 9999; 1.5 is not "
            "[DGT0205]\nK1 L1.5 C10000 P-1 O-2\n   ^~~~\n"
            "t.bgt:1:9: error: the number of 'C' must be whole and between 0 and 9999; 10000 is "
            "not [DGT0205]\nK1 L1.5 C10000 P-1 O-2\n        ^~~~~~\n"
            "t.bgt:1:16: error: the minus reverses lines and circles; 'P' has no direction "
            "[DGT0206]\nK1 L1.5 C10000 P-1 O-2\n               ^~~\n               P1\n"
            "t.bgt:1:20: error: the minus reverses lines and circles; 'O' has no direction "
            "[DGT0206]\nK1 L1.5 C10000 P-1 O-2\n                   ^~~\n                   O2\n");
  EXPECT_EQ(faults("L-1=X5"),
            "t.bgt:1:1: error: an element is defined without a minus; reverse 'L' where it is used "
            "[DGT0301]\nL-1=X5\n^~~\n");
}

TEST(ParserFaults, Operands) {
  EXPECT_EQ(faults("L2=L1"),
            "t.bgt:1:6: error: the definition lacks P (L=XYL L=PL); D (L=LD) [DGT0303]\n"
            "L2=L1\n     ^\n");
  EXPECT_EQ(faults("P1=X5"),
            "t.bgt:1:6: error: the definition lacks Y (P=XY) [DGT0303]\nP1=X5\n     ^\n");
  EXPECT_EQ(faults("C1=P1 R5 D2"),
            "t.bgt:1:10: error: D2 is surplus for C=XYR C=PR [DGT0304]\n"
            "C1=P1 R5 D2\n         ^~\n");
  EXPECT_EQ(faults("O1=C1 R5"),
            "t.bgt:1:4: error: 'O' cannot be defined by these; its forms are O=XYA O=PA "
            "[DGT0305]\nO1=C1 R5\n   ^~~~~\n");
  EXPECT_EQ(faults("L1="), "t.bgt:1:4: error: nothing defines L1 [DGT0302]\nL1=\n   ^\n");
}

TEST(ParserFaults, Selectors) {
  EXPECT_EQ(faults("L1=I2 P1 P2"),
            "t.bgt:1:4: error: L=XYXY L=PP has one solution; the selector selects nothing "
            "[DGT0306]\nL1=I2 P1 P2\n   ^~\n");
  EXPECT_EQ(faults("P1=I2 C1 X> C2"),
            "t.bgt:1:10: error: a definition takes one selector only [DGT0307]\n"
            "P1=I2 C1 X> C2\n         ^~\n");
}

TEST(ParserFaults, Assignments) {
  EXPECT_EQ(faults("N1=5 6"),
            "t.bgt:1:6: error: '6' is too much on this line [DGT0207]\nN1=5 6\n     ^\n");
  EXPECT_EQ(faults("N1=5*"),
            "t.bgt:1:6: error: a number or a variable N1 to N30 must stand here [DGT0210]\n"
            "N1=5*\n     ^\n");
  EXPECT_EQ(faults("N31=5"),
            "t.bgt:1:1: error: there is no variable 'N31'; they are N1 to N30 [DGT0106]\n"
            "N31=5\n^~~\n");
  EXPECT_EQ(faults("B1=C2"),
            "t.bgt:1:4: error: a text in quotes must stand here [DGT0211]\nB1=C2\n   ^~\n");
  EXPECT_EQ(faults("B1=\"C2\""),
            "t.bgt:1:7: error: a comma must stand before the closing quote [DGT0212]\n"
            "B1=\"C2\"\n      ^\n      ,\n");
}

TEST(ParserFaults, Macros) {
  EXPECT_EQ(faults("MAC"), "t.bgt:1:4: error: MAC needs the name of a file [DGT0213]\nMAC\n   ^\n");
  EXPECT_EQ(faults("MAC KVAD 10,20"),
            "t.bgt:1:13: error: a comma must stand behind every argument, the last one too "
            "[DGT0214]\nMAC KVAD 10,20\n            ^~\n              ,\n");
  EXPECT_EQ(faults("MAC KVAD 10 20,"),
            "t.bgt:1:10: error: a comma must stand behind every argument, the last one too "
            "[DGT0214]\nMAC KVAD 10 20,\n         ^~\n           ,\n");
  EXPECT_EQ(faults("MAC M 1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,"
                   "28,29,30,31,"),
            "t.bgt:1:88: error: a macro takes at most 30 arguments [DGT0215]\n"
            "MAC M 1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25,26,27,28,29,"
            "30,31,\n" +
                std::string(87, ' ') + "^~\n");
  EXPECT_EQ(faults("OPR"), "t.bgt:1:4: error: OPR needs the name of a file [DGT0213]\nOPR\n   ^\n");
}

TEST(ParserFaults, Loops) {
  EXPECT_EQ(faults("FOR 2\nFOR 3\nNEXT"),
            "t.bgt:1:1: error: this FOR has no NEXT [DGT0216]\nFOR 2\n^~~~~\n");
  EXPECT_EQ(faults("NEXT"), "t.bgt:1:1: error: this NEXT has no FOR [DGT0217]\nNEXT\n^~~~\n");
  EXPECT_EQ(faults("FOR 2 L1\nNEXT 5"),
            "t.bgt:1:7: error: 'L1' is too much on this line [DGT0207]\nFOR 2 L1\n      ^~\n"
            "t.bgt:2:6: error: '5' is too much on this line [DGT0207]\nNEXT 5\n     ^\n");
}

TEST(ParserFaults, WordsOutOfPlace) {
  EXPECT_EQ(faults("K1 L1 = N2"),
            "t.bgt:1:7: error: '=' cannot stand here [DGT0201]\nK1 L1 = N2\n      ^\n"
            "t.bgt:1:9: error: 'N2' cannot stand here [DGT0201]\nK1 L1 = N2\n        ^~\n");
}

TEST(ParserFaults, EachOfSeveralStatementsInALineIsParsed) {
  const SourceFile file("t.bgt", "L1=Y0 L2=X4, FOR 2 N1=N1+1, NEXT K1 L1 L2");
  DiagnosticBag bag;
  (void)parse(file, bag);
  std::string found;
  for (const Diagnostic& d : bag.all()) found += d.arguments.at(0) + " ";
  EXPECT_EQ(found, "L2 FOR N1 NEXT K1 ");
  EXPECT_EQ(print_syntax(file),
            "1: definition L1 = Y0 (L=Y)\n1: definition L2 = X4 (L=X)\n1: for 2\n"
            "  1: number N1 = 0 + N1 + 1\n1: next\n1: contour K1 L1 L2\n");
}

}  // namespace
}  // namespace dgt::language
