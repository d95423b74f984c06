// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/diagnostic.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>

#include "lang/text/render.h"

namespace dgt {
namespace {

std::multiset<std::string> placeholders(std::string_view text) {
  static const std::regex kPlaceholder("\\{[0-9]*\\}");
  const std::string s(text);
  return {std::sregex_token_iterator(s.begin(), s.end(), kPlaceholder),
          std::sregex_token_iterator()};
}

bool has_cyrillic(std::string_view text) {
  return text.find("\xD0") != std::string_view::npos || text.find("\xD1") != std::string_view::npos;
}

TEST(Messages, BothLanguagesAreThereWithTheSamePlaceholders) {
  for (const MessageInfo& row : all_messages()) {
    SCOPED_TRACE(row.name);
    EXPECT_FALSE(row.english.empty());
    EXPECT_FALSE(has_cyrillic(row.english));
    EXPECT_TRUE(has_cyrillic(row.russian));
    EXPECT_EQ(placeholders(row.english), placeholders(row.russian));
  }
}

TEST(Messages, CodesAreUniqueAndWellFormed) {
  static const std::regex kCode("[A-Z]+[0-9]{4}");
  std::set<std::string_view> codes;
  for (const MessageInfo& row : all_messages()) {
    EXPECT_TRUE(codes.insert(row.code).second) << row.code;
    EXPECT_TRUE(std::regex_match(std::string(row.code), kCode)) << row.code;
  }
}

TEST(DiagnosticBag, KeepsTheSameMessageAboutTheSameRangeOnce) {
  const SourceFile file("a.bgt", "abcdef");
  DiagnosticBag bag;
  bag.add({Message::Unexpected, {&file, 1, 2}, {"b"}});
  bag.add({Message::Unexpected, {&file, 1, 2}, {"b"}});
  bag.add({Message::Unexpected, {&file, 2, 3}, {"c"}});
  EXPECT_EQ(bag.all().size(), 2U);
  EXPECT_EQ(bag.error_count(), 2U);
}

TEST(DiagnosticBag, AWarningIsNoError) {
  const SourceFile file("a.bgt", "С");
  DiagnosticBag bag;
  bag.add({Message::LookAlike, {&file, 0, 2}, {"С", "C"}});
  EXPECT_FALSE(bag.has_errors());
}

TEST(DiagnosticBag, CountsOnPastItsLimitAndSaysSoOnce) {
  const SourceFile file("a.bgt", std::string(3000, 'x'));
  DiagnosticBag bag;
  for (std::uint32_t i = 0; i < 3000; ++i) bag.add({Message::Unexpected, {&file, i, i + 1}, {"x"}});
  bag.sort();
  EXPECT_EQ(bag.all().size(), DiagnosticBag::kMaxKept + 1);
  EXPECT_EQ(bag.all().back().message, Message::TooManyDiagnostics);
  EXPECT_EQ(bag.error_count(), 3000U);
}

TEST(DiagnosticBag, SortsByFileAsFirstMetThenByPlace) {
  const SourceFile main("z.bgt", "abc");
  const SourceFile macro("a.mac", "abc");
  DiagnosticBag bag;
  bag.add({Message::Unexpected, {&main, 2, 3}, {"c"}});
  bag.add({Message::Unexpected, {&macro, 0, 1}, {"a"}});
  bag.add({Message::Unexpected, {&main, 0, 1}, {"a"}});
  bag.sort();
  EXPECT_EQ(bag.all()[0].range, (Range{&main, 0, 1}));
  EXPECT_EQ(bag.all()[1].range, (Range{&main, 2, 3}));
  EXPECT_EQ(bag.all()[2].range, (Range{&macro, 0, 1}));
}

TEST(Render, ShowsPlaceTextCodeLineCaretAndFixIt) {
  const SourceFile file("a.bgt", "\tС2 Р14 L5\n");
  const auto begin = static_cast<std::uint32_t>(file.text().find("Р14"));
  const Range range{&file, begin, begin + 4};
  const Diagnostic diagnostic{Message::LookAlike, range, {"Р14", "P14"}, {}, FixIt{range, "P14"}};
  EXPECT_EQ(render(diagnostic),
            "a.bgt:1:5: warning: 'Р14' is not Latin; read as 'P14' [DGT0103]\n"
            "\tС2 Р14 L5\n"
            "\t   ^~~\n"
            "\t   P14\n");
  EXPECT_EQ(render(diagnostic, {Language::Russian, Colour::Plain}),
            "a.bgt:1:5: warning: «Р14» набрано не латиницей; прочитано как «P14» [DGT0103]\n"
            "\tС2 Р14 L5\n"
            "\t   ^~~\n"
            "\t   P14\n");
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

}  // namespace
}  // namespace dgt
