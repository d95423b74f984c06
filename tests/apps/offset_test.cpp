// SPDX-License-Identifier: GPL-3.0-or-later
//
// `dgt offset` as a script sees it, on shapes whose equidistants others published as failures of
// theirs, and on some that are degenerate on purpose. Golden files: `DGT_UPDATE_GOLDEN=1` rewrites
// them.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

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
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr double kPi = std::numbers::pi;

using Words = std::vector<std::string>;

Words call(const std::string& file, const std::string& distance, const Words& more = {}) {
  Words words = {"offset", file, "--distance", distance};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::string shape(const std::string& name) { return corpus("poly/" + name + ".poly"); }

json loops_of(const std::string& file, const std::string& distance, const Words& more = {}) {
  const Outcome outcome = run_dgt(call(file, distance, more));
  EXPECT_EQ(outcome.exit_code, 0) << file << " " << distance << outcome.err;
  return outcome.exit_code == 0 ? json::parse(outcome.out)["loops"] : json::array();
}

double sum(const json& loops, const char* key) {
  double total = 0;
  for (const json& loop : loops) total += loop[key].get<double>();
  return total;
}

void expect_shape(const json& loops, std::size_t count, double area, double length) {
  EXPECT_EQ(loops.size(), count);
  EXPECT_NEAR(sum(loops, "area"), area, 1e-9 * std::max(1.0, std::fabs(area)));
  EXPECT_NEAR(sum(loops, "length"), length, 1e-9 * std::max(1.0, length));
}

// --- golden files -------------------------------------------------------------------------------

struct Case {
  const char* name;
  const char* distance;
};

const std::vector<Case> kCases = {
    {"stair", "36"},     {"islands", "10"},       {"island", "0.5"}, {"needle", "2e-5"},
    {"needle", "-2e-5"}, {"slot", "1.999999999"}, {"slot", "2"},     {"slot", "2.000001"},
    {"slot", "-1"},      {"keyhole", "2"},        {"keyhole", "-2"}, {"stadium", "2"},
    {"stadium", "3"},    {"stadium", "-3"},       {"circle", "1"},   {"circle", "2"},
    {"circle", "-0.5"},  {"circle", "-1"},        {"cross", "1"},    {"cross", "-1"},
    {"stair", "0"},
};

class OffsetCorpus : public ::testing::TestWithParam<Case> {};

TEST_P(OffsetCorpus, GivesItsGoldenFile) {
  const auto& [name, distance] = GetParam();
  const Outcome outcome = run_dgt(call(shape(name), distance));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  const std::string file =
      corpus("poly/golden/" + std::string(name) + "_" + std::string(distance) + ".json");
  if (std::getenv("DGT_UPDATE_GOLDEN") != nullptr) {
    std::ofstream(file, std::ios::binary) << outcome.out;
  }
  EXPECT_EQ(outcome.out, read_text(file));
}

TEST_P(OffsetCorpus, BothEnginesGiveTheSameLoops) {
  const auto& [name, distance] = GetParam();
  const json production = loops_of(shape(name), distance, {"--engine", "production"});
  const json reference = loops_of(shape(name), distance, {"--engine", "reference"});
  ASSERT_EQ(production.size(), reference.size());
  for (std::size_t i = 0; i < production.size(); ++i) {
    for (const char* key : {"area", "length"}) {
      const auto expected = reference[i][key].get<double>();
      EXPECT_NEAR(production[i][key].get<double>(), expected, 1e-12 * std::fabs(expected));
    }
  }
}

TEST_P(OffsetCorpus, MovesMeetInTheSameDoublesAndBeginLowest) {
  const auto& [name, distance] = GetParam();
  json last;
  for (const json& loop : loops_of(shape(name), distance)) {
    const json& moves = loop["moves"];
    const auto place = [](const json& p) { return std::pair(p[1], p[0]); };
    for (std::size_t i = 0; i < moves.size(); ++i) {
      EXPECT_EQ(moves[i]["to"], moves[(i + 1) % moves.size()]["from"]);
      EXPECT_GE(place(moves[i]["from"]), place(moves[0]["from"]));
    }
    if (!last.is_null()) {
      EXPECT_LE(place(last), place(moves[0]["from"]));
    }
    last = moves[0]["from"];
    EXPECT_EQ(loop["closed"], true);
  }
}

std::string test_name(const ::testing::TestParamInfo<Case>& info) {
  std::string name = std::string(info.param.name) + "_" + info.param.distance;
  for (char& c : name) {
    if (c == '-') c = 'm';
    if (c == '.') c = 'p';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Corpus, OffsetCorpus, ::testing::ValuesIn(kCases), test_name);

// --- closed forms -------------------------------------------------------------------------------

TEST(OffsetClosedForm, Sample1P) {
  const Outcome outcome = run_dgt(call(corpus("1P.bgt"), "0.2"));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("dgt: note: contour 1: its programmed path was taken as a "
                                     "loop of 30 edges, area -678.773055 mm²\n"));
  // The program runs clockwise: to its left lies the outside.
  expect_shape(json::parse(outcome.out)["loops"], 1, -722.0058567836, 216.3784036755);
  expect_shape(loops_of(corpus("1P.bgt"), "-0.2"), 1, -635.7070496784, 214.7017100901);
}

TEST(OffsetClosedForm, PublishedFailures) {
  expect_shape(loops_of(shape("island"), "0.5"), 2, 19 * 19 - (4 + 4 + kPi / 4), 76 + 8 + kPi);
  // Islands grown by 10 touch the shrunken square and each other's reach: what is left of 80 × 80.
  const double first = 20 * 20 + 4 * 20 * 10 + 100 * kPi;
  const double second = 20 * 50 + 2 * (20 + 50) * 10 + 100 * kPi;
  EXPECT_NEAR(sum(loops_of(shape("islands"), "10"), "area"), 80 * 80 - first - second, 1e-9);
  EXPECT_GT(sum(loops_of(shape("stair"), "36"), "area"), 0);
}

TEST(OffsetClosedForm, ASlotOfTwiceTheDistanceParts) {
  EXPECT_EQ(loops_of(shape("slot"), "1.999999999").size(), 1U);
  EXPECT_EQ(loops_of(shape("slot"), "2").size(), 2U);
  EXPECT_EQ(loops_of(shape("slot"), "2.000000001").size(), 2U);
  EXPECT_EQ(loops_of(shape("slot"), "2.000001").size(), 2U);
}

TEST(OffsetClosedForm, AnOffsetOfAnOffsetIsTheOffsetOfTheSum) {
  const TemporaryFolder folder;
  const std::string once = folder.name("once.poly");
  ASSERT_EQ(run_dgt(call(shape("stadium"), "-1", {"-o", once})).exit_code, 0);
  const std::string twice = folder.name("twice.poly");
  ASSERT_EQ(run_dgt(call(once, "-2", {"-o", twice})).exit_code, 0);
  expect_shape(loops_of(twice, "-4"), 1, 100 * kPi + 200, 20 + 20 * kPi);
  expect_shape(loops_of(twice, "7"), 0, 0, 0);
  // Closing and opening: corners come back round.
  const std::string grown = folder.name("grown.poly");
  ASSERT_EQ(run_dgt(call(shape("cross"), "-0.5", {"-o", grown})).exit_code, 0);
  expect_shape(loops_of(grown, "0.5"), 1, 36 + 4 * (0.25 - kPi / 16), 40 - 4 * (1 - kPi / 4));
}

TEST(OffsetClosedForm, AFullCircleIsOneArcBegunAtItsLowestPoint) {
  const json loops = loops_of(shape("circle"), "1");
  ASSERT_EQ(loops.size(), 2U);
  ASSERT_EQ(loops[0]["moves"].size(), 1U);
  const json& outer = loops[0]["moves"][0];
  EXPECT_EQ(outer["from"], json({0.0, -4.0}));
  EXPECT_EQ(outer["to"], json({0.0, -4.0}));
  EXPECT_EQ(outer["center"], json({0.0, 0.0}));
  EXPECT_EQ(outer["radius"], 4.0);
  EXPECT_EQ(outer["sweep"], 360.0);
  EXPECT_EQ(loops[1]["moves"][0]["sweep"], -360.0);
}

/// A plate with `n` × `n` islands 8 × 8 on a pitch of 10: between them, and along the frame, runs a
/// grid of slots exactly 2 wide.
std::string grid_of_slots(int n) {
  std::string text;
  const auto rectangle = [&](double x0, double y0, double x1, double y1) {
    const auto vertex = [&](double x, double y) {
      text += std::to_string(x) + " " + std::to_string(y) + " 0\n";
    };
    vertex(x0, y0);
    vertex(x0, y1);
    vertex(x1, y1);
    vertex(x1, y0);
    text += "\n";
  };
  const double side = 10 * n + 2;
  text += "0 0 0\n" + std::to_string(side) + " 0 0\n" + std::to_string(side) + " " +
          std::to_string(side) + " 0\n0 " + std::to_string(side) + " 0\n\n";
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      rectangle(10 * column + 2, 10 * row + 2, 10 * column + 10, 10 * row + 10);
    }
  }
  return text;
}

TEST(OffsetClosedForm, ABigGridOfSlotsExactlyTwiceAsWide) {
  constexpr int kRooms = 24;
  const TemporaryFolder folder;
  const std::string grid = folder.write("grid.poly", grid_of_slots(kRooms));
  // Slots 2 wide vanish at 1; where two of them cross, four corner arcs leave a star of 4 − π, half
  // of it where a slot meets the one along the frame, a quarter in the frame's corners.
  const json stars = loops_of(grid, "1");
  EXPECT_EQ(stars.size(), static_cast<std::size_t>((kRooms + 1) * (kRooms + 1)));
  EXPECT_NEAR(sum(stars, "area"), kRooms * kRooms * (4 - kPi), 1e-9 * kRooms * kRooms);
  // A hair less and everything is joined: the frame, and a loop around every island.
  EXPECT_EQ(loops_of(grid, "0.999999999").size(), 1U + kRooms * kRooms);
  EXPECT_THAT(loops_of(grid, "1.5"), IsEmpty());
}

// --- input --------------------------------------------------------------------------------------

TEST(OffsetCommand, ReadsStandardInputAsPolyWhenTold) {
  const Outcome outcome =
      run_dgt(call("-", "1", {"--from", "poly"}), {.input = "0 0 0\n10 0 0\n10 10 0\n0 10 0\n"});
  EXPECT_EQ(outcome.exit_code, 0);
  expect_shape(json::parse(outcome.out)["loops"], 1, 64, 32);
}

TEST(OffsetCommand, NothingInNothingOut) {
  const TemporaryFolder folder;
  const std::string empty = folder.write("empty.poly", "# nothing\n");
  EXPECT_EQ(run_dgt(call(empty, "1")).out, "{\"schema\": \"dgt-offset/1\",\n \"loops\": []}\n");
  EXPECT_EQ(run_dgt(call(shape("circle"), "7", {"-o", folder.name("none.poly")})).exit_code, 0);
  EXPECT_EQ(read_text(folder.name("none.poly")), "");
}

TEST(OffsetCommand, OpenLoopsHaveAnEquidistantOnEitherSide) {
  const TemporaryFolder folder;
  const std::string open = folder.write("open.poly", "open\n0 0 0\n10 0 0\n10 10 0\n");
  for (const char* engine : {"production", "reference"}) {
    const json left = loops_of(open, "1", {"--engine", engine});
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0]["closed"], false);
    EXPECT_EQ(left[0]["area"], 0.0);
    EXPECT_EQ(left[0]["length"], 18.0);
    EXPECT_EQ(left[0]["moves"][0]["from"], json::array({0.0, 1.0}));
    const json right = loops_of(open, "-1", {"--engine", engine});
    ASSERT_EQ(right.size(), 1U);
    EXPECT_EQ(right[0]["moves"].size(), 3U);
    EXPECT_NEAR(right[0]["length"].get<double>(), 20 + kPi / 2, 1e-12);
    EXPECT_EQ(right[0]["moves"][0]["from"], json::array({0.0, -1.0}));
  }
  EXPECT_EQ(run_dgt(call(open, "1", {"-o", "-"})).exit_code, 0);
  EXPECT_EQ(run_dgt(call(open, "0")).exit_code, 2);
}

TEST(OffsetCommand, OpenLoopsLoseWhatComesTooNearToAnotherPart) {
  const TemporaryFolder folder;
  // A hook whose point lies 2 above its shank: at 1.5 the two come too near.
  const std::string hook = folder.write("hook.poly", "open\n0 0 0\n20 0 0\n20 2 0\n12 2 0\n");
  for (const char* engine : {"production", "reference"}) {
    const json loops = loops_of(hook, "1.5", {"--engine", engine});
    ASSERT_EQ(loops.size(), 1U) << engine;
    // Along the shank until the point is 1.5 away: 12 − √(1.5² − 0.5²).
    EXPECT_EQ(loops[0]["moves"].size(), 1U);
    EXPECT_NEAR(loops[0]["length"].get<double>(), 12 - std::sqrt(2.0), 1e-12);
  }
}

TEST(OffsetCommand, CornersOfASquare) {
  const TemporaryFolder folder;
  const std::string square = folder.write("square.poly", "0 0 0\n10 0 0\n10 10 0\n0 10 0\n");
  for (const char* engine : {"production", "reference"}) {
    const auto grown = [&](const Words& more) {
      Words words = {"--engine", engine};
      words.insert(words.end(), more.begin(), more.end());
      return loops_of(square, "-1", words);
    };
    expect_shape(grown({}), 1, 140 + kPi, 40 + 2 * kPi);
    expect_shape(grown({"--corner", "sharp"}), 1, 144, 48);
    EXPECT_EQ(grown({"--corner", "sharp"})[0]["moves"].size(), 4U);
    // Too far: √2 distances.
    expect_shape(grown({"--corner", "sharp", "--spike-limit", "1.4"}), 1, 140 + kPi, 40 + 2 * kPi);
    // Each corner is cut by a line that touches the unit circle at 45°: legs of 2 − √2.
    const double leg = 2 - std::sqrt(2.0);
    expect_shape(grown({"--corner", "chamfer"}), 1, 144 - 2 * leg * leg,
                 48 - 8 * leg + 4 * std::sqrt(2.0) * leg);
  }
}

/// Closed form, worked out from the sample's own lines and circles.
TEST(OffsetCommand, CornersOfSample1P) {
  for (const char* engine : {"production", "reference"}) {
    const Words with = {"--engine", engine};
    expect_shape(loops_of(corpus("1P.bgt"), "-0.2", with), 1, -635.7070496784, 214.7017100901);
    expect_shape(loops_of(corpus("1P.bgt"), "-0.2", {"--engine", engine, "--corner", "sharp"}), 1,
                 -635.6188261112, 215.5937000736);
  }
}

TEST(OffsetCommand, FaultsInAPolylineAreInputErrors) {
  const TemporaryFolder folder;
  const std::string faulty = folder.write("faulty.poly", "0 0 0\n1 0\n1 1 0\n");
  const std::string target = folder.name("out.poly");
  const Outcome outcome = run_dgt(call(faulty, "1", {"-o", target}));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, StartsWith(faulty + ":2:4: error: "));
  EXPECT_FALSE(std::filesystem::exists(target));
}

TEST(OffsetCommand, OpenContoursOfAProgramAreOpenLoops) {
  const TemporaryFolder folder;
  const std::string program =
      folder.write("open.bgt", "L1=Y0\nL2=X10\nG54 X0 Y0\nK1 L1 L2 X10 Y10\n");
  const Outcome outcome = run_dgt(call(program, "1"));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("taken as an open loop of"));
  EXPECT_EQ(json::parse(outcome.out)["loops"][0]["closed"], false);
}

TEST(OffsetCommand, WrongUsageIs2AndSaysWhy) {
  const TemporaryFolder folder;
  const std::vector<std::pair<Words, std::string>> calls = {
      {{"offset", shape("slot")}, "--distance"},
      {call(shape("slot"), "wide"), "'wide' is no distance in mm"},
      {call(shape("slot"), "1", {"--corner", "blunt"}), "blunt"},
      {call(shape("slot"), "1", {"--spike-limit", "0.5"}), "--spike-limit"},
      {call(shape("slot"), "1", {"--engine", "steam"}), "steam"},
      {call(shape("slot"), "1", {"-o", folder.name("x.pdf")}), "ends in .json, .poly or .svg"},
      {call(folder.write("part.txt", ""), "1"), "does not tell its language"},
  };
  for (const auto& [words, reason] : calls) {
    const Outcome outcome = run_dgt(words);
    EXPECT_EQ(outcome.exit_code, 2) << ::testing::PrintToString(words);
    EXPECT_THAT(outcome.out, IsEmpty()) << ::testing::PrintToString(words);
    EXPECT_THAT(outcome.err, HasSubstr(reason));
  }
}

// --- output -------------------------------------------------------------------------------------

TEST(OffsetCommand, WritesPolylines) {
  const TemporaryFolder folder;
  const std::string file = folder.name("out.poly");
  ASSERT_EQ(run_dgt(call(shape("stadium"), "1", {"-o", file})).exit_code, 0);
  EXPECT_EQ(read_text(file), "0 1 0\n10 1 1\n10 5 0\n0 5 1\n");
  ASSERT_EQ(run_dgt(call(shape("circle"), "1", {"-o", file})).exit_code, 0);
  EXPECT_EQ(read_text(file), "0 -4 1\n0 4 1\n\n0 -2 -1\n0 2 -1\n");
}

TEST(OffsetCommand, WritesDrawings) {
  const TemporaryFolder folder;
  const std::string file = folder.name("out.svg");
  ASSERT_EQ(run_dgt(call(shape("circle"), "1", {"-o", file})).exit_code, 0);
  // Both loops, each a path of its own.
  EXPECT_THAT(read_text(file), AllOf(HasSubstr("<svg "), HasSubstr("\"M0 -4 A4 4 "),
                                     HasSubstr("\"M0 -2 A2 2 "), HasSubstr("\"M-5 0 A5 5 ")));
}

TEST(OffsetCommand, OtherVerbsReadPolylinesToo) {
  EXPECT_EQ(run_dgt({"check", shape("stadium")}).exit_code, 0);
  const json path = json::parse(run_dgt({"path", shape("stadium")}).out);
  EXPECT_EQ(path["contours"].size(), 1U);
  EXPECT_EQ(path["contours"][0]["closed"], true);
  EXPECT_EQ(path["moves"][1]["source"]["line"], 3);
  EXPECT_EQ(run_dgt({"format", shape("stadium")}).exit_code, 2);
}

// --- loops that bound nothing
// ---------------------------------------------------------------------

std::string refusal(const std::string& loops, const char* language = "en") {
  const TemporaryFolder folder;
  const std::string file = folder.write("loops.poly", loops);
  const Outcome outcome = run_dgt({"offset", file, "--distance", "0.1", "--lang", language});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, IsEmpty());
  return outcome.err;
}

TEST(OffsetRefuses, ALoopThatCrossesItself) {
  const std::string eight = "0 0 0\n10 10 0\n10 0 0\n0 10 0\n";
  EXPECT_EQ(
      refusal(eight),
      "dgt: error: loop 1 crosses itself, or runs over itself, near X5 Y5: which side of it is "
      "the part cannot be told\n");
  EXPECT_EQ(
      refusal(eight, "ru"),
      "dgt: error: контур 1 пересекает сам себя или накладывается на себя у точки X5 Y5: с какой "
      "стороны деталь, определить нельзя\n");
}

TEST(OffsetRefuses, LoopsThatCross) {
  EXPECT_EQ(
      refusal("open\n50 0 0\n60 0 0\n\n0 0 0\n10 0 0\n10 10 0\n\n5 -5 0\n15 -5 0\n15 5 0\n5 5 0\n"),
      "dgt: error: loops 2 and 3 cross near X5 Y0: which side of them is the part cannot be "
      "told\n");
}

TEST(OffsetRefuses, AHoleThatRunsLikeItsOuterLoop) {
  EXPECT_EQ(refusal("0 0 0\n10 0 0\n10 10 0\n0 10 0\n\n2 2 0\n4 2 0\n4 4 0\n"),
            "dgt: error: loop 2, which begins at X2 Y2, runs the wrong way round: the part must "
            "lie to the "
            "left of every loop, outer ones counter-clockwise, holes clockwise\n");
}

}  // namespace
}  // namespace dgt
