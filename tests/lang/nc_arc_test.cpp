// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs of NC programs: the laws of lang/nc/arc.h, on the grid and off it.
#include <gmock/gmock.h>

#include <random>

#include "lang/nc/arc_check.h"
#include "lang/nc/told_arc.h"

namespace dgt {
namespace {

Spot spot(long x, long y) { return {Length::of_steps(x), Length::of_steps(y)}; }

/// The same place told so that no machine word holds it.
Spot off_grid(const Spot& s) {
  const Rational little = power_of_two(-130);
  const RationalPoint p = s.exact();
  return {Length(p.x + little), Length(p.y + little)};
}

Rational off_circle(const Circle& circle, const RationalPoint& p) {
  return abs(squared_length(p - circle.centre()) - circle.radius() * circle.radius());
}

/// Arcs of every size, whose centres lie a little off the bisectors of their chords.
struct RandomArc {
  Spot from, chord, centre;
};
RandomArc random_arc(std::mt19937& random) {
  std::uniform_int_distribution<long> size(1, 36);
  const long reach = 1L << size(random);
  std::uniform_int_distribution<long> step(-reach, reach);
  std::uniform_int_distribution<long> anywhere(-1'000'000'000'000, 1'000'000'000'000);
  RandomArc arc;
  arc.from = spot(anywhere(random), anywhere(random));
  do {
    arc.chord = spot(step(random), step(random));
    arc.centre = spot(step(random), step(random));
  } while (arc.chord == Spot() || arc.centre == Spot() || arc.centre == arc.chord);
  return arc;
}

TEST(NcArc, BothEndsLieOnTheCircleWithin2ToTheMinus90) {
  std::mt19937 random(1);
  const Rational bound = power_of_two(-60);  // of squares, at radii up to 2^20 mm
  for (int i = 0; i < 2000; ++i) {
    const RandomArc arc = random_arc(random);
    const Circle circle = circle_by_centre(arc.from, arc.chord, arc.centre, i % 2 == 0);
    EXPECT_EQ(circle.counter_clockwise(), i % 2 == 0);
    EXPECT_LT(off_circle(circle, arc.from.exact()), bound);
    EXPECT_LT(off_circle(circle, (arc.from + arc.chord).exact()), bound);
  }
}

TEST(NcArc, TheCentreIsTheFootOfTheGivenOneOnTheBisector) {
  std::mt19937 random(2);
  const Rational bound = power_of_two(-70);
  for (int i = 0; i < 2000; ++i) {
    const RandomArc arc = random_arc(random);
    const Circle circle = circle_by_centre(arc.from, arc.chord, arc.centre, true);
    const RationalPoint given = (arc.from + arc.centre).exact();
    const Vector w = arc.chord.exact();
    // What moved runs along the chord.
    EXPECT_LT(abs(cross(circle.centre() - given, w)), bound);
  }
}

TEST(NcArc, OnTheGridAndOffItAreTheSameArc) {
  std::mt19937 random(3);
  const Rational bound = power_of_two(-90);
  const auto expect_near = [&](const Circle& a, const Circle& b) {
    EXPECT_LT(abs(a.centre().x - b.centre().x), bound);
    EXPECT_LT(abs(a.centre().y - b.centre().y), bound);
    EXPECT_LT(abs(a.radius() - b.radius()), bound);
  };
  for (int i = 0; i < 1000; ++i) {
    const RandomArc arc = random_arc(random);
    const Spot off = off_grid(arc.from);
    ASSERT_FALSE(off.on_grid());
    expect_near(circle_by_centre(arc.from, arc.chord, arc.centre, true),
                circle_by_centre(off, arc.chord, arc.centre, true));
    const Length radius =
        Length::of_steps(3 * (std::abs(arc.chord.x.steps()) + std::abs(arc.chord.y.steps())));
    expect_near(circle_by_radius(arc.from, arc.chord, radius, i % 2 == 0, i % 3 == 0),
                circle_by_radius(off, arc.chord, radius, i % 2 == 0, i % 3 == 0));
  }
}

TEST(NcArc, OnTheGridTheLargestLengthsOverflowNothing) {
  const Rational bound = power_of_two(-90);
  const long most = Point::kMaxDecimalSteps;
  const Length largest = Length::of_steps(most);
  for (const Spot& chord : {spot(most, most), spot(-most, most), spot(most, 1), spot(-1, -most)}) {
    for (const Spot& from : {spot(most, -most), spot(-most, -most)}) {
      const Spot centre = spot(chord.x.steps() - 1, -chord.y.steps() + 3);
      const Circle told = circle_by_centre(from, chord, centre, true);
      const Circle other = circle_by_centre(off_grid(from), chord, centre, true);
      EXPECT_LT(abs(told.centre().x - other.centre().x), bound);
      EXPECT_LT(abs(told.centre().y - other.centre().y), bound);
      EXPECT_LT(abs(told.radius() - other.radius()), bound);
      const Circle by_radius = circle_by_radius(from, chord, largest, false, true);
      const Circle beside = circle_by_radius(off_grid(from), chord, largest, false, true);
      EXPECT_LT(abs(by_radius.centre().x - beside.centre().x), bound);
      EXPECT_LT(abs(by_radius.centre().y - beside.centre().y), bound);
    }
  }
}

/// Of a circle that is known at once, true as well.
bool is_made(const ElementPtr& element) {
  const auto* const later = dynamic_cast<const ElementOnDemand*>(element.source().get());
  return later == nullptr || later->is_made();
}

TEST(NcArc, AsElementsAreTheCirclesThatTheirOperandsGive) {
  std::mt19937 random(5);
  for (int i = 0; i < 1000; ++i) {
    const RandomArc arc = random_arc(random);
    const bool ccw = i % 2 == 0;
    const bool major = i % 3 == 0;
    const Length radius =
        Length::of_steps(std::abs(arc.chord.x.steps()) + std::abs(arc.chord.y.steps()));
    for (const Spot& from : {arc.from, off_grid(arc.from)}) {
      EXPECT_EQ(*told_by_centre(from, arc.chord, arc.centre, ccw),
                Element(circle_by_centre(from, arc.chord, arc.centre, ccw)));
      EXPECT_EQ(*told_by_radius(from, arc.chord, radius, major, ccw),
                Element(circle_by_radius(from, arc.chord, radius, major, ccw)));
      EXPECT_EQ(*told_half_turn(from, arc.chord, ccw), Element(half_turn(from, arc.chord, ccw)));
    }
  }
}

TEST(NcArc, OnTheGridTheCircleIsWorkedOutWhenItIsAskedForAndOffItAtOnce) {
  const Spot chord = spot(2'000'000'000, 0);
  const Spot centre = spot(1'000'000'000, 1'000'000'000);
  const Length radius = Length::of_steps(1'500'000'000);
  const Length fine(Rational(3, 2) + power_of_two(-130));
  const Spot off = off_grid(Spot());
  EXPECT_FALSE(is_made(told_by_centre(Spot(), chord, centre, true)));
  EXPECT_TRUE(is_made(told_by_centre(off, chord, centre, true)));
  EXPECT_TRUE(is_made(told_by_centre(Spot(), off_grid(chord), centre, true)));
  EXPECT_TRUE(is_made(told_by_centre(Spot(), chord, off_grid(centre), true)));
  EXPECT_FALSE(is_made(told_by_radius(Spot(), chord, radius, false, true)));
  EXPECT_TRUE(is_made(told_by_radius(off, chord, radius, false, true)));
  EXPECT_TRUE(is_made(told_by_radius(Spot(), chord, fine, false, true)));
  EXPECT_FALSE(is_made(told_half_turn(Spot(), chord, true)));
  EXPECT_TRUE(is_made(told_half_turn(off, chord, true)));
}

TEST(NcArc, ByRadiusTheRadiusIsExactAndTheLargerArcHasItsCentreOnTheOtherSide) {
  const Spot chord = spot(6'000'000'000, 0);
  const Length radius = Length::of_steps(5'000'000'000);
  for (const bool ccw : {true, false}) {
    for (const bool major : {true, false}) {
      const Circle circle = circle_by_radius(Spot(), chord, radius, major, ccw);
      EXPECT_EQ(abs(circle.radius()), 5);
      EXPECT_EQ(circle.centre().x, 3);
      EXPECT_LT(abs(circle.centre().y - (ccw == major ? -4 : 4)), power_of_two(-95));
    }
  }
}

TEST(NcArc, ARadiusOfHalfTheChordIsHalfATurnExactly) {
  const Circle circle =
      circle_by_radius(spot(1, 2), spot(7, 0), Length(Rational(7, 2'000'000'000)), false, true);
  EXPECT_EQ(circle.centre().x, Rational(9, 2'000'000'000));
  EXPECT_EQ(circle.radius(), Rational(7, 2'000'000'000));
}

TEST(NcArc, TheRadiiOfAnArcAreComparedExactlyAtTheTolerance) {
  // Radii 3 and 5 about a centre, in mm: they differ by 2.
  const Spot centre = spot(3'000'000'000, 0);
  const Spot chord = spot(8'000'000'000, 0);
  EXPECT_FALSE(radii_differ(chord, centre, 2));
  EXPECT_TRUE(radii_differ(chord, centre, Rational(2) - power_of_two(-100)));
  EXPECT_FALSE(radii_differ(off_grid(chord), centre, Rational(2) + power_of_two(-100)));
}

TEST(NcArc, AnArcOfNearlyAWholeTurnIsDividedInItsMiddle) {
  const Spot chord = spot(0, 100'000'000);  // 0.1 mm up, about a centre 10 mm to the right
  const Spot centre = spot(10'000'000'000, 40'000'000);
  EXPECT_FALSE(division_of(chord, centre, false).has_value());  // clockwise: a short arc
  const auto middle = division_of(chord, centre, true);
  ASSERT_TRUE(middle.has_value());
  EXPECT_NEAR(nearest_double(middle->x.millimetres()), 20, 1e-3);
  const Spot fitting = spot(10'000'000'000, 50'000'000);
  EXPECT_FALSE(division_of(chord, fitting, true).has_value());  // the radii are equal
}

TEST(NcArc, HalfTurnsAreToldExactly) {
  EXPECT_EQ(half_turns(spot(2, 0), spot(1, 0), true), 0);
  EXPECT_EQ(half_turns(spot(2, 0), spot(1, 1), true), -1);
  EXPECT_EQ(half_turns(spot(2, 0), spot(1, -1), true), 1);
  EXPECT_EQ(half_turns(spot(2, 0), spot(1, -1), false), -1);
  EXPECT_EQ(half_turns(spot(0, 0), spot(1, -1), false), 1);
}

// --- lengths ------------------------------------------------------------------------------------

TEST(NcLength, StaysExactBeyondTheGridAndComesBackToIt) {
  const Length third(Rational(1, 3));
  EXPECT_FALSE(third.on_grid());
  const Length one = third + third + third;
  EXPECT_TRUE(one.on_grid());
  EXPECT_EQ(one, Length::of_steps(1'000'000'000));
  const Length large = Length::of_steps(Point::kMaxDecimalSteps);
  EXPECT_FALSE((large + large).on_grid());
  EXPECT_EQ((large + large) - large, large);
}

TEST(NcLength, APointOfDecimalsIsAsExactAsOneOfRationals) {
  std::mt19937_64 random(4);
  std::uniform_int_distribution<std::int64_t> step(-Point::kMaxDecimalSteps,
                                                   Point::kMaxDecimalSteps);
  for (int i = 0; i < 10000; ++i) {
    const std::int64_t x = step(random) >> (i % 50);
    const Point fast = Point::decimal(x, -x);
    Rational value(x, 1'000'000'000);
    value.canonicalize();
    const Point slow(RationalPoint{value, -value});
    EXPECT_EQ(fast.x(), slow.x());
    EXPECT_EQ(fast.exact().x.a, value);
    EXPECT_TRUE(fast == slow);
  }
}

}  // namespace
}  // namespace dgt
