// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/write.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <random>

#include "post/plan.h"
#include "tests/post/paths.h"

// The writers held against a reader that knows nothing of them.

namespace dgt {
namespace {

using replay::Spot;
using replay::Step;
using testing::near;
using testing::PathBuilder;
using testing::unit_at;

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(engine_);
  }
  int whole(int a, int b) { return std::uniform_int_distribution<int>(a, b)(engine_); }
  bool coin() { return whole(0, 1) == 1; }

 private:
  std::mt19937_64 engine_;
};

/// Sweeps near every place where something changes.
double random_sweep(Random& random) {
  switch (random.whole(0, 6)) {
    case 0:
      return random.uniform(170, 190);
    case 1:
      return random.uniform(0.01, 5);
    case 2:
      return random.uniform(118, 122);
    case 3:
      return random.uniform(355, 359.9);
    case 4:
      return 90 * random.whole(1, 3);
    default:
      return random.uniform(1, 359);
  }
}

/// From under a unit to where the sagitta decides.
Rational random_radius(Random& random) {
  switch (random.whole(0, 4)) {
    case 0:
      return near(random.uniform(0.01, 1), 8);
    case 1:
      return near(std::exp(random.uniform(5, 14)), 4);
    case 2:
      return near(random.whole(1, 300) / 10.0, 4);
    default:
      return near(random.uniform(0.5, 200), 8);
  }
}

/// Starts among them that lie half-way between grid points.
RationalPoint random_start(Random& random) {
  const auto coordinate = [&]() -> Rational {
    Rational tenths(random.whole(-5000, 5000), 10);
    tenths.canonicalize();
    switch (random.whole(0, 3)) {
      case 0:
        return tenths + Rational(1, 20);
      case 1:
        return tenths;
      case 2:
        return tenths + Rational(1, 20) + random.whole(-1, 1) * Rational(1, 1000000000);
      default:
        return near(random.uniform(-500, 500), 10);
    }
  };
  return {coordinate(), coordinate()};
}

replay::Run replayed(const std::string& text, const Dialect& d, const RationalPoint& start) {
  const Spot from{nearest_double(start.x), nearest_double(start.y)};
  const double unit = nearest_double(d.unit);
  if (d.form == Form::ThreeB) return replay::three_b(text, unit, from);
  if (d.form == Form::Gcode) return replay::gcode(text, from);
  return replay::essi(
      text, unit, from,
      d.arc_form == ArcForm::Radius ? replay::EssiArcs::ByRadius : replay::EssiArcs::ByCentre);
}

std::vector<Step> cuts_of(const replay::Run& run) {
  std::vector<Step> cuts;
  for (const Step& s : run.steps)
    if (s.torch && s.kind != Step::Kind::Word) cuts.push_back(s);
  return cuts;
}

class EveryDialect : public ::testing::TestWithParam<const char*> {
 protected:
  /// Whose numbers may be as large as the arcs here.
  void SetUp() override {
    dialect_ = *find_dialect(GetParam());
    dialect_.largest = nullptr;
  }
  const Dialect& dialect() const { return dialect_; }
  double unit() const { return nearest_double(dialect().unit); }

 private:
  Dialect dialect_;
};

/// One arc: the laws of write.h, as measured from the text.
TEST_P(EveryDialect, MeasuredDeviationOfRandomArcsIsWithinTheCertificate) {
  Random random(11);
  const int cases = GetParam() == std::string("essi") ? 100000 : 40000;
  double worst = 0;
  int tight = 0;
  int measurable = 0;
  for (int i = 0; i < cases; ++i) {
    const RationalPoint start = random_start(random);
    PathBuilder p(start);
    p.feed("1").turn(unit_at(random.uniform(-180, 180)), random_radius(random),
                     random_sweep(random), random.coin());
    const Move& arc = p.path().moves.back();
    const WriteResult r = write(p.path(), dialect());
    ASSERT_TRUE(r.faults.empty());
    const auto cuts = cuts_of(replayed(r.text, dialect(), start));
    const double bound = r.report.deviation;
    worst = std::max(worst, bound / unit());
    ASSERT_LE(r.report.position_error_x, unit() * 0.5000001);
    ASSERT_LE(r.report.position_error_y, unit() * 0.5000001);
    const Step exact = testing::step_of(arc);
    if (cuts.empty()) {
      for (const Spot& s : replay::samples(exact, 20))
        ASSERT_LE(std::hypot(s.x - exact.from.x, s.y - exact.from.y),
                  bound + (dialect().positions == Positions::Absolute ? unit() : 1e-12));
      continue;
    }
    const double slack = 1e-9 + 1e-13 * exact.radius;
    const double measured = testing::measured_distance(cuts, {exact}, 25);
    ASSERT_LE(measured, bound + slack)
        << i << " r " << exact.radius << " sweep " << exact.sweep << "\n"
        << r.text;
    if (bound > 1e-3 * unit()) ++measurable;
    if (bound > 1e-3 * unit() && bound < 2 * measured) ++tight;
    for (const Step& s : cuts) {
      if (s.kind != Step::Kind::Arc) continue;
      ASSERT_EQ(s.ccw, exact.ccw);
      ASSERT_LE(s.mismatch, nearest_double(dialect().radius_mismatch) + 1e-9);
      if (dialect().arc_form == ArcForm::Radius && bound > 1e-5 * unit()) {
        ASSERT_LE(s.sweep, 2.0943953);
      }
    }
    ASSERT_LE(std::fabs(cuts.back().to.x - exact.to.x), unit() * 0.5 + 1e-9);
    ASSERT_LE(std::fabs(cuts.back().to.y - exact.to.y), unit() * 0.5 + 1e-9);
  }
  EXPECT_LE(worst, kWorstDeviation);
  EXPECT_GT(worst, 0.7);
  EXPECT_GT(tight, measurable * 9 / 10);
}

/// Chains of lines, rapids and arcs that come back to their start.
TEST_P(EveryDialect, WrittenPositionsStayWithinHalfAUnitAndClosedContoursClose) {
  Random random(23);
  for (int i = 0; i < 400; ++i) {
    const RationalPoint start = random_start(random);
    PathBuilder p(start);
    p.feed("1");
    const int length = random.whole(1, 25);
    for (int k = 0; k < length; ++k) {
      switch (random.whole(0, 3)) {
        case 0:
          p.rapid({p.at().x + near(random.uniform(-3, 3), 20),
                   p.at().y + near(random.uniform(-3, 3), 6)});
          break;
        case 1:
          p.line({p.at().x + near(random.uniform(-0.2, 0.2), 20),
                  p.at().y + near(random.uniform(-9, 9))});
          break;
        default:
          p.turn(unit_at(random.uniform(-180, 180)), random_radius(random), random_sweep(random),
                 random.coin());
      }
    }
    p.line(start);
    const WriteResult r = write(p.path(), dialect());
    ASSERT_TRUE(r.faults.empty());
    const replay::Run run = replayed(r.text, dialect(), start);
    if (dialect().positions == Positions::Incremental && dialect().form == Form::Essi) {
      EXPECT_EQ(run.sum_x, 0);
      EXPECT_EQ(run.sum_y, 0);
    }
    EXPECT_NEAR(run.end.x, nearest_double(start.x), unit() * 0.5 + 1e-6);
    EXPECT_NEAR(run.end.y, nearest_double(start.y), unit() * 0.5 + 1e-6);
    // Every end of a written move lies beside an end of a move or beside an arc.
    std::vector<Step> exact;
    for (const Move& m : p.path().moves) exact.push_back(testing::step_of(m));
    for (const Step& s : run.steps) {
      double least = 1e300;
      for (const Step& e : exact) least = std::min(least, replay::distance(s.to, e));
      ASSERT_LE(least, unit() * 0.7072 + 1e-6);
    }
  }
}

TEST_P(EveryDialect, TheSameInputGivesTheSameText) {
  Random random(5);
  PathBuilder p;
  p.feed("1").turn(unit_at(33), near(random.uniform(5, 9)), 300, true).line("1", "1");
  EXPECT_EQ(write(p.path(), dialect()).text, write(p.path(), dialect()).text);
}

TEST_P(EveryDialect, CountsWhatItWrites) {
  PathBuilder s;
  s.feed("1")
      .rapid("1", "0")
      .line("2", "0")
      .line("2.00001", "0")
      .line("2", "0")
      .arc({3, 1}, {2, 1}, true);
  const WriteResult r = write(s.path(), dialect());
  EXPECT_EQ(r.report.lines, 1u);
  EXPECT_EQ(r.report.arcs, 1u);
  EXPECT_EQ(r.report.dropped, 2u);
  EXPECT_EQ(r.report.arcs_divided, 0u);
}

TEST_P(EveryDialect, AnEmptyPathIsAnEmptyProgram) {
  const WriteResult r = write(Toolpath{}, dialect());
  EXPECT_TRUE(r.faults.empty());
  EXPECT_EQ(r.report.blocks, 0u);
  EXPECT_EQ(r.report.deviation, 0);
}

/// Points where circles cross have irrational coordinates.
TEST_P(EveryDialect, ArcsBetweenIrrationalPoints) {
  const Carrier a = carrier(Circle({0, 0}, 10));
  const Carrier b = carrier(Circle({7, Rational(1, 3)}, 8));
  const auto crossings = std::get<TwoPoints>(meet(a, b));
  Toolpath path;
  Move m;
  m.kind = MoveKind::Arc;
  m.from = crossings.at(Which::Entry);
  m.to = crossings.at(Which::Exit);
  m.carrier = a;
  path.moves = {m};
  std::swap(m.from, m.to);
  path.moves.push_back(m);
  path.moves.insert(path.moves.begin(), Move{});
  path.moves[0].kind = MoveKind::Rapid;
  path.moves[0].to = crossings.at(Which::Entry);
  const WriteResult r = write(path, dialect());
  const auto cuts = cuts_of(replayed(r.text, dialect(), {}));
  const double measured = testing::measured_distance(
      cuts, {testing::step_of(path.moves[1]), testing::step_of(path.moves[2])}, 200);
  EXPECT_LE(measured, r.report.deviation + 1e-9);
  EXPECT_GT(measured, r.report.deviation / 4);
}

/// An arc carried by an offset element.
TEST_P(EveryDialect, ArcsOnOffsetCarriers) {
  PathBuilder p;
  p.feed("1").arc({20, 20}, {0, 20}, true);
  Toolpath path = p.path();
  path.moves[0].carrier = {carrier(Circle({0, 20}, 25)).base, shared(5)};
  const WriteResult r = write(path, dialect());
  EXPECT_LT(r.report.deviation, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Write, EveryDialect,
                         ::testing::Values("essi", "essi-iso", "plasmatic", "linuxcnc",
                                           "fanuc-wire", "grbl", "3b"),
                         [](const auto& i) {
                           std::string name = i.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Write, JointsOfDividedArcsLieBesideTheArc) {
  // The nearest grid point of a point of the arc may be half a unit and more off it; one a few
  // units along is next to it.
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Rational r = near(random.uniform(20, 200), 8);
    const WriteResult result =
        write(PathBuilder().arc({0, 0}, {0, r}, true).path(), *find_dialect("essi"));
    const auto cuts = cuts_of(replay::essi(result.text, 0.1, {}));
    ASSERT_GE(cuts.size(), 2u);
    for (const Step& s : cuts)
      ASSERT_LT(std::fabs(std::hypot(s.to.x, s.to.y - nearest_double(r)) - nearest_double(r)),
                0.02);
  }
}

/// Averages over arcs with radii of 2 to 20 mm.
struct Quality {
  double deviation = 0;  // certified, in units
  double pieces = 0;
};
Quality quality(const char* dialect, double least_sweep, double most_sweep) {
  Random random(8);
  Quality sum;
  constexpr int kCases = 4000;
  for (int i = 0; i < kCases; ++i) {
    PathBuilder p({near(random.uniform(0, 9)), near(random.uniform(0, 9))});
    p.feed("1").turn(unit_at(random.uniform(-180, 180)), near(random.uniform(2, 20), 9),
                     random.uniform(least_sweep, most_sweep), random.coin());
    const WriteReport report = write(p.path(), *find_dialect(dialect)).report;
    sum.deviation += report.deviation / nearest_double(find_dialect(dialect)->unit) / kCases;
    sum.pieces += static_cast<double>(report.arcs) / kCases;
  }
  return sum;
}

TEST(Write, WholeRadiiAreChosenToFit) {
  const Quality q = quality("essi", 112, 118);
  EXPECT_LT(q.deviation, 0.42);  // the nearest whole radius: 0.446
  EXPECT_LT(q.pieces, 1.01);
}

TEST(Write, CentresAreChosenToFit) {
  const Quality q = quality("linuxcnc", 60, 110);
  EXPECT_LT(q.deviation, 0.6);  // the nearest centre: 0.67
  EXPECT_LT(q.pieces, 1.005);   // a few arcs in a thousand are divided
  EXPECT_LT(quality("plasmatic", 60, 110).pieces, 1.02);
}

TEST(Write, AHundredThousandMovesDoNotDrift) {
  PathBuilder p;
  const int count = 50000;
  for (int i = 0; i < count; ++i)
    p.line({p.at().x + Rational(1, 30), p.at().y + Rational(1, 70)})
        .line({p.at().x + Rational(1, 15), p.at().y});
  const WriteResult r = write(p.path(), *find_dialect("essi"));
  const replay::Run run = replay::essi(r.text, 0.1, {0, 0});
  EXPECT_EQ(run.sum_x, count);
  EXPECT_EQ(run.sum_y, 7143);  // 50000/7 = 7142.86
  EXPECT_LE(r.report.position_error_x, 0.0500001);
}

TEST(Write, AnotherSideOfAHugeCircleIsOutOfRange) {
  PathBuilder p;
  p.turn(UnitVector(), Rational("1000000000000"), 20, true);
  const WriteResult r = write(p.path(), *find_dialect("essi"));
  ASSERT_EQ(r.faults.size(), 1u);
  EXPECT_EQ(r.faults[0].kind, WriteFault::Kind::OutOfRange);
}

TEST(Write, NamesEveryCoordinateOutOfRange) {
  PathBuilder p;
  p.line("100000000001", "0").line("0", "100000000001");
  EXPECT_EQ(write(p.path(), *find_dialect("essi")).faults.size(), 2u);
}

}  // namespace
}  // namespace dgt
