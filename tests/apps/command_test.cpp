// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command as a script sees it: exit codes, streams, files.
#include "tests/support/command.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

namespace dgt {
namespace {

using support::corpus;
using support::Outcome;
using support::read_text;
using support::run_dgt;
using support::TemporaryFolder;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

constexpr int kDone = 0;
constexpr int kInputErrors = 1;
constexpr int kWrongUsage = 2;
constexpr int kFailure = 3;

/// L2 is used and never defined.
constexpr const char* kFaulty = "L1=Y2\nK1 L1 L2\n";

const std::vector<std::string> kVerbs = {"compile", "check", "path", "dump",
                                         "points",  "info",  "plot"};

/// A verb with the options it cannot do without.
std::vector<std::string> call(const std::string& verb, const std::string& file) {
  if (verb == "compile") return {verb, file, "--post", "essi"};
  return {verb, file};
}

// --- help and usage -----------------------------------------------------------------------------

TEST(DgtCommand, HelpNamesEveryVerbAndTheExitCodes) {
  const Outcome outcome = run_dgt({"--help"});
  EXPECT_EQ(outcome.exit_code, kDone);
  for (const std::string& verb : kVerbs) EXPECT_THAT(outcome.out, HasSubstr("\n  " + verb));
  EXPECT_THAT(outcome.out, HasSubstr("Exit codes:"));
  EXPECT_THAT(outcome.err, IsEmpty());
}

TEST(DgtCommand, EveryVerbHasHelpAndVersion) {
  const std::string version = run_dgt({"--version"}).out;
  EXPECT_THAT(version, StartsWith("dgt "));
  for (const std::string& verb : kVerbs) {
    const Outcome help = run_dgt({verb, "--help"});
    EXPECT_EQ(help.exit_code, kDone) << verb;
    EXPECT_THAT(help.out, AllOf(HasSubstr("FILE"), HasSubstr("--lang"))) << verb;
    EXPECT_EQ(run_dgt({verb, "--version"}).out, version) << verb;
  }
}

TEST(DgtCommand, WrongUsageIs2AndSaysWhy) {
  const TemporaryFolder folder;
  const std::string other = folder.write("part.txt", "L1=Y2\n");
  const std::vector<std::vector<std::string>> calls = {
      {},
      {"frobnicate"},
      {"path"},
      {"path", "--frobnicate", corpus("1P.bgt")},
      {"path", other},
      {"path", corpus("1P.bgt"), "--from", "latin"},
      {"path", corpus("1P.bgt"), "--lang", "tlh"},
      {"path", corpus("1P.bgt"), "--color", "red"},
      {"path", corpus("1P.bgt"), "--offset-side", "top"},
      {"path", corpus("1P.bgt"), "--join-tolerance", "wide"},
      {"path", corpus("1P.bgt"), "--join-tolerance", "-1"},
      {"plot", corpus("1P.bgt"), "-o", folder.name("part.gif")},
      {"compile", corpus("1P.bgt")},
      {"compile", corpus("1P.bgt"), "--post", "klingon"},
  };
  for (const auto& words : calls) {
    const Outcome outcome = run_dgt(words);
    EXPECT_EQ(outcome.exit_code, kWrongUsage) << ::testing::PrintToString(words);
    EXPECT_THAT(outcome.out, IsEmpty()) << ::testing::PrintToString(words);
    EXPECT_THAT(outcome.err, Not(IsEmpty())) << ::testing::PrintToString(words);
  }
  EXPECT_THAT(folder.entries(), ElementsAre("part.txt"));
}

// --- input --------------------------------------------------------------------------------------

TEST(DgtCommand, EveryVerbReadsStandardInput) {
  const std::string program = read_text(corpus("1P.bgt"));
  for (const std::string& verb : kVerbs) {
    const Outcome outcome = run_dgt(call(verb, "-"), {.input = program});
    EXPECT_EQ(outcome.exit_code, kDone) << verb << outcome.err;
  }
  EXPECT_EQ(run_dgt(call("compile", "-"), {.input = program}).out,
            run_dgt(call("compile", corpus("1P.bgt"))).out);
}

TEST(DgtCommand, TheExtensionMayBeInCapitalsOrOverruled) {
  const TemporaryFolder folder;
  const std::string program = read_text(corpus("1P.bgt"));
  EXPECT_EQ(run_dgt({"check", folder.write("PART.BGT", program)}).exit_code, kDone);
  EXPECT_EQ(run_dgt({"check", folder.write("part.txt", program), "--from", "dgt"}).exit_code,
            kDone);
}

TEST(DgtCommand, AMissingFileIs3) {
  const TemporaryFolder folder;
  for (const std::string& verb : kVerbs) {
    const Outcome outcome = run_dgt(call(verb, folder.name("no.bgt")));
    EXPECT_EQ(outcome.exit_code, kFailure) << verb;
    EXPECT_THAT(outcome.out, IsEmpty()) << verb;
    EXPECT_EQ(outcome.err,
              "dgt: error: " + folder.name("no.bgt") + ": No such file or directory\n");
  }
}

TEST(DgtCommand, FaultsInTheInputAre1AndNothingIsWritten) {
  const TemporaryFolder folder;
  const std::string faulty = folder.write("faulty.bgt", kFaulty);
  const std::string target = folder.write("old.svg", "old");
  for (const std::string& verb : kVerbs) {
    const Outcome outcome = run_dgt(call(verb, faulty));
    EXPECT_EQ(outcome.exit_code, kInputErrors) << verb;
    EXPECT_THAT(outcome.out, IsEmpty()) << verb;
    EXPECT_THAT(outcome.err, StartsWith(faulty + ":2:7: error: ")) << verb;
    if (verb == "check") continue;
    std::vector<std::string> words = call(verb, faulty);
    words.insert(words.end(), {"-o", target});
    EXPECT_EQ(run_dgt(words).exit_code, kInputErrors) << verb;
    EXPECT_EQ(read_text(target), "old") << verb;
  }
  EXPECT_THAT(folder.entries(), ElementsAre("faulty.bgt", "old.svg"));
}

TEST(DgtCommand, CheckGoesThroughAllFilesAndReturnsTheWorst) {
  const TemporaryFolder folder;
  const std::string faulty = folder.write("faulty.bgt", kFaulty);
  EXPECT_EQ(run_dgt({"check", corpus("1P.bgt"), corpus("5P.bgt")}).exit_code, kDone);
  EXPECT_EQ(run_dgt({"check", faulty, corpus("1P.bgt")}).exit_code, kInputErrors);
  const Outcome both = run_dgt({"check", folder.name("no.bgt"), faulty});
  EXPECT_EQ(both.exit_code, kFailure);
  EXPECT_THAT(both.err, HasSubstr(faulty + ":2:7: error: "));
}

TEST(DgtCommand, MacrosComeFromTheProgramsFolderAndFromTheMacroPath) {
  const TemporaryFolder folder;
  const std::string program = folder.write("call.bgt", read_text(corpus("kvad-square.bgt")));
  const Outcome beside = run_dgt({"dump", corpus("kvad-square.bgt")});
  EXPECT_EQ(beside.exit_code, kDone) << beside.err;
  EXPECT_EQ(run_dgt({"dump", program}).exit_code, kInputErrors);
  const Outcome through_path = run_dgt({"dump", program, "--mac-path", corpus("mac")});
  EXPECT_EQ(through_path.exit_code, kDone) << through_path.err;
  EXPECT_EQ(run_dgt({"dump", "--mac-path", folder.path(), "--mac-path", corpus("mac"), program})
                .exit_code,
            kDone);
}

TEST(DgtCommand, TheSideOfTheOffsetCanBeSet) {
  const std::string program = read_text(corpus("1P.bgt"));
  const auto side = [&](const std::string& value) {
    const Outcome outcome = run_dgt({"path", "-", "--offset-side", value}, {.input = program});
    return nlohmann::json::parse(outcome.out)["contours"][0]["side"].get<std::string>();
  };
  EXPECT_EQ(side("auto"), "right");
  EXPECT_EQ(side("right"), "right");
  EXPECT_EQ(side("left"), "left");
}

// --- output -------------------------------------------------------------------------------------

TEST(DgtCommand, AFileGetsTheBytesOfStandardOutputAndRunsAreAlike) {
  const TemporaryFolder folder;
  const std::string target = folder.name("out.svg");
  for (const std::string& verb : kVerbs) {
    if (verb == "check") continue;
    const Outcome first = run_dgt(call(verb, corpus("3P.bgt")));
    EXPECT_EQ(first.exit_code, kDone) << verb << first.err;
    EXPECT_THAT(first.out, Not(IsEmpty())) << verb;
    std::vector<std::string> words = call(verb, corpus("3P.bgt"));
    words.insert(words.end(), {"-o", target});
    const Outcome second = run_dgt(words);
    EXPECT_EQ(second.exit_code, kDone) << verb << second.err;
    EXPECT_THAT(second.out, IsEmpty()) << verb;
    EXPECT_EQ(read_text(target), first.out) << verb;
    EXPECT_EQ(second.err, first.err) << verb;
  }
  EXPECT_THAT(folder.entries(), ElementsAre("out.svg"));
}

TEST(DgtCommand, AFullDeviceIs3) {
  for (const std::string& verb : kVerbs) {
    if (verb == "check") continue;
    const Outcome outcome = run_dgt(call(verb, corpus("1P.bgt")), {.output_to = "/dev/full"});
    EXPECT_EQ(outcome.exit_code, kFailure) << verb;
    EXPECT_THAT(outcome.err, HasSubstr("No space left on device")) << verb;
  }
  EXPECT_EQ(run_dgt({"path", corpus("1P.bgt"), "-o", "/dev/full"}).exit_code, kFailure);
}

TEST(DgtCommand, AMissingFolderIs3AndNoFileIsLeft) {
  const TemporaryFolder folder;
  const Outcome outcome = run_dgt({"path", corpus("1P.bgt"), "-o", folder.name("no/out.json")});
  EXPECT_EQ(outcome.exit_code, kFailure);
  EXPECT_THAT(outcome.err, HasSubstr(folder.name("no/out.json") + ": No such file or directory"));
  EXPECT_THAT(folder.entries(), IsEmpty());
}

TEST(DgtCommand, NamesMayBeCyrillicAndHaveBlanks) {
  const TemporaryFolder folder;
  const std::string program = folder.write("Деталь 1.bgt", read_text(corpus("1P.bgt")));
  const std::string target = folder.name("УП № 1.ess");
  const Outcome outcome = run_dgt({"compile", program, "--post", "essi", "-o", target});
  EXPECT_EQ(outcome.exit_code, kDone) << outcome.err;
  EXPECT_THAT(read_text(target), Not(IsEmpty()));
}

// --- compile ------------------------------------------------------------------------------------

TEST(DgtCompile, ListNamesTheDialects) {
  const Outcome outcome = run_dgt({"compile", "--post", "list"});
  EXPECT_EQ(outcome.exit_code, kDone);
  EXPECT_EQ(
      outcome.out,
      "essi        ESSI with arcs by radius, increments of 0.1 mm\n"
      "essi-iso    ESSI with arcs by centre (ISO 6582), increments of 0.1 mm\n"
      "plasmatic   G-code in increments of 0.1 mm for plasma cutters\n"
      "linuxcnc    G-code for LinuxCNC, absolute, 0.001 mm\n"
      "fanuc-wire  G-code for wire machines of Fanuc's kind, G92, absolute, 0.001 mm\n"
      "grbl        G-code for GRBL, absolute, 0.001 mm, torch or laser on the spindle output\n"
      "3b          3B for wire machines, whole micrometres\n");
}

TEST(DgtCompile, TellsTheCertificateOnStandardError) {
  const Outcome outcome = run_dgt({"compile", corpus("1P.bgt"), "--post", "essi"});
  EXPECT_THAT(outcome.err, ::testing::ContainsRegex("dgt: note: essi: [0-9]+ blocks, at most "
                                                    "0\\.[0-9]{4} mm off the exact path"));
}

TEST(DgtCompile, SettingsChangeTheDialectAndTheLaterWins) {
  const auto compiled = [](const std::vector<std::string>& settings) {
    std::vector<std::string> words = {"compile", corpus("1P.bgt"), "--post", "plasmatic"};
    words.insert(words.end(), settings.begin(), settings.end());
    const Outcome outcome = run_dgt(words);
    EXPECT_EQ(outcome.exit_code, kDone) << outcome.err;
    return outcome.out;
  };
  EXPECT_THAT(compiled({}), HasSubstr("G01 X-4.4 Y1.8\n"));
  const std::string fine = compiled({"--set", "unit=0.001", "--set", "line_end=crlf"});
  EXPECT_THAT(fine, HasSubstr("G01 X-4.450 Y1.800\r\n"));
  EXPECT_EQ(compiled({"--set", "unit=0.001", "line_end=crlf"}), fine);
  EXPECT_EQ(compiled({"--set=unit=1", "--set", "decimals=3", "--set", "line_end=crlf"}), fine);
}

TEST(DgtCompile, ASettingBeforeTheFileDoesNotSwallowIt) {
  EXPECT_EQ(
      run_dgt({"compile", "--post", "essi", "--set", "unit=0.01", corpus("1P.bgt")}).exit_code,
      kDone);
}

TEST(DgtCompile, AWrongSettingIsWrongUsageAndNamesTheNearest) {
  const auto fault = [](const std::string& setting) {
    const Outcome outcome =
        run_dgt({"compile", corpus("1P.bgt"), "--post", "essi", "--set", setting});
    EXPECT_EQ(outcome.exit_code, kWrongUsage);
    EXPECT_THAT(outcome.out, IsEmpty());
    return outcome.err;
  };
  EXPECT_EQ(fault("unit"), "dgt: error: 'unit' sets nothing; a setting is written key=value\n");
  EXPECT_EQ(fault("unti=1"), "dgt: error: there is no setting 'unti'; the nearest is 'unit'\n");
  EXPECT_THAT(fault("unit=wide"),
              StartsWith("dgt: error: the setting 'unit' cannot be 'wide'; it takes "));
}

TEST(DgtCompile, WhatTheDialectCannotSayIs1AndNothingIsWritten) {
  const TemporaryFolder folder;
  const std::string program = folder.write("high.bgt", "P1=X1 Y0\nK1 P1 Z5 X20 Y0\n");
  const Outcome outcome =
      run_dgt({"compile", program, "--post", "essi", "-o", folder.name("high.ess")});
  EXPECT_EQ(outcome.exit_code, kInputErrors);
  EXPECT_THAT(outcome.err, StartsWith(program + ":2:10: error: "));
  EXPECT_THAT(folder.entries(), ElementsAre("high.bgt"));
}

TEST(DgtPlot, WithoutANameTheDrawingGoesToStandardOutput) {
  EXPECT_THAT(run_dgt({"plot", corpus("1P.bgt")}).out, StartsWith("<?xml"));
}

TEST(DgtPlot, NamesElementsAsTheyAreCutAndFilletsByTheirWord) {
  const auto drawn = [](const std::string& program) {
    return run_dgt({"plot", "--names", corpus(program)}).out;
  };
  EXPECT_THAT(drawn("1P.bgt"), HasSubstr(">C2</text>"));
  EXPECT_THAT(drawn("4P-plain.bgt"), HasSubstr(">R3</text>"));
  // Turned by 15 degrees, the upper side is cut as L-3 and is nowhere else.
  EXPECT_THAT(drawn("rows/contour_a.bgt"), HasSubstr(">L-3</text>"));
  EXPECT_THAT(drawn("rows/contour_a.bgt"), Not(HasSubstr(">L3</text>")));
  EXPECT_THAT(run_dgt({"plot", corpus("1P.bgt")}).out, Not(HasSubstr("<text")));
}

TEST(DgtPlot, TheSizeIsThatOfTheLongerSide) {
  EXPECT_THAT(run_dgt({"plot", "--size", "500", corpus("rows/contour_w.bgt")}).out,
              HasSubstr("width=\"500\""));
  EXPECT_EQ(run_dgt({"plot", "--size", "0", corpus("1P.bgt")}).exit_code, kWrongUsage);
}

TEST(DgtDump, PrintsTheStagesAskedFor) {
  const auto dump = [](const std::string& flag) {
    return run_dgt({"dump", corpus("1P.bgt"), flag}).out;
  };
  const std::string tokens = dump("--tokens");
  const std::string ast = dump("--ast");
  const std::string elements = dump("--elements");
  EXPECT_THAT(elements, HasSubstr("C2"));
  EXPECT_NE(tokens, ast);
  EXPECT_EQ(run_dgt({"dump", corpus("1P.bgt"), "--elements", "--ast", "--tokens"}).out,
            tokens + ast + elements);
  EXPECT_THAT(run_dgt({"dump", corpus("1P.bgt")}).out, StartsWith("start X14"));
}

// --- messages -----------------------------------------------------------------------------------

TEST(DgtCommand, TheLanguageComesFromTheOptionThenFromTheLocale) {
  const auto message = [](const std::vector<std::string>& options,
                          const std::vector<std::string>& environment) {
    std::vector<std::string> words = {"check", "-"};
    words.insert(words.end(), options.begin(), options.end());
    return run_dgt(words, {.input = kFaulty, .environment = environment}).err;
  };
  const std::string english = message({}, {});
  const std::string russian = message({"--lang", "ru"}, {});
  EXPECT_NE(english, russian);
  EXPECT_THAT(russian, StartsWith("<stdin>:2:7: error: "));
  EXPECT_EQ(message({}, {"LC_ALL=ru_RU.UTF-8"}), russian);
  EXPECT_EQ(message({}, {"LC_ALL=", "LC_MESSAGES=ru_RU.UTF-8", "LANG=de_DE.UTF-8"}), russian);
  EXPECT_EQ(message({}, {"LC_ALL=de_DE.UTF-8", "LANG=ru_RU.UTF-8"}), english);
  EXPECT_EQ(message({"--lang", "en"}, {"LC_ALL=ru_RU.UTF-8"}), english);
}

TEST(DgtCommand, ColourOnlyWhenAskedForWhereThereIsNoTerminal) {
  const auto message = [](const std::vector<std::string>& options) {
    std::vector<std::string> words = {"check", "-"};
    words.insert(words.end(), options.begin(), options.end());
    return run_dgt(words, {.input = kFaulty, .environment = {"NO_COLOR=1"}}).err;
  };
  EXPECT_THAT(message({}), Not(HasSubstr("\x1b[")));
  EXPECT_THAT(message({"--color", "always"}), HasSubstr("\x1b["));
  EXPECT_THAT(message({"--color", "never"}), Not(HasSubstr("\x1b[")));
}

}  // namespace
}  // namespace dgt
