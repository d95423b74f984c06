// SPDX-License-Identifier: GPL-3.0-or-later
// Orientation as part of the value: sides, offsets, distances, contacts.
#include "kernel/element.h"

#include <gmock/gmock.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <latch>
#include <memory>
#include <thread>
#include <vector>

#include "kernel/construct.h"

namespace dgt {
namespace {

ExactPoint at(Rational x, Rational y) {
  return ExactPoint(RationalPoint{std::move(x), std::move(y)});
}

TEST(Line, AlongTheAxesRunsToPlusXAndToMinusY) {
  EXPECT_EQ(horizontal_line(3).direction().vector(), (Vector{1, 0}));
  EXPECT_EQ(vertical_line(3).direction().vector(), (Vector{0, -1}));
  // Both have their left normal on the positive axis.
  EXPECT_EQ(horizontal_line(3).offset(10), horizontal_line(13));
  EXPECT_EQ(vertical_line(3).offset(10), vertical_line(13));
}

TEST(Circle, OffsetToTheLeftShrinksWhenCounterClockwiseAndGrowsWhenClockwise) {
  EXPECT_EQ(Circle({0, 0}, 5).offset(2), Circle({0, 0}, 3));
  EXPECT_EQ(Circle({0, 0}, -5).offset(2), Circle({0, 0}, -7));
}

TEST(Circle, IsEatenByAnOffsetThatReachesItsRadius) {
  const Circle c({0, 0}, 5);
  EXPECT_TRUE(c.survives_offset(Rational(4999, 1000)));
  EXPECT_FALSE(c.survives_offset(5));
  EXPECT_FALSE(c.survives_offset(5 - power_of_two(kZeroExponent)));
  EXPECT_FALSE(c.survives_offset(6));
  EXPECT_TRUE(c.survives_offset(-100));
  EXPECT_FALSE(c.reversed().survives_offset(-5));
  EXPECT_THROW(static_cast<void>(c.offset(5)), InternalError);
}

TEST(Circle, OfRadiusZeroThereIsNone) { EXPECT_THROW(Circle({0, 0}, 0), InternalError); }

// --- elements on demand -------------------------------------------------------------------------

class CountedCircle final : public ElementOnDemand {
 public:
  mutable std::atomic<int> times_made = 0;

 private:
  [[nodiscard]] Element make() const override {
    ++times_made;
    return Circle({1, 2}, -3);
  }
};

TEST(ElementOnDemand, IsMadeWhenItIsFirstAskedForAndOnce) {
  const auto source = std::make_shared<const CountedCircle>();
  const ElementPtr element(source);
  const ElementPtr copy = element;
  EXPECT_TRUE(element);
  EXPECT_EQ(element, copy);
  EXPECT_FALSE(source->is_made());
  EXPECT_EQ(*element, Element(Circle({1, 2}, -3)));
  EXPECT_EQ(element.get(), copy.get());
  EXPECT_TRUE(source->is_made());
  EXPECT_EQ(source->times_made, 1);
}

constexpr std::ptrdiff_t kThreads = 4;

/// Is given to nobody before all threads have made it.
class CircleOfAllThreads final : public ElementOnDemand {
 private:
  [[nodiscard]] Element make() const override {
    all_there_.arrive_and_wait();
    return Circle({1, 2}, -3);
  }

  mutable std::latch all_there_{kThreads};
};

TEST(ElementOnDemand, ThreadsThatAskAtOnceGetTheSameOne) {
  const ElementPtr element(std::make_shared<const CircleOfAllThreads>());
  std::array<const Element*, kThreads> seen{};
  std::vector<std::thread> threads;
  for (const Element*& mine : seen) threads.emplace_back([&] { mine = element.get(); });
  for (std::thread& thread : threads) thread.join();
  for (const Element* const one : seen) EXPECT_EQ(one, element.get());
  EXPECT_EQ(*element, Element(Circle({1, 2}, -3)));
}

TEST(ElementPtr, IsEqualWhereOneIsSharedNotWhereTwoAreAlike) {
  const ElementPtr none;
  const ElementPtr one(Circle({0, 0}, 1));
  const ElementPtr other(Circle({0, 0}, 1));
  EXPECT_FALSE(none);
  EXPECT_EQ(none, nullptr);
  EXPECT_EQ(none.get(), nullptr);
  EXPECT_NE(one, none);
  EXPECT_NE(one, other);
  EXPECT_EQ(*one, *other);
}

// --- places beside elements ---------------------------------------------------------------------

TEST(SideOf, LeftIsPositiveAndOnItIsZero) {
  EXPECT_EQ(side_of(horizontal_line(0), at(5, 1)), 1);
  EXPECT_EQ(side_of(horizontal_line(0), at(5, 0)), 0);
  EXPECT_EQ(side_of(horizontal_line(0), at(5, -1)), -1);
  EXPECT_EQ(side_of(Circle({0, 0}, 5), at(1, 1)), 1);
  EXPECT_EQ(side_of(Circle({0, 0}, -5), at(1, 1)), -1);
  EXPECT_EQ(side_of(Circle({0, 0}, -5), at(3, 4)), 0);
  EXPECT_EQ(side_of(Circle({0, 0}, -5), at(6, 0)), 1);
}

TEST(SideOf, TellsAHairbreadthFromAnIrrationalPoint) {
  // (√2, √2) lies on the circle of radius 2.
  const ExactPoint p(OneRoot(0, 1, 2), OneRoot(0, 1, 2));
  const Rational hair = power_of_two(-500);
  EXPECT_EQ(side_of(Circle({0, 0}, 2), p), 0);
  EXPECT_EQ(side_of(Circle({0, 0}, 2 + hair), p), 1);
  EXPECT_EQ(side_of(Circle({0, 0}, 2 - hair), p), -1);
}

TEST(DistanceTo, IsThatOfTheNearestPoint) {
  EXPECT_EQ(distance_to(horizontal_line(1), at(9, -2)), 3);
  EXPECT_EQ(distance_to(Circle({0, 0}, -5), at(0, 0)), 5);
  EXPECT_EQ(distance_to(Circle({0, 0}, 5), at(6, 8)), 5);
}

TEST(DistanceTo, ACircleNearbyLosesNothingToCancellation) {
  const Rational tiny = Rational(1) / 1000000000000000;  // 10⁻¹⁵ mm beside a radius of 1000
  EXPECT_DOUBLE_EQ(distance_to(Circle({0, 0}, 1000), at(1000 + tiny, 0)), 1e-15);
}

TEST(Contact, IsWhereTheElementsTouch) {
  EXPECT_EQ(contact(horizontal_line(0), Circle({3, 5}, 5)), (RationalPoint{3, 0}));
  EXPECT_EQ(contact(Circle({3, 5}, 5), horizontal_line(0)), (RationalPoint{3, 0}));
  EXPECT_EQ(contact(Circle({0, 0}, 5), Circle({8, 0}, -3)), (RationalPoint{5, 0}));
  EXPECT_EQ(contact(Circle({0, 0}, 5), Circle({2, 0}, 3)), (RationalPoint{5, 0}));
  EXPECT_THROW(static_cast<void>(contact(Circle({0, 0}, 5), Circle({0, 0}, 5))), InternalError);
}

TEST(KnownPoint, AnIrrationalPointStandsWithinItsBound) {
  const KnownPoint p = known_point(ExactPoint(OneRoot(1, 1, 2), OneRoot(-3, 5, 2)));
  EXPECT_GT(p.bound, 0);
  EXPECT_LE(p.bound, 0x1p-120);
  EXPECT_LE(std::fabs(nearest_double(OneRoot(1 - p.stand_in.x, 1, 2) * power_of_two(100))),
            std::ldexp(p.bound, 100));
}

}  // namespace
}  // namespace dgt
