// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/render.h"

#include <gtest/gtest.h>

#include <string>

namespace dgt {
namespace {

// The lines below the message, for a range that covers `marked` in the file's first line with it.
std::string picture(std::string_view source, std::string_view marked,
                    std::optional<std::string> replacement = std::nullopt) {
  const SourceFile file("a.bgt", source, Encoding::Utf8);
  const auto begin = static_cast<std::uint32_t>(file.text().find(marked));
  const Range range{&file, begin, begin + static_cast<std::uint32_t>(marked.size())};
  Diagnostic diagnostic{Message::MissingNumber, range, {"L"}};
  if (replacement) diagnostic.fix_it = FixIt{range, *replacement};
  const std::string shown = render(diagnostic);
  return shown.substr(shown.find('\n') + 1);
}

TEST(Render, ShowsPlaceTextCodeLineCaretAndFixIt) {
  const SourceFile file("a.bgt", "\tС2 Р14 L5\n");
  const auto begin = static_cast<std::uint32_t>(file.text().find("Р14"));
  const Range range{&file, begin, begin + 4};
  const Diagnostic diagnostic{Message::LookAlike, range, {"Р14", "P14"}, {}, FixIt{range, "P14"}};
  EXPECT_EQ(render(diagnostic),
            "a.bgt:1:5: warning: 'Р14' typed in Cyrillic, read as 'P14' [DGT0103]\n"
            "        С2 Р14 L5\n"
            "           ^~~\n"
            "           P14\n");
  EXPECT_EQ(render(diagnostic, {Language::Russian, Colour::Plain}),
            "a.bgt:1:5: warning: «Р14» набрано не латиницей; прочитано как «P14» [DGT0103]\n"
            "        С2 Р14 L5\n"
            "           ^~~\n"
            "           P14\n");
}

TEST(Render, UnderlinesASecondPlaceInTheSameLine) {
  const SourceFile file("a.bgt", "K1 L12 R5 C3\nC3\n");
  Diagnostic d{Message::NothingToReverse, {&file, 3, 6}, {"P"}};
  d.other = Range{&file, 10, 12};
  const auto below = [&] {
    const std::string shown = render(d);
    return shown.substr(shown.find('\n') + 1);
  };
  EXPECT_EQ(below(), "K1 L12 R5 C3\n   ^~~    ~~\n");
  std::swap(d.range, *d.other);  // the other one stands before it
  EXPECT_EQ(below(), "K1 L12 R5 C3\n   ~~~    ^~\n");
  d.other = Range{&file, 13, 15};
  EXPECT_EQ(below(), "K1 L12 R5 C3\n          ^~\n");
}

TEST(Render, ColoursOnlyWhenAsked) {
  const SourceFile file("a.bgt", "L");
  const Diagnostic diagnostic{Message::MissingNumber, {&file, 0, 1}, {"L"}};
  EXPECT_EQ(render(diagnostic, {Language::English, Colour::Ansi}),
            "\x1b[1ma.bgt:1:1:\x1b[0m \x1b[1;31merror:\x1b[0m \x1b[1m'L' needs a number\x1b[0m "
            "[DGT0202]\nL\n\x1b[1;32m^\x1b[0m\n");
}

TEST(Render, ShowsAWindowOfALongLine) {
  const SourceFile file("a.bgt", std::string(300, 'a') + "bcd" + std::string(300, 'e'));
  const std::string shown = render({Message::Unexpected, {&file, 300, 303}, {"bcd"}});
  const std::string line = "…" + std::string(40, 'a') + "bcd" + std::string(77, 'e') + "…";
  EXPECT_EQ(shown, "a.bgt:1:301: error: 'bcd' cannot stand here [DGT0201]\n" + line + "\n" +
                       std::string(41, ' ') + "^~~\n");
}

TEST(Render, ShowsNotesInTheSameForm) {
  const SourceFile file("a.bgt", "ab\ncd\n");
  const Diagnostic diagnostic{
      Message::Unexpected, {&file, 0, 2}, {"ab"}, {{Message::Unexpected, {&file, 3, 4}, {"c"}}}};
  EXPECT_EQ(render(diagnostic),
            "a.bgt:1:1: error: 'ab' cannot stand here [DGT0201]\nab\n^~\n"
            "a.bgt:2:1: error: 'c' cannot stand here [DGT0201]\ncd\n^\n");
}

TEST(Render, TabsAreShownAsBlanksUpToTheNextStop) {
  EXPECT_EQ(picture("L1\tC2\t\tP3", "C2"), "L1      C2              P3\n        ^~\n");
  EXPECT_EQ(picture("L1\tC2\t\tP3", "P3", "P4"),
            "L1      C2              P3\n                        ^~\n"
            "                        P4\n");
  EXPECT_EQ(picture("С2\tР4", "2\tР"), "С2      Р4\n ^~~~~~~~\n") << "a tab inside the range";
}

TEST(Render, ARangeOverLinesEndsWithItsFirst) {
  EXPECT_EQ(picture("K1 L1\r\nL2,\n", "L1\r\nL2"), "K1 L1\n   ^~\n");
}

TEST(Render, TheEndOfALineCanBePointedAt) {
  const SourceFile file("a.bgt", "K1 L1\n");
  const Range end{&file, 5, 5};
  EXPECT_EQ(render({Message::LineWithoutComma, end, {}, {}, FixIt{end, ","}}),
            "a.bgt:1:6: error: a line that goes on with a contour needs a comma [DGT0208]\n"
            "K1 L1\n     ^\n     ,\n");
}

TEST(Render, CyrillicCountsOneCombiningNoneWideTwo) {
  EXPECT_EQ(picture("' деталь и\u0306 中 L", "L"), "' деталь и\u0306 中 L\n              ^\n");
  EXPECT_EQ(picture("Ёж L", "Ёж"), "Ёж L\n^~\n");
}

TEST(Render, NothingInTheSourceReachesTheTerminalUnseen) {
  EXPECT_EQ(picture("L\x1B[2J\u202E\u009B1", "1"), "L\uFFFD[2J\uFFFD\uFFFD1\n       ^\n");
  const SourceFile file("a\x1B\n.bgt", "L");
  EXPECT_EQ(render({Message::MissingNumber, {&file, 0, 1}, {"L"}}),
            "aU+001BU+000A.bgt:1:1: error: 'L' needs a number [DGT0202]\nL\n^\n");
}

TEST(Render, ALineThatFitsIsNotCut) {
  const std::string line = std::string(117, 'a') + "bcd";
  EXPECT_EQ(picture(line, "bcd"), line + "\n" + std::string(117, ' ') + "^~~\n");
  const std::string cyrillic = [] {
    std::string text;
    for (int i = 0; i < 119; ++i) text += "ж";
    return text + "L";
  }();
  EXPECT_EQ(picture(cyrillic, "L"), cyrillic + "\n" + std::string(119, ' ') + "^\n");
}

TEST(Render, TheWindowOfALongLineBeginsWithIt) {
  const std::string line = "bcd" + std::string(300, 'e');
  EXPECT_EQ(picture(line, "bcd"), "bcd" + std::string(117, 'e') + "…\n^~~\n");
}

TEST(Render, TheWindowOfALongLineEndsWithIt) {
  const std::string line = std::string(300, 'e') + "bcd";
  EXPECT_EQ(picture(line, "bcd"),
            "…" + std::string(40, 'e') + "bcd\n" + std::string(41, ' ') + "^~~\n");
}

TEST(Render, AWideRangeEndsWithTheWindow) {
  const std::string wide(250, 'b');
  EXPECT_EQ(picture(std::string(300, 'a') + wide, wide),
            "…" + std::string(40, 'a') + std::string(80, 'b') + "…\n" + std::string(41, ' ') + "^" +
                std::string(79, '~') + "\n");
}

TEST(Render, AFixItOutsideTheWindowIsNotShown) {
  const SourceFile file("a.bgt", std::string(300, 'a'));
  const Diagnostic diagnostic{
      Message::MissingNumber, {&file, 0, 1}, {"a"}, {}, FixIt{{&file, 250, 251}, "b"}};
  EXPECT_EQ(render(diagnostic),
            "a.bgt:1:1: error: 'a' needs a number [DGT0202]\n" + std::string(120, 'a') + "…\n^\n");
}

TEST(Render, NotesKeepTheirOrderAndNameTheirFiles) {
  const SourceFile program("a.bgt", "MAC M 1,\n");
  const SourceFile macro("mac/m.mac", "L1=\nL2=\n");
  const Diagnostic diagnostic{Message::EmptyDefinition,
                              {&macro, 0, 3},
                              {"L1"},
                              {{Message::EmptyDefinition, {&macro, 4, 7}, {"L2"}},
                               {Message::ExpectedName, {&program, 0, 3}, {"MAC"}},
                               {Message::EmptyDefinition, {&macro, 0, 3}, {"L1"}}}};
  EXPECT_EQ(render(diagnostic, {Language::Russian, Colour::Plain}),
            "mac/m.mac:1:1: error: определение L1 пусто [DGT0302]\nL1=\n^~~\n"
            "mac/m.mac:2:1: error: определение L2 пусто [DGT0302]\nL2=\n^~~\n"
            "a.bgt:1:1: error: после MAC нужно имя файла [DGT0213]\nMAC M 1,\n^~~\n"
            "mac/m.mac:1:1: error: определение L1 пусто [DGT0302]\nL1=\n^~~\n");
}

TEST(Render, ABagIsShownInItsOrder) {
  const SourceFile file("a.bgt", "ab");
  DiagnosticBag bag;
  bag.add({Message::Unexpected, {&file, 1, 2}, {"b"}});
  bag.add({Message::Unexpected, {&file, 0, 1}, {"a"}});
  EXPECT_EQ(render(bag),
            "a.bgt:1:2: error: 'b' cannot stand here [DGT0201]\nab\n ^\n"
            "a.bgt:1:1: error: 'a' cannot stand here [DGT0201]\nab\n^\n");
}

}  // namespace
}  // namespace dgt
