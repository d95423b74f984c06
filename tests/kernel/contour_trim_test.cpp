// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "kernel/contour.h"
#include "kernel/stretch.h"
#include "tests/kernel/contour_notation.h"

namespace dgt::notation {
namespace {

using Kind = ContourFault::Kind;
using testing::IsEmpty;

ContourOptions trimmed(CornerStyle style = CornerStyle::Extend) {
  ContourOptions options;
  options.offset_side = OffsetSide::Left;
  options.gouge = GougePolicy::Trim;
  options.corner = style;
  return options;
}

std::vector<ContourNotice> cuts(const BuiltContour& built) {
  std::vector<ContourNotice> found;
  for (const ContourNotice& n : built.notices)
    if (n.kind == ContourNotice::Kind::Trimmed) found.push_back(n);
  return found;
}

/// No cut of the path comes nearer to the programmed contour than `offset`, exactly.
void expect_clear(const BuiltContour& built, const Rational& offset) {
  for (const Move& cut : built.moves) {
    if (!is_part(cut)) continue;
    for (const Move& wall : built.programmed) {
      if (!is_part(wall)) continue;
      EXPECT_FALSE(comes_nearer(stretch_of(cut), stretch_of(wall), offset))
          << text({cut}) << " " << text({wall});
    }
  }
}

void expect_joined(const BuiltContour& built) {
  for (std::size_t i = 1; i < built.moves.size(); ++i)
    EXPECT_EQ(built.moves[i - 1].to, built.moves[i].from) << i;
}

// A room 40 × 20 with a keyway of 4 in its floor, cut counter-clockwise from inside.
class TrimTest : public testing::Test {
 protected:
  BuiltContour room(const std::string& offset, const What& bottom_of_keyway,
                    const ContourOptions& options) {
    return build({w(offset), to("-10", "10"), along(vertical("-20")), along(horizontal("0")),
                  along(vertical("-2")), bottom_of_keyway, along(minus(vertical("2"))),
                  along(horizontal("0")), along(minus(vertical("20"))),
                  along(minus(horizontal("20"))), along(vertical("-20")), to("-10", "10")},
                 at("0", "10"), options);
  }
};

TEST_F(TrimTest, AKeywayTooNarrowForTheToolIsPassed) {
  const auto built = room("3", along(horizontal("-8")), trimmed());
  ASSERT_THAT(built.faults, IsEmpty()) << text(built.faults);
  EXPECT_EQ(
      text(built.moves),
      "line(0,10 -10,10) line(-10,10 -17,10) line(-17,10 -17,3) line(-17,3 1,3) line(1,3 17,3) "
      "line(17,3 17,17) line(17,17 -17,17) line(-17,17 -17,10) line(-17,10 -10,10)");
  expect_clear(built, 3);
  expect_joined(built);
}

TEST_F(TrimTest, ARoundKeywayEatenByTheOffsetIsPassed) {
  const auto built = room("3", along(circle("0", "-8", "2")), trimmed(CornerStyle::Round));
  ASSERT_THAT(built.faults, IsEmpty()) << text(built.faults);
  // The arcs about the edges of the keyway cross at a depth of 3 − √5.
  EXPECT_EQ(text(built.moves),
            "line(0,10 -10,10) line(-10,10 -17,10) line(-17,10 -17,3) line(-17,3 -2,3) "
            "arc(-2,3 0,2.2361 r3 -41.8103) arc(0,2.2361 2,3 r3 -41.8103) line(2,3 17,3) "
            "line(17,3 17,17) line(17,17 -17,17) line(-17,17 -17,10) line(-17,10 -10,10)");
  expect_clear(built, Rational(3));
  expect_joined(built);
}

TEST_F(TrimTest, WhatIsLeftOutIsNamedWithItsPlace) {
  const auto found = cuts(room("3", along(circle("0", "-8", "2")), trimmed(CornerStyle::Round)));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].item, 3U);   // the floor before the keyway, at whose corner the tool turns
  EXPECT_EQ(found[0].other, 6U);  // its other side, at whose end the tool turns back
  EXPECT_DOUBLE_EQ(found[0].x, 0);
  EXPECT_NEAR(found[0].y, std::sqrt(5), 1e-12);
}

TEST_F(TrimTest, AKeywayThatFitsStaysAsItIs) {
  const auto plain = room("2", along(horizontal("-8")), [] {
    ContourOptions options;
    options.offset_side = OffsetSide::Left;
    return options;
  }());
  const auto built = room("2", along(horizontal("-8")), trimmed());
  ASSERT_THAT(built.faults, IsEmpty());
  EXPECT_EQ(text(built.moves), text(plain.moves));
  EXPECT_THAT(cuts(built), IsEmpty());
}

TEST_F(TrimTest, AFilletEatenByTheOffsetLeavesItsCorner) {
  const auto built = build({w("3"), to("10", "10"), along(horizontal("0")), fillet("2"),
                            along(minus(vertical("20"))), along(minus(horizontal("20"))),
                            along(vertical("0")), along(horizontal("0")), to("10", "10")},
                           at("10", "10"), trimmed());
  ASSERT_THAT(built.faults, IsEmpty()) << text(built.faults);
  EXPECT_EQ(text(built.moves),
            "line(10,10 10,3) line(10,3 17,3) line(17,3 17,17) line(17,17 3,17) line(3,17 3,3) "
            "line(3,3 10,3) line(10,3 10,10)");
  expect_clear(built, 3);
}

TEST_F(TrimTest, AFilletOfExactlyTheOffsetLeavesItsCentre) {
  const auto built = build({w("2"), to("10", "10"), along(horizontal("0")), fillet("2"),
                            along(minus(vertical("20"))), along(minus(horizontal("20"))),
                            along(vertical("0")), along(horizontal("0")), to("10", "10")},
                           at("10", "10"), trimmed());
  ASSERT_THAT(built.faults, IsEmpty()) << text(built.faults);
  EXPECT_EQ(text(built.moves).substr(0, 60),
            "line(10,10 10,2) line(10,2 18,2) line(18,2 18,18) line(18,18");
}

TEST_F(TrimTest, APartBehindANeckIsRefusedWithItsPlace) {
  // The keyway opens into a bulb that the tool would have to reach through the neck.
  const auto built = room("3", along(circle("0", "-14", "9")), trimmed());
  ASSERT_FALSE(built.faults.empty());
  EXPECT_EQ(built.faults.back().kind, Kind::TrimSplits) << text(built.faults);
  EXPECT_LT(built.faults.back().y, -5);
  EXPECT_NE(built.faults.front().kind, Kind::TrimSplits);  // what gouges is told as well
}

TEST_F(TrimTest, BegunInTheNarrowPartItIsRefused) {
  const auto built =
      build({w("3"), to("0", "-4"), along(vertical("-2")), along(horizontal("-8")),
             along(minus(vertical("2"))), along(horizontal("0")), along(minus(vertical("20"))),
             along(minus(horizontal("20"))), along(vertical("-20")), along(horizontal("0")),
             along(vertical("-2")), to("0", "-4")},
            at("0", "10"), trimmed());
  ASSERT_FALSE(built.faults.empty());
  EXPECT_EQ(built.faults.back().kind, Kind::TrimStart) << text(built.faults);
}

TEST_F(TrimTest, ARoomTooSmallForTheToolIsRefused) {
  const auto built = build({w("11"), to("10", "10"), along(horizontal("0")),
                            along(minus(vertical("20"))), along(minus(horizontal("20"))),
                            along(vertical("0")), along(horizontal("0")), to("10", "10")},
                           at("10", "10"), trimmed());
  ASSERT_FALSE(built.faults.empty());
  EXPECT_EQ(built.faults.back().kind, Kind::TrimStart) << text(built.faults);
}

TEST_F(TrimTest, AnOpenContourIsTrimmedAlongItsWay) {
  const auto built =
      build({w("3"), along(vertical("-20")), along(horizontal("0")), along(vertical("-2")),
             along(horizontal("-8")), along(minus(vertical("2"))), along(horizontal("0")),
             along(minus(vertical("20")))},
            at("-10", "10"), trimmed());
  ASSERT_THAT(built.faults, IsEmpty()) << text(built.faults);
  EXPECT_EQ(text(built.moves), "line(-10,10 -17,3) line(-17,3 1,3) line(1,3 17,3)");
  EXPECT_EQ(cuts(built).size(), 1U);
}

TEST_F(TrimTest, CodesOfWhatIsLeftOutComeWhereTheToolGoesOver) {
  const auto built =
      build({w("3"), along(vertical("-20")), along(horizontal("0")), along(vertical("-2")),
             code("M21"), along(horizontal("-8")), along(minus(vertical("2"))),
             along(horizontal("0")), along(minus(vertical("20")))},
            at("-10", "10"), trimmed());
  ASSERT_THAT(built.faults, IsEmpty()) << text(built.faults);
  EXPECT_EQ(text(built.moves), "line(-10,10 -17,3) line(-17,3 1,3) M21 line(1,3 17,3)");
}

}  // namespace
}  // namespace dgt::notation
