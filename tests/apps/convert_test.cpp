// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

#include "apps/driver/pipeline.h"
#include "post/write.h"
#include "tests/support/command.h"

namespace dgt {
namespace {

using ::testing::HasSubstr;

/// Arcs of every size and sweep, as a CAM system would write them with six decimals.
std::string random_arcs(unsigned seed, int count) {
  std::mt19937 random(seed);
  const auto between = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  std::string text = "G21 G90\nG00 X0 Y0\n";
  double x = 0;
  double y = 0;
  const auto rounded = [](double value) { return std::round(value * 1e6) / 1e6; };
  for (int i = 0; i < count; ++i) {
    const double radius = std::pow(10, between(-1.5, 3.5));
    const double begin = between(0, 2 * std::numbers::pi);
    const double sense = i % 2 == 0 ? 1 : -1;
    const double sweep = sense * std::pow(10, between(-2.5, 0.79));
    const double cx = radius * std::cos(begin);
    const double cy = radius * std::sin(begin);
    x = rounded(x + cx - radius * std::cos(begin + sweep));
    y = rounded(y + cy - radius * std::sin(begin + sweep));
    text += fmt::format("{} X{:.6f} Y{:.6f} I{:.6f} J{:.6f}\n", sense > 0 ? "G03" : "G02", x, y, cx,
                        cy);
  }
  return text + "M02\n";
}

std::string written(const std::string& name, const std::string& text, const Dialect& dialect) {
  SourceSettings settings;
  if (name.ends_with(".iso")) settings.from = InputLanguage::EssiIso;
  const Compilation made = compile_bytes(name, text, settings);
  EXPECT_TRUE(made.result.path.has_value()) << dialect.name;
  return made.result.path ? write(*made.result.path, dialect).text : "";
}

TEST(Convert, ArcsOfEverySizeComeBackByteForByteInEveryDialect) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const std::string source = random_arcs(seed, 1000);
    for (Dialect dialect : dialects()) {
      dialect.largest = nullptr;  // the arcs go far
      const std::string name = dialect.form == Form::Gcode           ? "a.ngc"
                               : dialect.form == Form::ThreeB        ? "a.3b"
                               : dialect.arc_form == ArcForm::Centre ? "a.iso"
                                                                     : "a.ess";
      const std::string once = written("a.ngc", source, dialect);
      ASSERT_FALSE(once.empty());
      EXPECT_EQ(written(name, once, dialect), once) << dialect.name << ", seed " << seed;
    }
  }
}

TEST(Convert, TheStarIsTheSameInGcode) {
  const auto outcome =
      support::run_dgt({"convert", support::corpus("essi/star.ess"), "--to", "plasmatic"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("G91\nM07\nG01 X69.2 Y0.1\nG01 X-34.7 Y-59.9\n"));
  EXPECT_THAT(outcome.out, HasSubstr("M08\nM02\n"));
}

TEST(Convert, NcProgramsHaveNoWordsOrElementsOfDgt) {
  const std::string star = support::corpus("essi/star.ess");
  EXPECT_EQ(support::run_dgt({"dump", star}).exit_code, 0);
  const auto outcome = support::run_dgt({"dump", "--tokens", star});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("is no DGT source"));
}

TEST(Convert, WithoutADialectIsWrongUsage) {
  EXPECT_EQ(support::run_dgt({"convert", support::corpus("essi/star.ess")}).exit_code, 2);
}

TEST(Convert, AProgramWithAnErrorIsNotWritten) {
  const support::TemporaryFolder folder;
  const std::string out = folder.name("a.ngc");
  const auto outcome = support::run_dgt(
      {"convert", folder.write("a.ess", "-1000-1000+500++\n"), "--to", "linuxcnc", "-o", out});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(folder.entries(), std::vector<std::string>{"a.ess"});
}

}  // namespace
}  // namespace dgt
