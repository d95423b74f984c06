// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/path_json.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/driver/points.h"
#include "apps/driver/summary.h"
#include "tests/support/moves.h"

namespace dgt {
namespace {

using Json = nlohmann::json;
using support::at;
using ::testing::HasSubstr;

/// A rapid, a dwell, a code, a straight cut with a height and a feed, and an arc back.
Toolpath sample() {
  Toolpath path;
  path.files = {"part \"1\".bgt", "mac/KVAD.mac"};
  path.start = {1, Rational(1, 3)};
  Move dwell = support::straight(MoveKind::Dwell, at(0, 0), at(0, 0));
  dwell.seconds = shared(Rational(1, 2));
  Move code = support::straight(MoveKind::Code, at(0, 0), at(0, 0));
  code.code = "M7";
  Move line = support::line(at(0, 0), at(3, 4));
  line.z = shared(Rational(-1));
  line.feed = shared(Rational(250));
  line.role = Role::LeadIn;
  line.source = {1, 7, 3};
  Move arc = support::arc({0, 0}, -5, at(3, 4), at(4, 3));
  path.moves = {support::rapid(at(1, 1), at(0, 0)),        dwell, code, line, arc,
                support::full_circle({-1, 3}, 5, at(4, 3))};
  Contour contour;
  contour.id = 2;
  contour.offset = Rational(1, 5);
  contour.side = Side::Right;
  contour.closed = true;
  contour.first = 3;
  contour.last = 5;
  contour.programmed = std::vector{line};
  path.contours = {contour};
  return path;
}

Json sample_json() { return Json::parse(to_json(sample())); }

TEST(PathAsJson, HasTheHeadOfTheSchema) {
  const Json json = sample_json();
  EXPECT_EQ(json["schema"], "dgt-path/1");
  EXPECT_EQ(json["units"], "mm");
  EXPECT_EQ(json["start"], Json({1.0, 1.0 / 3.0}));
  EXPECT_EQ(json.size(), 6U);
  EXPECT_DOUBLE_EQ(json["length"]["rapid"], std::sqrt(2.0));
}

TEST(PathAsJson, AContourHasItsMovesAsProgrammedAndAsTheToolRuns) {
  const Json contour = sample_json()["contours"][0];
  EXPECT_EQ(contour["id"], 2);
  EXPECT_EQ(contour["offset"], 0.2);
  EXPECT_EQ(contour["side"], "right");
  EXPECT_EQ(contour["closed"], true);
  EXPECT_EQ(contour["programmed"].size(), 1U);
  ASSERT_EQ(contour["moves"].size(), 2U);
  EXPECT_EQ(contour["moves"][0], sample_json()["moves"][3]);
}

TEST(PathAsJson, AMoveHasWhatItsKindHasAndNothingElse) {
  const Json moves = sample_json()["moves"];
  ASSERT_EQ(moves.size(), 6U);
  EXPECT_EQ(moves[0], Json::parse(R"({"kind": "rapid", "from": [1.0, 1.0], "to": [0.0, 0.0],
                                      "role": "contour"})"));
  EXPECT_EQ(moves[1], Json::parse(R"({"kind": "dwell", "from": [0.0, 0.0], "to": [0.0, 0.0],
                                      "seconds": 0.5, "role": "contour"})"));
  EXPECT_EQ(moves[2], Json::parse(R"({"kind": "code", "from": [0.0, 0.0], "to": [0.0, 0.0],
                                      "code": "M7", "role": "contour"})"));
  EXPECT_EQ(moves[3], Json::parse(R"({"kind": "line", "from": [0.0, 0.0], "to": [3.0, 4.0],
                                      "z": -1.0, "feed": 250.0, "role": "lead-in",
                                      "source": {"file": "mac/KVAD.mac", "line": 7, "column": 3}})"));
}

TEST(PathAsJson, AnArcHasItsCircleItsSenseAndItsSweep) {
  const Json arc = sample_json()["moves"][4];
  EXPECT_EQ(arc["kind"], "arc");
  EXPECT_EQ(arc["center"], Json({0.0, 0.0}));
  EXPECT_EQ(arc["radius"], 5.0);
  EXPECT_EQ(arc["ccw"], false);
  EXPECT_NEAR(arc["sweep"], -16.260204708311957, 1e-12);
}

TEST(PathAsJson, AFullCircleSweepsExactly360) {
  EXPECT_EQ(sample_json()["moves"][5]["sweep"], 360.0);
}

TEST(PathAsJson, NamesOfFilesMayHoldAnything) {
  Toolpath path = sample();
  path.files[1] = "a\"\\\n\xFF.bgt";
  const Json json = Json::parse(to_json(path));
  EXPECT_EQ(json["moves"][3]["source"]["file"], "a\"\\\n\xEF\xBF\xBD.bgt");
}

TEST(PathAsJson, WholeNumbersKeepTheirPoint) {
  EXPECT_THAT(to_json(sample()), HasSubstr("\"to\": [3.0, 4.0], \"z\": -1.0"));
}

TEST(ListOfPoints, IsNumberedFromTheStart) {
  EXPECT_EQ(list_points(sample()),
            "     1       1.000000       0.333333  start\n"
            "     2       0.000000       0.000000  rapid\n"
            "     3       3.000000       4.000000  line Z-1.000000\n"
            "     4       4.000000       3.000000  arc X0.000000 Y0.000000 R-5.000000\n"
            "     5       4.000000       3.000000  arc X-1.000000 Y3.000000 R5.000000\n");
}

TEST(SummaryOfAPath, CountsMovesPiercesLengthsAndTheTrueBox) {
  const Summary sum = summarise(sample());
  EXPECT_THAT(sum.moves, ::testing::ElementsAre(1, 2, 1, 1, 1));
  EXPECT_EQ(sum.contours, 1U);
  EXPECT_EQ(sum.pierces, 1U);
  EXPECT_EQ(sum.dwell, 0.5);
  EXPECT_EQ(sum.box.left, -6);
  EXPECT_EQ(sum.box.top, 8);
  // The line goes down by 1 on its way.
  EXPECT_NEAR(sum.length.cut, std::sqrt(26) + 5 * 0.2837941092083280 + 31.41592653589793, 1e-12);
}

TEST(SummaryOfAPath, EveryRapidBeforeACutIsAPierce) {
  Toolpath path = sample();
  path.moves.push_back(support::rapid(at(4, 3), at(9, 9)));
  path.moves.push_back(support::line(at(9, 9), at(10, 9)));
  EXPECT_EQ(summarise(path).pierces, 2U);
}

TEST(SummaryOfAPath, SpeaksEnglishAndRussian) {
  EXPECT_EQ(to_text(summarise(sample()), Language::English),
            "moves: lines 1, arcs 2, rapids 1, dwells 1, codes 1\n"
            "contours: 1\n"
            "pierces: 1\n"
            "cut: 37.934 mm\n"
            "rapid: 1.414 mm\n"
            "dwell: 0.500 s\n"
            "time: 0:00:03.9 (cut 3.3 s, rapid 0.1 s, pierce 0.0 s, dwell 0.5 s)\n"
            "box: X -6.000 … 4.000, Y -2.000 … 8.000 (10.000 × 10.000) mm\n");
  EXPECT_THAT(to_text(summarise(Toolpath{}), Language::Russian), HasSubstr("движения нет"));
}

TEST(SummaryOfAPath, AsJsonHasNoBoxWhenNothingMoves) {
  EXPECT_EQ(Json::parse(to_json(summarise(Toolpath{})))["box"], nullptr);
  const Json json = Json::parse(to_json(summarise(sample())));
  EXPECT_EQ(json["schema"], "dgt-info/1");
  EXPECT_EQ(json["moves"]["arc"], 2);
  EXPECT_EQ(json["time"]["dwell"], 0.5);
  EXPECT_EQ(json["box"]["min"], Json({-6.0, -2.0}));
}

}  // namespace
}  // namespace dgt
