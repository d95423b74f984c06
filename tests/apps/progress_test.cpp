// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a person at a terminal sees of long work, and nobody else.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <regex>
#include <string>
#include <vector>

#include "tests/support/command.h"

namespace dgt {
namespace {

using support::Outcome;
using support::run_dgt;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

constexpr int kLines = 20'000;
const std::string kClearLine = "\r\x1b[K";

std::string zigzag() {
  std::string text = "G21 G90\nG00 X0 Y0\nM03\n";
  for (int i = 0; i < kLines; ++i) text += fmt::format("G01 X{}.5 Y{}\n", i, i % 2);
  return text + "M02\n";
}

/// The numbers behind `what` in lines of their own, in order.
std::vector<int> percentages(const std::string& seen, const std::string& what) {
  const std::regex line("\r\x1b\\[K" + what + " (\\d+) %(?=\r)");
  std::vector<int> all;
  for (std::sregex_iterator at(seen.begin(), seen.end(), line), end; at != end; ++at)
    all.push_back(std::stoi((*at)[1]));
  return all;
}

void expect_rising(const std::vector<int>& percents) {
  ASSERT_THAT(percents, Not(IsEmpty()));
  EXPECT_GT(percents.front(), 0);
  EXPECT_LE(percents.back(), 100);
  for (std::size_t i = 1; i < percents.size(); ++i) EXPECT_LT(percents[i - 1], percents[i]);
}

class ProgressOnATerminal : public ::testing::Test {
 protected:
  Outcome run(std::vector<std::string> arguments, bool on_terminal = true) {
    return run_dgt(arguments, {.on_terminal = on_terminal});
  }

  support::TemporaryFolder folder_;
  std::string program_ = folder_.write("long.ngc", zigzag());
  std::string written_ = folder_.name("out.ngc");
};

TEST_F(ProgressOnATerminal, TellsHowMuchIsReadWrittenAndProvedInOneLine) {
  const Outcome convert = run({"convert", program_, "--to", "linuxcnc", "-o", written_});
  ASSERT_EQ(convert.exit_code, 0) << convert.err;
  expect_rising(percentages(convert.err, "reading long.ngc …"));
  expect_rising(percentages(convert.err, "writing long.ngc …"));
  EXPECT_THAT(convert.err.substr(0, convert.err.rfind(" %")), Not(HasSubstr("\n")));

  const Outcome verify = run({"verify", written_, "--against", program_});
  ASSERT_EQ(verify.exit_code, 0) << verify.err;
  expect_rising(percentages(verify.err, "proving out.ngc …"));
  EXPECT_TRUE(verify.err.ends_with(kClearLine));
}

TEST_F(ProgressOnATerminal, TellsHowMuchIsReadOfEveryLanguage) {
  std::string essi = "53\n";
  std::string dgt = "G54 X0 Y0\n";
  std::string three_b;
  for (int i = 1; i <= kLines; ++i) {
    essi += "+10+10\n";
    three_b += "B10B0B10GXL1\n";
    dgt += fmt::format("P{}=X{} Y1\n", i % 1000, i);
  }
  const Outcome of_essi = run({"check", folder_.write("long.ess", essi + "54\n")});
  expect_rising(percentages(of_essi.err, "reading long.ess …"));
  const Outcome of_three_b = run({"check", folder_.write("long.3b", three_b + "DD\n")});
  expect_rising(percentages(of_three_b.err, "reading long.3b …"));
  const Outcome of_dgt = run({"check", folder_.write("long.bgt", dgt)});
  expect_rising(percentages(of_dgt.err, "reading long.bgt …"));
}

TEST_F(ProgressOnATerminal, IsToldInRussianToo) {
  const Outcome check = run({"check", program_, "--lang", "ru"});
  expect_rising(percentages(check.err, "чтение long.ngc …"));
}

TEST_F(ProgressOnATerminal, IsNotToldElsewhereNorInALog) {
  EXPECT_THAT(run({"check", program_}, false).err, Not(HasSubstr("reading")));
  EXPECT_THAT(run({"check", program_, "--diagnostics", "sarif"}).err, Not(HasSubstr("reading")));
}

TEST_F(ProgressOnATerminal, IsNotPaintedMoreThanTenTimesASecond) {
  // What is shown within one tenth of a second is one line; the stages begin anew.
  const Outcome check = run({"check", program_});
  EXPECT_THAT(percentages(check.err, "reading long.ngc …"), SizeIs(::testing::Lt(kLines / 1024)));
}

}  // namespace
}  // namespace dgt
