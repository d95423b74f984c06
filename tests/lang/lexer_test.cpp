// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/lexer.h"

#include <gtest/gtest.h>

#include "lang/dgt/dump.h"
#include "lang/text/render.h"

namespace dgt::language {
namespace {

// The first line's words, and what was said about them.
struct Lexed {
  explicit Lexed(std::string_view text) : file("t.bgt", text) {
    Lexer lexer(file, bag);
    EXPECT_TRUE(lexer.next_line(line));
  }
  SourceFile file;
  DiagnosticBag bag;
  Lexer::Line line;
};

std::string words(std::string_view text) { return print_words(SourceFile("t.bgt", text)); }

TEST(Lexer, BlanksAreInsignificantOutsideNumbers) {
  EXPECT_EQ(words("L 11=X N1"), "1: L11 = XN1\n");
  EXPECT_EQ(words("L11=XN1"), "1: L11 = XN1\n");
  EXPECT_EQ(words("K1AN1C1L1C4"), "1: K1 AN1 C1 L1 C4\n");
  EXPECT_EQ(words("P 11G 0 L11V 6"), "1: P11 G0 L11 V6\n");
  EXPECT_EQ(words("A - 30 , L - N 3"), "1: A-30 , L-N3\n");
  EXPECT_EQ(words("X 1 2"), "1: X1 2\n") << "a blank ends a number";
}

TEST(Lexer, ReadsEverySpellingOfANumber) {
  EXPECT_EQ(words("X5 X5. X.5 X-0 X+5 X0.10 X-.25"), "1: X5 X5 X0.5 X-0 X5 X0.1 X-0.25\n");
  EXPECT_EQ(words("C-1."), "1: C-1\n");
  EXPECT_EQ(words("X0.1234567890123456789012345678901234567890"),
            "1: X0.123456789012345678901234567890123456789\n")
      << "no digit is lost";
}

TEST(Lexer, CaseIsInsignificant) { EXPECT_EQ(words("for 5"), "1: FOR 5\n"); }

TEST(Lexer, AVariableMayStandForAnyNumber) {
  EXPECT_EQ(words("RN1 X N2 A-N3 X-N1 LN4 L-N30"), "1: RN1 XN2 A-N3 X-N1 LN4 L-N30\n");
}

TEST(Lexer, SelectorsAreWords) { EXPECT_EQ(words("L1 X> C1 y < C2"), "1: L1 X> C1 Y< C2\n"); }

TEST(Lexer, AssignmentsHaveOperators) {
  EXPECT_EQ(words("N5=N1*N2+N2-N3/N4"), "1: N5 = N1 * N2 + N2 - N3 / N4\n");
  EXPECT_EQ(words("N1=4*-2"), "1: N1 = 4 * - 2\n");
  EXPECT_EQ(words("N1=-.5"), "1: N1 = - 0.5\n");
}

TEST(Lexer, KeywordsNeedNoBlankBehind) {
  EXPECT_EQ(words("FOR5"), "1: FOR 5\n");
  EXPECT_EQ(words("FORN1"), "1: FOR N1\n");
  EXPECT_EQ(words("F 100"), "1: F100\n");
  EXPECT_EQ(words("M5 A30"), "1: M5 A30\n") << "no MAC without its C";
}

TEST(Lexer, AFileNameEndsAtABlank) {
  EXPECT_EQ(words("MAC KVAD 10,-20,N3,"), "1: MAC KVAD 10 , - 20 , N3 ,\n");
  EXPECT_EQ(words("MAC Плита-2 1,"), "1: MAC Плита-2 1 ,\n");
  EXPECT_EQ(words("OPR det1opr ' note"), "1: OPR det1opr\n");
}

TEST(Lexer, ACommentRunsToTheEndOfItsLine) {
  EXPECT_EQ(words("K1 L1 ' C5 L5 № 7\nL2"), "1: K1 L1\n2: L2\n");
}

TEST(Lexer, ADirectiveIsKept) {
  EXPECT_EQ(words("'@ offset-side right"), "1: '@ offset-side right\n");
}

TEST(Lexer, TextsAreCutIntoWordsInPlace) {
  EXPECT_EQ(words("B1=\"C2 P4L5,\""), "1: B1 = \" C2 P4 L5 , \"\n");
}

TEST(Lexer, WordsKnowTheirPlaceInCharacters) {
  const Lexed lexed("С2 Р4  L-5");
  ASSERT_EQ(lexed.line.words.size(), 3U);
  EXPECT_EQ(lexed.line.words[1].column, 4U);
  EXPECT_EQ(lexed.line.words[2].column, 8U);
  EXPECT_EQ(lexed.line.words[2].range.text(), "L-5");
  EXPECT_EQ(lexed.line.words[2].number().text(), "5");
}

TEST(Lexer, LookAlikesAreReadWithOneWarningALine) {
  const Lexed lexed("В1=\"С2,\"");
  EXPECT_EQ(words("В1=\"С2,\""), "1: B1 = \" C2 , \"\n");
  EXPECT_EQ(render(lexed.bag),
            "t.bgt:1:1: warning: 'В, С' typed in Cyrillic, read as 'B, C' [DGT0103]\n"
            "В1=\"С2,\"\n^~~~~\nB1=\"C\n");
  EXPECT_FALSE(lexed.line.broken);
}

TEST(Lexer, AKeywordInCyrillicIsWarnedOfOnce) {
  const Lexed lexed("МАС KVAD 1,");
  EXPECT_EQ(render(lexed.bag),
            "t.bgt:1:1: warning: 'МАС' typed in Cyrillic, read as 'MAC' [DGT0103]\n"
            "МАС KVAD 1,\n^~~\nMAC\n");
}

TEST(Lexer, ALookAlikeIsNamedOnceHoweverOftenItComes) {
  EXPECT_EQ(render(Lexed("K1 С1 L1 С2 − С3−1 − 2").bag),
            "t.bgt:1:4: warning: 'С' typed in Cyrillic, read as 'C' [DGT0103]\n"
            "K1 С1 L1 С2 − С3−1 − 2\n"
            "   ^~~~~~~~~~~~\n"
            "   C1 L1 C2 − C\n"
            "t.bgt:1:13: warning: '−' is read as - [DGT0113]\n"
            "K1 С1 L1 С2 − С3−1 − 2\n"
            "            ^~~~~~~~\n"
            "            - С3-1 -\n");
}

TEST(Lexer, SmallLookAlikesAndTypographicMinusAreReadToo) {
  EXPECT_EQ(words("х5 у−7"), "1: X5 Y-7\n");
  EXPECT_EQ(words("N1=5−7"), "1: N1 = 5 - 7\n");
}

TEST(Lexer, NoBreakSpacesAreBlanks) { EXPECT_EQ(words("L\u00A01 =\u00A0X5"), "1: L1 = X5\n"); }

TEST(Lexer, LookAlikesInACommentAreNobodysBusiness) {
  EXPECT_TRUE(Lexed("L1=X5 ' В1").bag.empty());
}

TEST(Lexer, ReportsWhatIsNoWordAndReadsOn) {
  const Lexed lexed("L1 №% E5 L2");
  EXPECT_EQ(render(lexed.bag),
            "t.bgt:1:4: error: '№' has no meaning in the language [DGT0101]\n"
            "L1 №% E5 L2\n   ^\n"
            "t.bgt:1:5: error: '%' has no meaning in the language [DGT0101]\n"
            "L1 №% E5 L2\n    ^\n"
            "t.bgt:1:7: error: no word of the language begins with 'E' [DGT0104]\n"
            "L1 №% E5 L2\n      ^\n");
  EXPECT_TRUE(lexed.line.broken);
  EXPECT_EQ(lexed.line.words.size(), 2U);
}

TEST(Lexer, BytesThatAreNoTextAreReportedOnceWhereverTheyStand) {
  const Lexed lexed("L1 \xFF\xFE L2 ' привет");
  EXPECT_EQ(render(lexed.bag),
            "t.bgt:1:4: error: the bytes FF FE are no text in utf-8 [DGT0102]\n"
            "L1 \uFFFD\uFFFD L2 ' привет\n   ^~\n");
  EXPECT_TRUE(lexed.line.broken);
  EXPECT_EQ(lexed.line.words.size(), 2U) << "the rest is read";
  EXPECT_EQ(render(Lexed("L1 ' привет \xFF").bag),
            "t.bgt:1:13: error: the bytes FF are no text in utf-8 [DGT0102]\n"
            "L1 ' привет \uFFFD\n            ^\n");
}

TEST(Lexer, ReportsVariablesThatDoNotExist) {
  EXPECT_EQ(render(Lexed("X N31 Y-N0").bag),
            "t.bgt:1:3: error: there is no variable 'N31'; they are N1 to N30 [DGT0106]\n"
            "X N31 Y-N0\n  ^~~\n"
            "t.bgt:1:9: error: there is no variable 'N0'; they are N1 to N30 [DGT0106]\n"
            "X N31 Y-N0\n        ^~\n");
}

TEST(Lexer, AVariableWithAFractionIsNoVariable) {
  const Lexed lexed("RN2.5C-1");
  EXPECT_EQ(render(lexed.bag),
            "t.bgt:1:2: error: there is no variable 'N2.5'; they are N1 to N30 [DGT0106]\n"
            "RN2.5C-1\n ^~~~\n");
  EXPECT_EQ(lexed.line.words.size(), 2U);
  EXPECT_EQ(lexed.line.words[0].scale, 0U);
}

TEST(Lexer, ReportsANumberOfAbsurdLength) {
  const std::string number(201, '1');
  EXPECT_EQ(render(Lexed("X" + number).bag),
            "t.bgt:1:2: error: the number has 201 digits; at most 200 can be read [DGT0105]\nX" +
                number.substr(0, 119) + "…\n ^" + std::string(118, '~') + "\n");
}

TEST(Lexer, ReportsAnOpenQuote) {
  EXPECT_EQ(render(Lexed("B1=\"C2,").bag),
            "t.bgt:1:4: error: the quote is not closed on its line [DGT0107]\n"
            "B1=\"C2,\n   ^\n");
}

}  // namespace
}  // namespace dgt::language
