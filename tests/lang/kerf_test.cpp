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
  Read(const char* name, std::string_view text, const char* kerf) : file_(name, text) {
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
    if (!bag_.has_errors()) path = with_kerf(file_, std::move(program), ContourOptions{}, bag_);
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

}  // namespace
}  // namespace dgt
