// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/dialect_file.h"

#include <gmock/gmock.h>

#include <fstream>
#include <regex>

#include "apps/driver/settings.h"
#include "lang/text/render.h"
#include "tests/support/command.h"

namespace dgt {
namespace {

using support::run_dgt;
using support::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kPart = "F100\nK1 X0 Y0 X9 Y0 X9 Y-0.5\n";

/// What is said about a dialect file.
std::string messages(const std::string& text, Language language = Language::English) {
  const TemporaryFolder folder;
  const auto source = read_dialect_file(folder.write("mine.toml", text));
  const std::string shown = render(source->bag, {language});
  return std::regex_replace(shown, std::regex("[^ \n]*mine.toml"), "mine.toml");
}

TEST(DialectFiles, EveryShippedFileIsReadWholeAndTellsOfItself) {
  EXPECT_EQ(shipped_dialects().size(), dialects().size());
  for (const ShippedDialect& one : shipped_dialects()) {
    EXPECT_EQ(messages(std::string(one.text)), "") << one.name;
    const Dialect dialect = read_dialect(std::string(one.name), one.text).dialect;
    EXPECT_FALSE(dialect.about.empty()) << one.name;
    EXPECT_FALSE(dialect.about_ru.empty()) << one.name;
    const std::string file =
        std::string(DGT_SOURCE_DIR) + "/post/dialects/" + std::string(one.name) + ".toml";
    EXPECT_EQ(one.text, support::read_text(file)) << "what is built in is what is installed";
  }
}

TEST(DialectFiles, ACopyOfAShippedFileWritesTheSame) {
  const TemporaryFolder folder;
  const std::string part = folder.write("part.bgt", kPart);
  for (const ShippedDialect& one : shipped_dialects()) {
    const std::string file = folder.write("mine.toml", std::string(one.text));
    const auto own = run_dgt({"compile", part, "--post", file});
    const auto shipped = run_dgt({"compile", part, "--post", std::string(one.name)});
    EXPECT_EQ(own.exit_code, 0) << own.err;
    EXPECT_EQ(own.out, shipped.out);
  }
}

TEST(DialectFiles, AShopsOwn) {
  const TemporaryFolder folder;
  const std::string part = folder.write("part.bgt", kPart);
  const std::string file = folder.write(
      "mine.toml",
      "base = 'plasmatic'\nunit = 0.01\n[program]\nheader = ['%', '(part) G91']\n"
      "[line_numbers]\nword = 'N'\nfirst = 5\nstep = 5\n[numbers]\nplus = true\n"
      "trailing_zeros = false\n[words]\nline = 'G1'\nx = 'U'\ny = 'V'\nrepeat_motion = false\n"
      "[codes]\ntranslate.M1 = 'M01'\n[torch]\non = ''\noff = ''\n");
  const auto outcome = run_dgt({"compile", part, "--post", file});
  EXPECT_EQ(outcome.out, "%\n(part) G91\nN5 G1 U+9. F100\nN10 V-0.5\nN15 M02\n") << outcome.err;
}

TEST(DialectFiles, AMachineFileNamesOneBesideIt) {
  const TemporaryFolder folder;
  const std::string part = folder.write("part.bgt", kPart);
  folder.write("mine.toml", "base = '3b'\n[program]\nfooter = 'END'\n");
  const std::string machine = folder.write("wire.toml", "dialect = 'mine.toml'\n");
  const auto outcome = run_dgt({"compile", part, "--machine", machine});
  EXPECT_EQ(outcome.out, "B9000B0B9000GXL1\nB0B500B500GYL4\nEND\n") << outcome.err;
  const auto set = run_dgt({"compile", part, "--set", "dialect=" + folder.name("mine.toml")});
  EXPECT_EQ(set.out, outcome.out) << set.err;
}

TEST(DialectFiles, OneThatIsNotThereIsAFailure) {
  const TemporaryFolder folder;
  const auto outcome =
      run_dgt({"compile", folder.write("part.bgt", kPart), "--post", folder.name("none.toml")});
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_THAT(outcome.out, IsEmpty());
}

TEST(DialectFiles, OneWithAFaultWritesNothing) {
  const TemporaryFolder folder;
  const auto outcome = run_dgt({"compile", folder.write("part.bgt", kPart), "--post",
                                folder.write("mine.toml", "base = 'grbl'\nhaeder = 'x'\n")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.err, HasSubstr("mine.toml:2:1: error"));
}

TEST(DialectFiles, TheListTellsOfEach) {
  const auto english = run_dgt({"compile", "--post", "list"}).out;
  const auto russian = run_dgt({"compile", "--post", "list", "--lang", "ru"}).out;
  for (const Dialect& dialect : dialects()) {
    EXPECT_THAT(english, HasSubstr(dialect.name));
    EXPECT_THAT(english, HasSubstr(dialect.about + "\n"));
    EXPECT_THAT(russian, HasSubstr(dialect.about_ru + "\n"));
  }
}

/// Key and values of each row of the table in post/README.md.
TEST(DialectFiles, TheReadmeHoldsEveryKeyAndItsValuesInOrder) {
  const std::string text = support::read_text(std::string(DGT_SOURCE_DIR) + "/post/README.md");
  const std::size_t begin = text.find("### Keys of a dialect file");
  const std::string section = text.substr(begin, text.find("\n### 3B", begin) - begin);
  static const std::regex kRow("\n\\| `([a-z_.*]+)` \\| ((?:[^|\\\\]|\\\\.)*) \\|");
  static const std::regex kEscaped("\\\\(.)");
  std::vector<std::pair<std::string, std::string>> rows;
  for (std::sregex_iterator row(section.begin(), section.end(), kRow), end; row != end; ++row)
    rows.emplace_back((*row)[1], std::regex_replace((*row)[2].str(), kEscaped, "$1"));
  std::vector<std::pair<std::string, std::string>> known;
  for (const SettingKey& key : dialect_keys()) known.emplace_back(key.key, key.expected);
  EXPECT_EQ(rows, known);
}

// --- what a person is told

TEST(DialectFileMessages, AKeyThatIsNone) {
  EXPECT_EQ(messages("form = 'words'\n[torch]\non_code = 'M3'\n"),
            "mine.toml:3:1: error: a dialect file has no 'torch.on_code'; the nearest is "
            "'torch.on_codes' [DGT0906]\n"
            "on_code = 'M3'\n"
            "^~~~~~~\n");
  EXPECT_EQ(messages("form = 'words'\nunits = 1\n", Language::Russian),
            "mine.toml:2:1: error: в файле диалекта не бывает «units»; ближайший ключ: «unit» "
            "[DGT0906]\n"
            "units = 1\n"
            "^~~~~\n");
}

TEST(DialectFileMessages, AValueThatIsNone) {
  EXPECT_EQ(messages("form = '3b'\npositions = 'absolute'\n"),
            "mine.toml:2:13: error: 'positions' of a dialect cannot be 'absolute'; it takes "
            "absolute|incremental [DGT0907]\n"
            "positions = 'absolute'\n"
            "            ^~~~~~~~~~\n");
  EXPECT_EQ(messages("form = 'words'\nheights = 'yes'\n", Language::Russian),
            "mine.toml:2:11: error: «heights» диалекта не может быть 'yes'; допустимо true|false "
            "[DGT0907]\n"
            "heights = 'yes'\n"
            "          ^~~~~\n");
}

TEST(DialectFileMessages, WithoutAForm) {
  EXPECT_THAT(messages("unit = 1\n"),
              HasSubstr("mine.toml:1:1: error: a dialect file says 'form', or 'base' for a dialect "
                        "to start from; it takes words|signed|3b [DGT0908]\n"));
  EXPECT_THAT(messages("", Language::Russian),
              HasSubstr("error: в файле диалекта нужен ключ «form» или «base» с "
                        "диалектом-образцом; допустимо words|signed|3b [DGT0908]\n"));
}

TEST(DialectFileMessages, WhatIsNoToml) {
  EXPECT_THAT(messages("form = words\n"), HasSubstr("mine.toml:1:8: error: 'words' is no TOML"));
  EXPECT_THAT(messages("unit = 1\nunit = 2\n"), HasSubstr("stands here a second time"));
}

/// Every key with what it does not take.
TEST(DialectFileMessages, NoKeyTakesWhatItShouldNot) {
  for (const SettingKey& key : dialect_keys()) {
    const std::string name =
        key.key == "codes.translate.*" ? "codes.translate.M1" : std::string(key.key);
    for (const char* value : {"1979-05-27", "[1, 2]", "-1"}) {
      const std::string form = name == "form" || name == "base" ? "" : "form = 'words'\n";
      EXPECT_THAT(messages(form + name + " = " + value + "\n"), HasSubstr("[DGT0907]"))
          << name << " = " << value;
    }
  }
}

}  // namespace
}  // namespace dgt
