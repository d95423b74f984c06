// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "kernel/contour.h"
#include "tests/kernel/contour_notation.h"

namespace dgt::notation {
namespace {

using testing::IsEmpty;

ContourOptions corners(CornerStyle style, const Rational& limit = 4) {
  ContourOptions options;
  options.corner = style;
  options.corner_limit = limit;
  return options;
}

std::vector<ContourNotice> long_corners(const BuiltContour& built) {
  std::vector<ContourNotice> found;
  for (const ContourNotice& n : built.notices)
    if (n.kind == ContourNotice::Kind::LongCorner) found.push_back(n);
  return found;
}

// A rectangle 20 × 10, counter-clockwise, begun in its lower left corner.
class CornerTest : public testing::Test {
 protected:
  BuiltContour rectangle(const std::string& offset, const Point& tool,
                         const ContourOptions& options) {
    return build({w(offset), along(left), along(bottom), along(right), along(top), along(left),
                  along(bottom)},
                 tool, options);
  }
  ElementPtr bottom = horizontal("0");
  ElementPtr top = minus(horizontal("10"));
  ElementPtr left = vertical("0");
  ElementPtr right = minus(vertical("20"));
};

TEST_F(CornerTest, RoundGoesAboutTheProgrammedCornersTheFirstIncluded) {
  const auto built = rectangle("1", at("-5", "5"), corners(CornerStyle::Round));
  ASSERT_THAT(built.faults, IsEmpty());
  EXPECT_EQ(text(built.moves),
            "line(-5,5 0,-1) line(0,-1 20,-1) arc(20,-1 21,0 r1 90) line(21,0 21,10) "
            "arc(21,10 20,11 r1 90) line(20,11 0,11) arc(0,11 -1,10 r1 90) line(-1,10 -1,0) "
            "arc(-1,0 0,-1 r1 90)");
  EXPECT_EQ(built.moves[2].role, Role::Corner);
  EXPECT_EQ(built.moves[2].source.column, 4U);  // the element behind the corner
  EXPECT_TRUE(built.closed);
}

TEST_F(CornerTest, RoundLeavesInnerCornersAlone) {
  const auto built = rectangle("1", at("5", "5"), corners(CornerStyle::Round));
  EXPECT_EQ(text(built.moves),
            "line(5,5 1,1) line(1,1 19,1) line(19,1 19,9) line(19,9 1,9) line(1,9 1,1)");
}

TEST_F(CornerTest, RoundRunsClockwiseWhereTheToolIsOnTheLeft) {
  const auto built = build(
      {w("1"), along(minus(right)), along(minus(bottom)), along(minus(left)), along(minus(top))},
      at("25", "5"), corners(CornerStyle::Round));
  ASSERT_EQ(built.side, Side::Left);
  EXPECT_EQ(text(built.moves),
            "line(25,5 21,-1) line(21,-1 0,-1) arc(0,-1 -1,0 r1 -90) line(-1,0 -1,11)");
}

TEST_F(CornerTest, ChamferExtendsUpToTheLimitAndCutsAcrossBeyondIt) {
  // A square corner lies √2 of the offset away: 1.4142.
  const auto near = rectangle("1", at("-5", "5"), corners(CornerStyle::Chamfer, number("1.42")));
  EXPECT_EQ(text(near.moves),
            "line(-5,5 -1,-1) line(-1,-1 21,-1) line(21,-1 21,11) line(21,11 -1,11) "
            "line(-1,11 -1,-1)");
  const auto far = rectangle("1", at("-5", "5"), corners(CornerStyle::Chamfer, 1));
  EXPECT_EQ(text(far.moves),
            "line(-5,5 -0.4142,-1) line(-0.4142,-1 20.4142,-1) line(20.4142,-1 21,-0.4142) "
            "line(21,-0.4142 21,10.4142) line(21,10.4142 20.4142,11) line(20.4142,11 -0.4142,11) "
            "line(-0.4142,11 -1,10.4142) line(-1,10.4142 -1,-0.4142) "
            "line(-1,-0.4142 -0.4142,-1)");
  EXPECT_EQ(far.moves[2].role, Role::Corner);
}

TEST_F(CornerTest, ALongExtendedCornerIsNoticedWithItsPlace) {
  const auto built = rectangle("1", at("-5", "5"), corners(CornerStyle::Extend, number("1.41")));
  const auto found = long_corners(built);
  ASSERT_EQ(found.size(), 4U);  // the one where it begins and ends is one
  EXPECT_EQ(found[0].item, 2U);
  EXPECT_EQ(found[0].other, 3U);
  EXPECT_NEAR(found[0].measure, std::sqrt(2), 1e-12);
  EXPECT_DOUBLE_EQ(found[0].x, 21);
  EXPECT_DOUBLE_EQ(found[0].y, -1);
  EXPECT_THAT(long_corners(rectangle("1", at("-5", "5"), {})), IsEmpty());
  EXPECT_THAT(long_corners(rectangle("1", at("5", "5"), corners(CornerStyle::Extend, 1))),
              IsEmpty());  // inner corners
}

TEST_F(CornerTest, OfALineAndACircleTheArcEndsBesideTheCornerOnBoth) {
  // Into the disc at (−4, −3), the tool above the line and inside the circle.
  const auto built = build({w("1"), along(vertical("-20")), along(horizontal("-3")),
                            along(circle("0", "0", "5")), to("9", "9")},
                           at("-19", "5"), corners(CornerStyle::Round));
  ASSERT_THAT(built.faults, IsEmpty()) << text(built.faults);
  EXPECT_EQ(text(built.moves),
            "line(-19,5 -19,-2) line(-19,-2 -4,-2) arc(-4,-2 -3.2,-2.4 r1 -53.1301) "
            "arc(-3.2,-2.4 2.8284,2.8284 r4 188.1301) line(2.8284,2.8284 9,9)");
}

TEST_F(CornerTest, AtACuspTheToolGoesHalfATurnRound) {
  // Along Y0 to the contact with a circle that comes the other way: back above the line.
  const auto c = circle("10", "5", "-5");
  const auto built = build({w("1"), to("0", "-5"), along(bottom), along(c), to("-9", "5")},
                           at("0", "-5"), corners(CornerStyle::Round));
  ASSERT_THAT(built.faults, IsEmpty()) << text(built.faults);
  EXPECT_EQ(built.moves[2].role, Role::Corner);
  EXPECT_EQ(text({built.moves[1], built.moves[2]}), "line(0,-1 10,-1) arc(10,-1 10,1 r1 180)");
}

TEST_F(CornerTest, ATangentJointIsNoCorner) {
  const auto c = circle("10", "5", "5");
  const auto built = build({w("1"), to("0", "-5"), along(bottom), along(c), to("20", "5")},
                           at("0", "-5"), corners(CornerStyle::Round));
  ASSERT_THAT(built.faults, IsEmpty()) << text(built.faults);
  for (const Move& move : built.moves) EXPECT_NE(move.role, Role::Corner);
}

TEST_F(CornerTest, ArcsWhoseOffsetsMissEachOtherAreGoneRound) {
  // Two lobes that meet in a spike, from inside: circles of 4 whose centres lie 10 apart.
  const auto lobes = [&](CornerStyle style) {
    return build({w("2"), along(left), along(circle("5", "0", "6")), along(circle("15", "0", "6")),
                  along(right)},
                 at("2", "0"), corners(style));
  };
  const auto extended = lobes(CornerStyle::Extend);
  ASSERT_EQ(extended.faults.size(), 1U) << text(extended.faults);
  EXPECT_EQ(extended.faults[0].kind, ContourFault::Kind::NoMeeting);
  EXPECT_TRUE(extended.faults[0].round_works);
  EXPECT_DOUBLE_EQ(extended.faults[0].measure, 2);
  EXPECT_EQ(extended.faults[0].largest_offset, Rational(1));
  for (const auto style : {CornerStyle::Round, CornerStyle::Chamfer}) {
    const auto gone_round = lobes(style);
    ASSERT_THAT(gone_round.faults, IsEmpty()) << text(gone_round.faults);
    EXPECT_EQ(gone_round.moves[2].role, Role::Corner);
  }
}

TEST_F(CornerTest, RoundIsNotAdvisedWhereTheToolGougesThen) {
  // The lobes of 1P and a tool twice as wide as the slots that lead to them.
  const auto built = build({w("4"), along(horizontal("2")), along(circle("14", "0", "-5")),
                            along(minus(horizontal("-2"))), along(circle("0", "0", "-7"))},
                           at("14", "0"));
  ASSERT_FALSE(built.faults.empty());
  EXPECT_EQ(built.faults[0].kind, ContourFault::Kind::NoMeeting);
  EXPECT_FALSE(built.faults[0].round_works);
}

TEST_F(CornerTest, WhereUChangesTheOffsetTheElementsAreExtended) {
  const auto built = build({w("1"), along(left), along(bottom), u("2"), along(right), along(top)},
                           at("-5", "5"), corners(CornerStyle::Round));
  EXPECT_EQ(text(built.moves), "line(-5,5 -1,-1) line(-1,-1 22,-1) line(22,-1 22,12)");
}

TEST_F(CornerTest, LinesRunAgainstTheirDirectionTurnTheOtherWay) {
  const auto built = build(
      {w("1"), along(minus(left)), along(minus(bottom)), along(minus(right)), along(minus(top))},
      at("-5", "5"), corners(CornerStyle::Round));
  EXPECT_EQ(built.side, Side::Left);
  EXPECT_EQ(text(built.moves),
            "line(-5,5 -1,-1) line(-1,-1 20,-1) arc(20,-1 21,0 r1 90) line(21,0 21,11)");
}

}  // namespace
}  // namespace dgt::notation
