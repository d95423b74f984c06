// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/gcode.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/post/paths.h"

namespace dgt {
namespace {

using testing::PathBuilder;
using testing::q;

const Dialect& plasmatic() { return *find_dialect("plasmatic"); }
const Dialect& linuxcnc() { return *find_dialect("linuxcnc"); }

std::string text(const PathBuilder& p, const Dialect& d) { return write(p.path(), d).text; }

double radius_at_end(const replay::Step& arc) {
  return std::hypot(arc.to.x - arc.centre.x, arc.to.y - arc.centre.y);
}

TEST(PlasmaticText, IncrementsFromTheStartZeroWordsLeftOut) {
  PathBuilder p({q("3"), q("4")});
  p.rapid("5", "4").feed("1000").line("5", "-12.5").line("15", "0").dwell("2.5");
  p.arc({15, -7}, {15, q("-3.5")}, true);
  EXPECT_EQ(text(p, plasmatic()),
            "G21\nG91\nG00 X2.0\nM07\nG01 Y-16.5 F1000\nG01 X10.0 Y12.5\nG04 X2.5\n"
            "G03 Y-7.0 J-3.5\nM08\nM02\n");
}

TEST(PlasmaticText, WithoutAFeedNoneIsWritten) {
  EXPECT_EQ(text(PathBuilder().line("1", "0"), plasmatic()), "G21\nG91\nM07\nG01 X1.0\nM08\nM02\n");
}

TEST(PlasmaticText, ASettingOverridesTheFeed) {
  Dialect d = plasmatic();
  d.feed = shared(q("2500.5"));
  PathBuilder p;
  p.feed("100").line("1", "0").feed("200").line("2", "0");
  EXPECT_EQ(text(p, d), "G21\nG91\nM07\nG01 X1.0 F2500.5\nG01 X1.0\nM08\nM02\n");
}

TEST(PlasmaticText, AFeedIsSaidWhereItChanges) {
  PathBuilder p;
  p.feed("100").line("1", "0").feed("100").line("2", "0").feed("200").line("3", "0");
  EXPECT_EQ(text(p, plasmatic()),
            "G21\nG91\nM07\nG01 X1.0 F100\nG01 X1.0\nG01 X1.0 F200\nM08\nM02\n");
}

TEST(PlasmaticText, TwoDecimalsOnAnUnevenUnit) {
  Dialect d = plasmatic();
  d.unit = q("0.05");
  EXPECT_EQ(text(PathBuilder().line("1.02", "-0.03"), d),
            "G21\nG91\nM07\nG01 X1.00 Y-0.05\nM08\nM02\n");
}

TEST(PlasmaticText, ALongDwellInMilliseconds) {
  Dialect d = plasmatic();
  d.dwell_unit = DwellUnit::Milliseconds;
  EXPECT_EQ(text(PathBuilder().dwell("0.05"), d), "G21\nG91\nG04 X50\nM02\n");
}

TEST(PlasmaticText, WhatItCannotSayIsAFault) {
  PathBuilder p;
  p.code("M17").line("1", "0").height("1").code("T5").code("M00").code("S3");
  const WriteResult r = write(p.path(), plasmatic());
  ASSERT_EQ(r.faults.size(), 3u);
  EXPECT_EQ(r.faults[0].kind, WriteFault::Kind::UnknownCode);
  EXPECT_EQ(r.faults[1].kind, WriteFault::Kind::HeightImpossible);
  EXPECT_EQ(r.faults[2].code, "T5");
}

TEST(LinuxcncText, AbsoluteWithARapidToTheStart) {
  PathBuilder p({14, 0});
  p.feed("300").line("9.4174", "2").rapid("0", "0");
  EXPECT_EQ(text(p, linuxcnc()),
            "G21 G90 G17 G40 G91.1\nG00 X14.000 Y0.000\nM07\nG01 X9.417 Y2.000 F300\nM08\n"
            "G00 X0.000 Y0.000\nM02\n");
}

TEST(LinuxcncText, OnlyCodesThatItsInterpreterKnowsPass) {
  // What `rs274` of LinuxCNC 2.9 accepts of M0 to M210 alone on its line, but for M2 and M30, and
  // for those that save its state or end a subprogram (M70 to M73, M99).
  const std::vector<int> known = {0, 1, 3, 4, 5, 6, 7, 8, 9, 19, 48, 49, 50, 51, 52, 53, 60};
  for (int number = 0; number <= 210; ++number) {
    if (number == 2 || number == 30) continue;
    const bool passes = std::find(known.begin(), known.end(), number) != known.end();
    EXPECT_EQ(meaning_of(linuxcnc(), "M" + std::to_string(number)).kind,
              passes ? CodeMeaning::Kind::Words : CodeMeaning::Kind::Unknown)
        << "M" << number;
  }
}

TEST(PlasmaticText, OnlyCodesOfTheGuidePass) {
  const std::vector<int> known = {0, 3, 4, 5, 7, 8};
  for (int number = 0; number <= 210; ++number) {
    if (number == 2 || number == 30) continue;
    const bool passes = std::find(known.begin(), known.end(), number) != known.end();
    EXPECT_EQ(meaning_of(plasmatic(), "M" + std::to_string(number)).kind,
              passes ? CodeMeaning::Kind::Words : CodeMeaning::Kind::Unknown)
        << "M" << number;
  }
}

// --- cuts after the program's own torch-off code

std::vector<std::size_t> put_out_before_a_cut(const PathBuilder& p, const Dialect& d) {
  std::vector<std::size_t> moves;
  for (const WriteNote& note : write(p.path(), d).report.notes)
    if (note.kind == WriteNote::Kind::CutsWithTorchOff) moves.push_back(note.move);
  return moves;
}

using Moves = std::vector<std::size_t>;

TEST(TorchOffCode, CutsBehindItAreNotedOnceAtTheCode) {
  PathBuilder p;
  p.feed("1").code("M7").line("1", "0").code("M8").line("2", "0").line("3", "0");
  EXPECT_EQ(put_out_before_a_cut(p, plasmatic()), Moves{2});
  EXPECT_EQ(put_out_before_a_cut(p, linuxcnc()), Moves{2});
  EXPECT_EQ(put_out_before_a_cut(p, *find_dialect("essi")), Moves{2});
}

TEST(TorchOffCode, EachThatIsFollowedByACutIsNoted) {
  PathBuilder p;
  p.feed("1").code("M8").line("1", "0").code("M7").line("2", "0").code("M5").line("3", "0");
  EXPECT_EQ(put_out_before_a_cut(p, linuxcnc()), (Moves{0, 4}));
}

TEST(TorchOffCode, RapidsAfterItAndANewTorchOnAreAsItShouldBe) {
  PathBuilder p;
  p.feed("1").code("M7").line("1", "0").code("M8").rapid("2", "0").code("M3").line("3", "0");
  p.code("M5");
  EXPECT_EQ(put_out_before_a_cut(p, linuxcnc()), Moves{});
  EXPECT_EQ(put_out_before_a_cut(PathBuilder().feed("1").line("1", "0"), linuxcnc()), Moves{});
}

TEST(TorchOffCode, ACutThatRoundsToNothingDoesNotCount) {
  PathBuilder p;
  p.code("M7").line("1", "0").code("M8").line("1.01", "0").rapid("0", "0");
  EXPECT_EQ(put_out_before_a_cut(p, plasmatic()), Moves{});
}

TEST(TorchOffCode, WithoutATorchThereIsNothingToNote) {
  Dialect d = linuxcnc();
  d.torch = TorchPolicy::None;
  PathBuilder p;
  p.feed("1").code("M7").line("1", "0").code("M8").line("2", "0");
  EXPECT_EQ(put_out_before_a_cut(p, d), Moves{});
  EXPECT_EQ(text(p, d),
            "G21 G90 G17 G40 G91.1\nG00 X0.000 Y0.000\nM07\nG01 X1.000 Y0.000 F1\nM08\n"
            "G01 X2.000 Y0.000\nM02\n");
}

TEST(LinuxcncText, AMissingFeedIsDefaultedWithANote) {
  const WriteResult r = write(PathBuilder().line("1", "0").line("2", "0").path(), linuxcnc());
  EXPECT_EQ(r.text,
            "G21 G90 G17 G40 G91.1\nG00 X0.000 Y0.000\nM07\nG01 X1.000 Y0.000 F1000\n"
            "G01 X2.000 Y0.000\nM08\nM02\n");
  ASSERT_EQ(r.report.notes.size(), 1u);
  EXPECT_EQ(r.report.notes[0].kind, WriteNote::Kind::FeedDefaulted);
  EXPECT_EQ(r.report.notes[0].value, "1000");
}

TEST(LinuxcncText, CodesPassAndTheProgramsTorchIsItsOwn) {
  PathBuilder p;
  p.feed("1").code("M03").code("S500").code("T2").line("1", "0").code("M05").dwell("0.25");
  EXPECT_EQ(text(p, linuxcnc()),
            "G21 G90 G17 G40 G91.1\nG00 X0.000 Y0.000\nM3\nS500\nT2\nG01 X1.000 Y0.000 F1\nM5\n"
            "G04 P0.25\nM02\n");
}

TEST(LinuxcncText, HeightsOnLinesAndHelices) {
  PathBuilder p;
  p.feed("1").line("1", "0").height("-0.5").line("2", "0").line("2", "0").height("1.25");
  p.arc({2, 0}, {2, 10}, true).height("3.25");
  EXPECT_EQ(text(p, linuxcnc()),
            "G21 G90 G17 G40 G91.1\nG00 X0.000 Y0.000\nM07\nG01 X1.000 Y0.000 Z-0.500 F1\n"
            "G01 X2.000 Y0.000\nG01 X2.000 Y0.000 Z1.250\n"
            "G03 X2.000 Y20.000 Z2.250 I0.000 J10.000\nG03 X2.000 Y0.000 Z3.250 I0.000 J-10.000\n"
            "M08\nM02\n");
}

TEST(LinuxcncText, RoundedEndsGetACentreWithEqualRadii) {
  PathBuilder p({q("0.0004"), 0});
  p.feed("1").arc({q("10.0004"), 10}, {q("0.0004"), 10}, true);
  const auto run = replay::gcode(text(p, linuxcnc()), {});
  const replay::Step& arc = run.steps[3];
  ASSERT_EQ(arc.kind, replay::Step::Kind::Arc);
  EXPECT_EQ(arc.from.x, 0);  // the centre counts from here, not from 0.0004
  EXPECT_LT(arc.mismatch, 1e-9);
  EXPECT_NEAR(arc.centre.x, 0.0004, 0.001);
  EXPECT_NEAR(arc.centre.y, 10, 0.0011);
}

// LinuxCNC refuses a smaller one as a "Zero-radius arc".
TEST(LinuxcncText, NoRadiusIsBelowTheLeast) {
  Dialect fine = linuxcnc();
  fine.unit = q("0.000001");
  int arcs = 0;
  for (const char* radius : {"0.001", "0.0012", "0.001269", "0.001271", "0.002"}) {
    PathBuilder p({q(radius), 0});
    p.feed("1").arc({q(radius), 0}, {0, 0}, true);
    for (const Dialect& dialect : {linuxcnc(), fine}) {
      const WriteResult r = write(p.path(), dialect);
      EXPECT_LE(r.report.deviation, 1.25 * nearest_double(dialect.unit));
      for (const replay::Step& step : replay::gcode(r.text, {}).steps) {
        if (step.kind != replay::Step::Kind::Arc) continue;
        ++arcs;
        EXPECT_GE(step.radius, 0.00127 - 1e-12) << radius;
        EXPECT_GE(radius_at_end(step), 0.00127 - 1e-12) << radius;
      }
    }
  }
  EXPECT_GT(arcs, 4);
}

TEST(LinuxcncText, ACircleAboveTheLeastRadiusStaysTwoArcs) {
  PathBuilder p({q("0.001271"), 0});
  p.feed("1").arc({q("0.001271"), 0}, {0, 0}, true);
  Dialect fine = linuxcnc();
  fine.unit = q("0.000001");
  EXPECT_EQ(write(p.path(), fine).report.arcs, 2u);
  EXPECT_EQ(write(p.path(), fine).report.lines, 0u);
}

TEST(Dialects, AreFoundByName) {
  EXPECT_EQ(dialects().size(), 7u);
  EXPECT_EQ(find_dialect("fanuc"), nullptr);
}

TEST(Dialects, LeadingZerosOfACodeDoNotMatter) {
  EXPECT_EQ(meaning_of(plasmatic(), "M00").words, "M00");
  EXPECT_EQ(meaning_of(plasmatic(), "M0").words, "M00");
  EXPECT_EQ(meaning_of(plasmatic(), "M007").torch, TorchAct::On);
  EXPECT_EQ(meaning_of(*find_dialect("essi"), "00").words, "0");
  EXPECT_EQ(meaning_of(*find_dialect("essi"), "").kind, CodeMeaning::Kind::Unknown);
}

}  // namespace
}  // namespace dgt
