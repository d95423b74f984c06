// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/essi.h"

#include <gtest/gtest.h>

#include "tests/post/paths.h"

namespace dgt {
namespace {

using testing::PathBuilder;
using testing::q;
using testing::unit_at;

const Dialect& essi() { return *find_dialect("essi"); }

std::string text(const PathBuilder& p) { return write(p.path(), essi()).text; }

TEST(EssiText, TheGuidesLines) {
  PathBuilder p;
  p.line("50", "20").line("60", "-1.5").line("60", "-462.7").line("144", "-462.7");
  EXPECT_EQ(text(p), "53\n+500+200\n+100-215\n+-4612\n+840+\n54\n");
}

TEST(EssiText, TheGuidesArcs) {
  // +1000++640-+ has an irrational centre; these have rational ones.
  PathBuilder p;
  p.arc({0, 60}, {0, 30}, true).arc({0, 0}, {0, 30}, true);
  EXPECT_EQ(text(p), "53\n++600+300--\n+-600+300--\n54\n");
}

TEST(EssiText, SenseAndSize) {
  const UnitVector down(Vector{0, -1});
  const UnitVector up(Vector{0, 1});
  EXPECT_EQ(text(PathBuilder().arc({10, 10}, {0, 10}, true)), "53\n+100+100+100--\n54\n");
  EXPECT_EQ(text(PathBuilder().arc({10, 10}, {10, 0}, false)), "53\n+100+100+100-+\n54\n");
}

TEST(EssiText, AnExactMajorArcIsWrittenWhole) {
  EXPECT_EQ(text(PathBuilder().arc({10, 10}, {10, 0}, true)), "53\n+100+100+100+-\n54\n");
  EXPECT_EQ(text(PathBuilder().arc({10, 10}, {0, 10}, false)), "53\n+100+100+100++\n54\n");
}

TEST(EssiText, AFullCircleOnTheGridIsTwoExactHalves) {
  const WriteResult r = write(PathBuilder().arc({0, 0}, {0, 30}, true).path(), essi());
  EXPECT_EQ(r.text, "53\n++600+300--\n+-600+300--\n54\n");
  EXPECT_LT(r.report.deviation, 1e-9);
  EXPECT_EQ(r.report.arcs, 2u);
  EXPECT_EQ(r.report.arcs_divided, 1u);
}

TEST(EssiText, AFullCircleOffTheGridIsThreeOrMoreArcs) {
  const WriteResult r =
      write(PathBuilder({0, 0}).arc({0, 0}, {0, q("30.03")}, true).path(), essi());
  EXPECT_GE(r.report.arcs, 3u);
  EXPECT_GT(r.report.deviation, 0);
  EXPECT_LE(r.report.deviation, 0.125);
}

TEST(EssiText, RapidsLookLikeLinesAndTheTorchTellsThem) {
  PathBuilder p;
  p.rapid("1", "1").line("2", "1").rapid("5", "5").line("6", "5");
  EXPECT_EQ(text(p), "+10+10\n53\n+10+\n54\n+30+40\n53\n+10+\n54\n");
}

TEST(EssiText, TorchCodesOfTheProgramReplaceTheAutomaticOnes) {
  PathBuilder p;
  p.rapid("1", "1").code("M07").line("2", "1").code("M8").line("3", "1").rapid("5", "5");
  EXPECT_EQ(text(p), "+10+10\n53\n+10+\n54\n+10+\n+20+40\n");
}

TEST(EssiText, AStopAndTechnologyCodesStayInPlace) {
  PathBuilder p;
  p.line("1", "0").code("M0").code("29").line("2", "0").code("38").code("M2");
  EXPECT_EQ(text(p), "53\n+10+\n0\n29\n+10+\n38\n54\n");
}

TEST(EssiText, FeedAndPowerAreDroppedWithOneNoteEach) {
  PathBuilder p;
  p.feed("300").code("S100").line("1", "0").line("2", "0").code("S200").line("3", "0");
  const WriteResult r = write(p.path(), essi());
  EXPECT_EQ(r.text, "53\n+10+\n+10+\n+10+\n54\n");
  ASSERT_EQ(r.report.notes.size(), 2u);
  EXPECT_EQ(r.report.notes[0].kind, WriteNote::Kind::PowerDropped);
  EXPECT_EQ(r.report.notes[0].place.line, 1u);
  EXPECT_EQ(r.report.notes[1].kind, WriteNote::Kind::FeedDropped);
  EXPECT_EQ(r.report.notes[1].move, 1u);
}

TEST(EssiText, WhatItCannotSayIsAFaultAndNothingIsWritten) {
  PathBuilder p;
  p.line("1", "0").height("5").dwell("2").code("M17").code("T1").code("101").code("M2");
  p.line("2", "0").line("99999999999999", "0");
  const WriteResult r = write(p.path(), essi());
  EXPECT_EQ(r.text, "");
  std::vector<WriteFault::Kind> kinds;
  for (const WriteFault& f : r.faults) kinds.push_back(f.kind);
  using Kind = WriteFault::Kind;
  EXPECT_EQ(kinds, (std::vector{Kind::HeightImpossible, Kind::DwellImpossible, Kind::UnknownCode,
                                Kind::UnknownCode, Kind::UnknownCode, Kind::MoveAfterEnd,
                                Kind::OutOfRange}));
  EXPECT_EQ(r.faults[2].code, "M17");
  EXPECT_EQ(r.faults[2].place.line, 3u);
  EXPECT_EQ(r.faults[2].move, 2u);
}

TEST(EssiText, AShallowArcIsALine) {
  // Sagitta 0.04 mm: under half a unit.
  const WriteResult r =
      write(PathBuilder().turn(UnitVector(Vector{0, -1}), 1000, 1.0, true).path(), essi());
  EXPECT_EQ(r.report.arcs, 0u);
  EXPECT_EQ(r.report.lines, 1u);
  EXPECT_EQ(r.report.arcs_as_lines, 1u);
}

TEST(EssiText, AnArcJustDeepEnoughIsAnArc) {
  const WriteResult r =
      write(PathBuilder().turn(UnitVector(Vector{0, -1}), 1000, 1.3, true).path(), essi());
  EXPECT_EQ(r.report.arcs, 1u);
  EXPECT_EQ(r.report.lines, 0u);
}

TEST(EssiText, AnArcThatRoundsToNothingIsDroppedAndItsRemainderCarried) {
  PathBuilder p;
  for (int i = 0; i < 40; ++i)
    p.arc({p.at().x + q("0.01"), p.at().y + q("0.01")}, {p.at().x, p.at().y + q("0.01")}, true);
  const WriteResult r = write(p.path(), essi());
  EXPECT_EQ(r.report.dropped, 36u);
  const auto run = replay::essi(r.text, 0.1, {0, 0});
  EXPECT_EQ(run.sum_x, 4);
  EXPECT_EQ(run.sum_y, 4);
}

TEST(EssiText, ATinyFullCircleThatRoundsToNothingDoesNotLightTheTorch) {
  const WriteResult r = write(PathBuilder().arc({0, 0}, {0, q("0.01")}, true).path(), essi());
  EXPECT_EQ(r.text, "");
  EXPECT_GT(r.report.dropped, 0u);
  EXPECT_LE(r.report.deviation, 0.125);
  EXPECT_GE(r.report.deviation, 0.01);
}

TEST(EssiText, ANearlyFullCircleKeepsItsTurn) {
  // Its ends round to one point; it is still a circle.
  PathBuilder p;
  p.turn(UnitVector(Vector{0, -1}), 30, 359.99, true);
  const WriteResult r = write(p.path(), essi());
  const auto run = replay::essi(r.text, 0.1, {0, 0});
  double turned = 0;
  for (const auto& s : run.steps)
    if (s.kind == replay::Step::Kind::Arc) turned += s.sweep;
  EXPECT_NEAR(turned, 2 * std::acos(-1.0), 0.02);
}

TEST(EssiText, LineEndsAreASetting) {
  Dialect d = essi();
  d.line_end = "\r\n";
  EXPECT_EQ(write(PathBuilder().line("1", "0").path(), d).text, "53\r\n+10+\r\n54\r\n");
}

}  // namespace
}  // namespace dgt
