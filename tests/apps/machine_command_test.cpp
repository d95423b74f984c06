// SPDX-License-Identifier: GPL-3.0-or-later
//
// --machine and --set as a script sees them.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/command.h"

namespace dgt {
namespace {

using support::corpus;
using support::Outcome;
using support::run_dgt;
using support::TemporaryFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

constexpr int kDone = 0;
constexpr int kInputErrors = 1;
constexpr int kWrongUsage = 2;
constexpr int kFailure = 3;

const std::vector<std::string> kVerbs = {"compile", "check", "path", "dump",
                                         "points",  "info",  "plot"};

Outcome run(const std::string& verb, std::vector<std::string> options,
            const std::string& program = corpus("1P.bgt")) {
  options.insert(options.begin(), {verb, program});
  return run_dgt(options);
}

TEST(DgtMachine, EveryVerbThatExecutesTakesIt) {
  const TemporaryFolder folder;
  const std::string machine = folder.write("m.toml", "dialect = 'essi'\nmax_moves = 3\n");
  for (const std::string& verb : kVerbs) {
    const Outcome refused = run(verb, {"--machine", machine});
    EXPECT_EQ(refused.exit_code, kInputErrors) << verb;
    EXPECT_THAT(refused.err, HasSubstr("more than 3 moves [DGT0611]")) << verb;
    const Outcome done = run(verb, {"--machine", machine, "--set", "max_moves=1000"});
    EXPECT_EQ(done.exit_code, kDone) << verb << done.err;
  }
}

TEST(DgtMachine, TheWireMachineNeedsNoPost) {
  const Outcome outcome = run("compile", {"--machine", corpus("machine/wire.toml")});
  EXPECT_EQ(outcome.exit_code, kDone) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("G21 G90 G17 G40 G91.1\nG00 X14.0000 Y0.0000\nG01 "));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr(" F2.5\n"), Not(HasSubstr("M07"))));
}

TEST(DgtMachine, PostAndSetWinOverTheFile) {
  const std::string machine = corpus("machine/wire.toml");
  const auto out = [&](const std::vector<std::string>& more) {
    std::vector<std::string> options = {"--machine", machine};
    options.insert(options.end(), more.begin(), more.end());
    const Outcome outcome = run("compile", options);
    EXPECT_EQ(outcome.exit_code, kDone) << outcome.err;
    return outcome.out;
  };
  EXPECT_THAT(out({"--set", "unit=0.001"}), HasSubstr("\nG00 X14.000 Y0.000\n"));
  EXPECT_THAT(out({"--post", "plasmatic", "--set", "torch=auto"}),
              AllOf(StartsWith("G21\nG91\nM07\n"), HasSubstr("G01 X-4.4497")));
  EXPECT_EQ(out({"--set", "dialect=plasmatic", "--set", "torch=auto"}),
            out({"--post", "plasmatic", "--set", "torch=auto"}));
}

TEST(DgtMachine, TheOffsetSideIsTheSourcesThenTheOptionsThenSetsThenTheFiles) {
  const TemporaryFolder folder;
  const std::string machine = folder.write("m.toml", "offset_side = 'left'\n");
  const std::string text = support::read_text(corpus("1P.bgt"));
  const std::string plain = folder.write("plain.bgt", text);
  const std::string directed = folder.write("directed.bgt", "'@ offset-side left\n" + text);
  const auto side = [&](const std::string& program, const std::vector<std::string>& options) {
    const Outcome outcome = run("path", options, program);
    EXPECT_EQ(outcome.exit_code, kDone) << outcome.err;
    const auto path = nlohmann::json::parse(outcome.out, nullptr, false);
    return path.is_discarded() ? "" : path["contours"][0]["side"].get<std::string>();
  };
  EXPECT_EQ(side(plain, {}), "right");
  EXPECT_EQ(side(plain, {"--machine", machine}), "left");
  EXPECT_EQ(side(plain, {"--machine", machine, "--set", "offset_side=right"}), "right");
  EXPECT_EQ(side(plain, {"--set", "offset_side=right", "--offset-side", "left"}), "left");
  EXPECT_EQ(side(directed, {"--set", "offset_side=right", "--offset-side", "right"}), "left");
}

TEST(DgtMachine, MacrosComeFromTheMachinesFoldersToo) {
  const TemporaryFolder folder;
  const std::string program =
      folder.write("call.bgt", support::read_text(corpus("kvad-square.bgt")));
  EXPECT_EQ(run("dump", {}, program).exit_code, kInputErrors);
  EXPECT_EQ(run("dump", {"--machine", corpus("machine/wire.toml")}, program).exit_code, kDone);
  EXPECT_EQ(run("dump", {"--set", "macro_path=/:" + corpus("mac")}, program).exit_code, kDone);
}

TEST(DgtMachine, AFaultyFileIs1WithPlacesOnceHoweverManyPrograms) {
  const TemporaryFolder folder;
  const std::string machine = folder.write("m.toml", "unit = wide\n");
  for (const std::string& verb : kVerbs) {
    const Outcome outcome = run(verb, {"--machine", machine});
    EXPECT_EQ(outcome.exit_code, kInputErrors) << verb;
    EXPECT_THAT(outcome.out, IsEmpty()) << verb;
    EXPECT_THAT(outcome.err, StartsWith(machine + ":1:8: error: ")) << verb;
  }
  EXPECT_EQ(run("check", {corpus("5P.bgt"), "--machine", machine}).err,
            run("check", {"--machine", machine}).err);
}

TEST(DgtMachine, AFileThatCannotBeReadIs3) {
  const TemporaryFolder folder;
  for (const std::string& verb : kVerbs) {
    const Outcome outcome = run(verb, {"--machine", folder.name("no.toml")});
    EXPECT_EQ(outcome.exit_code, kFailure) << verb;
    EXPECT_EQ(outcome.err,
              "dgt: error: " + folder.name("no.toml") + ": No such file or directory\n");
  }
}

TEST(DgtMachine, AWrongSettingOnTheCommandLineIs2ForEveryVerb) {
  for (const std::string& verb : kVerbs) {
    const Outcome outcome = run(verb, {"--set", "max_move=5"});
    EXPECT_EQ(outcome.exit_code, kWrongUsage) << verb;
    EXPECT_EQ(outcome.err,
              "dgt: error: there is no setting 'max_move'; the nearest is 'max_moves'\n");
  }
}

TEST(DgtMachine, SomethingMustSayTheDialect) {
  const Outcome outcome = run("compile", {});
  EXPECT_EQ(outcome.exit_code, kWrongUsage);
  EXPECT_EQ(outcome.err,
            "dgt: error: nothing says which dialect to write; say '--post NAME' or set 'dialect' "
            "in the machine file; they are essi, essi-iso, plasmatic, linuxcnc, fanuc-wire, grbl, "
            "3b\n");
}

}  // namespace
}  // namespace dgt
