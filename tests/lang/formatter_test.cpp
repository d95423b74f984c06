// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/formatter.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <filesystem>

#include "apps/driver/path_json.h"
#include "lang/text/render.h"
#include "tests/lang/program.h"
#include "tests/support/command.h"
#include "tests/support/program_generators.h"

namespace dgt::language {
namespace {

namespace fs = std::filesystem;
using support::read_text;

std::string formatted(std::string_view text) {
  const SourceFile file("t.bgt", text);
  DiagnosticBag bag;
  const auto result = format(file, bag);
  return result ? *result : render(bag);
}

// --- layout -------------------------------------------------------------------------------------

TEST(Formatter, PutsOneBlankBetweenItemsAndNoneInsideWords) {
  EXPECT_EQ(formatted("  l 11 =x N 1\n"), "L11=XN1\n");
  EXPECT_EQ(formatted("C1L1C4"), "C1 L1 C4\n");
  EXPECT_EQ(formatted("K1W0.2P1L1X  >C1\tL-  2P1"), "K1 W0.2 P1 L1 X> C1 L-2 P1\n");
  EXPECT_EQ(formatted("P 11G 0 X5Y - N3"), "P11 G0 X5 Y-N3\n");
}

TEST(Formatter, WritesNumbersInTheirShortestSpelling) {
  EXPECT_EQ(formatted("L1=X5."), "L1=X5\n");
  EXPECT_EQ(formatted("L1=X.5"), "L1=X0.5\n");
  EXPECT_EQ(formatted("L1=X+5"), "L1=X5\n");
  EXPECT_EQ(formatted("L1=X-005.2500"), "L1=X-5.25\n");
  EXPECT_EQ(formatted("L1=X123456789012345678901234567890.0625000"),
            "L1=X123456789012345678901234567890.0625\n");
  EXPECT_EQ(formatted("L1=X0.00000000000000000000000000000000010"),
            "L1=X0.0000000000000000000000000000000001\n");
  EXPECT_EQ(formatted("C01=C-1. R5 L1 I2"), "C1=C-1 R5 L1 I2\n");
}

TEST(Formatter, KeepsTheMinusOfZero) {
  EXPECT_EQ(formatted("K1 L-0 A-0 L1"), "K1 L-0 A-0 L1\n");
  EXPECT_EQ(formatted("K1 A-0.0 L1"), "K1 A-0 L1\n");
}

TEST(Formatter, DropsCommasThatOnlyPartItems) {
  EXPECT_EQ(formatted("C12=X5,Y7,,R3,"), "C12=X5 Y7 R3\n");
  EXPECT_EQ(formatted("K1,W0.2,P1,C12,P1"), "K1 W0.2 P1 C12 P1\n");
  EXPECT_EQ(formatted("K1= W 3 P 11"), "K1 W3 P11\n");
}

TEST(Formatter, EndsALineThatGoesOnWithAContourInOneComma) {
  EXPECT_EQ(formatted("A-60, L1 C2 L-2 C-1."), "A-60 L1 C2 L-2 C-1,\n");
  EXPECT_EQ(formatted("L1, C2, L-2,"), "L1 C2 L-2,\n");
  EXPECT_EQ(formatted(" , "), ",\n");
  EXPECT_EQ(formatted("G0 X14 Y0"), "G0 X14 Y0\n");
}

TEST(Formatter, KeepsTheCommasOfArgumentsAndTexts) {
  EXPECT_EQ(formatted("MAC  Kvad 10 , +20,-N3 ,.5 ,"), "MAC Kvad 10,20,-N3,0.5,\n");
  EXPECT_EQ(formatted("MACKVAD"), "MAC KVAD\n");
  EXPECT_EQ(formatted("B 1 = \"c2P4,L5 ,\""), "B1=\"C2 P4, L5,\"\n");
  EXPECT_EQ(formatted("B1=\"10 ,- 20 ,\""), "B1=\"10,-20,\"\n");
  EXPECT_EQ(formatted("K2 = W0.2 B1 ,"), "K2 W0.2 B1,\n");
  EXPECT_EQ(formatted("mac slot B1,5,"), "MAC slot B1,5,\n");
  EXPECT_EQ(formatted("mac slot , B1"), "MAC slot ,B1\n");
}

TEST(Formatter, WritesArithmeticWithoutBlanks) {
  EXPECT_EQ(formatted("N5 = N1 * N2 + 3 - -4 / +2"), "N5=N1*N2+3--4/2\n");
  EXPECT_EQ(formatted("N5 = + 3"), "N5=3\n");
  EXPECT_EQ(formatted("N5=-N 3"), "N5=-N3\n");
}

TEST(Formatter, IndentsTheBodiesOfLoops) {
  EXPECT_EQ(formatted("for +5\n' body\nFOR N1\nN2=N2+1\nNEXT\n\nNEXT 'end\nL1=X0"),
            "FOR 5\n  ' body\n  FOR N1\n    N2=N2+1\n  NEXT\n\nNEXT  'end\nL1=X0\n");
}

TEST(Formatter, IndentsDeepNestingNoFurtherThanTwentyLoops) {
  std::string text;
  for (int i = 0; i < 50; ++i) text += "FOR 1\n";
  text += "N1=1\n";
  for (int i = 0; i < 50; ++i) text += "NEXT\n";
  const std::string result = formatted(text);
  EXPECT_NE(result.find("\n" + std::string(40, ' ') + "N1=1\n"), std::string::npos) << result;
  EXPECT_EQ(formatted(result), result);
}

TEST(Formatter, KeepsOneOfARunOfBlankLinesAndNoneAtTheEnds) {
  EXPECT_EQ(formatted("\n\t\nL1=X0\n \n\n\nL2=X1\n\n"), "L1=X0\n\nL2=X1\n");
  EXPECT_EQ(formatted(""), "");
  EXPECT_EQ(formatted("\n \n"), "");
  EXPECT_EQ(formatted("L1=X0\rL2=X1\r\n\rL3=X2"), "L1=X0\nL2=X1\n\nL3=X2\n");
}

// --- comments -----------------------------------------------------------------------------------

TEST(Formatter, AlignsCommentsBehindCodeInRuns) {
  EXPECT_EQ(formatted("N1=5 ' five\nL1=X0 Y0 A20'slope\nL2=X0\nN3=1 ' alone"),
            "N1=5          ' five\nL1=X0 Y0 A20  'slope\nL2=X0\nN3=1  ' alone\n");
  EXPECT_EQ(formatted("N1=5 ' five\n' between\nL1=X0 Y0 A20 ' slope"),
            "N1=5  ' five\n' between\nL1=X0 Y0 A20  ' slope\n");
}

TEST(Formatter, ALongLineDoesNotPushTheCommentsOfItsNeighbours) {
  std::string items = "K1";
  for (int i = 0; i < 30; ++i) items += " L1";
  EXPECT_EQ(formatted("N1=5 ' a\nN12=6 ' b\n" + items + " ' c\nN1=7 ' d"),
            "N1=5   ' a\nN12=6  ' b\n" + items + "  ' c\nN1=7  ' d\n");
}

TEST(Formatter, LeavesTheWordsOfCommentsAlone) {
  EXPECT_EQ(formatted("'С2   р4 ,, \"  \t\nL1=Х5'С2,  L 1 ' again  "),
            "'С2   р4 ,, \"\nL1=X5  'С2,  L 1 ' again\n");
  EXPECT_EQ(formatted("MAC KVAD'no blank"), "MAC KVAD  'no blank\n");
}

TEST(Formatter, KeepsDirectives) {
  EXPECT_EQ(formatted("  '@ offset-side   right  \nK1 W1 '@ offset-side left"),
            "'@ offset-side   right\nK1 W1  '@ offset-side left\n");
}

TEST(Formatter, WritesLookAlikesAsTheirLatinLetters) {
  EXPECT_EQ(formatted("В1=\"С2 Р4 L5,\""), "B1=\"C2 P4 L5,\"\n");
  EXPECT_EQ(formatted("МАС КВАД 1,"), "MAC КВАД 1,\n");  // a file may be called so
  EXPECT_EQ(formatted("L1=X\u22125\u00A0' ok"), "L1=X-5  ' ok\n");
}

// --- refusal ------------------------------------------------------------------------------------

TEST(Formatter, RefusesAFileWithSyntaxErrors) {
  for (const char* const text : {"L1=X", "L1=X0 ?", "FOR 5\nL1=X0", "NEXT", "B1=\"C2", "L1=X0,5 Y2",
                                 "MAC KVAD 10 20", "K1 P-1"}) {
    const SourceFile file("t.bgt", text);
    DiagnosticBag bag;
    EXPECT_EQ(format(file, bag), std::nullopt) << text;
    EXPECT_TRUE(bag.has_errors()) << text;
  }
}

TEST(Formatter, AsksNotWhetherTheProgramRuns) {
  EXPECT_EQ(formatted("K1 L99 C99\nMAC nowhere 1,"), "K1 L99 C99\nMAC nowhere 1,\n");
}

// --- laws ---------------------------------------------------------------------------------------

/// The tool path without the places in the source; what stands in its way when there is none.
std::string path_of(std::string_view text, const std::string& name, SourceLoader& loader) {
  const SourceFile file(name, text);
  DiagnosticBag bag;
  CompileResult result = compile(file, loader, {}, bag);
  if (!result.path) {
    std::vector<std::string_view> codes;
    for (const Diagnostic& d : bag.all()) {
      if (d.severity() == Severity::Error) codes.push_back(d.code());
    }
    std::ranges::sort(codes);  // files come in the order of the first warning too
    return fmt::format("{}", fmt::join(codes, " "));
  }
  for (Move& move : result.path->moves) move.source = {};
  for (Contour& contour : result.path->contours) {
    for (Move& move : contour.programmed.value()) move.source = {};
  }
  return to_json(*result.path);
}

/// The comments from their marks, one a line, without blanks at their ends. For programs without an
/// apostrophe in a name.
std::string comments_of(std::string_view text) {
  const SourceFile file("t.bgt", text);
  std::string comments;
  for (std::uint32_t line = 1; line <= file.line_count(); ++line) {
    const std::string_view whole = file.line_text(line);
    const std::size_t mark = whole.find('\'');
    if (mark == std::string_view::npos) continue;
    comments += whole.substr(mark, whole.find_last_not_of(" \t\v\f") + 1 - mark);
    comments += '\n';
  }
  return comments;
}

TEST(FormatterLaws, HoldOverTheCorpus) {
  int programs = 0;
  for (const auto& entry : fs::recursive_directory_iterator(support::corpus(""))) {
    const fs::path path = entry.path();
    if (path.extension() != ".bgt" && path.extension() != ".mac") continue;
    const SourceFile file(path.string(), read_text(path));
    DiagnosticBag bag;
    const auto once = format(file, bag);
    ASSERT_TRUE(once) << path << "\n" << render(bag);
    EXPECT_EQ(formatted(*once), *once) << path;
    EXPECT_EQ(comments_of(*once), comments_of(file.text())) << path;
    FolderLoader loader(path.parent_path());
    EXPECT_EQ(path_of(*once, path.string(), loader), path_of(file.text(), path.string(), loader))
        << path;
    ++programs;
  }
  EXPECT_GT(programs, 100);
}

RC_GTEST_PROP(FormatterLaws, FormattingTwiceIsFormattingOnce, ()) {
  const std::string text = *support::any_program();
  const std::string once = formatted(text);
  RC_ASSERT(once.find("error:") == std::string::npos);
  RC_ASSERT(formatted(once) == once);
}

RC_GTEST_PROP(FormatterLaws, TheProgramKeepsItsMeaning, ()) {
  const std::string text = *support::any_program();
  MemoryLoader loader({{"SLOT.mac", support::kMacro}});
  const std::string path = path_of(text, "t.bgt", loader);
  RC_CLASSIFY(path.starts_with("{"), "compiles");
  RC_ASSERT(path_of(formatted(text), "t.bgt", loader) == path);
}

RC_GTEST_PROP(FormatterLaws, EveryCommentStays, ()) {
  const std::string text = *support::any_program();
  RC_ASSERT(comments_of(formatted(text)) == comments_of(text));
}

// However the words of a program are spaced and spelt, one layout comes out.
RC_GTEST_PROP(FormatterLaws, SpacingAndSpellingDoNotShow, ()) {
  const support::Skeleton program = *support::any_skeleton();
  const std::string one = *support::any_spelling(program);
  const std::string other = *support::any_spelling(program);
  RC_ASSERT(formatted(one) == formatted(other));
}

}  // namespace
}  // namespace dgt::language
