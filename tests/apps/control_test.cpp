// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contours that the control offsets: every program of the corpus with an offset is written so for
// every dialect that can, read back with the offset applied the control's way, and proved. What
// cannot be written is named with its reason.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

#include "apps/driver/certificate.h"
#include "apps/driver/control_proof.h"
#include "apps/driver/nc_files.h"
#include "post/write.h"
#include "tests/support/command.h"

namespace dgt {
namespace {

namespace fs = std::filesystem;
using Kind = WriteFault::Kind;
using Refused = std::map<std::string, Kind>;

/// Of the programs of the corpus that no control can offset, and why.
const Refused kNever = {
    {"kvad-guide-call", Kind::SideChanges},      {"rows/contour_cul", Kind::OffsetsDiffer},
    {"rows/contour_luc", Kind::OffsetsDiffer},   {"rows/contour_lul", Kind::OffsetsDiffer},
    {"rows/contour_xyl", Kind::PointsInContour},
};
/// These that a control cannot come to that meets its next element: their leads are too short.
const Refused kTooShort = {{"kvad-square", Kind::LeadTooShort}};
/// These where the control takes the offset from its settings.
const Refused kTwoOffsets = {{"rows/variables_texts", Kind::OffsetsVary}};
/// These where nobody knows how the control comes to its offset.
const Refused kUnknown = {
    {"1P", Kind::BeginsInCorner},
    {"2P", Kind::BeginsInCorner},
    {"3P", Kind::BeginsInCorner},
    {"rows/macro", Kind::BeginsInCorner},
    {"rows/comments", Kind::EntryUnknown},
    {"rows/contour_cp", Kind::EntryUnknown},
    {"rows/contour_ld", Kind::EntryUnknown},
    {"rows/contour_lp", Kind::EntryUnknown},
    {"rows/contour_lx", Kind::EntryUnknown},
    {"rows/contour_lxy", Kind::EntryUnknown},
    {"rows/contour_ly", Kind::EntryUnknown},
    {"rows/contour_pc", Kind::EntryUnknown},
    {"rows/contour_pl", Kind::EntryUnknown},
    {"rows/contour_points", Kind::EntryUnknown},
    {"rows/contour_xc", Kind::EntryUnknown},
    {"rows/contour_xl", Kind::EntryUnknown},
    {"rows/contour_xyc", Kind::EntryUnknown},
    {"rows/contour_yl", Kind::EntryUnknown},
    {"rows/line_cc_inner", Kind::EntryUnknown},
    {"rows/point_xy", Kind::EntryUnknown},
    {"rows/redefinition", Kind::EntryUnknown},
};

struct Case {
  const char* dialect;
  std::vector<const Refused*> refused;
  std::map<std::string, Kind> codes;  ///< what the dialect cannot say at all
};

const std::vector<Case>& cases() {
  static const std::map<std::string, Kind> kCoarse = {{"rows/contour_m", Kind::UnknownCode}};
  static const std::map<std::string, Kind> kEssi = {{"rows/contour_m", Kind::UnknownCode},
                                                    {"rows/contour_t", Kind::DwellImpossible}};
  static const std::vector<Case> kCases = {
      {"linuxcnc", {&kNever, &kTooShort}, {}},
      {"fanuc-wire", {&kNever, &kTwoOffsets}, {}},
      {"plasmatic", {&kNever, &kTooShort, &kUnknown}, kCoarse},
      {"essi", {&kNever, &kTooShort, &kUnknown, &kTwoOffsets}, kEssi},
      {"essi-iso", {&kNever, &kTooShort, &kUnknown}, kCoarse},
  };
  return kCases;
}

struct Program {
  std::string name;  ///< from the corpus' folder, without its extension
  std::string file;
  Compilation made;
};

Rational offset_of(const Compilation& made) {
  Rational offset = 0;
  for (const Contour& contour : made.result.path->contours)
    if (contour.side != Side::None) offset = abs(contour.offset);
  return offset;
}

/// Those of the corpus with an offset.
const std::vector<Program>& programs() {
  static const std::vector<Program> kPrograms = [] {
    std::set<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(support::corpus("")))
      if (entry.path().extension() == ".bgt") files.insert(entry.path());
    std::vector<Program> all;
    for (const fs::path& file : files) {
      auto made = compile_file(file.string(), SourceSettings{});
      if (!made || !made->result.path || made->bag.has_errors()) continue;
      if (sgn(offset_of(*made)) == 0) continue;
      fs::path name = file.lexically_relative(support::corpus(""));
      all.push_back({name.replace_extension().string(), file.string(), *std::move(made)});
    }
    return all;
  }();
  return kPrograms;
}

Settings settings_for(const char* dialect, const Rational& offset) {
  Settings settings;
  settings.dialect = *find_dialect(dialect);
  settings.dialect.compensation = Compensation::Control;
  settings.source.essi.nc.kerf_width = 2 * offset;
  settings.source.gcode.nc.kerf_width = 2 * offset;
  return settings;
}

Certificate proof_of(const Program& program, const std::string& text, const Settings& settings) {
  SourceSettings reading = as_its_control(settings);
  reading.from = language_of(settings.dialect);
  const std::string name = "part" + std::string(extension_of(settings.dialect));
  const Compilation read = compile_bytes(name, text, reading);
  if (!read.result.path) return {};
  const SourceSettings source;
  return prove({name, read, reading}, {program.file, program.made, source}, settings.dialect,
               limits_of(settings.dialect));
}

class ControlOffset : public ::testing::TestWithParam<Case> {};

TEST_P(ControlOffset, OfTheCorpusIsProvedOrRefusedByName) {
  Refused refused = GetParam().codes;
  for (const Refused* const more : GetParam().refused) refused.insert(more->begin(), more->end());
  std::size_t proved = 0;
  for (const Program& program : programs()) {
    const Settings settings = settings_for(GetParam().dialect, offset_of(program.made));
    const WriteResult written = write(*program.made.result.path, settings.dialect);
    const auto reason = refused.find(program.name);
    if (reason != refused.end()) {
      ASSERT_FALSE(written.faults.empty()) << program.name;
      EXPECT_EQ(written.faults.front().kind, reason->second) << program.name;
      EXPECT_NE(written.faults.front().place.line, 0u) << program.name;
      refused.erase(reason);
      continue;
    }
    ASSERT_TRUE(written.faults.empty())
        << program.name << " " << static_cast<int>(written.faults.front().kind);
    const Certificate proof = proof_of(program, written.text, settings);
    EXPECT_TRUE(proof.holds()) << program.name << "\n"
                               << to_text(proof, Language::English) << written.text;
    EXPECT_GT(proof.by_control, 0u) << program.name;
    ++proved;
  }
  EXPECT_TRUE(refused.empty()) << refused.begin()->first << " is not in the corpus";
  EXPECT_GT(proved, 70u);
}

INSTANTIATE_TEST_SUITE_P(Control, ControlOffset, ::testing::ValuesIn(cases()),
                         [](const auto& i) { return std::to_string(i.index); });

/// The proof is one: of another offset, another side, a contour that is a unit off.
TEST(ControlProof, FailsForAnotherProgram) {
  for (const Program& program : programs()) {
    if (program.name != "rows/contour_w" && program.name != "rows/contour_crc") continue;
    Settings settings = settings_for("linuxcnc", offset_of(program.made));
    const std::string text = write(*program.made.result.path, settings.dialect).text;
    ASSERT_TRUE(proof_of(program, text, settings).holds());
    const auto changed = [&](const std::string& from, const std::string& to) {
      std::string other = text;
      const std::size_t at = other.find(from);
      EXPECT_NE(at, std::string::npos) << from << " in\n" << text;
      if (at != std::string::npos) other.replace(at, from.size(), to);
      return proof_of(program, other, settings).holds();
    };
    const std::string width = to_short_decimal(Rational(2 * offset_of(program.made)));
    EXPECT_FALSE(changed("D" + width, "D" + to_short_decimal(Rational(2 * offset_of(program.made) +
                                                                      Rational(1, 100)))));
    EXPECT_FALSE(changed("G42.1", "G41.1"));
    EXPECT_FALSE(changed("G40\n", ""));
  }
}

TEST(ControlProof, OfAnOpenContourFailsForAControlOfTheOtherKind) {
  for (const Program& program : programs()) {
    if (program.name != "rows/contour_lp" && program.name != "rows/contour_cp") continue;
    Settings settings = settings_for("linuxcnc", offset_of(program.made));
    const std::string text = write(*program.made.result.path, settings.dialect).text;
    EXPECT_TRUE(proof_of(program, text, settings).holds());
    settings.dialect.kerf.entry = KerfEntry::Beside;
    EXPECT_FALSE(proof_of(program, text, settings).holds());
  }
}

/// A closed contour is right both ways: a control of the other kind runs twice where it comes in.
TEST(ControlProof, OfAClosedContourHoldsForBothKinds) {
  for (const Program& program : programs()) {
    if (program.name != "rows/contour_w" && program.name != "rows/contour_crc") continue;
    const Settings settings = settings_for("plasmatic", offset_of(program.made));
    const std::string text = write(*program.made.result.path, settings.dialect).text;
    const Certificate proof = proof_of(program, text, settings);
    EXPECT_TRUE(proof.holds()) << to_text(proof, Language::English);
    EXPECT_EQ(proof.leads.size(), 2u);
  }
}

/// What begins in a corner of the part is right for controls that meet the offset there; others
/// would cut into the part on their way, and the proof for them does not hold.
TEST(ControlProof, OfAContourFromACornerFailsWhereNobodyKnowsTheControl) {
  int proved = 0;
  for (const Program& program : programs()) {
    const auto reason = kUnknown.find(program.name);
    if (reason == kUnknown.end() || reason->second != Kind::BeginsInCorner) continue;
    Settings settings = settings_for("linuxcnc", offset_of(program.made));
    const std::string text = write(*program.made.result.path, settings.dialect).text;
    EXPECT_TRUE(proof_of(program, text, settings).holds()) << program.name;
    settings.dialect.kerf.entry = KerfEntry::Either;
    EXPECT_FALSE(proof_of(program, text, settings).holds()) << program.name;
    ++proved;
  }
  EXPECT_EQ(proved, 4);
}

Program program_of(const std::string& text) {
  return {"t", "t.bgt", compile_bytes("t.bgt", text, SourceSettings{})};
}

/// A plate from its outer corner: a control that meets the offset comes in a little before it. That
/// is right for others where nothing stands in the way.
TEST(ControlProof, OfAPlateFromItsCornerHoldsUnlessAPartStandsInTheWay) {
  const std::string plate =
      "'@ offset-side right\nL1=Y0\nL2=X40\nL3=Y30\nL4=X0\nC1=X40.3 Y-0.8 R0.3\nP1=X50 Y-5\n"
      "G54 X45 Y15\nK1 W0.2 L1 L-2 L-3 L4 L1 L-2\n";
  const auto holds = [](const Program& program, KerfEntry entry) {
    Settings settings = settings_for("linuxcnc", offset_of(program.made));
    const std::string text = write(*program.made.result.path, settings.dialect).text;
    settings.dialect.kerf.entry = entry;
    return proof_of(program, text, settings).holds();
  };
  const Program alone = program_of(plate);
  EXPECT_TRUE(holds(alone, KerfEntry::Meets));
  EXPECT_TRUE(holds(alone, KerfEntry::Either));
  const Program crowded = program_of(plate + "K2 G0 P1 C1 P1\n");
  EXPECT_TRUE(holds(crowded, KerfEntry::Meets));
  EXPECT_FALSE(holds(crowded, KerfEntry::Either));
}

}  // namespace
}  // namespace dgt
