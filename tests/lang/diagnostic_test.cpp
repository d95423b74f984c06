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

TEST(Messages, ArgumentsAreMadeVisible) {
  const std::vector<std::string> arguments = {"\u200B\x1B[2J\n\t\xFF"};
  EXPECT_EQ(text(Message::UnknownCharacter, arguments, Language::English),
            "'U+200BU+001B[2JU+000A \uFFFD' has no meaning in the language");
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
  const std::string last = render(bag.all().back());
  EXPECT_EQ(last.substr(0, last.find('\n')),
            "a.bgt:1:1001: error: more than 1000 errors; the rest is not shown [DGT0001]");
  EXPECT_EQ(bag.error_count(), 3000U);
}

TEST(DiagnosticBag, RemarksAndWarningsNeverCrowdOutErrors) {
  const SourceFile file("a.bgt", std::string(3000, 'x'));
  DiagnosticBag bag;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    bag.add({Message::InRound, {&file, i, i + 1}, {"2"}});
    bag.add({Message::LookAlike, {&file, i, i + 1}, {"x", "X"}});
  }
  EXPECT_FALSE(bag.has_errors());
  bag.add({Message::Unexpected, {&file, 2999, 3000}, {"x"}});
  bag.sort();
  const auto& all = bag.all();
  ASSERT_EQ(all.size(), 2 * (DiagnosticBag::kMaxKept + 1) + 1);
  EXPECT_EQ(all[all.size() - 3].message, Message::Unexpected);
  const auto first_line = [](const Diagnostic& d) {
    const std::string shown = render(d);
    return shown.substr(0, shown.find('\n'));
  };
  EXPECT_EQ(first_line(all[all.size() - 2]),
            "a.bgt:1:1001: note: more than 1000 remarks; the rest is not shown [DGT0003]");
  EXPECT_EQ(first_line(all.back()),
            "a.bgt:1:1001: warning: more than 1000 warnings; the rest is not shown [DGT0002]");
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

TEST(Messages, QuoteNoMoreOfTheSourceThanAPersonReads) {
  std::string word;
  for (int i = 0; i < 1000; ++i) word += "Ж";
  const std::vector<std::string> arguments{word};
  const std::string told = text(Message::UnknownCharacter, arguments, Language::English);
  EXPECT_EQ(told, "'" + word.substr(0, 600) + "…' has no meaning in the language");
}

}  // namespace
}  // namespace dgt
