// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/nc/kerf.h"

#include <gmock/gmock.h>

#include <string>

#include "lang/essi/reader.h"
#include "lang/gcode/reader.h"
#include "lang/text/render.h"

namespace dgt {
namespace {

using ::testing::SizeIs;

/// A program from memory, read with its kerf.
class Read {
 public:
  Read(const char* name, std::string_view text, const char* kerf, KerfLead lead = KerfLead::Moved)
      : file_(name, text) {
    const Rational width = *parse_decimal(kerf);
    NcProgram program;
    if (file_.name().ends_with(".ess")) {
      EssiOptions options;
      options.nc.kerf_width = width;
      program = read_essi(file_, options, bag_);
    } else {
      GcodeOptions options;
      options.nc.kerf_width = width;
      program = read_gcode(file_, options, bag_);
    }
    if (!bag_.has_errors())
      path = with_kerf(file_, std::move(program), ContourOptions{}, bag_, lead);
  }
  [[nodiscard]] std::string messages() const { return render(bag_); }
  /// The printed form without the places in the source.
  [[nodiscard]] std::string moves() const {
    Toolpath bare = path;
    for (Move& move : bare.moves) move.source = {};
    return to_text(bare);
  }

  Toolpath path;

 private:
  SourceFile file_;
  DiagnosticBag bag_;
};

TEST(Kerf, ALeadAHoleOfTwoHalvesAndALeadOutMoveAsAWhole) {
  const Read read("t.nc",
                  "G21 G91\nG43 X0.5\nG00 X17 Y8\nG41\nM07\nG03 X3 Y3 J3\nG03 X-10 I-5\n"
                  "G03 X10 I5\nG03 X-3 Y3 I-3\nM08\nG40\nG00 X-17\nM02\n",
                  "9");
  EXPECT_EQ(read.messages(), "");
  EXPECT_EQ(read.moves(),
            "start X0.000000 Y0.000000\n"
            "1 rapid X17.000000 Y8.500000 position\n"
            "2 code M7\n"
            "contour 1 offset 0.5 side left closed\n"
            "3 arc X19.500000 Y11.000000 centre X17.000000 Y11.000000 radius 2.500000 sweep "
            "90.000000 lead-in\n"
            "4 arc X10.500000 Y11.000000 centre X15.000000 Y11.000000 radius 4.500000 sweep "
            "180.000000 contour\n"
            "5 arc X19.500000 Y11.000000 centre X15.000000 Y11.000000 radius 4.500000 sweep "
            "180.000000 contour\n"
            "6 arc X17.000000 Y13.500000 centre X17.000000 Y11.000000 radius 2.500000 sweep "
            "90.000000 lead-out\n"
            "7 code M8\n"
            "8 rapid X0.000000 Y14.000000 position\n");
}

TEST(Kerf, EssiOffsetsByHalfTheWidthToTheSideOfTheTravel) {
  const Read read("t.ess", "29\n53\n+100+\n++100\n-100+\n+-100\n54\n38\n", "2");
  EXPECT_EQ(read.messages(), "");
  ASSERT_THAT(read.path.contours, SizeIs(1));
  EXPECT_EQ(read.path.contours[0].side, Side::Left);
  EXPECT_EQ(read.path.contours[0].offset, 1);
  EXPECT_TRUE(read.path.contours[0].closed);
  EXPECT_EQ(read.moves(),
            "start X0.000000 Y0.000000\n"
            "1 rapid X1.000000 Y1.000000 position\n"
            "2 code 53\n"
            "contour 1 offset 1 side left closed\n"
            "3 line X9.000000 Y1.000000 contour\n"
            "4 line X9.000000 Y9.000000 contour\n"
            "5 line X1.000000 Y9.000000 contour\n"
            "6 line X1.000000 Y1.000000 contour\n"
            "7 code 54\n");
}

TEST(Kerf, OnTheRightASquareGrowsAndItsCornersAreProlonged) {
  const Read read("t.ess", "30\n53\n+100+\n++100\n-100+\n+-100\n54\n38\n", "2");
  EXPECT_EQ(read.messages(), "");
  EXPECT_EQ(read.moves(),
            "start X0.000000 Y0.000000\n"
            "1 rapid X-1.000000 Y-1.000000 position\n"
            "2 code 53\n"
            "contour 1 offset 1 side right closed\n"
            "3 line X11.000000 Y-1.000000 contour\n"
            "4 line X11.000000 Y11.000000 contour\n"
            "5 line X-1.000000 Y11.000000 contour\n"
            "6 line X-1.000000 Y-1.000000 contour\n"
            "7 code 54\n");
}

TEST(Kerf, StraightCutsBesideTheCompensatedOnesLeadToItsMovedEnds) {
  const Read read(
      "t.nc", "G91\nG43 X1\nG00 X5\nG01 X5\nG41\nG01 Y10\nG01 X10\nG40\nG01 X10\nG00 X1\n", "0");
  EXPECT_EQ(read.messages(), "");
  EXPECT_EQ(read.moves(),
            "start X0.000000 Y0.000000\n"
            "1 rapid X5.000000 Y0.000000 position\n"
            "contour 1 offset 0 side none open\n"
            "2 line X9.000000 Y0.000000 contour\n"
            "contour 2 offset 1 side left open\n"
            "3 line X9.000000 Y11.000000 contour\n"
            "4 line X20.000000 Y11.000000 contour\n"
            "contour 3 offset 0 side none open\n"
            "5 line X30.000000 Y10.000000 contour\n"
            "6 rapid X31.000000 Y10.000000 position\n");
}

TEST(Kerf, LinesInARowAndArcsOfOneCircleStayJoined) {
  const Read read("t.nc",
                  "G91\nG43 X1\nG41\nG01 X5\nG01 X5\nG03 X5 Y5 J5\nG03 X-5 Y5 I-5\nG01 X-5\n", "0");
  EXPECT_EQ(read.messages(), "");
  EXPECT_EQ(read.moves(),
            "start X0.000000 Y0.000000\n"
            "1 rapid X0.000000 Y1.000000 position\n"
            "contour 1 offset 1 side left open\n"
            "2 line X5.000000 Y1.000000 contour\n"
            "3 line X10.000000 Y1.000000 contour\n"
            "4 arc X14.000000 Y5.000000 centre X10.000000 Y5.000000 radius 4.000000 sweep "
            "90.000000 contour\n"
            "5 arc X10.000000 Y9.000000 centre X10.000000 Y5.000000 radius 4.000000 sweep "
            "90.000000 contour\n"
            "6 line X5.000000 Y9.000000 contour\n");
}

TEST(Kerf, NearlyTangentJointsOfACoarseGridCross) {
  const Read read("t.ess", "29\n53\n+500+1\n+71+29+100--\n+290+290\n54\n38\n", "8");
  EXPECT_EQ(read.messages(), "");
  EXPECT_EQ(read.path.moves.size(), 6U) << read.moves();
  for (std::size_t i = 1; i < read.path.moves.size(); ++i)
    EXPECT_TRUE(read.path.moves[i].from == read.path.moves[i - 1].to);
}

TEST(Kerf, AFullCircleWithLeadsIsCutWhole) {
  const Read read("t.nc", "G91\nG43 X1\nG00 X20\nG42\nG01 X5\nG02 I10\nG01 X-5\nG40\nG00 X1\n",
                  "0");
  EXPECT_EQ(read.messages(), "");
  EXPECT_EQ(read.moves(),
            "start X0.000000 Y0.000000\n"
            "1 rapid X20.000000 Y-1.000000 position\n"
            "contour 1 offset 1 side right closed\n"
            "2 line X26.055728 Y-1.000000 lead-in\n"
            "3 arc X44.000000 Y0.000000 centre X35.000000 Y0.000000 radius 9.000000 sweep "
            "-186.379370 contour\n"
            "4 arc X26.055728 Y1.000000 centre X35.000000 Y0.000000 radius 9.000000 sweep "
            "-186.379370 contour\n"
            "5 line X20.000000 Y1.000000 lead-out\n"
            "6 rapid X21.000000 Y0.000000 position\n");
}

TEST(Kerf, AFaultInASubprogramTellsWhereItIsCalled) {
  const Read read("t.ess", "101+\n53\n+100+\n++10+5-+\n-100+\n54\n101-\n30\n101\n38\n", "2");
  EXPECT_EQ(read.messages(),
            "t.ess:4:1: error: the offset eats ++10+5-+, which lacks 0.5 mm [DGT0502]\n"
            "++10+5-+\n"
            "^~~~~~~~\n"
            "t.ess:9:1: note: in the subprogram 101, called here [DGT1219]\n"
            "101\n"
            "^~~\n");
}

TEST(Kerf, ASwitchThatSaysTheSameAgainChangesNothing) {
  const Read read("t.nc", "G91\nG43 X1\nG41\nG01 X5\nG41\nG01 X5\n", "0");
  EXPECT_EQ(read.messages(), "");
  EXPECT_THAT(read.path.contours, SizeIs(1));
}

TEST(Kerf, ADiameterBehindTheWordIsHalved) {
  const Read read("t.nc", "G91\nG41.1 D4\nG01 X5\n", "0");
  ASSERT_THAT(read.path.contours, SizeIs(1));
  EXPECT_EQ(read.path.contours[0].offset, 2);
}

// --- led by the first move

/// A corner of 90° between a lead of 5 and a cut of 10, the tool on its inner side.
constexpr const char* kLed = "G43 X1\nG00 X0 Y5\nG41\nG01 X0 Y0\nG01 X10\nG01 Y10\nG40\nG01 X0\n";

TEST(KerfLead, WhereTheOffsetsMeet) {
  const Read read("t.nc", kLed, "0", KerfLead::Meets);
  EXPECT_EQ(read.messages(), "");
  EXPECT_EQ(read.moves(),
            "start X0.000000 Y5.000000\n"
            "contour 1 offset 1 side left open\n"
            "1 line X1.000000 Y1.000000 lead-in\n"
            "2 line X9.000000 Y1.000000 contour\n"
            "3 line X9.000000 Y10.000000 contour\n"
            "contour 2 offset 0 side none open\n"
            "4 line X0.000000 Y10.000000 contour\n");
}

TEST(KerfLead, BesideTheBeginning) {
  const Read read("t.nc", kLed, "0", KerfLead::Beside);
  EXPECT_EQ(read.messages(), "");
  EXPECT_EQ(read.moves(),
            "start X0.000000 Y5.000000\n"
            "contour 1 offset 1 side left open\n"
            "1 line X0.000000 Y1.000000 lead-in\n"
            "2 line X9.000000 Y1.000000 contour\n"
            "3 line X9.000000 Y10.000000 contour\n"
            "contour 2 offset 0 side none open\n"
            "4 line X0.000000 Y10.000000 contour\n");
}

TEST(KerfLead, ARapidUnderTheKerfLeadsToo) {
  const char* const rapid =
      "G43 X1\nG00 X0 Y5\nG41\nG00 X0 Y0\nM07\nG01 X10\nG01 Y10\nG40\nM08\nG00 X0\n";
  const std::string start = "start X0.000000 Y5.000000\n";
  const std::string cuts =
      "2 code M7\n"
      "contour 1 offset 1 side left open\n"
      "3 line X9.000000 Y1.000000 contour\n"
      "4 line X9.000000 Y10.000000 contour\n"
      "5 code M8\n"
      "6 rapid X0.000000 Y10.000000 position\n";
  EXPECT_EQ(Read("t.nc", rapid, "0", KerfLead::Meets).moves(),
            start + "1 rapid X1.000000 Y1.000000 position\n" + cuts);
  EXPECT_EQ(Read("t.nc", rapid, "0", KerfLead::Beside).moves(),
            start + "1 rapid X0.000000 Y1.000000 position\n" + cuts);
}

TEST(KerfLead, ACircleIsMetWhereItIs) {
  const Read read("t.nc", "G43 X1\nG00 X0 Y-15\nG42\nG01 X0 Y-10\nG03 J10\nG40\nG01 Y-15\n", "0",
                  KerfLead::Meets);
  EXPECT_EQ(read.messages(), "");
  // As LinuxCNC 2.9 meets it: X1.0000 Y-10.9545.
  EXPECT_THAT(read.moves(), ::testing::HasSubstr("1 line X1.000000 Y-10.954451 lead-in\n"));
  EXPECT_THAT(read.moves(), ::testing::HasSubstr("line X0.000000 Y-15.000000"));
}

TEST(KerfLead, HasToBeStraightAndLongerThanTheOffset) {
  const auto told = [](const char* text) {
    return Read("t.nc", text, "0", KerfLead::Beside).messages();
  };
  EXPECT_EQ(
      told("G91\nG43 X1\nG41\nG03 X3 Y3 J3\nG01 Y5\n"),
      "t.nc:4:1: error: the control comes to its offset on the first move behind G41, G42, 29 "
      "or 30, and that has to be straight [DGT1407]\n"
      "G03 X3 Y3 J3\n"
      "^~~~~~~~~~~~\n");
  EXPECT_EQ(
      told("G91\nG43 X1\nG41\nG01 X1\nG01 Y5\n"),
      "t.nc:4:1: error: the control comes to its offset on this move; it is 1 mm long and has "
      "to be longer than the offset of 1 mm [DGT1408]\n"
      "G01 X1\n"
      "^~~~~~\n");
  EXPECT_EQ(
      told("G91\nG43 X1\nG41\nG01 X5\n"),
      "t.nc:4:1: error: on this move the control comes to its offset, and nothing is cut with "
      "it behind [DGT1409]\n"
      "G01 X5\n"
      "^~~~~~\n");
}

// --- leads of runs that do not close

/// A hole begun in its middle, whose ring stays open by less than the kerf.
constexpr const char* kOpenRing =
    "G91\nG43 X3\nG41\nG01 X10\nG03 X-10 Y10 I-10\nG03 X-10 Y-10 J-10\n"
    "G03 X10 Y-10 I10\nG03 X9.6 Y7.2 J10\nG40\nG00 X-1\n";

TEST(Kerf, TheToolThatComesBackMayCutTheLead) {
  const Read read("t.nc", kOpenRing, "0");
  EXPECT_EQ(
      read.messages(),
      "t.nc:4:1: warning: 'G01 X10' is taken for a lead: the tool cuts into it later, from its "
      "far side; nothing is left of it [DGT1410]\n"
      "G01 X10\n"
      "^~~~~~~\n");
  ASSERT_FALSE(read.path.contours.empty());
  EXPECT_EQ(read.path.contours[0].programmed->at(0).role, Role::LeadIn);
  EXPECT_EQ(read.path.contours[0].programmed->at(1).role, Role::Contour);
}

TEST(Kerf, ASlotTooNarrowIsNoLead) {
  const Read read("t.nc", "G91\nG43 X1\nG41\nG01 Y-10\nG03 X1.5 I0.75\nG01 Y10\n", "0");
  EXPECT_THAT(read.messages(), ::testing::HasSubstr("error: "));
}

TEST(Kerf, ACutInTheMiddleOfARunIsNoLead) {
  // It comes back under its third cut, and the tool grazes that from its far side.
  const Read read("t.nc",
                  "G91\nG43 X0.6\nG41\nG01 X10\nG01 Y10\nG01 X10\nG01 Y5\nG01 X5\nG01 Y-10\n"
                  "G01 X-12\nG01 Y4.2\nG01 X5\nG01 Y-3\n",
                  "0");
  EXPECT_THAT(read.messages(), ::testing::HasSubstr("t.nc:12:1: error: "));
  EXPECT_THAT(read.messages(), ::testing::Not(::testing::HasSubstr("taken for a lead")));
}

TEST(Kerf, RoundingOfTheProgramIsNoGouge) {
  // Closed but for a thousandth, which the tool is then nearer to its beginning.
  const char* const text =
      "G90\nG43 X1\nG41\nG01 X9.5\nG01 Y{}\nG01 X-10\nG01 Y0.001\nG01 X3\nG40\n";
  std::string coarse = text;
  coarse.replace(coarse.find("{}"), 2, "10.000");
  EXPECT_EQ(Read("t.nc", coarse, "0").messages(), "");
}

}  // namespace
}  // namespace dgt
