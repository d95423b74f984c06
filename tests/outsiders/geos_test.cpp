// SPDX-License-Identifier: GPL-3.0-or-later
//
// Areas of equidistants against GEOS, which knows polygons alone: arcs go in as chords and come out
// as chords. If the boundary that GEOS works on lies within ε of ours, and its own arcs within ε
// more, then what it calls the places at least d away lies between what is at least d + ε and what
// is at least d − ε away. So its area must lie between the two exact areas at these distances: a
// proof, not a tolerance; a lost or a surplus loop shows.
#include <geos_c.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>

#include "apps/driver/offset_input.h"
#include "apps/driver/pipeline.h"
#include "kernel/offset.h"
#include "tests/kernel/offset_families.h"
#include "tests/support/command.h"

namespace dgt {
namespace {

/// Chords of the contour's arcs leave them by at most this. Unit: mm.
constexpr double kChord = 1e-4;
/// Chords for a quarter turn of a corner.
constexpr int kQuarterSegments = 64;
/// GEOS takes vertices off its input that do not move it by more than this part of the distance.
constexpr double kSimplification = 0.01;

using Ring = std::vector<std::pair<double, double>>;

/// The ring, with `chords` of each arc, or as many as kChord asks for.
Ring tessellated(const Chain& chain, std::optional<int> chords = std::nullopt) {
  Ring ring;
  for (const ChainEdge& edge : chain.edges) {
    const double x = nearest_double(edge.from.x);
    const double y = nearest_double(edge.from.y);
    ring.emplace_back(x, y);
    if (edge.is_line()) continue;
    const RationalPoint centre = edge.centre();
    const double cx = nearest_double(centre.x);
    const double cy = nearest_double(centre.y);
    const double r = std::fabs(nearest_double(edge.radius));
    const double begin = std::atan2(y - cy, x - cx);
    double sweep =
        std::atan2(nearest_double(edge.to.y) - cy, nearest_double(edge.to.x) - cx) - begin;
    const double turn = 2 * std::numbers::pi;
    if (sgn(edge.radius) > 0 && sweep < 0) sweep += turn;
    if (sgn(edge.radius) < 0 && sweep > 0) sweep -= turn;
    const double step = 2 * std::acos(std::max(0.0, 1 - kChord / r));
    const int parts = chords.value_or(static_cast<int>(std::ceil(std::fabs(sweep) / step)));
    for (int i = 1; i < parts; ++i) {
      const double angle = begin + sweep * i / parts;
      ring.emplace_back(cx + r * std::cos(angle), cy + r * std::sin(angle));
    }
  }
  ring.push_back(ring.front());
  return ring;
}

void say_nothing(const char*, void*) {}

/// GEOS's own area of the ring's equidistant; nothing when it gives up.
class Geos {
 public:
  Geos() : handle_(GEOS_init_r()) {
    GEOSContext_setErrorMessageHandler_r(handle_, say_nothing, nullptr);
  }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;
  ~Geos() { GEOS_finish_r(handle_); }

  [[nodiscard]] std::optional<double> area_inside(const Ring& ring, double distance) const {
    const auto polygon = owned(GEOSGeom_createPolygon_r(handle_, linear(ring), nullptr, 0));
    const auto buffer = owned(GEOSBuffer_r(handle_, polygon.get(), -distance, kQuarterSegments));
    double area = 0;
    if (!buffer || GEOSArea_r(handle_, buffer.get(), &area) != 1) return std::nullopt;
    return area;
  }

 private:
  struct Destroy {
    GEOSContextHandle_t handle;
    void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(handle, g); }
  };
  [[nodiscard]] std::unique_ptr<GEOSGeometry, Destroy> owned(GEOSGeometry* g) const {
    return {g, Destroy{handle_}};
  }
  [[nodiscard]] GEOSGeometry* linear(const Ring& ring) const {
    GEOSCoordSequence* points =
        GEOSCoordSeq_create_r(handle_, static_cast<unsigned>(ring.size()), 2);
    for (unsigned i = 0; i < ring.size(); ++i) {
      GEOSCoordSeq_setXY_r(handle_, points, i, ring[i].first, ring[i].second);
    }
    return GEOSGeom_createLinearRing_r(handle_, points);
  }

  GEOSContextHandle_t handle_;
};

double exact_area(const std::vector<Chain>& loops, double distance) {
  double sum = 0;
  for (const OffsetLoop& loop : production_offset(loops, Rational(distance))) sum += area(loop);
  return sum;
}

struct Shape {
  std::string name;
  std::vector<Chain> loops;  ///< one, counter-clockwise
  double distance;
  double slack;  ///< how far GEOS's input may lie off ours, mm
};

double slack_of_arcs(double distance) { return kChord + kSimplification * std::fabs(distance); }

std::vector<Shape> shapes() {
  std::vector<Shape> all;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const std::string number = std::to_string(seed);
    for (const double d : {0.3, -0.7}) {
      all.push_back(
          {"ring" + number, families::random_ring(60 + 10 * seed, seed), d, slack_of_arcs(d)});
    }
    // Lines and large steps alone: nothing that could be taken off.
    for (const double d : {0.49, 0.51, -0.8}) {
      all.push_back({"pocket" + number, families::grid_pocket(20 + seed, seed), d, 1e-9});
    }
  }
  for (const double d : {0.4, 0.99, -0.5}) {
    all.push_back({"slots", families::slots(12), d, slack_of_arcs(d)});
  }
  return all;
}

double slack_of(const Shape& shape) {
  const double quarter = std::numbers::pi / 2;
  return shape.slack + std::fabs(shape.distance) * (1 - std::cos(quarter / kQuarterSegments / 2));
}

/// Holds the area that GEOS finds between the exact ones at distances `slack` more and less.
void expect_between(const Chain& loop, double distance, double slack, double theirs) {
  const double most = exact_area({loop}, distance - slack);
  const double least = exact_area({loop}, distance + slack);
  const double rounding = 1e-9 * most;
  EXPECT_GE(theirs, least - rounding);
  EXPECT_LE(theirs, most + rounding);
  EXPECT_LT(most - least, 0.03 * most) << "proves little";
}

TEST(AgainstGeos, AreasLieBetweenThoseALittleNearerAndFarther) {
  const Geos geos;
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name + " by " + std::to_string(shape.distance));
    const Chain& loop = shape.loops.front();
    const auto theirs = geos.area_inside(tessellated(loop), shape.distance);
    ASSERT_TRUE(theirs.has_value());
    expect_between(loop, shape.distance, slack_of(shape), *theirs);
  }
}

/// Counter-clockwise, where the program runs clockwise.
Chain sample_1p() {
  const auto made = compile_file(support::corpus("1P.bgt"), SourceSettings{});
  const Toolpath& path = *made->result.path;
  return reversed(loop_of(path, path.contours.front()).value());
}

TEST(AgainstGeos, Sample1P) {
  const Geos geos;
  const Chain loop = sample_1p();
  for (const double distance : {0.2, -0.2}) {
    const auto theirs = geos.area_inside(tessellated(loop), distance);
    ASSERT_TRUE(theirs.has_value());
    expect_between(loop, distance, slack_of({"1P", {}, distance, slack_of_arcs(distance)}),
                   *theirs);
  }
}

// Known disagreement: grown by 0.2, sample 1P with 2000 chords an arc gains some 19 mm² in GEOS
// 3.11, and the exact area is the closed form's.
TEST(AgainstGeos, Sample1PAt2000ChordsAnArcIsAKnownDisagreement) {
  constexpr double kClosedForm = 722.0058567836;
  const Chain loop = sample_1p();
  EXPECT_NEAR(exact_area({loop}, -0.2), kClosedForm, 1e-9 * kClosedForm);
  if (!std::string(GEOSversion()).starts_with("3.11.")) GTEST_SKIP() << "GEOS " << GEOSversion();
  const auto theirs = Geos().area_inside(tessellated(loop, 2000), -0.2);
  ASSERT_TRUE(theirs.has_value());
  EXPECT_GT(*theirs, kClosedForm + 10);
}

}  // namespace
}  // namespace dgt
