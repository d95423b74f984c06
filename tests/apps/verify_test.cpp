// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/driver/certificate.h"
#include "post/write.h"
#include "tests/support/command.h"

namespace dgt {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Kind = VerifyFault::Kind;

Compilation read(const std::string& name, const std::string& text) {
  return compile_bytes(name, text, SourceSettings{});
}

/// The dialects whose settings for reading are the built-in ones.
std::vector<Dialect> plain_dialects() {
  return {*find_dialect("essi"), *find_dialect("plasmatic"), *find_dialect("linuxcnc"),
          *find_dialect("3b")};
}

std::string name_for(const Dialect& dialect) {
  if (dialect.form == Form::ThreeB) return "a.3b";
  return dialect.form == Form::Essi ? "a.ess" : "a.ngc";
}

Certificate prove(const std::string& text, const Compilation& exact, const Dialect& dialect) {
  return verify(read(name_for(dialect), text), exact, dialect.name, limits_of(dialect));
}

/// The programs of the corpus that compile.
std::vector<Compilation> corpus_programs() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(support::corpus("")))
    if (entry.path().extension() == ".bgt") files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<Compilation> programs;
  for (const fs::path& file : files) {
    auto made = compile_file(file.string(), SourceSettings{});
    if (made && made->result.path && !made->bag.has_errors()) programs.push_back(*std::move(made));
  }
  return programs;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// Where the number of an axis (0: X, 1: Y) stands in a block: of ESSI its first two fields.
std::optional<std::pair<std::size_t, std::size_t>> number_of(const std::string& line, int axis,
                                                             Form form) {
  const auto end_of = [&](std::size_t at) {
    return std::min(line.find_first_not_of("0123456789.", at), line.size());
  };
  if (form == Form::Essi) {
    if (line.empty() || (line[0] != '+' && line[0] != '-')) return std::nullopt;
    const std::size_t second = end_of(1);
    return axis == 0 ? std::pair<std::size_t, std::size_t>{0, second}
                     : std::pair{second, end_of(second + 1)};
  }
  const std::size_t at = line.find(axis == 0 ? 'X' : 'Y');
  if (at == std::string::npos || line.rfind("G04", 0) == 0) return std::nullopt;
  const std::size_t sign = line[at + 1] == '-' ? 1 : 0;
  return std::pair{at + 1, end_of(at + 1 + sign)};
}

/// The number one unit further; what one unit is shows in the number of its decimals.
std::string changed(const std::string& number, int by, const Dialect& dialect) {
  const Rational step = dialect.form == Form::Essi ? Rational(1) : dialect.unit;
  const std::string digits = number == "+" || number == "-" ? "0" : number;
  const Rational value = *parse_decimal(digits) + by * step;
  const std::string text = to_short_decimal(value);
  if (dialect.form != Form::Essi) return text;
  return sgn(value) == 0 ? "+" : sgn(value) > 0 ? "+" + text : text;
}

bool names(const Certificate& proof, std::size_t line) {
  return std::ranges::any_of(proof.faults, [line](const VerifyFault& fault) {
    return fault.first_line <= line && line <= fault.last_line;
  });
}

/// A stop inside a divided arc may lie anywhere along it.
bool inside_an_arc(const Certificate& proof, std::size_t line) {
  return std::ranges::any_of(proof.rows, [line](const Certificate::Row& row) {
    return row.first_line <= line && line < row.last_line;
  });
}

bool half_a_unit_off(const Certificate& proof, std::size_t line, int axis) {
  const double half = nearest_double(Rational(proof.limits.unit / 2));
  return std::ranges::any_of(proof.rows, [&](const Certificate::Row& row) {
    return row.last_line == line && (axis == 0 ? row.error_x : row.error_y) == half;
  });
}

TEST(Verify, EveryProgramOfTheCorpusIsProvedInEveryDialect) {
  for (const Compilation& exact : corpus_programs()) {
    for (const Dialect& dialect : plain_dialects()) {
      const WriteResult written = write(*exact.result.path, dialect);
      if (!written.faults.empty()) continue;
      const Certificate proof = prove(written.text, exact, dialect);
      EXPECT_TRUE(proof.holds()) << to_text(proof, Language::English);
      EXPECT_LE(proof.deviation.value, written.report.deviation * 1.5 + 1e-8)
          << dialect.name << ": " << exact.file->name();
    }
  }
}

/// One unit in one block, both axes, both ways, every block of every program. What is not found is
/// a stop half-way between two grid points, which may be rounded either way, and a stop inside a
/// divided arc that moves along it.
TEST(Verify, OneUnitInOneBlockIsFoundAndTheBlockNamed) {
  std::size_t tried = 0;
  std::size_t refused = 0;
  std::size_t half_way = 0;
  for (const Compilation& exact : corpus_programs()) {
    for (const Dialect& dialect : plain_dialects()) {
      if (dialect.form == Form::ThreeB) continue;  // tests/apps/three_b_test.cpp
      const WriteResult written = write(*exact.result.path, dialect);
      if (!written.faults.empty()) continue;
      const std::vector<std::string> lines = lines_of(written.text);
      for (std::size_t i = 0; i < lines.size(); ++i) {
        for (const int axis : {0, 1}) {
          const auto number = number_of(lines[i], axis, dialect.form);
          if (!number) continue;
          for (const int by : {-1, 1}) {
            std::vector<std::string> altered = lines;
            const std::size_t length = number->second - number->first;
            altered[i].replace(number->first, length,
                               changed(lines[i].substr(number->first, length), by, dialect));
            const Compilation program = read(name_for(dialect), joined(altered));
            ++tried;
            if (!program.result.path) {  // an arc that is none
              ++refused;
              continue;
            }
            const Certificate proof = verify(program, exact, dialect.name, limits_of(dialect));
            if (proof.holds()) {
              ++half_way;
              EXPECT_TRUE(half_a_unit_off(proof, i + 1, axis) || inside_an_arc(proof, i + 1))
                  << dialect.name << ", " << exact.file->name() << ":" << i + 1 << ": " << lines[i]
                  << " → " << altered[i] << "\n"
                  << to_text(proof, Language::English);
            } else {
              EXPECT_TRUE(names(proof, i + 1))
                  << dialect.name << ", " << exact.file->name() << ":" << i + 1 << ": " << lines[i]
                  << " → " << altered[i] << "\n"
                  << to_text(proof, Language::English);
            }
          }
        }
      }
    }
  }
  RecordProperty("tried", static_cast<int>(tried));
  RecordProperty("refused", static_cast<int>(refused));
  RecordProperty("half_way", static_cast<int>(half_way));
  EXPECT_GT(tried, 3000U);
  EXPECT_LT(half_way, tried / 20);
}

/// A square with a hole, small enough to be altered by hand.
const std::string kSquare =
    "G21 G90\nG00 X0 Y0\nM07\nG01 X10 Y0\nG01 X10 Y10\nG01 X0 Y10\nG01 X0 Y0\nM08\n"
    "G00 X5 Y3\nM07\nG03 X5 Y7 I0 J2\nG03 X5 Y3 I0 J-2\nM08\nM02\n";

Certificate of_square(const std::string& from, const std::string& to) {
  std::string text = kSquare;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos);
  text.replace(at, from.size(), to);
  const Dialect& dialect = *find_dialect("linuxcnc");
  return verify(read("a.ngc", text), read("b.ngc", kSquare), dialect.name, limits_of(dialect));
}

std::vector<Kind> kinds(const Certificate& proof) {
  std::vector<Kind> all;
  for (const VerifyFault& fault : proof.faults) all.push_back(fault.kind);
  return all;
}

TEST(Verify, AProgramRunsItself) {
  const Certificate proof = of_square("M02", "M02");
  EXPECT_TRUE(proof.holds());
  EXPECT_EQ(proof.moves, 7U);
  EXPECT_EQ(proof.closed, 2U);
  EXPECT_LT(proof.deviation.value, 1e-10);
}

TEST(Verify, AnArcRunTheOtherWayDeviates) {
  const Certificate proof = of_square("G03 X5 Y7 I0 J2", "G02 X5 Y7 I0 J2");
  ASSERT_EQ(kinds(proof), std::vector<Kind>{Kind::Deviates});
  EXPECT_EQ(proof.faults[0].first_line, 11U);
  EXPECT_GE(proof.faults[0].measure, 2);
}

TEST(Verify, ARapidForACutIsFound) {
  const Certificate proof = of_square("G01 X0 Y10", "G00 X0 Y10");
  ASSERT_FALSE(proof.holds());
  EXPECT_EQ(proof.faults[0].first_line, 6U);
}

TEST(Verify, ABlockLeftOutIsFound) {
  const Certificate proof = of_square("G01 X10 Y10\n", "");
  ASSERT_FALSE(proof.holds());
  EXPECT_EQ(proof.faults[0].first_line, 5U);
}

TEST(Verify, ABlockTooManyIsFound) {
  const Certificate proof = of_square("M08\nM02", "G01 X5 Y5\nM08\nM02");
  ASSERT_EQ(kinds(proof), std::vector<Kind>{Kind::Surplus});
  EXPECT_EQ(proof.faults[0].first_line, 13U);
}

TEST(Verify, AProgramThatEndsEarlyIsFound) {
  const Certificate proof = of_square("G03 X5 Y3 I0 J-2\n", "");
  ASSERT_FALSE(proof.holds());
  EXPECT_FALSE(proof.is_complete);
  EXPECT_EQ(proof.faults.back().kind, Kind::Ended);
}

TEST(Verify, ADigitMissingIsFoundAndWhatFollowsIsComparedAllTheSame) {
  const Certificate proof = of_square("G01 X10 Y10", "G01 X1 Y10");
  ASSERT_EQ(kinds(proof), std::vector<Kind>{Kind::Displaced});
  EXPECT_EQ(proof.faults[0].first_line, 5U);
  EXPECT_DOUBLE_EQ(proof.faults[0].dx, -9);
  EXPECT_TRUE(proof.is_complete);
}

TEST(Verify, AContourThatDoesNotCloseIsFound) {
  const Certificate proof = of_square("G01 X0 Y0", "G01 X0.001 Y0");
  ASSERT_EQ(kinds(proof), (std::vector<Kind>{Kind::Displaced, Kind::Open}));
  EXPECT_DOUBLE_EQ(proof.faults[1].dx, 0.001);
}

TEST(Verify, RadiiThatDifferMoreThanTheControlTakesAreFound) {
  const Certificate proof = of_square("G03 X5 Y7 I0 J2", "G03 X5 Y7 I0 J2.03");
  ASSERT_FALSE(proof.holds());
  EXPECT_EQ(proof.faults[0].kind, Kind::RadiusMismatch);
  EXPECT_EQ(proof.faults[0].first_line, 11U);
  EXPECT_NEAR(proof.mismatch.value, 0.06, 1e-9);
}

TEST(Verify, AFullCircleMatchesItsHalvesAndTheOtherWayAbout) {
  const std::string halves = "G21 G90\nG00 X5 Y3\nM07\nG03 X5 Y7 J2\nG03 X5 Y3 J-2\nM08\nM02\n";
  const std::string whole = "G21 G90\nG00 X5 Y3\nM07\nG03 X5 Y3 J2\nM08\nM02\n";
  const Dialect& dialect = *find_dialect("linuxcnc");
  EXPECT_TRUE(verify(read("a.ngc", halves), read("b.ngc", whole), dialect.name, limits_of(dialect))
                  .holds());
}

// --- the command

TEST(VerifyCommand, TellsTheProofAndFailsWithFour) {
  const support::TemporaryFolder folder;
  const std::string good = folder.write("a.ngc", kSquare);
  std::string text = kSquare;
  text.replace(text.find("Y10"), 3, "Y10.001");
  const std::string bad = folder.write("b.ngc", text);
  const auto proved = support::run_dgt({"verify", good, "--against", good});
  EXPECT_EQ(proved.exit_code, 0);
  EXPECT_THAT(proved.out, HasSubstr("PROVED"));
  const auto failed = support::run_dgt({"verify", bad, "--against", good});
  EXPECT_EQ(failed.exit_code, 4);
  EXPECT_THAT(failed.out, HasSubstr("! line 5: stops beside the path by X +0.000000 Y +0.001000"));
  const auto russian = support::run_dgt({"verify", bad, "--against", good, "--lang", "ru"});
  EXPECT_THAT(russian.out, HasSubstr("НЕ ДОКАЗАНО"));
  EXPECT_THAT(russian.out, HasSubstr("! строка 5: точка смещена"));
  EXPECT_EQ(support::run_dgt({"verify", bad, "--against", good, "--tolerance", "0"}).exit_code, 2);
}

TEST(VerifyCommand, JsonHoldsTheCertificate) {
  const support::TemporaryFolder folder;
  const std::string good = folder.write("a.ngc", kSquare);
  const auto outcome = support::run_dgt({"verify", good, "--against", good, "--json"});
  EXPECT_EQ(outcome.exit_code, 0);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["schema"], "dgt-verify/1");
  EXPECT_EQ(json["verified"], true);
  EXPECT_EQ(json["dialect"], "linuxcnc");
  EXPECT_EQ(json["blocks"].size(), 7U);
  EXPECT_EQ(json["closure"]["contours"], 2);
}

TEST(VerifyCommand, TheUnitOfTheMachineHoldsForEssi) {
  const support::TemporaryFolder folder;
  const std::string source = support::corpus("1P.bgt");
  const std::string out = folder.name("a.ess");
  ASSERT_EQ(support::run_dgt({"compile", source, "--post", "essi", "--set", "unit=0.01", "-o", out})
                .exit_code,
            0);
  EXPECT_EQ(support::run_dgt({"verify", out, "--against", source, "--set", "unit=0.01"}).exit_code,
            0);
  EXPECT_EQ(support::run_dgt({"verify", out, "--against", source}).exit_code, 4);
}

TEST(VerifyCommand, OnlyNcProgramsCanBeVerified) {
  const std::string source = support::corpus("1P.bgt");
  EXPECT_EQ(support::run_dgt({"verify", source, "--against", source}).exit_code, 2);
}

}  // namespace
}  // namespace dgt
