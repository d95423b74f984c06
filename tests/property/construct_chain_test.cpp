// SPDX-License-Identifier: GPL-3.0-or-later
// A thousand constructions, each on the results of those before: as a program does that builds on
// its own elements in a loop. Bit lengths and bounds must stay where they are.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <deque>
#include <random>

#include "kernel/construct.h"

namespace dgt {
namespace {

std::size_t height_of(const Line& line) {
  return std::max({height(line.normal().x()), height(line.normal().y()), height(line.p())});
}
std::size_t height_of(const Circle& c) {
  return std::max({height(c.centre().x), height(c.centre().y), height(c.radius())});
}
std::size_t height_of(const KnownPoint& p) {
  return std::max(height(p.stand_in.x), height(p.stand_in.y));
}

/// The latest elements of each kind, which the next construction draws on.
class Chain {
 public:
  explicit Chain(unsigned seed) : random_(seed) {
    lines_ = {horizontal_line(Rational(7, 3)), vertical_line(Rational(-12, 10))};
    circles_ = {Circle({3, 4}, 5), Circle({-20, 11}, -7)};
    points_ = {known_point(RationalPoint{1, 2}), known_point(RationalPoint{31, -17})};
  }

  /// One more construction of the form `form`; false when these operands have no result.
  bool step(int form) {
    switch (form) {
      case 0:
        return take(line_through(point(), point()));
      case 1:
        return take(tangent_from(point(), circle()));
      case 2:
        return take(common_tangent(circle(), circle()));
      case 3:
        return take(Construction<Line>(line_turned(line(), number(), point())));
      case 4:
        return take(Construction<Line>(tangent_at_angle(circle(), number())));
      case 5:
        return take(touching(line(), line(), radius()));
      case 6:
        return take(touching(line(), circle(), radius(), selector()));
      case 7:
        return take(touching(circle(), circle(), radius(), selector()));
      case 8:
        return take(circle_through(point(), point(), point()));
      case 9:
        return take(circle_polar(point(), number(), number(), radius()));
      case 10:
        return take(meeting_point(line(), circle(), selector()));
      case 11:
        return take(meeting_point(circle(), circle(), selector()));
      case 12:
        return take(meeting_point(line(), line(), Selector::Default));
      default:
        return take(Construction<KnownPoint>(point_polar(point(), number(), number())));
    }
  }
  static constexpr int kForms = 14;

  [[nodiscard]] std::size_t greatest_height() const { return greatest_height_; }
  [[nodiscard]] double greatest_bound() const { return greatest_bound_; }

 private:
  unsigned below(std::size_t n) { return static_cast<unsigned>(random_() % n); }
  Rational number() {
    Rational r(static_cast<int>(below(1000001)) - 500000, 10000);
    r.canonicalize();
    return r;
  }
  Rational radius() { return number() + Rational(1, 20000); }
  Selector selector() { return below(2) == 0 ? Selector::I1 : Selector::I2; }
  const Line& line() { return lines_[below(lines_.size())]; }
  const Circle& circle() { return circles_[below(circles_.size())]; }
  const KnownPoint& point() { return points_[below(points_.size())]; }

  // Parts are of a part's size: what lies metres away is not built on.
  static bool in_reach(const RationalPoint& p) { return abs(p.x) < 10000 && abs(p.y) < 10000; }
  static bool in_reach(const Line& l) { return abs(l.p()) < 10000; }
  static bool in_reach(const Circle& c) { return in_reach(c.centre()) && abs(c.radius()) < 10000; }
  static bool in_reach(const KnownPoint& p) { return in_reach(p.stand_in); }

  std::deque<Line>& pool(const Line&) { return lines_; }
  std::deque<Circle>& pool(const Circle&) { return circles_; }
  std::deque<KnownPoint>& pool(const KnownPoint&) { return points_; }

  template <class T>
  bool take(const Construction<T>& result) {
    const auto* made = std::get_if<Constructed<T>>(&result);
    if (!made || !in_reach(made->value)) return false;
    greatest_height_ = std::max(greatest_height_, height_of(made->value));
    greatest_bound_ = std::max({greatest_bound_, made->bound, made->turn});
    auto& elements = pool(made->value);
    elements.push_back(made->value);
    if (elements.size() > 4) elements.pop_front();
    return true;
  }

  std::mt19937 random_;
  std::deque<Line> lines_;
  std::deque<Circle> circles_;
  std::deque<KnownPoint> points_;
  std::size_t greatest_height_ = 0;
  double greatest_bound_ = 0;
};

class ChainOfAThousand : public ::testing::TestWithParam<unsigned> {};

TEST_P(ChainOfAThousand, DependentConstructionsStaysWithinTheHeightAndTheBound) {
  Chain chain(GetParam());
  std::mt19937 forms(GetParam() + 1000);
  std::array<int, Chain::kForms> made{};
  int steps = 0;
  for (int tries = 0; steps < 1000; ++tries) {
    ASSERT_LT(tries, 100000) << "the chain is stuck";
    const auto form = forms() % Chain::kForms;
    if (!chain.step(static_cast<int>(form))) continue;
    ++made[form];
    ++steps;
  }
  RecordProperty("greatest_bit_length", static_cast<int>(chain.greatest_height()));
  RecordProperty("greatest_bound", std::to_string(chain.greatest_bound() * 0x1p96) + " / 2^96");
  EXPECT_LE(chain.greatest_height(), kMaxHeight);
  EXPECT_LE(chain.greatest_bound(), 0x1p-80);
  for (int form = 0; form < Chain::kForms; ++form)
    EXPECT_GT(made[static_cast<std::size_t>(form)], 0) << "form " << form << " never had a result";
}

INSTANTIATE_TEST_SUITE_P(Seeds, ChainOfAThousand, ::testing::Range(0U, 8U));

TEST(ChainOfTurns, AThousandTurnedLinesKeepTheirHeightAndTheirAngle) {
  // 1000 × 0.36° is a whole turn: the errors add up, no more.
  Line line = horizontal_line(1);
  const KnownPoint centre = known_point(RationalPoint{0, 0});
  std::size_t highest = 0;
  double turn = 0;
  for (int i = 0; i < 1000; ++i) {
    const Constructed<Line> next = line_turned(line, Rational(36, 100), centre);
    line = next.value;
    turn += next.turn;
    highest = std::max(highest, height_of(line));
  }
  RecordProperty("greatest_bit_length", static_cast<int>(highest));
  EXPECT_LE(highest, kMaxHeight);
  EXPECT_LE(abs(line.direction().y()), Rational(turn));
  EXPECT_LE(turn, 1001 * 0x1p-96);
  EXPECT_GT(line.direction().x(), 0);
}

TEST(Height, OfACappedDirectionTheTurnSaysHowFarItMoved) {
  UnitVector long_normal({Rational(3, 5), Rational(4, 5)});
  while (height(long_normal.x()) <= kMaxHeight)
    long_normal = rotated(long_normal, UnitVector({Rational(3, 5), Rational(4, 5)}));
  const RationalPoint p{Rational(1, 3), 7};
  for (const UnitVector& n : {long_normal, -long_normal, turned_left(long_normal)}) {
    const Constructed<Line> line = parallel_through(known_point(p), Line(n, 0));
    EXPECT_LE(height_of(line.value), 512U);
    const Rational sine = abs(cross(line.value.normal().vector(), n.vector()));
    EXPECT_GT(sgn(dot(line.value.normal().vector(), n.vector())), 0);
    EXPECT_GT(sine, 0);
    EXPECT_LE(sine, Rational(line.turn));
    EXPECT_LE(abs(line.value.distance_to_left(p)), Rational(line.bound));
    EXPECT_LE(line.turn, 0x1p-189);
  }
}

TEST(Height, OfACappedElementIsSmallAndTheBoundSaysHowFarItMoved) {
  const Rational third = Rational(1) / 3;
  Rational deep = third;
  while (height(deep) <= kMaxHeight) deep = deep * third + 1;
  const auto circle =
      std::get<Constructed<Circle>>(circle_about(known_point(RationalPoint{0, 0}), deep));
  EXPECT_LE(height(circle.value.radius()), 256U);
  EXPECT_GT(circle.bound, 0);
  EXPECT_LE(abs(circle.value.radius() - deep), Rational(circle.bound));

  // A radius of next to nothing stays one.
  const Rational minute = deep * power_of_two(-2000);
  const auto dot =
      std::get<Constructed<Circle>>(circle_about(known_point(RationalPoint{0, 0}), -minute));
  EXPECT_LT(dot.value.radius(), 0);
  EXPECT_LE(abs(dot.value.radius() + minute), Rational(dot.bound));

  const KnownPoint point = known_point(RationalPoint{deep, -deep});
  EXPECT_LE(height_of(point), 256U);
  EXPECT_LE(abs(point.stand_in.x - deep), Rational(point.bound));

  const Constructed<Line> line = parallel_at(horizontal_line(0), deep);
  EXPECT_LE(height_of(line.value), 256U);
  EXPECT_LE(abs(line.value.p() - deep), Rational(line.bound));
}

}  // namespace
}  // namespace dgt
