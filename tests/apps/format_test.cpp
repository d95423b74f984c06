// SPDX-License-Identifier: GPL-3.0-or-later
//
// dgt format as a script sees it: what is written where, and in which bytes.
#include <gmock/gmock.h>

#include "tests/support/command.h"

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

constexpr const char* kMessy = "l 1=Y 2 'a\n\n\nk1 L1,\n";
constexpr const char* kTidy = "L1=Y2  'a\n\nK1 L1\n";
constexpr const char* kFaulty = "L1=Y2 ?\n";

TEST(DgtFormat, HasHelpAndReadsStandardInput) {
  EXPECT_THAT(run_dgt({"format", "--help"}).out, AllOf(HasSubstr("FILE"), HasSubstr("--check")));
  const Outcome outcome = run_dgt({"format", "-"}, {.input = kMessy});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, kTidy);
  EXPECT_THAT(outcome.err, IsEmpty());
}

TEST(DgtFormat, WritesOneFileToAnother) {
  const TemporaryFolder folder;
  const std::string source = folder.write("part.bgt", kMessy);
  const Outcome outcome = run_dgt({"format", source, "-o", folder.name("out.bgt")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_EQ(read_text(folder.name("out.bgt")), kTidy);
  EXPECT_EQ(read_text(source), kMessy);
}

TEST(DgtFormat, WritesManyInPlaceAndRefusesTheFaulty) {
  const TemporaryFolder folder;
  const std::string faulty = folder.write("a.bgt", kFaulty);
  const std::string messy = folder.write("b.bgt", kMessy);
  const std::string macro = folder.write("c.MAC", kMessy);
  const Outcome outcome = run_dgt({"format", "--in-place", faulty, messy, macro});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr(faulty + ":1:7: error: "));
  EXPECT_EQ(read_text(faulty), kFaulty);
  EXPECT_EQ(read_text(messy), kTidy);
  EXPECT_EQ(read_text(macro), kTidy);
  EXPECT_THAT(folder.entries(), ElementsAre("a.bgt", "b.bgt", "c.MAC"));
}

TEST(DgtFormat, RefusesAFaultyFileAndWritesNothing) {
  const TemporaryFolder folder;
  const std::string faulty = folder.write("a.bgt", kFaulty);
  const Outcome outcome = run_dgt({"format", faulty, "-o", folder.name("out.bgt")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(run_dgt({"format", faulty}).out, IsEmpty());
  EXPECT_THAT(folder.entries(), ElementsAre("a.bgt"));
}

TEST(DgtFormat, ChecksWithoutWriting) {
  const TemporaryFolder folder;
  const std::string messy = folder.write("messy.bgt", kMessy);
  const std::string tidy = folder.write("tidy.bgt", kTidy);
  const Outcome outcome = run_dgt({"format", "--check", tidy, messy});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "dgt: error: " + messy + " is not in canonical layout\n");
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_EQ(read_text(messy), kMessy);
  EXPECT_EQ(run_dgt({"format", "--check", tidy}).exit_code, 0);
}

TEST(DgtFormat, WrongUsageIs2) {
  const TemporaryFolder folder;
  const std::string a = folder.write("a.bgt", kTidy);
  const std::string other = folder.write("a.nc", "G0 X1 Y2\n");
  const std::vector<std::vector<std::string>> calls = {
      {"format"},
      {"format", other},
      {"format", a, a},
      {"format", a, a, "-o", folder.name("b.bgt")},
      {"format", a, "--check", "--in-place"},
      {"format", a, "--in-place", "-o", folder.name("b.bgt")}};
  for (const auto& call : calls) {
    const Outcome outcome = run_dgt(call);
    EXPECT_EQ(outcome.exit_code, 2) << ::testing::PrintToString(call);
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_THAT(outcome.err, Not(IsEmpty()));
  }
  EXPECT_THAT(folder.entries(), ElementsAre("a.bgt", "a.nc"));
}

TEST(DgtFormat, KeepsEncodingMarksAndLineEnds) {
  const TemporaryFolder folder;
  // "' Пробная деталь для станка" and a Cyrillic С before `1`, in Windows-1251, with CRLF, Ctrl+Z.
  const std::string words =
      "' \xCF\xF0\xEE\xE1\xED\xE0\xFF \xE4\xE5\xF2\xE0\xEB\xFC \xE4\xEB\xFF \xF1\xF2\xE0\xED\xEA"
      "\xE0\r\n";
  const std::string source = folder.write("a.bgt", words + "\xD1 1=X0 Y0 R.5\r\n\x1A");
  const Outcome outcome = run_dgt({"format", "--in-place", source});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(read_text(source), words + "C1=X0 Y0 R0.5\r\n\x1A");

  const std::string marked = folder.write("b.bgt", "\xEF\xBB\xBF' т\rl1=X0\r");
  EXPECT_EQ(run_dgt({"format", marked}).out, "\xEF\xBB\xBF' т\rL1=X0\r");
}

TEST(DgtFormat, ReadsAForcedEncoding) {
  // 0x91 is С in CP866, a quotation mark in Windows-1251.
  const Outcome outcome =
      run_dgt({"format", "--encoding", "cp866", "-"}, {.input = "\x91 1=X0 Y0 R5\n"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "C1=X0 Y0 R5\n");
}

TEST(DgtFormat, TheCommandKeepsTheToolPathOfTheSamples) {
  const TemporaryFolder folder;
  for (const char* const name : {"1P", "2P", "3P", "4P", "5P"}) {
    const std::string source = corpus(std::string(name) + ".bgt");
    const std::string tidy = folder.name(std::string(name) + ".bgt");
    ASSERT_EQ(run_dgt({"format", source, "-o", tidy}).exit_code, 0);
    EXPECT_EQ(run_dgt({"compile", tidy, "--post", "essi"}).out,
              run_dgt({"compile", source, "--post", "essi"}).out)
        << name;
  }
}

}  // namespace
}  // namespace dgt
