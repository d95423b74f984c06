// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <filesystem>

#include "tests/support/command.h"

namespace dgt {
namespace {

namespace fs = std::filesystem;
using support::corpus;
using support::read_text;
using support::run_dgt;
using support::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kFaulty = "L1=Y2\nK1 L1 L2\n";

/// A folder of three programs, one of them in a folder below.
void fill(const TemporaryFolder& folder) {
  folder.write("a.bgt", read_text(corpus("1P.bgt")));
  folder.write("b.bgt", read_text(corpus("2P.bgt")));
  fs::create_directory(folder.path() / "sub");
  folder.write("sub/c.ess", read_text(corpus("essi/star.ess")));
  folder.write("notes.txt", "no program\n");
}

TEST(Batch, WritesEveryProgramAsCompileDoes) {
  const TemporaryFolder folder;
  fill(folder);
  const TemporaryFolder out;
  const auto outcome =
      run_dgt({"batch", folder.path(), "--post", "linuxcnc", "-o", out.path(), "--jobs", "3"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("3 programs, 0 failed"));
  EXPECT_EQ(read_text(out.name("a.ngc")),
            run_dgt({"compile", folder.name("a.bgt"), "--post", "linuxcnc"}).out);
  EXPECT_TRUE(fs::exists(out.path() / "sub" / "c.ngc"));
  EXPECT_FALSE(fs::exists(out.path() / "notes.ngc"));
}

TEST(Batch, SaysTheSameHoweverManyWork) {
  const TemporaryFolder folder;
  fill(folder);
  for (int i = 0; i < 20; ++i)
    folder.write("n" + std::to_string(i) + ".bgt", i % 3 == 0 ? kFaulty : "L1=Y2\n");
  const TemporaryFolder out;
  const auto with = [&](const char* jobs) {
    return run_dgt({"batch", folder.path(), "--post", "essi", "-o", out.path(), "--jobs", jobs});
  };
  const auto one = with("1");
  const auto many = with("4");
  EXPECT_EQ(one.exit_code, 1);
  EXPECT_EQ(one.out, many.out);
  EXPECT_EQ(one.err, many.err);
}

TEST(Batch, AFaultyProgramHoldsUpNoOther) {
  const TemporaryFolder folder;
  folder.write("a.bgt", kFaulty);
  folder.write("b.bgt", read_text(corpus("1P.bgt")));
  const TemporaryFolder out;
  const auto outcome = run_dgt({"batch", folder.path(), "--post", "essi", "-o", out.path()});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("failed"));
  EXPECT_EQ(out.entries(), std::vector<std::string>{"b.ess"});
}

TEST(Batch, PatternsChooseByName) {
  const TemporaryFolder folder;
  fill(folder);
  const TemporaryFolder out;
  const auto outcome = run_dgt(
      {"batch", folder.name("?.bgt"), folder.name("b*"), "--post", "essi", "-o", out.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(out.entries(), (std::vector<std::string>{"a.ess", "b.ess"}));
}

TEST(Batch, TwoProgramsForOneFileAreWrongUsage) {
  const TemporaryFolder folder;
  folder.write("a.bgt", read_text(corpus("1P.bgt")));
  folder.write("a.dgt", read_text(corpus("2P.bgt")));
  const TemporaryFolder out;
  const auto outcome = run_dgt({"batch", folder.path(), "--post", "essi", "-o", out.path()});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("would both be written to"));
  EXPECT_TRUE(out.entries().empty());
}

TEST(Batch, NothingThereIsWrongUsage) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_dgt({"batch", folder.name("*.bgt"), "--post", "essi", "-o", folder.name("out")})
                .exit_code,
            2);
}

// --- drawings

TEST(PlotFile, IsWhatItsNameSays) {
  const TemporaryFolder folder;
  const auto drawn = [&](const std::string& name) {
    const std::string file = folder.name(name);
    EXPECT_EQ(run_dgt({"plot", corpus("1P.bgt"), "-o", file}).exit_code, 0) << name;
    return read_text(file);
  };
  EXPECT_EQ(drawn("a.png").substr(1, 3), "PNG");
  EXPECT_EQ(drawn("a.pdf").substr(0, 5), "%PDF-");
  EXPECT_EQ(drawn("a.pdf"), drawn("b.PDF"));
  EXPECT_EQ(drawn("a.png"), drawn("b.png"));
}

TEST(PlotFile, PngHasTheSizeThatIsAskedFor) {
  const TemporaryFolder folder;
  const std::string file = folder.name("a.png");
  ASSERT_EQ(run_dgt({"plot", corpus("1P.bgt"), "--size", "300", "-o", file}).exit_code, 0);
  const std::string bytes = read_text(file);
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  EXPECT_EQ(std::max(at(18) * 256 + at(19), at(22) * 256 + at(23)), 300);
}

TEST(PlotFile, DxfHasTrueArcsOnItsLayers) {
  const TemporaryFolder folder;
  const std::string source =
      folder.write("a.ngc", "G90\nG00 X5 Y3\nM07\nG03 X5 Y3 J2\nG02 X7 Y5 I2\nM08\nG00 X0\nM02\n");
  const std::string file = folder.name("a.dxf");
  ASSERT_EQ(run_dgt({"plot", source, "-o", file}).exit_code, 0);
  const std::string text = read_text(file);
  EXPECT_THAT(text, HasSubstr("\nCIRCLE\n8\nEQUIDISTANT\n10\n5.0\n20\n5.0\n30\n0.0\n40\n2.0\n"));
  // Clockwise from (5, 3) about (7, 3) to (7, 5): DXF runs it the other way about.
  EXPECT_THAT(text,
              HasSubstr("\nARC\n8\nEQUIDISTANT\n10\n7.0\n20\n3.0\n30\n0.0\n40\n2.0\n50\n90.0\n"
                        "51\n180.0\n"));
  EXPECT_THAT(text, HasSubstr("\nLINE\n8\nRAPIDS\n"));
  EXPECT_THAT(text, HasSubstr("\n0\nEOF\n"));
}

}  // namespace
}  // namespace dgt
