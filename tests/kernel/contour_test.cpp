// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/contour.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "tests/kernel/contour_notation.h"

namespace dgt::notation {
namespace {

using Kind = ContourFault::Kind;
using testing::IsEmpty;

class ContourTest : public testing::Test {
 protected:
  ElementPtr bottom = horizontal("0");
  ElementPtr top = minus(horizontal("10"));
  ElementPtr left = vertical("0");           // runs down
  ElementPtr right = minus(vertical("20"));  // runs up
};

/// The one fault of a contour.
ContourFault only_fault(const BuiltContour& built) {
  EXPECT_EQ(built.faults.size(), 1U) << text(built.faults);
  return built.faults.empty() ? ContourFault{} : built.faults.front();
}

TEST_F(ContourTest, FirstPairOnlyPositions) {
  const auto built = build({along(left), along(bottom), along(right)}, at("5", "5"));
  EXPECT_EQ(text(built.moves), "line(5,5 0,0) line(0,0 20,0)");
  EXPECT_EQ(built.moves[0].role, Role::LeadIn);
  EXPECT_FALSE(built.closed);
}

TEST_F(ContourTest, RectangleCloses) {
  const auto built =
      build({along(left), along(bottom), along(right), along(top), along(left), along(bottom)},
            at("5", "5"));
  EXPECT_EQ(text(built.moves),
            "line(5,5 0,0) line(0,0 20,0) line(20,0 20,10) line(20,10 0,10) line(0,10 0,0)");
  EXPECT_TRUE(built.closed);
}

TEST_F(ContourTest, OffsetLiesWhereTheToolStands) {
  const auto inside = build(
      {w("1"), along(left), along(bottom), along(right), along(top), along(left), along(bottom)},
      at("5", "5"));
  EXPECT_EQ(text(inside.moves),
            "line(5,5 1,1) line(1,1 19,1) line(19,1 19,9) line(19,9 1,9) line(1,9 1,1)");
  EXPECT_EQ(inside.side, Side::Left);
  const auto outside = build(
      {w("1"), along(left), along(bottom), along(right), along(top), along(left), along(bottom)},
      at("-5", "5"));
  EXPECT_EQ(text(outside.moves),
            "line(-5,5 -1,-1) line(-1,-1 21,-1) line(21,-1 21,11) line(21,11 -1,11) "
            "line(-1,11 -1,-1)");
  EXPECT_EQ(outside.side, Side::Right);
}

TEST_F(ContourTest, ToolOnTheFirstElementLeavesTheSideUnknown) {
  const auto built = build({w("1"), along(left), along(bottom), along(right)}, at("0", "5"));
  EXPECT_EQ(only_fault(built).kind, Kind::SideUnknown);
  EXPECT_THAT(built.moves, IsEmpty());
}

TEST_F(ContourTest, NegativeOffsetAsksForASide) {
  const std::vector<What> contour{w("-1"), along(left), along(bottom), along(right)};
  EXPECT_EQ(only_fault(build(contour, at("5", "5"))).kind, Kind::SideOfNegative);
  ContourOptions options;
  options.offset_side = OffsetSide::Left;
  const auto built = build(contour, at("5", "5"), options);
  EXPECT_EQ(text(built.moves), "line(5,5 -1,-1) line(-1,-1 21,-1)");
  EXPECT_EQ(built.side, Side::Right);
}

TEST_F(ContourTest, FilletJoinsLines) {
  const auto built = build({along(left), along(bottom), fillet("2"), along(right), along(top)});
  EXPECT_EQ(text(built.moves), "line(0,0 18,0) arc(18,0 20,2 r2 90) line(20,2 20,10)");
  EXPECT_EQ(built.moves[1].role, Role::Fillet);
}

TEST_F(ContourTest, SecondFilletTurnsTheOtherWay) {
  const auto built = build(
      {along(left), along(bottom), select(Selector::I2), fillet("2"), along(right), along(top)});
  EXPECT_EQ(text(built.moves), "line(0,0 22,0) arc(22,0 20,-2 r2 -270) line(20,-2 20,10)");
}

TEST_F(ContourTest, NegativeFilletIsClockwise) {
  const auto built = build({along(left), along(bottom), fillet("-2"), along(right), along(top)});
  EXPECT_EQ(text(built.moves), "line(0,0 22,0) arc(22,0 20,-2 r2 -270) line(20,-2 20,10)");
}

TEST_F(ContourTest, FilletInTheFirstPairIsCut) {
  const auto built = build({along(bottom), fillet("2"), along(right), along(top)}, at("5", "5"));
  EXPECT_EQ(text(built.moves), "line(5,5 18,0) arc(18,0 20,2 r2 90) line(20,2 20,10)");
}

TEST_F(ContourTest, ChamferIsMeasuredOnTheProgrammedContour) {
  const std::vector<What> contour{w("1"),       along(left),  along(bottom),
                                  chamfer("2"), along(right), along(top)};
  const auto built = build(contour, at("5", "5"));
  EXPECT_EQ(text(built.programmed),
            "line(5,5 0,0) line(0,0 18,0) line(18,0 20,2) line(20,2 20,10)");
  EXPECT_EQ(built.moves[2].role, Role::Chamfer);
  // The chamfer line is offset by 1 as well: its corner lies √2 − 1 further along.
  EXPECT_EQ(text(built.moves),
            "line(5,5 1,1) line(1,1 17.5858,1) line(17.5858,1 19,2.4142) line(19,2.4142 19,9)");
}

TEST_F(ContourTest, ChamferEatenByTheOffset) {
  const auto built = build(
      {w("4"), along(left), along(bottom), chamfer("2"), along(right), along(top)}, at("5", "5"));
  EXPECT_EQ(only_fault(built).kind, Kind::Eaten);
  EXPECT_EQ(only_fault(built).item, 3U);
}

TEST_F(ContourTest, FilletEatenByTheOffset) {
  const auto built = build(
      {w("2.5"), along(left), along(bottom), fillet("2"), along(right), along(top)}, at("5", "5"));
  const auto fault = only_fault(built);
  EXPECT_EQ(fault.kind, Kind::Eaten);
  EXPECT_EQ(fault.item, 3U);
  EXPECT_DOUBLE_EQ(fault.measure, 0.5);
  EXPECT_TRUE(fault.on_equidistant);
  EXPECT_EQ(fault.largest_offset, Rational(1999, 1000));  // 2 itself eats it
}

TEST_F(ContourTest, FilletEatenToExactlyNothing) {
  const auto built = build(
      {w("2"), along(left), along(bottom), fillet("2"), along(right), along(top)}, at("5", "5"));
  EXPECT_EQ(only_fault(built).kind, Kind::Eaten);
}

TEST_F(ContourTest, LineTooShortForTheBlendsAtItsEnds) {
  // The side is 10 long: legs of 6 and 7 overlap by 3.
  for (const auto& blend : {chamfer, fillet}) {
    const auto built =
        build({along(left), along(bottom), blend("6"), along(right), blend("7"), along(top)},
              at("5", "5"));
    const auto fault = only_fault(built);
    EXPECT_EQ(fault.kind, Kind::BlendsOverlap);
    EXPECT_EQ(fault.item, 3U);
    EXPECT_DOUBLE_EQ(fault.measure, 3);
    EXPECT_FALSE(fault.on_equidistant);
  }
}

TEST_F(ContourTest, LineTooShortForABlendAndItsCorner) {
  const auto built =
      build({along(left), along(bottom), fillet("12"), along(right), along(top), along(left)},
            at("5", "5"));
  EXPECT_EQ(only_fault(built).kind, Kind::BlendsOverlap);
  EXPECT_EQ(only_fault(built).item, 3U);
}

TEST_F(ContourTest, LineJustLongEnoughForTheBlendsAtItsEnds) {
  const auto built =
      build({along(left), along(bottom), fillet("5"), along(right), fillet("5"), along(top)},
            at("5", "5"));
  EXPECT_TRUE(built.faults.empty());
}

TEST_F(ContourTest, LineTooShortForAFilletToACircle) {
  // The hole begins at x = 12; a fillet r outside it begins at x = 20 − √(64 + 16r).
  const auto hole = circle("20", "0", "-8");
  const auto with = [&](const std::string& r) {
    return build({along(left), along(bottom), fillet(r), along(hole), along(bottom)}, at("5", "5"));
  };
  EXPECT_THAT(with("2").faults, IsEmpty());
  EXPECT_THAT(with("20").faults, IsEmpty());
  const auto fault = only_fault(with("24"));
  EXPECT_EQ(fault.kind, Kind::BlendsOverlap);
  EXPECT_EQ(fault.item, 1U);
  EXPECT_NEAR(fault.measure, std::sqrt(64. + 16 * 24) - 20, 1e-12);
}

TEST_F(ContourTest, LineTooShortForAFilletToACircleItDoesNotMeet) {
  // The circle stays 1 above the line, the fillet reaches it all the same.
  const auto above = circle("6", "9", "-8");
  const auto with = [&](const std::string& r) {
    return build({along(left), along(bottom), fillet(r), along(above), along(top)}, at("5", "5"));
  };
  EXPECT_THAT(with("1").faults, IsEmpty());
  const auto fault = only_fault(with("9"));
  EXPECT_EQ(fault.kind, Kind::BlendsOverlap);
  EXPECT_EQ(fault.item, 1U);
}

TEST_F(ContourTest, ArcTooShortForTheFilletsAtItsEnds) {
  // A boss of radius 3 at the bottom of a right-angled valley. Fillets r on its flanks begin
  // √(9 + 6r) up the slopes; they pass each other over the boss once that is less than r.
  const auto boss = circle("0", "0", "-3");
  const auto with = [&](const std::string& first, const std::string& second) {
    return build({to("-20", "20"), along(turned(bottom, "-45")), fillet(first), along(boss),
                  fillet(second), along(turned(bottom, "45")), to("20", "20")},
                 at("0", "30"));
  };
  EXPECT_THAT(with("7", "7").faults, IsEmpty());
  EXPECT_THAT(with("1", "20").faults, IsEmpty());
  const auto fault = only_fault(with("9", "9"));
  EXPECT_EQ(fault.kind, Kind::BlendsOverlap);
  EXPECT_EQ(fault.item, 3U);
  const double slope = std::sqrt(63.);
  EXPECT_NEAR(fault.measure, 2 * 3 * std::atan((9 - slope) / (9 + slope)), 1e-9);
}

TEST_F(ContourTest, ArcOfAlmostAFullTurnBetweenFilletsIsNoOverlap) {
  // Round a hub and out again where it was entered.
  const auto hub = circle("0", "0", "5");
  const auto built = build({to("-1", "20"), along(vertical("-1")), fillet("2"), along(hub),
                            fillet("2"), along(minus(vertical("1"))), to("1", "20")},
                           at("0", "30"));
  EXPECT_THAT(built.faults, IsEmpty()) << text(built.faults);
}

TEST_F(ContourTest, LegTurnedOverByTheOffsetIsEaten) {
  // A slot 3 wide and a tool of radius 2 in it: the bottom leg runs backwards.
  const auto near = minus(vertical("3"));
  const auto built =
      build({w("2"), along(left), along(bottom), along(near), along(top)}, at("1.5", "5"));
  EXPECT_EQ(only_fault(built).kind, Kind::Eaten);
  EXPECT_EQ(only_fault(built).item, 2U);
  EXPECT_EQ(only_fault(built).largest_offset, Rational(3, 2));
}

TEST_F(ContourTest, ApproachAndDepartureAlongTheNormal) {
  const auto c = circle("0", "0", "10");
  const auto built = build({w("1"), to("0", "15"), along(c), to("20", "0")}, at("0", "20"));
  EXPECT_EQ(text(built.moves),
            "line(0,20 0,15) line(0,15 0,11) arc(0,11 11,0 r11 270) line(11,0 20,0)");
  EXPECT_EQ(built.moves[0].role, Role::Position);
  EXPECT_EQ(built.moves[1].role, Role::LeadIn);
  EXPECT_EQ(built.moves[3].role, Role::LeadOut);
}

TEST_F(ContourTest, OneFootAndBackIsAFullCircle) {
  const auto c = circle("0", "0", "-10");
  const auto built = build({w("1"), to("0", "15"), along(c), to("0", "15")}, at("0", "20"));
  EXPECT_EQ(text(built.moves),
            "line(0,20 0,15) line(0,15 0,11) arc(0,11 0,11 r11 -360) line(0,11 0,15)");
  EXPECT_TRUE(built.moves[2].full_circle);
  EXPECT_TRUE(built.closed);
}

TEST_F(ContourTest, CommonTangentsJoinCircles) {
  const auto a = circle("0", "0", "5");
  const auto b = circle("20", "0", "5");
  const auto built =
      build({along(a), tangent(), along(b), tangent(), along(a), tangent(), along(b)});
  EXPECT_EQ(text(built.moves),
            "line(0,0 0,-5) line(0,-5 20,-5) arc(20,-5 20,5 r5 180) line(20,5 0,5) "
            "arc(0,5 0,-5 r5 180) line(0,-5 20,-5)");
  EXPECT_EQ(built.moves[1].role, Role::Tangent);
}

TEST_F(ContourTest, CircleIsLeftWhereTheLineLeavesIt) {
  // The slot of sample 1P: into the lobe along +X, round clockwise, out along −X.
  const auto lobe = circle("14", "0", "-5");
  const auto built = build({along(horizontal("2")), along(lobe), along(minus(horizontal("-2"))),
                            along(circle("0", "0", "-7"))},
                           at("14", "0"));
  EXPECT_EQ(text(built.moves),
            "line(14,0 9.4174,2) arc(9.4174,2 9.4174,-2 r5 -312.8436) line(9.4174,-2 6.7082,-2)");
}

TEST_F(ContourTest, SelectorsCompareCoordinates) {
  const auto c = circle("0", "0", "5");
  const auto line = horizontal("3");
  const auto positioned = [&](Selector s) {
    return text(build({along(line), select(s), along(c), to("10", "10")}).moves).substr(0, 14);
  };
  EXPECT_EQ(positioned(Selector::I1), "line(0,0 -4,3)");
  EXPECT_EQ(positioned(Selector::I2), "line(0,0 4,3) ");
  EXPECT_EQ(positioned(Selector::GreaterX), "line(0,0 4,3) ");
  EXPECT_EQ(positioned(Selector::SmallerX), "line(0,0 -4,3)");
  const auto equal = build({along(line), select(Selector::GreaterY), along(c), to("10", "10")});
  EXPECT_EQ(equal.faults.front().kind, Kind::EqualCandidates);
}

TEST_F(ContourTest, SelectorBetweenLinesSelectsNothing) {
  const auto built = build({along(left), select(Selector::I2), along(bottom), along(right)});
  EXPECT_EQ(only_fault(built).kind, Kind::NoChoice);
}

TEST_F(ContourTest, NearMissIsJoinedWithANotice) {
  const auto c = circle("0", "5.0005", "5");
  const auto built = build({along(left), along(bottom), along(c), to("0", "20")});
  EXPECT_THAT(built.faults, IsEmpty()) << text(built.faults);
  ASSERT_EQ(built.notices.size(), 1U);
  EXPECT_EQ(built.notices[0].kind, ContourNotice::Kind::JoinedGap);
  EXPECT_DOUBLE_EQ(built.notices[0].measure, 0.0005);
}

TEST_F(ContourTest, MissReportsTheGap) {
  const auto built = build({along(bottom), along(circle("0", "5.25", "5")), to("0", "20")});
  const auto fault = built.faults.front();
  EXPECT_EQ(fault.kind, Kind::NoMeeting);
  EXPECT_DOUBLE_EQ(fault.measure, 0.25);
  EXPECT_FALSE(fault.on_equidistant);
}

TEST_F(ContourTest, MissOfTheEquidistantSaysSo) {
  // A line that cuts a clockwise circle 0.5 deep: offset to the right both draw back, by 1 each.
  const auto c = circle("0", "4.5", "-5");
  const auto built =
      build({w("1"), along(left), along(bottom), along(c), to("0", "20")}, at("-20", "-3"));
  ASSERT_FALSE(built.faults.empty());
  EXPECT_TRUE(built.faults.front().on_equidistant);
  EXPECT_DOUBLE_EQ(built.faults.front().measure, 1.5);
  // They would touch until 0.25, but the leg between runs out of length a little before.
  EXPECT_EQ(built.faults.front().largest_offset, Rational(123, 500));
}

TEST_F(ContourTest, DistanceRunsAlongTheLine) {
  const auto built = build({along(left), along(bottom), travel("7"), to("7", "5")});
  EXPECT_EQ(text(built.moves), "line(0,0 7,0) line(7,0 7,5)");
}

TEST_F(ContourTest, DistanceIsMeasuredOnTheProgrammedContour) {
  const auto built = build({w("1"), along(left), along(bottom), travel("7")}, at("5", "5"));
  EXPECT_EQ(text(built.moves), "line(5,5 1,1) line(1,1 7,1)");
}

TEST_F(ContourTest, AxisBeginsAndEnds) {
  const auto built =
      build({w("1"), axis(vertical("3")), along(bottom), axis(vertical("12"))}, at("3", "5"));
  EXPECT_EQ(text(built.moves), "line(3,5 3,1) line(3,1 12,1)");
}

TEST_F(ContourTest, TechnologyStaysInPlace) {
  const auto built = build({code("M7"), along(left), along(bottom), dwell("0.5"), along(right),
                            height("-3"), along(top)},
                           at("5", "5"));
  EXPECT_EQ(text(built.moves), "M7 line(5,5 0,0) dwell(0.5) line(0,0 20,0) line(20,0 20,10 z-3)");
}

TEST_F(ContourTest, RapidOnceIsForTheNextMoveOffTheElements) {
  const auto built =
      build({to("5", "5"), rapid(), along(bottom), along(right), along(top)}, at("9", "9"));
  EXPECT_EQ(text(built.moves), "line(9,9 5,5) rapid(5,5 5,0) line(5,0 20,0) line(20,0 20,10)");
}

TEST_F(ContourTest, RapidFeedRefusesArcs) {
  const auto built = build({feed("0"), along(bottom), fillet("2"), along(right), along(top)});
  EXPECT_EQ(only_fault(built).kind, Kind::RapidArc);
}

TEST_F(ContourTest, SecondOffsetFromTheNextElement) {
  const auto built =
      build({w("1"), along(left), along(bottom), u("2"), along(right), along(top)}, at("5", "5"));
  EXPECT_EQ(text(built.moves), "line(5,5 1,1) line(1,1 18,1) line(18,1 18,8)");
}

TEST_F(ContourTest, OffsetChangeAtAFilletIsRefused) {
  const auto built =
      build({w("1"), along(left), along(bottom), u("2"), fillet("2"), along(right), along(top)},
            at("5", "5"));
  EXPECT_EQ(only_fault(built).kind, Kind::OffsetAtTangent);
}

TEST_F(ContourTest, CutAgainstTheLineIsNoticed) {
  const auto built = build({w("1"), along(left), along(minus(bottom)), along(right)}, at("5", "5"));
  ASSERT_EQ(built.notices.size(), 2U);
  EXPECT_EQ(built.notices[1].kind, ContourNotice::Kind::AgainstDirection);
  EXPECT_EQ(built.notices[1].item, 2U);
}

TEST_F(ContourTest, ZeroArcIsRefused) {
  // Two tangents at one point of the circle: nothing is left of it.
  const auto c = circle("0", "5", "5");
  const auto built =
      build({along(left), along(bottom), along(c), along(bottom), to("9", "9")}, at("-9", "9"));
  EXPECT_EQ(built.faults.front().kind, Kind::ZeroArc);
}

TEST_F(ContourTest, CentreAsApproachIsRefused) {
  const auto built = build({to("3", "4"), along(circle("3", "4", "5")), to("9", "9")});
  EXPECT_EQ(built.faults.front().kind, Kind::CentreApproach);
}

TEST_F(ContourTest, ClosedWhenTheEndLiesOnTheFirstLeg) {
  const auto built = build({to("-5", "6"), along(left), along(bottom), along(right), along(top),
                            along(left), axis(horizontal("3"))},
                           at("-9", "9"));
  EXPECT_TRUE(built.closed) << text(built.moves);
}

// A U-shaped slot, 4 wide, entered and left by lines that the tool's neighbours do not know of.
class GougeTest : public ContourTest {
 protected:
  BuiltContour slot(const std::string& offset, const ContourOptions& options = {}) {
    return build({w(offset), along(vertical("-20")), along(horizontal("0")), along(vertical("0")),
                  along(circle("2", "-10", "2")), along(minus(vertical("4"))),
                  along(horizontal("0")), along(minus(vertical("20")))},
                 at("-15", "5"), options);
  }
};

TEST_F(GougeTest, SlotExactlyAsWideAsTheToolIsNone) {
  const auto built = slot("1.999");
  EXPECT_THAT(built.faults, IsEmpty()) << text(built.faults);
}

TEST_F(GougeTest, SlotNarrowerThanTheToolNamesBothSidesAndWhatFits) {
  // The round end would be eaten first; a flat end is not, and the sides still meet it.
  const auto built =
      build({w("2.1"), along(vertical("-20")), along(horizontal("0")), along(vertical("0")),
             axis(horizontal("-10")), axis(horizontal("-10")), along(minus(vertical("4"))),
             along(horizontal("0")), along(minus(vertical("20")))},
            at("-15", "5"));
  ASSERT_FALSE(built.faults.empty());
  const auto& fault = built.faults.front();
  EXPECT_EQ(fault.kind, Kind::Gouge);
  EXPECT_NEAR(fault.measure, 0.2, 1e-9);  // 2.1 − (4 − 2.1)
  EXPECT_EQ(fault.item, 3U);
  EXPECT_EQ(fault.other, 6U);
  EXPECT_EQ(fault.largest_offset, Rational(2));
}

TEST_F(GougeTest, SampleOneRefusesAToolWiderThanItsSlots) {
  std::vector<What> hub{w("2.1")};
  const auto top_side = horizontal("2");
  const auto bottom_side = minus(horizontal("-2"));
  const auto lobe = circle("14", "0", "-5");
  const auto rim = circle("0", "0", "-7");
  for (const char* angle : {"0", "-60", "-120", "-180", "-240", "-300"}) {
    for (const auto& e : {top_side, lobe, bottom_side, rim}) hub.push_back(along(turned(e, angle)));
  }
  hub.push_back(along(top_side));
  hub.push_back(along(lobe));
  const auto built = build(hub, at("14", "0"));
  ASSERT_FALSE(built.faults.empty());
  EXPECT_EQ(built.faults.front().kind, Kind::Gouge);
  EXPECT_EQ(built.faults.front().largest_offset, Rational(2));
  hub.front() = w("2.001");
  EXPECT_EQ(build(hub, at("14", "0")).faults.front().kind, Kind::Gouge);
}

TEST_F(GougeTest, AToolExactlyAsWideAsTheSlotsGoesRoundTheLobesInFullTurns) {
  const auto built = build({w("2"), along(horizontal("2")), along(circle("14", "0", "-5")),
                            along(minus(horizontal("-2"))), along(circle("0", "0", "-7"))},
                           at("14", "0"));
  ASSERT_THAT(built.faults, IsEmpty()) << text(built.faults);
  EXPECT_EQ(text(built.moves), "line(14,0 11,0) arc(11,0 11,0 r3 -360) line(11,0 5,0)");
  EXPECT_TRUE(built.moves[1].full_circle);
}

TEST_F(GougeTest, MayOnlyWarn) {
  ContourOptions options;
  options.gouge = GougePolicy::Warn;
  const auto built =
      build({w("2.1"), along(vertical("-20")), along(horizontal("0")), along(vertical("0")),
             axis(horizontal("-10")), axis(horizontal("-10")), along(minus(vertical("4"))),
             along(horizontal("0")), along(minus(vertical("20")))},
            at("-15", "5"), options);
  EXPECT_THAT(built.faults, IsEmpty());
  EXPECT_TRUE(std::any_of(built.notices.begin(), built.notices.end(),
                          [](const auto& n) { return n.kind == ContourNotice::Kind::Gouge; }));
  EXPECT_FALSE(built.moves.empty());
}

TEST_F(GougeTest, LeadBeyondTheMeetingIsNoPart) {
  // KVAD cut whole: it begins on the left side above the square and ends on it.
  const auto side = [](const std::string& x) { return vertical(x); };
  const auto built =
      build({w("3"), to("5", "5"), rapid(), along(side("10")), chamfer("6"),
             along(horizontal("-40")), chamfer("6"), along(minus(side("40"))), chamfer("6"),
             along(minus(horizontal("-10"))), chamfer("6"), along(side("10"))});
  EXPECT_THAT(built.faults, IsEmpty()) << text(built.faults);
  EXPECT_TRUE(built.closed);
  EXPECT_EQ(built.side, Side::Right);
}

TEST_F(GougeTest, LoopAboutACornerIsMeant) {
  // Overshoot, turn clockwise about the corner, come back across the first line: usual in wire
  // work.
  const auto built = build({w("0.2"), to("10", "-5"), along(bottom), fillet("-3"), along(right),
                            along(top), along(left), along(bottom), to("10", "-5")},
                           at("10", "-5"));
  EXPECT_THAT(built.faults, IsEmpty()) << text(built.faults);
  EXPECT_TRUE(built.closed);
}

}  // namespace
}  // namespace dgt::notation
