// SPDX-License-Identifier: GPL-3.0-or-later
//
// dgt check over many programs, --fix, and diagnostics as SARIF.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/support/command.h"

namespace dgt {
namespace {

using nlohmann::json;
using support::corpus;
using support::Outcome;
using support::read_text;
using support::run_dgt;
using support::TemporaryFolder;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* kFaulty = "L1=Y2\nK1 L1 L2\n";

// --- many programs ------------------------------------------------------------------------------

TEST(DgtCheck, SumsUpSeveralPrograms) {
  const TemporaryFolder folder;
  const std::string faulty = folder.write("a.bgt", kFaulty);
  const Outcome outcome = run_dgt({"check", faulty, corpus("1P.bgt"), faulty});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, EndsWith("dgt: note: 3 programs checked, 2 with errors\n"));
  EXPECT_THAT(outcome.out, IsEmpty());
}

TEST(DgtCheck, SaysNothingOfASingleProgramThatIsRight) {
  const Outcome outcome = run_dgt({"check", corpus("rows/line_x.bgt"), "--offset-side", "left"});
  EXPECT_THAT(outcome.err, Not(HasSubstr("checked")));
}

// --- fixes --------------------------------------------------------------------------------------

TEST(DgtCheckFix, PutsAllReplacementsInPlaceAndTellsOfEach) {
  const TemporaryFolder folder;
  const std::string part = folder.write(
      "part.bgt", "С1=X0,5 Y0 R5 ' круг, С1\r\nP1=X4 Y0\r\nB1=\"C1 P-1\"\r\nK1 P1 B1\r\n");
  const Outcome outcome = run_dgt({"check", "--fix", part});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(read_text(part),
            "C1=X0.5 Y0 R5 ' круг, С1\r\nP1=X4 Y0\r\nB1=\"C1 P1,\"\r\nK1 P1 B1\r\n");
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("dgt: note: " + part + ":1:1: 'С' is now 'C' [DGT0103]\n"),
                    HasSubstr(part + ":1:6: ',' is now '.' [DGT0204]\n"),
                    HasSubstr(part + ":3:11: ',' put in [DGT0212]\n"),
                    HasSubstr(part + ":3:8: 'P-1' is now 'P1' [DGT0206]\n"),
                    Not(HasSubstr("error:")), Not(HasSubstr("warning:"))));
  EXPECT_THAT(folder.entries(), ElementsAre("part.bgt"));
}

TEST(DgtCheckFix, FixesAgainWhatAFixBringsToLight) {
  const TemporaryFolder folder;
  // The Cyrillic letter and the minus overlap.
  const std::string part = folder.write("part.bgt", "P1=X9 Y0\nP2=X9 Y5\nK1 Р-1 P2\n");
  const Outcome outcome = run_dgt({"check", "--fix", part});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(read_text(part), "P1=X9 Y0\nP2=X9 Y5\nK1 P1 P2\n");
}

TEST(DgtCheckFix, TakesOutASelectorThatSelectsNothing) {
  const Outcome outcome = run_dgt({"check", "--fix", "-"}, {.input = "L1=I2 X5\n"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "L1= X5\n");
  EXPECT_EQ(outcome.err, "dgt: note: <stdin>:1:4: 'I2' taken out [DGT0306]\n");
}

TEST(DgtCheckFix, WritesWhatItFixedThoughErrorsRemain) {
  const TemporaryFolder folder;
  const std::string part = folder.write("part.bgt", "С1=X0 Y0 R5\nK1 L9 C1\n");
  const Outcome outcome = run_dgt({"check", "--fix", part});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr(part + ":2:4: error: L9 is not defined here [DGT0308]\n"));
  EXPECT_EQ(read_text(part), "C1=X0 Y0 R5\nK1 L9 C1\n");
}

TEST(DgtCheckFix, LeavesWhatAWorkingProgramCutsToThePerson) {
  const std::string part =
      "L1=Y0\nL2=X40\nL3=Y30\nL4=X0\nP1=X20 Y-5\nG54 X20 Y-5\nK1 W0.2 P1 L1 L2 L-3 L4 L1 P1\n";
  const Outcome outcome = run_dgt({"check", "--fix", "-"}, {.input = part});
  EXPECT_THAT(outcome.err, HasSubstr("warning: L2 is cut against its direction"));
  EXPECT_EQ(outcome.out, part);
}

TEST(DgtCheckFix, LeavesAFileWithBytesThatAreNoTextAsItIs) {
  const TemporaryFolder folder;
  const std::string bytes = "P-1=X0,5 Y0 ' \xFF\n";
  const std::string part = folder.write("part.bgt", bytes);
  const Outcome outcome = run_dgt({"check", "--fix", "--encoding", "utf-8", part});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(read_text(part), bytes);
}

TEST(DgtCheckFix, KeepsTheEncoding) {
  const TemporaryFolder folder;
  const std::string words = "' \xCF\xF0\xEE\xE1\xED\xE0\xFF \xE4\xE5\xF2\xE0\xEB\xFC\r\n";
  const std::string part = folder.write("part.bgt", words +
                                                        "\xD1"
                                                        "1=X0 Y0 R5\r\n");
  EXPECT_EQ(run_dgt({"check", "--fix", part}).exit_code, 0);
  EXPECT_EQ(read_text(part), words + "C1=X0 Y0 R5\r\n");
}

// --- SARIF --------------------------------------------------------------------------------------

TEST(DgtSarif, OneLogHoldsTheDiagnosticsOfAllPrograms) {
  const TemporaryFolder folder;
  (void)folder.write("a.bgt", kFaulty);
  (void)folder.write("b.bgt", "С1=X0 Y0 R5\n");
  const Outcome outcome =
      run_dgt({"check", "a.bgt", "b.bgt", "--diagnostics", "sarif"}, {.folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, IsEmpty());
  const json log = json::parse(outcome.err);
  ASSERT_EQ(log.at("runs").size(), 1U);
  const json& run = log.at("runs").at(0);
  ASSERT_EQ(run.at("results").size(), 2U);
  EXPECT_EQ(run.at("results").at(0).at("ruleId"), "DGT0308");
  EXPECT_EQ(run.at("results").at(1).at("ruleId"), "DGT0103");
  EXPECT_EQ(run.at("artifacts").at(0).at("location").at("uri"), "a.bgt");
  EXPECT_EQ(run.at("artifacts").at(1).at("location").at("uri"), "b.bgt");
  EXPECT_FALSE(run.at("tool").at("driver").at("version").get<std::string>().empty());
  EXPECT_FALSE(run.contains("invocations"));
}

TEST(DgtSarif, FilesThatFailAreNotifications) {
  const Outcome outcome = run_dgt({"check", "no.bgt", corpus("1P.bgt"), "--diagnostics", "sarif"});
  EXPECT_EQ(outcome.exit_code, 3);
  const json log = json::parse(outcome.err);
  const json& invocation = log.at("runs").at(0).at("invocations").at(0);
  EXPECT_FALSE(invocation.at("executionSuccessful").get<bool>());
  EXPECT_EQ(invocation.at("toolExecutionNotifications").at(0).at("message").at("text"),
            "no.bgt: No such file or directory");
}

TEST(DgtSarif, CompileWritesItsResultBesideTheLog) {
  const std::vector<std::string> call = {"compile", corpus("1P.bgt"), "--post", "essi"};
  std::vector<std::string> as_sarif = call;
  as_sarif.insert(as_sarif.end(), {"--diagnostics", "sarif"});
  const Outcome outcome = run_dgt(as_sarif);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, run_dgt(call).out);
  const json log = json::parse(outcome.err);
  EXPECT_EQ(log.at("runs").at(0).at("results").at(0).at("level"), "note");
}

TEST(DgtSarif, ALogWithoutDiagnosticsIsALogToo) {
  const Outcome outcome = run_dgt({"format", "-", "--diagnostics", "sarif"}, {.input = "L1=X0\n"});
  EXPECT_EQ(outcome.out, "L1=X0\n");
  EXPECT_THAT(json::parse(outcome.err).at("runs").at(0).at("results"), IsEmpty());
}

}  // namespace
}  // namespace dgt
