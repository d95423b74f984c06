// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/part_crossing.h"

#include <gmock/gmock.h>

#include "tests/kernel/contour_notation.h"

namespace dgt::notation {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// Contours cut one after the other, with rapids between them.
class Sheet {
 public:
  Sheet(const std::string& x, const std::string& y) { state_.at = at(x, y); }
  Sheet& rapid_to(const std::string& x, const std::string& y) {
    Move move;
    move.kind = MoveKind::Rapid;
    move.role = Role::Position;
    move.from = state_.at;
    move.to = state_.at = at(x, y);
    path_.moves.push_back(move);
    return *this;
  }
  Sheet& cut(std::vector<What> whats) {
    BuiltContour built = build_contour(items(std::move(whats)), state_, {});
    EXPECT_THAT(built.faults, IsEmpty());
    Contour& contour = path_.contours.emplace_back();
    contour.offset = built.offset;
    contour.side = built.side;
    contour.closed = built.closed;
    contour.programmed = built.programmed;
    contour.first = path_.moves.size();
    path_.moves.insert(path_.moves.end(), built.moves.begin(), built.moves.end());
    contour.last = path_.moves.size();
    return *this;
  }
  /// Each crossing as `lead-in K0/2 0.2 at 10,5`: the role, the contour and its move, the depth.
  [[nodiscard]] std::vector<std::string> crossings(CrossingMoves which = CrossingMoves::All) const {
    std::vector<std::string> told;
    for (const PartCrossing& c : find_part_crossings(path_, which, 0)) {
      const Move& move = path_.moves[c.move];
      const auto short_of = [](double v) { return to_short_decimal(Rational(v), 4); };
      std::string text = move.kind == MoveKind::Rapid ? "rapid" : name_of(move.role);
      text += " K" + std::to_string(c.contour) + "/" + std::to_string(c.wall);
      if (c.depth > 0) text += " " + short_of(c.depth);
      told.push_back(text + " at " + short_of(c.x) + "," + short_of(c.y));
    }
    return told;
  }

 private:
  Toolpath path_;
  ToolState state_;
};

class PartCrossing20x10 : public testing::Test {
 protected:
  /// From the lower left corner, counter-clockwise.
  [[nodiscard]] std::vector<What> rectangle(const std::string& offset) const {
    return {w(offset),  along(left), along(bottom), along(right),
            along(top), along(left), along(bottom)};
  }
  ElementPtr bottom = horizontal("0");
  ElementPtr top = minus(horizontal("10"));
  ElementPtr left = vertical("0");
  ElementPtr right = minus(vertical("20"));
};

TEST_F(PartCrossing20x10, ALeadFromTheSideOfTheToolCrossesNothing) {
  EXPECT_THAT(Sheet("-5", "-5").cut(rectangle("0.5")).crossings(), IsEmpty());
}

TEST_F(PartCrossing20x10, ALeadThroughThePartReachesAsDeepAsTheToolIsWide) {
  const auto sheet = Sheet("25", "5").cut(rectangle("0.5"));
  EXPECT_THAT(sheet.crossings(), ElementsAre("lead-in K0/2 0.5 at 20,4.0816"));
}

TEST_F(PartCrossing20x10, ALeadBesideThePartIsHeldAgainstTheWidthOfTheTool) {
  // Past the upper left corner, 0.2968 away from it, to the lower left one.
  EXPECT_THAT(Sheet("-0.2", "15").cut(rectangle("0.5")).crossings(),
              ElementsAre("lead-in K0/3 0.2033 at -0.2967,10.0057"));
}

TEST_F(PartCrossing20x10, ALeadThatGrazesExactlyAtItsReachCrossesNothing) {
  // Down the side, 0.5 away from it all the time, and round the corner.
  const auto sheet =
      Sheet("-0.5", "30")
          .cut({w("0.5"), to("-0.5", "30"), along(bottom), along(right), along(top)});
  EXPECT_THAT(sheet.crossings(), IsEmpty());
}

TEST_F(PartCrossing20x10, WithoutAnOffsetALeadMayEndOnTheContourAndNotCrossIt) {
  EXPECT_THAT(Sheet("-5", "-5").cut(rectangle("0")).crossings(), IsEmpty());
  EXPECT_THAT(Sheet("25", "5").cut(rectangle("0")).crossings(),
              ElementsAre("lead-in K0/2 at 20,4"));
}

TEST_F(PartCrossing20x10, ALeadAlongTheTangentOfACircleIsAContactNotACrossing) {
  Toolpath path;
  Contour& contour = path.contours.emplace_back();
  Move arc;
  arc.kind = MoveKind::Arc;
  arc.from = at("7", "0");
  arc.to = at("-7", "0");
  arc.carrier = carrier(*circle("0", "0", "7"));
  contour.programmed = std::vector{arc};
  Move lead;
  lead.role = Role::LeadIn;
  lead.from = at("7", "-9");
  lead.to = arc.from;
  path.moves = {lead, arc};
  contour.last = path.moves.size();
  EXPECT_THAT(find_part_crossings(path, CrossingMoves::All, 0), IsEmpty());
  path.moves.front().from = at("-9", "9");  // through the circle
  EXPECT_THAT(find_part_crossings(path, CrossingMoves::All, 0), SizeIs(1));
}

TEST_F(PartCrossing20x10, ARapidIsToldOnceForEachContourWhereItFirstMeetsIt) {
  const auto sheet =
      Sheet("-5", "-5").cut(rectangle("0.5")).rapid_to("-5", "5").rapid_to("25", "5");
  EXPECT_THAT(sheet.crossings(), ElementsAre("rapid K0/4 at 0,5"));
  EXPECT_THAT(sheet.crossings(CrossingMoves::Leads), IsEmpty());
  EXPECT_THAT(sheet.crossings(CrossingMoves::None), IsEmpty());
}

TEST_F(PartCrossing20x10, ARapidThroughACornerMeetsIt) {
  const auto sheet =
      Sheet("-5", "-5").cut(rectangle("0.5")).rapid_to("-5", "5").rapid_to("5", "-5");
  EXPECT_THAT(sheet.crossings(), ElementsAre("rapid K0/1 at 0,0"));
}

TEST_F(PartCrossing20x10, ARapidFromWhereACutWithoutOffsetEndsDoesNotMeetItThere) {
  const auto sheet = Sheet("-5", "-5").cut(rectangle("0")).rapid_to("-5", "-5");
  EXPECT_THAT(sheet.crossings(), IsEmpty());
}

TEST_F(PartCrossing20x10, AMoveTooShortToHaveAnInsideMeetsNothing) {
  const auto sheet = Sheet("-5", "-5").cut(rectangle("0")).rapid_to("0.000001", "0.000001");
  EXPECT_THAT(sheet.crossings(), IsEmpty());
}

TEST_F(PartCrossing20x10, ALineCutAgainstItsDirectionIsNoWall) {
  Sheet sheet("-5", "-5");
  sheet.cut({w("0.5"), along(left), along(bottom), along(minus(right)), along(top), along(left),
             along(bottom)});
  EXPECT_THAT(sheet.rapid_to("25", "-5").rapid_to("25", "5").rapid_to("15", "5").crossings(),
              IsEmpty());
}

TEST_F(PartCrossing20x10, APartWithoutContoursIsCrossedByNothing) {
  EXPECT_THAT(Sheet("5", "5").crossings(), IsEmpty());
}

}  // namespace
}  // namespace dgt::notation
