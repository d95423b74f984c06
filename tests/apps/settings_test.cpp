// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/settings.h"

#include <gmock/gmock.h>

#include <regex>
#include <set>

#include "lang/text/render.h"
#include "tests/support/command.h"

namespace dgt {
namespace {

using support::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A machine file in a folder of its own.
struct Machine {
  explicit Machine(const std::string& text)
      : name(folder.write("m.toml", text)), file(*read_machine_file(name)) {}

  /// What it comes to, with `--set` on top.
  Settings settled(std::vector<Setting> set = {}, const char* post = "") {
    return *settle({&file, std::move(set), find_dialect(post)});
  }
  /// What a person is told about it, without the name of the folder.
  std::string messages(Language language = Language::English) {
    (void)settled();
    std::string shown = render(file.bag, {language});
    const std::string path = folder.name("");
    for (auto at = shown.find(path); at != std::string::npos; at = shown.find(path))
      shown.erase(at, path.size());
    return shown;
  }

  TemporaryFolder folder;
  std::string name;
  MachineFile file;
};

// --- values -------------------------------------------------------------------------------------

TEST(MachineSettings, EveryKeyOfTheExecutionChangesItsField) {
  Machine machine(
      "offset_side = 'left'\njoin_tolerance = 0.05\ngouge = 'warn'\n"
      "corner = 'chamfer'\ncorner_limit = 2.5\ncrossings = 'leads'\n"
      "max_statements = 1\nmax_moves = 2\nmax_loop_depth = 3\nmax_macro_depth = 4\n"
      "max_text_depth = 5\n");
  const EvaluateOptions made = machine.settled().source.evaluate;
  EXPECT_THAT(machine.messages(), IsEmpty());
  EXPECT_EQ(made.offset_side, OffsetSide::Left);
  EXPECT_EQ(made.join_tolerance, Rational(1, 20));
  EXPECT_EQ(made.gouge, GougePolicy::Warn);
  EXPECT_EQ(made.corner, CornerStyle::Chamfer);
  EXPECT_EQ(made.corner_limit, Rational(5, 2));
  EXPECT_EQ(made.crossings, CrossingMoves::Leads);
  EXPECT_EQ(made.bounds.statements, 1U);
  EXPECT_EQ(made.bounds.moves, 2U);
  EXPECT_EQ(made.bounds.loop_depth, 3U);
  EXPECT_EQ(made.bounds.macro_depth, 4U);
  EXPECT_EQ(made.bounds.text_depth, 5U);
}

TEST(MachineSettings, NumbersAreTheDecimalsAsWrittenInQuotesOrNot) {
  EXPECT_EQ(Machine("unit = 0.05").settled().dialect.unit, Rational(1, 20));
  EXPECT_EQ(Machine("unit = \"0.05\"").settled().dialect.unit, Rational(1, 20));
  EXPECT_EQ(Machine("unit = 5e-2").settled().dialect.unit, Rational(1, 20));
  EXPECT_EQ(Machine("unit = 1").settled().dialect.unit, 1);
  Rational tiny(1);
  for (int i = 0; i < 30; ++i) tiny /= 10;
  EXPECT_EQ(Machine("join_tolerance = 0.100000000000000000000000000001")
                .settled()
                .source.evaluate.join_tolerance,
            Rational(1, 10) + tiny);
}

TEST(MachineSettings, WordsMayBeANumber) {
  EXPECT_EQ(Machine("torch_on = 53").settled().dialect.torch_on, "53");
}

TEST(MachineSettings, TheDialectIsChosenBeforeItIsChanged) {
  Machine machine("unit = 0.01\ndialect = \"essi\"");
  EXPECT_EQ(machine.settled().dialect.name, "essi");
  EXPECT_EQ(machine.settled().dialect.unit, Rational(1, 100));
  EXPECT_EQ(machine.settled({{"dialect", "plasmatic"}}).dialect.name, "plasmatic");
  EXPECT_EQ(machine.settled({{"dialect", "plasmatic"}}, "linuxcnc").dialect.name, "linuxcnc");
  EXPECT_EQ(machine.settled({{"dialect", "plasmatic"}}, "linuxcnc").dialect.unit, Rational(1, 100));
}

TEST(MachineSettings, WithoutADialectTheOthersHoldAllTheSame) {
  EXPECT_EQ(Machine("max_arc_degrees = 170").settled().dialect.name, "");
  EXPECT_THAT(Machine("max_arc_degrees = 170").messages(), IsEmpty());
}

TEST(MachineSettings, SetWinsOverTheFileAndTheLaterOverTheEarlier) {
  Machine machine("unit = 0.01\ngouge = 'warn'\nmacro_path = ['a']");
  EXPECT_EQ(machine.settled({{"decimals", "3"}}).dialect.unit, Rational(1, 1000));
  EXPECT_EQ(machine.settled({{"unit", "1"}, {"unit", "2"}}).dialect.unit, 2);
  EXPECT_EQ(machine.settled({{"gouge", "error"}}).source.evaluate.gouge, GougePolicy::Error);
  EXPECT_THAT(machine.settled({{"macro_path", "/x:y"}}).source.macro_path, ElementsAre("/x", "y"));
}

TEST(MachineSettings, FoldersAreMeantFromWhereTheFileLies) {
  Machine machine("macro_path = ['a', '/b', '']");
  EXPECT_THAT(machine.settled().source.macro_path, ElementsAre(machine.folder.name("a"), "/b"));
  Machine one("macro_path = 'c:d'");
  EXPECT_THAT(one.settled().source.macro_path, ElementsAre(one.folder.name("c:d")));
}

TEST(MachineSettings, AFaultInSetIsReturned) {
  const auto fault = [](const Setting& setting) { return settle({nullptr, {setting}}).error(); };
  EXPECT_EQ(fault({"max_mves", "1"}).nearest, "max_moves");
  EXPECT_EQ(fault({"torch_of", "1"}).nearest, "torch_off");
  EXPECT_EQ(fault({"dialect", "klingon"}).expected,
            "essi|essi-iso|plasmatic|linuxcnc|fanuc-wire|grbl|3b|FILE.toml");
  for (const Setting& setting : {Setting{"max_moves", "0"},
                                 {"max_moves", "1.5"},
                                 {"max_moves", "1000000000001"},
                                 {"max_moves", "99999999999999999999"},
                                 {"max_moves", ""},
                                 {"max_loop_depth", "1001"},
                                 {"join_tolerance", "-1"},
                                 {"join_tolerance", "x"},
                                 {"offset_side", "top"},
                                 {"gouge", "note"},
                                 {"corner", "sharp"},
                                 {"crossings", "some"},
                                 {"corner_limit", "0.5"}})
    EXPECT_EQ(fault(setting).kind, SettingFault::Kind::BadValue) << setting.key;
}

// --- what a person is told ----------------------------------------------------------------------

TEST(MachineMessages, WhatIsNoTomlIsShownFromWhereItBegins) {
  EXPECT_EQ(Machine("# Станок\nunit = 0,05\n").messages(),
            "m.toml:2:9: error: ',05' is no TOML; a setting is written key = value, with words in "
            "quotes [DGT0901]\n"
            "unit = 0,05\n"
            "        ^~~\n");
  EXPECT_EQ(Machine("torch_on = M3 S1\n").messages(Language::Russian),
            "m.toml:1:12: error: «M3 S1» не TOML; настройка пишется ключ = значение, слова в "
            "кавычках [DGT0901]\n"
            "torch_on = M3 S1\n"
            "           ^~~~~\n");
}

TEST(MachineMessages, AKeyStandsOnce) {
  EXPECT_EQ(Machine("unit = 1\nunit = 2\n").messages(),
            "m.toml:2:1: error: 'unit' stands here a second time [DGT0902]\n"
            "unit = 2\n"
            "^~~~\n");
  EXPECT_EQ(Machine("unit = 1\nunit = 2\n").messages(Language::Russian),
            "m.toml:2:1: error: «unit» стоит здесь второй раз [DGT0902]\n"
            "unit = 2\n"
            "^~~~\n");
}

TEST(MachineMessages, AllFaultsOfAFileAreToldInOrder) {
  EXPECT_EQ(
      Machine("torch_of = 'M5'\nunit = 'wide'\ngouge = true\n[essi]\nunits = 1\n").messages(),
      "m.toml:1:1: error: there is no setting 'torch_of'; the nearest is 'torch_off' "
      "[DGT0903]\n"
      "torch_of = 'M5'\n"
      "^~~~~~~~\n"
      "m.toml:2:8: error: the setting 'unit' cannot be 'wide'; it takes 0.000001…100 mm "
      "[DGT0904]\n"
      "unit = 'wide'\n"
      "       ^~~~~~\n"
      "m.toml:3:9: error: the setting 'gouge' cannot be true; it takes error|warn|trim [DGT0904]\n"
      "gouge = true\n"
      "        ^~~~\n"
      "m.toml:5:1: error: there is no setting 'essi.units'; the nearest is 'essi.unit' [DGT0903]\n"
      "units = 1\n"
      "^~~~~\n");
  EXPECT_EQ(Machine("torch_of = 'M5'\nunit = 'wide'\n").messages(Language::Russian),
            "m.toml:1:1: error: нет настройки «torch_of»; ближайшая: «torch_off» [DGT0903]\n"
            "torch_of = 'M5'\n"
            "^~~~~~~~\n"
            "m.toml:2:8: error: настройка «unit» не может быть 'wide'; допустимо 0.000001…100 mm "
            "[DGT0904]\n"
            "unit = 'wide'\n"
            "       ^~~~~~\n");
}

TEST(MachineMessages, WhatIsOfTheWrongTypeIsShownAsItStands) {
  const auto value = [](const std::string& text) {
    const std::string shown = Machine(text).messages();
    std::smatch match;
    static const std::regex kCannot("cannot be (.*) \\[DGT0904\\]");
    return std::regex_search(shown, match, kCannot) ? match[1].str() : shown;
  };
  EXPECT_EQ(value("torch_on = true"), "true; it takes \"M3 S1\"");
  EXPECT_EQ(value("unit = [\"1\"]"), "[\"1\"]; it takes 0.000001…100 mm");
  EXPECT_EQ(value("unit = 1979-05-27"), "1979-05-27; it takes 0.000001…100 mm");
  EXPECT_EQ(value("unit = nan"), "nan; it takes 0.000001…100 mm");
  EXPECT_EQ(value("macro_path = 5"), "5; it takes [\"/a\", \"/b\"], /a:/b");
  EXPECT_EQ(value("macro_path = [5]"), "[5]; it takes [\"/a\", \"/b\"], /a:/b");
  EXPECT_EQ(value("dialect = \"Essi\""),
            "\"Essi\"; it takes essi|essi-iso|plasmatic|linuxcnc|fanuc-wire|grbl|3b|FILE.toml");
  EXPECT_EQ(value("max_moves = -1"), "-1; it takes 1…1000000000000");
}

TEST(MachineMessages, UnitAndDecimalsSayTheSame) {
  EXPECT_EQ(Machine("decimals = 1\nunit = 0.1\n").messages(),
            "m.toml:2:1: error: 'unit' says again what 'decimals' has said; keep one of them "
            "[DGT0905]\n"
            "unit = 0.1\n"
            "^~~~\n");
  EXPECT_EQ(Machine("unit = 0.1\ndecimals = 1\n").messages(Language::Russian),
            "m.toml:2:1: error: «decimals» повторяет сказанное в «unit»; оставьте одно из них "
            "[DGT0905]\n"
            "decimals = 1\n"
            "^~~~~~~~\n");
}

TEST(MachineMessages, AFileInWindows1251IsReadToo) {
  const TemporaryFolder folder;
  // "# Станок лазерной резки, цех номер два" in Windows-1251.
  const std::string name = folder.write(
      "m.toml",
      "# \xD1\xF2\xE0\xED\xEE\xEA \xEB\xE0\xE7\xE5\xF0\xED\xEE\xE9 \xF0\xE5\xE7\xEA\xE8, "
      "\xF6\xE5\xF5 \xED\xEE\xEC\xE5\xF0 \xE4\xE2\xE0\nunit = 0.05\n");
  MachineFile file = *read_machine_file(name);
  EXPECT_FALSE(file.bag.has_errors()) << render(file.bag);
  EXPECT_EQ(settle({&file, {}})->dialect.unit, Rational(1, 20));
}

// --- documentation and example ------------------------------------------------------------------

/// Key and values of each row of the settings' table in post/README.md.
std::vector<std::pair<std::string, std::string>> documented() {
  const std::string text =
      support::read_text(std::filesystem::path(DGT_SOURCE_DIR) / "post" / "README.md");
  const std::size_t begin = text.find("### Settings");
  const std::string section = text.substr(begin, text.find("\n## ", begin) - begin);
  static const std::regex kRow("\n\\| `([a-z0-9_.]+)` \\| ((?:[^|\\\\]|\\\\.)*) \\|");
  static const std::regex kEscaped("\\\\(.)");
  std::vector<std::pair<std::string, std::string>> rows;
  for (std::sregex_iterator row(section.begin(), section.end(), kRow), end; row != end; ++row)
    rows.emplace_back((*row)[1], std::regex_replace((*row)[2].str(), kEscaped, "$1"));
  return rows;
}

TEST(SettingsTable, HoldsEveryKeyAndItsValuesInTheOrderOfTheHelp) {
  std::vector<std::pair<std::string, std::string>> known;
  for (const SettingKey& key : all_settings()) known.emplace_back(key.key, key.expected);
  EXPECT_EQ(documented(), known);
}

TEST(SettingsTable, NoKeyIsThereTwice) {
  std::set<std::string_view> keys;
  for (const SettingKey& key : all_settings()) EXPECT_TRUE(keys.insert(key.key).second) << key.key;
}

TEST(SettingsTable, NamesEveryDialect) {
  std::string names;
  for (const Dialect& dialect : dialects()) names += (names.empty() ? "" : "|") + dialect.name;
  EXPECT_EQ(all_settings().front().key, "dialect");
  EXPECT_EQ(all_settings().front().expected, names + "|FILE.toml");
}

TEST(MachineExample, TheWireMachineOfTheCorpusIsReadWhole) {
  MachineFile machine = *read_machine_file(support::corpus("machine/wire.toml"));
  const Settings made = *settle({&machine, {}});
  EXPECT_THAT(render(machine.bag), IsEmpty());
  EXPECT_EQ(made.dialect.name, "linuxcnc");
  EXPECT_EQ(made.dialect.unit, Rational(1, 10000));
  EXPECT_EQ(*made.dialect.feed, Rational(5, 2));
  EXPECT_EQ(made.dialect.torch, TorchPolicy::None);
  EXPECT_EQ(meaning_of(made.dialect, "M102").words, "M102");
  EXPECT_EQ(made.source.evaluate.join_tolerance, Rational(1, 2000));
  EXPECT_EQ(made.source.evaluate.bounds.moves, 1'000'000U);
}

}  // namespace
}  // namespace dgt
