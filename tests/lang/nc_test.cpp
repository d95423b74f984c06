// SPDX-License-Identifier: GPL-3.0-or-later
//
// What ESSI and G-code mean, block by block.
#include <gmock/gmock.h>

#include <string>

#include "lang/essi/reader.h"
#include "lang/gcode/reader.h"
#include "lang/nc/path_builder.h"
#include "lang/text/render.h"

namespace dgt {
namespace {

/// The moves of a program as to_text() prints them, without places; or what is wrong with it.
std::string printed(const SourceFile&, NcProgram program, const DiagnosticBag& bag) {
  if (bag.has_errors()) return render(bag);
  for (Move& move : program.path.moves) move.source = {};
  return to_text(program.path);
}

std::string gcode(std::string_view text, const GcodeOptions& options = {}) {
  const SourceFile file("t.nc", text);
  DiagnosticBag bag;
  return printed(file, read_gcode(file, options, bag), bag);
}

std::string essi(std::string_view text, const EssiOptions& options = {}) {
  const SourceFile file("t.ess", text);
  DiagnosticBag bag;
  return printed(file, read_essi(file, options, bag), bag);
}

// --- G-code -------------------------------------------------------------------------------------

TEST(Gcode, TheFirstAbsoluteRapidIsWhereTheProgramStarts) {
  EXPECT_EQ(gcode("G0 X5 Y-2.5\nG1 X6\n"),
            "start X5.000000 Y-2.500000\n1 line X6.000000 Y-2.500000 contour\n");
  EXPECT_EQ(gcode("G0 Z5\nG0 X5 Y1\nG1 X6\n"),
            "start X5.000000 Y1.000000\n1 rapid X5.000000 Y1.000000 Z5 position\n"
            "2 line X6.000000 Y1.000000 contour\n");
  EXPECT_EQ(gcode("G91\nG0 X5\n"),
            "start X0.000000 Y0.000000\n1 rapid X5.000000 Y0.000000 position\n");
  EXPECT_EQ(gcode("G92 X5 Y7\nG1 X6\n"),
            "start X5.000000 Y7.000000\n1 line X6.000000 Y7.000000 contour\n");
}

TEST(Gcode, InchesAreExact) {
  EXPECT_EQ(gcode("G20\nG1 X0.1 Y-1.00001 F10\n"),
            "start X0.000000 Y0.000000\n1 line X2.540000 Y-25.400254 F254 contour\n");
}

TEST(Gcode, WordsAreModalAndInAnyCase) {
  EXPECT_EQ(gcode("n10 g91 g1 x1 f100\nx1\ny1\ng90x0\n"),
            "start X0.000000 Y0.000000\n1 line X1.000000 Y0.000000 F100 contour\n"
            "2 line X2.000000 Y0.000000 F100 contour\n3 line X2.000000 Y1.000000 F100 contour\n"
            "4 line X0.000000 Y1.000000 F100 contour\n");
}

TEST(Gcode, WordsOfAnArcThatAreZeroAreLeftOut) {
  EXPECT_EQ(gcode("G91\nG03 Y-7.00 J-3.50\n"),
            "start X0.000000 Y0.000000\n1 arc X0.000000 Y-7.000000 centre X0.000000 Y-3.500000 "
            "radius 3.500000 sweep 180.000000 contour\n");
}

TEST(Gcode, AnArcWithoutAnEndIsAFullCircle) {
  EXPECT_EQ(gcode("G2 I3 J4\n"),
            "start X0.000000 Y0.000000\n1 arc X0.000000 Y0.000000 centre X3.000000 Y4.000000 "
            "radius 5.000000 sweep -360.000000 contour\n");
}

TEST(Gcode, CentresMayBeAbsoluteAndRadiiNegative) {
  EXPECT_EQ(gcode("G90.1\nG0 X10 Y0\nG3 X0 Y10 I0 J0\nG91.1\nG3 X-10 Y0 R-10\n"),
            "start X10.000000 Y0.000000\n1 arc X0.000000 Y10.000000 centre X0.000000 Y0.000000 "
            "radius 10.000000 sweep 90.000000 contour\n2 arc X-10.000000 Y0.000000 centre "
            "X-10.000000 Y10.000000 radius 10.000000 sweep 270.000000 contour\n");
}

TEST(Gcode, ARisingArcIsAHelix) {
  EXPECT_EQ(gcode("G0 X10 Y0\nG1 Z1\nG3 X-10 I-10 Z3\n"),
            "start X10.000000 Y0.000000\n1 line X10.000000 Y0.000000 Z1 contour\n"
            "2 arc X-10.000000 Y0.000000 centre X0.000000 Y0.000000 radius 10.000000 sweep "
            "180.000000 Z3 contour\n");
}

TEST(Gcode, DwellsCodesAndTheOrderInABlock) {
  EXPECT_EQ(gcode("G91 G0 X1 M0 S100 T2 M3\nG04 X2.5\nG4 P.001 G0 X1\nM02\n"),
            "start X0.000000 Y0.000000\n1 code S100\n2 code T2\n3 code M3\n"
            "4 rapid X1.000000 Y0.000000 position\n5 code M0\n6 dwell 2.5 s\n7 dwell 0.001 s\n"
            "8 rapid X2.000000 Y0.000000 position\n");
  GcodeOptions options;
  options.dwell_unit = Rational(1, 1000);
  EXPECT_EQ(gcode("G4 X250\n", options), "start X0.000000 Y0.000000\n1 dwell 0.25 s\n");
}

TEST(Gcode, G92ShiftsAndG53DoesNotKnowIt) {
  EXPECT_EQ(gcode("G1 X10\nG92 X0\nG1 X1\nG53 X1\nG92.1\nG1 X3\n"),
            "start X0.000000 Y0.000000\n1 line X10.000000 Y0.000000 contour\n"
            "2 line X11.000000 Y0.000000 contour\n3 line X1.000000 Y0.000000 contour\n"
            "4 line X3.000000 Y0.000000 contour\n");
}

TEST(Gcode, DecimalsOfAnyLengthAreExact) {
  const SourceFile file("t.nc", "G1 X0.12345678901234567890123 Y2000000000\n");
  DiagnosticBag bag;
  const NcProgram program = read_gcode(file, {}, bag);
  ASSERT_EQ(program.path.moves.size(), 1U);
  EXPECT_EQ(program.path.moves[0].to.exact().x.a, *parse_decimal("0.12345678901234567890123"));
  EXPECT_EQ(program.path.moves[0].to.exact().y.a, 2000000000);
}

TEST(Gcode, AnyLineEndsAndTapeMarksAndANumberOfTheProgram) {
  EXPECT_EQ(gcode("%\rO0001 (A)\r\nG1 X1\n\n;x\rX2%\n%\nX3\n"),
            "start X0.000000 Y0.000000\n1 line X1.000000 Y0.000000 contour\n"
            "2 line X2.000000 Y0.000000 contour\n");
}

// --- ESSI ---------------------------------------------------------------------------------------

TEST(Essi, SignsAloneAreZero) {
  EXPECT_EQ(essi("53\n+840+\n+-4612\n++200\n54\n--100\n"),
            "start X0.000000 Y0.000000\n1 code 53\n2 line X84.000000 Y0.000000 contour\n"
            "3 line X84.000000 Y-461.200000 contour\n4 line X84.000000 Y-441.200000 contour\n"
            "5 code 54\n6 rapid X84.000000 Y-451.200000 position\n");
}

TEST(Essi, TheSignsOfAnArcChooseSizeAndSense) {
  const std::string begin = "start X0.000000 Y0.000000\n1 code 53\n2 arc X6.000000 Y0.000000 ";
  const auto arc = [](const char* signs) { return essi(std::string("53\n+60++50") + signs); };
  EXPECT_EQ(arc("--"),
            begin + "centre X3.000000 Y4.000000 radius 5.000000 sweep 73.739795 contour\n");
  EXPECT_EQ(arc("-+"),
            begin + "centre X3.000000 Y-4.000000 radius 5.000000 sweep -73.739795 contour\n");
  EXPECT_EQ(arc("+-"),
            begin + "centre X3.000000 Y-4.000000 radius 5.000000 sweep 286.260205 contour\n");
  EXPECT_EQ(arc("++"),
            begin + "centre X3.000000 Y4.000000 radius 5.000000 sweep -286.260205 contour\n");
}

TEST(Essi, RepetitionsTurnOnAndTheScaleActsOnce) {
  EXPECT_EQ(essi("101+\n+100+\n101-\n53\n101+4+900+200\n"),
            "start X0.000000 Y0.000000\n1 code 53\n2 line X0.000000 Y20.000000 contour\n"
            "3 line X-20.000000 Y20.000000 contour\n4 line X-20.000000 Y0.000000 contour\n"
            "5 line X0.000000 Y0.000000 contour\n");
}

TEST(Essi, NestedCallsAddAnglesAndMultiplyScales) {
  EXPECT_EQ(essi("101+\n102+1+450+50\n101-\n102+\n+100+\n102-\n53\n101+1+450+50\n"),
            "start X0.000000 Y0.000000\n1 code 53\n2 line X0.000000 Y2.500000 contour\n");
}

TEST(Essi, TheSenseOfTheTurnAndTheUnitOfTheScaleAreSettings) {
  EssiOptions options;
  options.rotation = RotationSense::Clockwise;
  options.scale_unit = Rational(1, 1000);
  options.unit = Rational(1, 100);
  EXPECT_EQ(essi("101+\n+1000+\n101-\n53\n101++900+500\n", options),
            "start X0.000000 Y0.000000\n1 code 53\n2 line X0.000000 Y-5.000000 contour\n");
}

TEST(Essi, NoCircleIsWorkedOutBeforeItIsAskedFor) {
  const SourceFile file("t.ess", "53\n+100+0+80-+\n+0+100+80-+\n54\n");
  DiagnosticBag bag;
  const NcProgram program = read_essi(file, {}, bag);
  std::size_t arcs = 0;
  for (const Move& move : program.path.moves) {
    if (move.kind != MoveKind::Arc) continue;
    ++arcs;
    const auto* const source =
        dynamic_cast<const ElementOnDemand*>(move.carrier.base.source().get());
    ASSERT_NE(source, nullptr);
    EXPECT_FALSE(source->is_made());
    EXPECT_EQ(abs(move.circle().radius()), 8);
    EXPECT_TRUE(source->is_made());
  }
  EXPECT_EQ(arcs, 2U);
}

TEST(Essi, TheStarClosesAndItsTwelveEdgesAreEqual) {
  const SourceFile file("t.ess", "101+\n+230+400\n+230-400\n101-\n53\n101+6-600+150\n54\n");
  DiagnosticBag bag;
  NcProgram program = read_essi(file, {}, bag);
  ASSERT_EQ(program.path.moves.size(), 14U);
  program.path.contours = contours_of(program.path.moves);
  const auto& contours = program.path.contours;
  ASSERT_EQ(contours.size(), 1U);
  EXPECT_TRUE(contours[0].closed);
  const Rational edge = Rational(15, 100) * Rational(15, 100) * (230 * 230 + 400 * 400);
  for (const Move& move : programmed_moves(program.path, contours[0])) {
    const ExactPoint a = move.from.exact();
    const ExactPoint b = move.to.exact();
    const Rational square = squared_length({b.x.a - a.x.a, b.y.a - a.y.a});
    EXPECT_LT(abs(square - edge), power_of_two(-100));
  }
}

TEST(Essi, IsoArcsGoAboutACentreAndModesAreCodes) {
  EssiOptions options;
  options.dialect = EssiDialect::Iso;
  EXPECT_EQ(
      essi("39+1500\n7\n++600++300+\n82\n+100+100\n70\n81\n+100+\n8\n5\n+1+\n63\n", options),
      "start X0.000000 Y0.000000\n1 code 53\n2 arc X0.000000 Y60.000000 centre X0.000000 "
      "Y30.000000 radius 30.000000 sweep 180.000000 F1500 contour\n"
      "3 line X10.000000 Y10.000000 F1500 contour\n4 line X35.400000 Y10.000000 F1500 contour\n"
      "5 code 54\n6 rapid X35.654000 Y10.000000 position\n");
  EXPECT_EQ(essi("6\n29\n7\n++1000\n+1000+\n+-1000\n-1000+\n8\n38\n5\n", options),
            "start X0.000000 Y0.000000\n1 code 53\n2 line X0.000000 Y100.000000 contour\n"
            "3 line X100.000000 Y100.000000 contour\n4 line X100.000000 Y0.000000 contour\n"
            "5 line X0.000000 Y0.000000 contour\n6 code 54\n");
}

TEST(Essi, SubprogramsWithoutMovesDoNotRunForever) {
  EXPECT_THAT(essi("101+\n101-\n101+999999999999\n"), ::testing::HasSubstr("DGT0610"));
}

}  // namespace
}  // namespace dgt
