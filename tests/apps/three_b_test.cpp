// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs in 3B, written here and by others: read back, proved, written again.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <random>
#include <sstream>

#include "apps/driver/certificate.h"
#include "lang/text/render.h"
#include "post/write.h"
#include "tests/support/command.h"

namespace dgt {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Kind = VerifyFault::Kind;

const Dialect& three_b() { return *find_dialect("3b"); }

Compilation read(const std::string& text) { return compile_bytes("a.3b", text, SourceSettings{}); }
Certificate prove(const Compilation& program, const Compilation& exact) {
  return verify(program, exact, "3b", limits_of(three_b()));
}

/// Everything of the corpus that has a path, by its name.
std::map<std::string, Compilation> corpus() {
  std::map<std::string, Compilation> programs;
  for (const auto& entry : fs::recursive_directory_iterator(support::corpus(""))) {
    const fs::path name = entry.path().lexically_relative(support::corpus(""));
    if (!entry.is_regular_file() || *name.begin() == "golden" || !language_of(name.string()))
      continue;
    auto made = compile_file(entry.path().string(), SourceSettings{});
    if (made && made->result.path) programs.emplace(name.string(), *std::move(made));
  }
  return programs;
}

TEST(ThreeBPrograms, TheWholeCorpusComesBackByteForByteAndIsProved) {
  // What 3B has no words for: heights, dwells, codes, numbers of more than six digits.
  const std::map<std::string, WriteFault::Kind> refused = {
      {"dxf/blocks.dxf", WriteFault::Kind::BeyondLargest},
      {"rows/contour_lzl.bgt", WriteFault::Kind::HeightImpossible},
      {"rows/contour_m.bgt", WriteFault::Kind::UnknownCode},
      {"rows/contour_t.bgt", WriteFault::Kind::DwellImpossible},
      {"rows/contour_z.bgt", WriteFault::Kind::HeightImpossible}};
  std::size_t proved = 0;
  std::map<std::string, WriteFault::Kind> not_written;
  for (const auto& [name, exact] : corpus()) {
    const WriteResult written = write(*exact.result.path, three_b());
    if (!written.faults.empty()) {
      not_written.emplace(name, written.faults.front().kind);
      continue;
    }
    const Compilation program = read(written.text);
    ASSERT_TRUE(program.result.path.has_value()) << name << "\n" << render(program.bag);
    EXPECT_EQ(write(*program.result.path, three_b()).text, written.text) << name;
    const Certificate proof = prove(program, exact);
    EXPECT_TRUE(proof.holds()) << name << "\n" << to_text(proof, Language::English);
    EXPECT_LE(proof.deviation.value, written.report.deviation * 1.5 + 1e-8) << name;
    ++proved;
  }
  EXPECT_EQ(not_written, refused);
  EXPECT_GT(proved, 120U);
}

/// Lines, arcs and whole circles of every size, as G-code.
std::string random_path(unsigned seed, int count) {
  std::mt19937 random(seed);
  const auto between = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  const auto rounded = [](double value) { return std::round(value * 1e6) / 1e6; };
  std::string text = "G21 G90\nG00 X0 Y0\n";
  double x = 0;
  double y = 0;
  for (int i = 0; i < count; ++i) {
    const double radius = std::pow(10, between(-1.9, 2));
    const double begin = between(0, 2 * std::numbers::pi);
    const double cx = radius * std::cos(begin);
    const double cy = radius * std::sin(begin);
    const char* const arc = i % 2 == 0 ? "G03" : "G02";
    if (i % 10 == 0) {
      text += fmt::format("{} I{:.6f} J{:.6f}\n", arc, cx, cy);
      continue;
    }
    const double sweep = (i % 2 == 0 ? 1 : -1) * std::pow(10, between(-2.5, 0.79));
    const bool is_arc = i % 3 != 0;
    const double step_x = is_arc ? cx - radius * std::cos(begin + sweep) : cx;
    const double step_y = is_arc ? cy - radius * std::sin(begin + sweep) : cy;
    x = rounded(x + step_x);
    y = rounded(y + step_y);
    text += is_arc ? fmt::format("{} X{:.6f} Y{:.6f} I{:.6f} J{:.6f}\n", arc, x, y, cx, cy)
                   : fmt::format("{} X{:.6f} Y{:.6f}\n", i % 7 == 0 ? "G00" : "G01", x, y);
    if (i % 11 == 0) text += "M00\n";
  }
  return text + "M02\n";
}

TEST(ThreeBPrograms, RandomPathsComeBackByteForByteAndAreProved) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Compilation exact = compile_bytes("a.ngc", random_path(seed, 200), SourceSettings{});
    ASSERT_TRUE(exact.result.path.has_value()) << render(exact.bag);
    const WriteResult written = write(*exact.result.path, three_b());
    ASSERT_TRUE(written.faults.empty());
    const Compilation program = read(written.text);
    ASSERT_TRUE(program.result.path.has_value()) << render(program.bag);
    EXPECT_EQ(write(*program.result.path, three_b()).text, written.text) << seed;
    const Certificate proof = prove(program, exact);
    EXPECT_TRUE(proof.holds()) << seed << "\n" << to_text(proof, Language::English);
    EXPECT_LE(proof.deviation.value, written.report.deviation * 1.5 + 1e-8);
  }
}

// --- one unit ------------------------------------------------------------------------------------

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Where the number behind the B that is `index`th on the line stands.
std::pair<std::size_t, std::size_t> number_of(const std::string& line, int index) {
  std::size_t at = 0;
  for (int i = 0; i < index; ++i) at = line.find('B', at) + 1;
  at = line.find('B', at) + 1;
  return {at, line.find_first_not_of("0123456789", at) - at};
}

/// Whether the program stops wherever the other does: then no more than the radius of an arc was
/// altered, by a unit, and that lies within what the curves may run apart.
bool stops_alike(const Compilation& a, const Compilation& b) {
  const std::vector<Move>& first = a.result.path->moves;
  const std::vector<Move>& second = b.result.path->moves;
  return std::ranges::equal(
      first, second, [](const Move& m, const Move& n) { return m.kind == n.kind && m.to == n.to; });
}

bool names(const Certificate& proof, std::size_t line) {
  return std::ranges::any_of(proof.faults, [line](const VerifyFault& fault) {
    return fault.first_line <= line && line <= fault.last_line;
  });
}
struct Tally {
  std::size_t tried = 0;
  std::size_t refused = 0;
  std::size_t alike = 0;
};

void alter_every_number(const std::string& name, const Compilation& exact, const std::string& text,
                        Tally& tally) {
  const Compilation original = read(text);
  const std::vector<std::string> lines = lines_of(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i][0] != 'B') continue;
    for (const int index : {0, 1, 2}) {
      for (const int by : {-1, 1}) {
        const auto [at, length] = number_of(lines[i], index);
        const long number = std::stol(lines[i].substr(at, length)) + by;
        if (number < 0) continue;
        std::string altered;
        for (const std::string& line : lines) {
          std::string copy = line;
          if (&line == &lines[i]) copy.replace(at, length, std::to_string(number));
          altered += copy + "\n";
        }
        ++tally.tried;
        const Compilation program = read(altered);
        if (!program.result.path) {
          ++tally.refused;
          const auto is_here = [&](const Diagnostic& diagnostic) {
            return diagnostic.range.place().line == i + 1;
          };
          EXPECT_TRUE(std::ranges::any_of(program.bag.all(), is_here)) << name << ":" << i + 1;
          continue;
        }
        if (stops_alike(original, program)) {
          ++tally.alike;
          continue;
        }
        const Certificate proof = prove(program, exact);
        EXPECT_TRUE(!proof.holds() && names(proof, i + 1))
            << name << ":" << i + 1 << ": " << lines[i] << ", number " << index << " by " << by
            << "\n"
            << to_text(proof, Language::English);
      }
    }
  }
}

TEST(ThreeBPrograms, OneUnitInOneNumberIsRefusedOrFoundAndTheBlockNamed) {
  Tally tally;
  for (const auto& [name, exact] : corpus()) {
    const WriteResult written = write(*exact.result.path, three_b());
    if (written.faults.empty() && written.text.size() < 2000)
      alter_every_number(name, exact, written.text, tally);
  }
  RecordProperty("refused", static_cast<int>(tally.refused));
  RecordProperty("alike", static_cast<int>(tally.alike));
  EXPECT_GT(tally.tried, 3000U);
  EXPECT_GT(tally.refused, tally.tried / 3);
  EXPECT_LT(tally.alike, tally.tried / 10);
}

// --- programs of others -------------------------------------------------------------------------

TEST(ThreeBPrograms, AnArcThatControlsEndApartIsNotProved) {
  const Compilation exact =
      compile_bytes("a.ngc", "G21 G91\nG03 X-100.2 Y0 I-50.1 J-0.1\nM02\n", SourceSettings{});
  const Compilation program = read("B50100B100B100000GYNR1\nDD\n");
  ASSERT_TRUE(program.result.path.has_value());
  const Certificate proof = prove(program, exact);
  ASSERT_EQ(proof.faults.size(), 1U) << to_text(proof, Language::English);
  EXPECT_EQ(proof.faults[0].kind, Kind::EndOpen);
  EXPECT_EQ(proof.faults[0].first_line, 1U);
  EXPECT_THAT(
      to_text(proof, Language::English),
      HasSubstr("line 1: controls end this block up to 0.002000 mm apart; 0.001 is allowed"));
  EXPECT_THAT(
      to_text(proof, Language::Russian),
      HasSubstr("строка 1: разные станки закончат этот кадр в точках до 0.002000 мм друг от "
                "друга; допустимо 0.001"));
  EXPECT_THAT(to_json(proof), HasSubstr("\"end-open\""));
}

TEST(ThreeBCommand, ReadsConvertsAndProvesByTheExtension) {
  const support::TemporaryFolder folder;
  const std::string part = support::corpus("kvad-square.bgt");
  const std::string program = folder.name("part.3B");
  ASSERT_EQ(support::run_dgt({"compile", part, "--post", "3b", "-o", program}).exit_code, 0);
  EXPECT_THAT(support::run_dgt({"verify", program, "--against", part}).out,
              HasSubstr("control    3b, unit 0.001 mm"));
  const auto converted = support::run_dgt({"convert", program, "--to", "linuxcnc"});
  EXPECT_EQ(converted.exit_code, 0);
  EXPECT_THAT(converted.out, HasSubstr("G00 X7.000 Y5.000\n"));
  for (const char* verb : {"check", "dump", "info", "path", "plot"})
    EXPECT_EQ(support::run_dgt({verb, program}).exit_code, 0) << verb;
}

TEST(ThreeBCommand, TheUnitAndTheMeaningOfDAreSettings) {
  const support::TemporaryFolder folder;
  const std::string program = folder.write("a.txt", "B100B0B100GXL1\nD\nB0B100B100GYL2\nDD\n");
  const auto dump = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"dump", "--from", "3b", program});
    return support::run_dgt(arguments).out;
  };
  EXPECT_THAT(dump({}), HasSubstr("rapid X0.100000 Y0.100000"));
  EXPECT_THAT(dump({"--set", "3b.unit=0.01"}), HasSubstr("rapid X1.000000 Y1.000000"));
  EXPECT_THAT(dump({"--set", "3b.pause=stop"}), HasSubstr("line X0.100000 Y0.100000"));
  const std::string machine = folder.write("m.toml", "[3b]\nunit = 0.01\npause = 'stop'\n");
  EXPECT_THAT(dump({"--machine", machine}), HasSubstr("line X1.000000 Y1.000000"));
}

}  // namespace
}  // namespace dgt
