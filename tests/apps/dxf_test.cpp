// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drawings through the command: plotted and read back, offset, written and proved.
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/command.h"

namespace dgt {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::run_dgt;
using support::TemporaryFolder;
using ::testing::HasSubstr;

/// Degrees in sixteen digits put an end this far beside its place, a metre from the centre. Unit:
/// mm.
constexpr double kRounding = 1e-9;

std::vector<json> cuts_of(const std::string& file) {
  const auto outcome = run_dgt({"path", file});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  std::vector<json> cuts;
  const json path = json::parse(outcome.out);
  for (const json& move : path["moves"]) {
    const bool is_arc = move["kind"] == "arc";
    const bool goes = is_arc || move["from"] != move["to"];  // a change of height draws nothing
    if (goes && (is_arc || move["kind"] == "line")) cuts.push_back(move);
  }
  return cuts;
}

double difference(const json& a, const json& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    most = std::max(most, std::fabs(a[i].get<double>() - b[i].get<double>()));
  return most;
}

bool is_whole_turn(const json& arc) { return std::fabs(arc["sweep"].get<double>()) == 360; }

/// DXF has no sense of a circle.
void expect_same(const json& drawn, const json& read, const std::string& where) {
  ASSERT_EQ(drawn["kind"], read["kind"]) << where;
  EXPECT_LE(difference(drawn["from"], read["from"]), kRounding) << where;
  EXPECT_LE(difference(drawn["to"], read["to"]), kRounding) << where;
  if (drawn["kind"] != "arc") return;
  EXPECT_LE(difference(drawn["center"], read["center"]), kRounding) << where;
  EXPECT_NEAR(drawn["radius"].get<double>(), read["radius"].get<double>(), kRounding) << where;
  if (is_whole_turn(drawn)) return;
  EXPECT_EQ(drawn["ccw"], read["ccw"]) << where;
}

std::vector<std::string> programs() {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(support::corpus(""))) {
    const fs::path& name = entry.path();
    const bool is_golden = name.string().find("/golden/") != std::string::npos;
    const bool is_program = name.extension() == ".bgt" || name.extension() == ".ess" ||
                            name.extension() == ".cnc" || name.extension() == ".poly";
    // Of two half circles nothing says which way they run.
    if (!is_golden && is_program && name.filename() != "circle.poly") names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

TEST(DxfDrawings, EveryProgramOfTheCorpusComesBackMoveForMoveFromItsDrawing) {
  const TemporaryFolder folder;
  const std::string drawing = folder.name("a.dxf");
  std::size_t count = 0;
  for (const std::string& program : programs()) {
    if (run_dgt({"check", program}).exit_code != 0) continue;
    const std::vector<json> drawn = cuts_of(program);
    if (drawn.empty()) continue;  // definitions alone
    ASSERT_EQ(run_dgt({"plot", program, "-o", drawing}).exit_code, 0) << program;
    const std::vector<json> read = cuts_of(drawing);
    ASSERT_EQ(drawn.size(), read.size()) << program;
    for (std::size_t i = 0; i < drawn.size(); ++i)
      expect_same(drawn[i], read[i], program + ", move " + std::to_string(i + 1));
    ++count;
  }
  EXPECT_GT(count, 110U);
}

std::string plate() { return support::corpus("dxf/plate.dxf"); }

TEST(DxfDrawings, ArePlottedMeasuredAndOffset) {
  const auto info = run_dgt({"info", plate(), "--json"});
  ASSERT_EQ(info.exit_code, 0) << info.err;
  const json told = json::parse(info.out);
  EXPECT_EQ(told["contours"], 4);
  EXPECT_EQ(told["box"]["max"], json({100.0, 60.0}));
  const auto offset = run_dgt({"offset", plate(), "--distance", "-2"});
  ASSERT_EQ(offset.exit_code, 0) << offset.err;
  EXPECT_EQ(json::parse(offset.out)["schema"], "dgt-offset/1");
  EXPECT_THAT(run_dgt({"plot", plate(), "-o", "-"}).out, HasSubstr("<svg"));
}

TEST(DxfDrawings, AreWrittenWithKerfForEveryControlAndProved) {
  const TemporaryFolder folder;
  for (const char* dialect : {"linuxcnc", "plasmatic", "essi"}) {
    const std::string name = folder.name(dialect[0] == 'e' ? "p.ess" : "p.cnc");
    const auto written =
        run_dgt({"convert", plate(), "--to", dialect, "--set", "kerf=0.8", "-o", name});
    ASSERT_EQ(written.exit_code, 0) << written.err;
    const auto proved =
        run_dgt({"verify", name, "--post", dialect, "--against", plate(), "--set", "kerf=0.8"});
    EXPECT_EQ(proved.exit_code, 0) << dialect << '\n' << proved.out << proved.err;
  }
}

TEST(DxfDrawings, ABatchTakesThemAsItTakesPrograms) {
  const TemporaryFolder folder;
  const auto outcome =
      run_dgt({"batch", support::corpus("dxf/*.dxf"), "--post", "linuxcnc", "-o", folder.name("")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_GE(folder.entries().size(), 3U);
}

TEST(DxfDrawings, SettingsChooseLayersAndTolerances) {
  const std::string layers = support::corpus("dxf/layers.dxf");
  EXPECT_THAT(run_dgt({"info", layers}).out, HasSubstr("contours: 3"));
  EXPECT_THAT(run_dgt({"info", layers, "--set", "dxf.layers=engrave"}).out,
              HasSubstr("contours: 1"));
  const auto coarse = run_dgt({"info", plate(), "--json", "--set", "dxf.curve_tolerance=0.1"});
  const auto fine = run_dgt({"info", plate(), "--json", "--set", "dxf.curve_tolerance=0.0001"});
  EXPECT_LT(json::parse(coarse.out)["moves"]["arc"], json::parse(fine.out)["moves"]["arc"]);
  EXPECT_EQ(run_dgt({"info", plate(), "--set", "dxf.curve_tolerance=0"}).exit_code, 2);
  EXPECT_EQ(run_dgt({"info", plate(), "--set", "dxf.order=random"}).exit_code, 2);
}

TEST(DxfDrawings, CutOffAnywhereTheyAreRefusedAndNothingFalls) {
  const TemporaryFolder folder;
  const std::string text = support::read_text(plate());
  for (std::size_t length = 0; length < text.size() - 10; length += 97) {
    const std::string name = folder.write("t.dxf", text.substr(0, length));
    const auto outcome = run_dgt({"check", name});
    EXPECT_EQ(outcome.exit_code, 1) << length << '\n' << outcome.err;
  }
}

}  // namespace
}  // namespace dgt
