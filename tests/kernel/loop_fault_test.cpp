// SPDX-License-Identifier: GPL-3.0-or-later
// Loops that bound a region and loops that bound none: crossings, overlaps, contacts, nesting.
#include "kernel/loop_fault.h"

#include <gmock/gmock.h>

#include "kernel/number.h"

namespace dgt {
namespace {

struct Vertex {
  const char* x;
  const char* y;
  const char* bulge = "0";
};
using Loop = std::vector<Vertex>;

std::vector<Chain> chains(const std::vector<Loop>& loops) {
  std::vector<Chain> result;
  for (const Loop& loop : loops) {
    std::vector<BulgeVertex> vertices;
    for (const Vertex& v : loop)
      vertices.push_back(
          {{*parse_scientific(v.x), *parse_scientific(v.y)}, *parse_scientific(v.bulge)});
    result.push_back(chain_of(vertices, true).value());
  }
  return result;
}

/// `crossing 1 2 at 5,5`, loops counted from 1; `none`. The same must come out whatever edge each
/// loop begins with.
std::string fault(std::vector<Loop> loops) {
  const auto told = [](const std::vector<Chain>& made) -> std::string {
    const auto f = find_loop_fault(made);
    if (!f) return "none";
    const bool crossing = f->kind == LoopFault::Kind::Crossing;
    return (crossing ? "crossing " : "nesting ") + std::to_string(f->loop + 1) + " " +
           std::to_string(f->other + 1) +
           (crossing ? " at " + to_short_decimal(Rational(f->x), 3) + "," +
                           to_short_decimal(Rational(f->y), 3)
                     : "");
  };
  const std::string first = told(chains(loops));
  for (Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      std::rotate(loop.begin(), loop.begin() + 1, loop.end());
      EXPECT_EQ(told(chains(loops)), first) << "begun elsewhere";
    }
  }
  return first;
}

const Loop kSquare = {{"0", "0"}, {"10", "0"}, {"10", "10"}, {"0", "10"}};
const Loop kHole = {{"2", "2"}, {"2", "8"}, {"8", "8"}, {"8", "2"}};

TEST(LoopFault, ASquareWithAHoleBoundsARegion) {
  EXPECT_EQ(fault({kSquare}), "none");
  EXPECT_EQ(fault({kSquare, kHole}), "none");
  EXPECT_EQ(fault({kHole}), "none") << "all the plane but a square";
}

TEST(LoopFault, AHoleThatRunsTheSameWayIsWronglyNested) {
  EXPECT_EQ(fault({kSquare, {{"2", "2"}, {"8", "2"}, {"8", "8"}, {"2", "8"}}}), "nesting 2 2");
}

TEST(LoopFault, ALoopBesideThatRunsBackwardsIsWronglyNested) {
  EXPECT_EQ(fault({kSquare, {{"20", "0"}, {"20", "5"}, {"25", "5"}, {"25", "0"}}}), "nesting 2 2");
}

TEST(LoopFault, AFigureOfEightCrossesItself) {
  EXPECT_EQ(fault({{{"0", "0"}, {"10", "10"}, {"10", "0"}, {"0", "10"}}}), "crossing 1 1 at 5,5");
}

TEST(LoopFault, LoopsThatOverlapCross) {
  EXPECT_EQ(fault({kSquare, {{"5", "-5"}, {"15", "-5"}, {"15", "5"}, {"5", "5"}}}),
            "crossing 1 2 at 5,0");
}

TEST(LoopFault, NeighbouringArcsThatMeetOnceMoreCross) {
  // Both bulge over their chords and meet again left of their joint.
  EXPECT_EQ(fault({{{"-38.4502", "8.392", "0.1495"},
                    {"-21.363", "-0.0444", "0.2321"},
                    {"-35.7433", "-3.6746", "0"},
                    {"-50", "0", "0"}}}),
            "crossing 1 1 at -22.391,0.14");
}

TEST(LoopFault, ALineThatMeetsTheArcBehindItOnceMoreCrossesIt) {
  EXPECT_EQ(fault({{{"0", "0"}, {"10", "0", "1"}, {"-10", "0", "0"}, {"-10", "-5", "0"}}}), "none");
  EXPECT_EQ(fault({{{"-20", "-1"}, {"10", "0", "-1"}, {"-10", "0", "0"}, {"-20", "20", "0"}}}),
            "crossing 1 1 at -9.978,-0.666");
}

TEST(LoopFault, ACircleOfTwoHalvesIsOneLoop) {
  EXPECT_EQ(fault({{{"0", "0", "1"}, {"10", "0", "1"}}}), "none");
}

TEST(LoopFault, LoopsMayTouchAtAPointAndAlongAnEdge) {
  EXPECT_EQ(fault({kSquare, {{"10", "10"}, {"20", "10"}, {"20", "20"}}}), "none") << "corners";
  EXPECT_EQ(fault({kSquare, {{"10", "5"}, {"20", "0"}, {"20", "10"}}}), "none") << "corner on edge";
  EXPECT_EQ(fault({kSquare, {{"10", "0"}, {"20", "0"}, {"20", "10"}, {"10", "10"}}}), "none")
      << "edges";
  EXPECT_EQ(fault({kSquare, {{"0", "5"}, {"5", "8"}, {"5", "2"}}}), "none") << "a hole at the edge";
  EXPECT_EQ(fault({kSquare, {{"10", "5", "1"}, {"20", "5", "1"}}}), "none") << "an arc on a line";
}

TEST(LoopFault, TheSameLoopTwiceRunsOverItself) {
  EXPECT_EQ(fault({kSquare, kSquare}), "crossing 1 2 at 0,0");
}

TEST(LoopFault, AnEdgeThatDoublesBackIsNoCrossing) {
  EXPECT_EQ(fault({{{"0", "0"}, {"10", "0"}, {"20", "0"}, {"10", "0"}, {"10", "10"}}}), "none");
}

TEST(LoopFault, AnArcThatRunsBackOverItselfIsNoCrossing) {
  EXPECT_EQ(fault({{{"-12", "-12", "0.25"}, {"-11", "-10", "-0.25"}}}), "none");
}

TEST(LoopFault, ATangentCuspIsNoCrossing) {
  // The arc arrives in its end along the line that leaves it, in rational stand-ins nearly so;
  // the loop beside it touches, so that the arrangement decides.
  EXPECT_EQ(fault({{{"1", "-2"}, {"2", "0"}, {"0", "0", "-0.5"}}}), "none");
  EXPECT_EQ(
      fault({{{"1", "-2"}, {"2", "0"}, {"0", "0", "-0.5"}}, {{"2", "0"}, {"3", "0"}, {"3", "1"}}}),
      "none");
}

TEST(LoopFault, AContactInDecimalsIsNoCrossing) {
  // Two loops that overlap by 10⁻¹² mm on less than 10⁻⁹ mm.
  EXPECT_EQ(fault({kSquare, {{"9.999999999999", "5"}, {"20", "0"}, {"20", "10"}}}), "none");
  EXPECT_EQ(fault({kSquare, {{"9.999", "5"}, {"20", "0"}, {"20", "10"}}}), "crossing 1 2 at 10,5");
}

TEST(LoopFault, NoLoopsAreRight) { EXPECT_FALSE(find_loop_fault({})); }

}  // namespace
}  // namespace dgt
