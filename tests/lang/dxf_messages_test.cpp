// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every message about a drawing, as a person reads it, with its line.
#include <gtest/gtest.h>

#include "lang/dxf/reader.h"
#include "lang/text/render.h"
#include "tests/lang/dxf_text.h"

namespace dgt {
namespace {

/// The first lines of the messages about a file, without the lines of the source.
std::string told_of_file(std::string_view text, const DxfOptions& options = {},
                         Language language = Language::English) {
  const SourceFile file("t.dxf", text);
  DiagnosticBag bag;
  (void)read_dxf(file, options, {}, bag);
  bag.sort();
  std::string told;
  for (const Diagnostic& diagnostic : bag.all()) {
    DiagnosticBag one;
    one.add(diagnostic);
    const std::string shown = render(one, {language, Colour::Plain});
    told += shown.substr(0, shown.find('\n') + 1);
  }
  return told;
}

std::string told(std::string_view groups, const DxfOptions& options = {}) {
  return told_of_file(dxf_text(groups), options);
}

TEST(DxfMessages, BinaryFilesAreNamed) {
  EXPECT_EQ(told_of_file("AutoCAD Binary DXF\r\n"),
            "t.dxf:1:1: error: this is a binary DXF file; save it as ASCII DXF [DGT1501]\n");
}

TEST(DxfMessages, DwgFilesAreNamed) {
  EXPECT_EQ(told_of_file(std::string_view("AC1015\0\0\0", 9)),
            "t.dxf:1:1: error: this is a DWG file; save it as DXF [DGT1502]\n");
}

TEST(DxfMessages, AnEmptyFile) {
  EXPECT_EQ(told_of_file("\n \n"), "t.dxf:1:1: error: the file is empty [DGT1503]\n");
}

TEST(DxfMessages, ALineThatIsNoCodeEndsTheReading) {
  EXPECT_EQ(told_of_file("0\nSECTION\n2\nENTITIES\nX10\n0\n"),
            "t.dxf:5:1: error: 'X10' stands where a group code is due; DXF is pairs of lines, a "
            "whole number that says what follows, and a value [DGT1504]\n");
}

TEST(DxfMessages, CutOffInAPair) {
  EXPECT_EQ(told_of_file("0\nSECTION\n2\nENTITIES\n0"),
            "t.dxf:5:1: error: the file ends in the middle of the drawing; it was not written or "
            "copied whole [DGT1505]\n");
}

TEST(DxfMessages, CutOffInASection) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 LINE|8 0|10 "
                 "0|20 0|11 10|21 0"),
            "t.dxf:26:2: error: the file ends in the middle of the drawing; it was not written or "
            "copied whole [DGT1505]\n");
}

TEST(DxfMessages, WithoutEofWhatIsThereIsRead) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 LINE|8 0|10 "
                 "0|20 0|11 10|21 0|0 ENDSEC"),
            "t.dxf:16:1: warning: open ends: 2; one lies at X0 Y0 [DGT1542]\n"
            "t.dxf:28:7: warning: the file does not end with EOF; what stands before has been read "
            "[DGT1506]\n");
}

TEST(DxfMessages, EntitiesWithoutASection) {
  EXPECT_EQ(told("0 LINE|8 0|10 0|20 0|11 10|21 0"),
            "t.dxf:2:1: error: 'LINE' stands where a SECTION begins [DGT1507]\n");
}

TEST(DxfMessages, AHeaderThatGoesOnBehindItsEndIsRead) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $HANDSEED|5 FFFF|0 ENDSEC|9 $DIMASZ|40 2.5|9 $INSUNITS|70 "
                 "4|0 ENDSEC|"
                 "0 SECTION|2 ENTITIES|0 LINE|8 0|10 0|20 0|11 10|21 0|0 ENDSEC|0 EOF"),
            "t.dxf:26:1: warning: open ends: 2; one lies at X0 Y0 [DGT1542]\n");
}

TEST(DxfMessages, ADecimalCommaIsNoNumber) {
  EXPECT_EQ(told("0 SECTION|2 ENTITIES|0 LINE|10 0|20 0|11 1,5|21 0|0 ENDSEC|0 EOF"),
            "t.dxf:12:1: error: '1,5' is no number, and the group 11 is one [DGT1508]\n");
}

TEST(DxfMessages, NumbersOfNoPart) {
  EXPECT_EQ(told("0 SECTION|2 ENTITIES|0 LINE|10 0|20 0|11 1e12|21 0|0 ENDSEC|0 EOF"),
            "t.dxf:12:1: error: 1e12 is beyond ±1000000000; no part is that large [DGT1509]\n");
}

TEST(DxfMessages, NumbersOfTooManyDigits) {
  EXPECT_EQ(told("0 SECTION|2 ENTITIES|0 LINE|10 0|20 0|11 0." + std::string(201, '1') +
                 "|21 0|0 ENDSEC|0 EOF"),
            "t.dxf:12:1: error: the number has 202 digits; at most 200 can be read [DGT0105]\n");
}

TEST(DxfMessages, FlagsAreWhole) {
  EXPECT_EQ(told("0 SECTION|2 ENTITIES|0 LWPOLYLINE|70 1.5|10 0|20 0|10 1|20 0|0 ENDSEC|0 EOF"),
            "t.dxf:8:1: error: 1.5 is no whole number, and the group 70 is one [DGT1510]\n");
}

TEST(DxfMessages, ACircleWithoutRadius) {
  EXPECT_EQ(told("0 SECTION|2 ENTITIES|0 CIRCLE|10 0|20 0|0 ENDSEC|0 EOF"),
            "t.dxf:6:1: error: 'CIRCLE' lacks its group 40 [DGT1511]\n");
}

TEST(DxfMessages, AVertexWithoutY) {
  EXPECT_EQ(told("0 SECTION|2 ENTITIES|0 LWPOLYLINE|70 0|10 0|10 5|20 1|0 ENDSEC|0 EOF"),
            "t.dxf:10:1: error: '0' lacks its group 20 [DGT1511]\n");
}

TEST(DxfMessages, VerticesWithoutEnd) {
  EXPECT_EQ(told("0 SECTION|2 ENTITIES|0 POLYLINE|70 0|0 VERTEX|10 0|20 0|0 VERTEX|10 1|20 0|0 "
                 "LINE|8 0|10 0|20 0|11 10|21 0|0 ENDSEC|0 EOF"),
            "t.dxf:6:1: error: the vertices of this POLYLINE do not end with SEQEND [DGT1512]\n");
}

TEST(DxfMessages, ATiltedCircle) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 CIRCLE|10 "
                 "0|20 0|40 1|210 1|220 0|230 0|0 ENDSEC|0 EOF"),
            "t.dxf:16:1: error: this CIRCLE lies in another plane than the drawing; leave its "
            "layer out with '--set dxf.layers', or draw it flat [DGT1513]\n");
}

TEST(DxfMessages, ANegativeRadius) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 CIRCLE|10 "
                 "0|20 0|40 -1|0 ENDSEC|0 EOF"),
            "t.dxf:16:1: error: the radius -1 is negative [DGT1514]\n");
}

TEST(DxfMessages, AnArcOfNoSweep) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 ARC|10 0|20 "
                 "0|40 1|50 30|51 30|0 ENDSEC|0 EOF"),
            "t.dxf:16:1: error: this arc ends at the angle where it begins: nothing, or a whole "
            "turn; draw a circle, or leave it out [DGT1515]\n");
}

TEST(DxfMessages, AFlatEllipse) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 ELLIPSE|10 "
                 "0|20 0|11 5|21 0|40 0|41 0|42 6.28|0 ENDSEC|0 EOF"),
            "t.dxf:16:1: error: the minor axis of this ellipse is 0 of its major one; it must be "
            "more than 0 [DGT1516]\n");
}

TEST(DxfMessages, ASplineOfFitPoints) {
  EXPECT_EQ(
      told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 SPLINE|71 3|11 "
           "0|21 0|11 5|21 5|0 ENDSEC|0 EOF"),
      "t.dxf:16:1: error: this spline has only points to pass through, and programs differ in what "
      "they draw through them; save it with control points, or as a polyline [DGT1517]\n");
}

TEST(DxfMessages, ASplineOfTooFewPoints) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 SPLINE|71 "
                 "3|10 0|20 0|10 5|20 5|0 ENDSEC|0 EOF"),
            "t.dxf:16:1: error: a spline of degree 3 cannot have 2 control points; the degree is 1 "
            "to 25, and there are more points [DGT1518]\n");
}

TEST(DxfMessages, ASplineOfTooFewKnots) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 SPLINE|71 "
                 "1|40 0|40 0|40 1|10 0|20 0|10 5|20 5|0 ENDSEC|0 EOF"),
            "t.dxf:16:1: error: this spline has 3 knots; with its degree and control points it has "
            "4 [DGT1519]\n");
}

TEST(DxfMessages, KnotsThatFall) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 SPLINE|71 "
                 "1|40 0|40 1|40 0|40 1|10 0|20 0|10 5|20 5|0 ENDSEC|0 EOF"),
            "t.dxf:16:1: error: the knots of this spline do not come in order [DGT1520]\n");
}

TEST(DxfMessages, WeightsThatAreNegative) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 SPLINE|71 "
                 "1|40 0|40 0|40 1|40 1|41 1|41 -1|10 0|20 0|10 5|20 5|0 ENDSEC|0 EOF"),
            "t.dxf:16:1: error: the weights of this spline are not one for each control point, all "
            "more than 0 [DGT1521]\n");
}

TEST(DxfMessages, ABlockScaledToNothing) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 BLOCKS|0 BLOCK|2 A|0 "
                 "ENDBLK|0 ENDSEC|0 SECTION|2 ENTITIES|0 INSERT|2 A|10 0|20 0|41 0|0 ENDSEC|0 EOF"),
            "t.dxf:28:1: error: the block 'A' is scaled to nothing [DGT1522]\n");
}

TEST(DxfMessages, ABlockThatIsNotThere) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 INSERT|2 "
                 "NUT|10 0|20 0|0 ENDSEC|0 EOF"),
            "t.dxf:16:1: error: there is no block 'NUT' in this file [DGT1523]\n");
}

TEST(DxfMessages, ABlockInItself) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 BLOCKS|0 BLOCK|2 A|0 "
                 "INSERT|2 a|10 0|20 0|0 ENDBLK|0 ENDSEC|0 SECTION|2 ENTITIES|0 INSERT|2 A|10 0|20 "
                 "0|0 ENDSEC|0 EOF"),
            "t.dxf:20:1: error: the block 'a' contains itself [DGT1524]\n");
}

TEST(DxfMessages, AnArrayOfAMillionNothings) {
  EXPECT_EQ(
      told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 BLOCKS|0 BLOCK|2 A|0 ENDBLK|0 "
           "ENDSEC|0 SECTION|2 ENTITIES|0 INSERT|2 A|10 0|20 0|70 1000|71 1000|0 ENDSEC|0 EOF",
           {.max_moves = 100}),
      "t.dxf:28:1: error: the drawing comes to more than 100 moves, the bound max_moves "
      "[DGT1525]\n");
}

TEST(DxfMessages, NothingToCut) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 EOF"),
            "t.dxf:1:1: error: nothing to cut was read [DGT1526]\n");
}

TEST(DxfMessages, ALayerThatIsNotThere) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 LINE|8 "
                 "CUT|10 0|20 0|11 10|21 0|0 ENDSEC|0 EOF",
                 {.layers = {"HOLES"}}),
            "t.dxf:1:1: error: nothing lies on the layer 'HOLES'; layers with something on them: "
            "CUT [DGT1527]\n");
}

TEST(DxfMessages, NoUnit) {
  EXPECT_EQ(told("0 SECTION|2 ENTITIES|0 LINE|8 0|10 0|20 0|11 10|21 0|0 ENDSEC|0 EOF"),
            "t.dxf:1:1: note: the drawing does not say its unit; millimetres are read, '--set "
            "dxf.unit=inch' reads inches [DGT1528]\n"
            "t.dxf:6:1: warning: open ends: 2; one lies at X0 Y0 [DGT1542]\n");
}

TEST(DxfMessages, ADrawingOfPlot) {
  EXPECT_EQ(told("999 dgt plot|0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 "
                 "CIRCLE|8 EQUIDISTANT|10 0|20 0|40 1|0 ENDSEC|0 EOF"),
            "t.dxf:1:1: note: a drawing of 'dgt plot': the layer EQUIDISTANT is read, as it was "
            "cut; '--set dxf.layers=CONTOUR' reads the programmed contours [DGT1529]\n");
}

TEST(DxfMessages, FrozenLayersAndThoseThatAreOff) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 TABLES|0 TABLE|2 "
                 "LAYER|0 LAYER|2 ICE|70 1|0 LAYER|2 DARK|62 -7|0 ENDTAB|0 ENDSEC|0 SECTION|2 "
                 "ENTITIES|0 CIRCLE|8 ice|10 0|20 0|40 1|0 CIRCLE|8 Dark|10 0|20 0|40 2|0 "
                 "CIRCLE|10 0|20 0|40 3|0 ENDSEC|0 EOF"),
            "t.dxf:40:1: note: left out, since their layers do not show: DARK 1, ICE 1; '--set "
            "dxf.layers=NAME,NAME' chooses layers [DGT1530]\n");
}

TEST(DxfMessages, Texts) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 TEXT|1 A|0 "
                 "TEXT|1 B|0 POINT|10 1|20 1|0 CIRCLE|10 0|20 0|40 3|0 ENDSEC|0 EOF"),
            "t.dxf:16:1: note: left out, since they are not cut: POINT 1, TEXT 2 [DGT1531]\n");
}

TEST(DxfMessages, Solids) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 3DSOLID|1 "
                 "A|0 CIRCLE|10 0|20 0|40 3|0 ENDSEC|0 EOF"),
            "t.dxf:16:1: warning: not read: 3DSOLID 1; explode them into lines, arcs, polylines or "
            "splines if they are to be cut [DGT1532]\n");
}

TEST(DxfMessages, HiddenEntities) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 LINE|60 1|10 "
                 "0|20 0|11 1|21 1|0 CIRCLE|10 0|20 0|40 3|0 ENDSEC|0 EOF"),
            "t.dxf:16:1: note: left out, since they are hidden or stand on a sheet of paper: 1 "
            "[DGT1533]\n");
}

TEST(DxfMessages, LinesThatRise) {
  EXPECT_EQ(
      told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 LINE|10 0|20 0|30 "
           "0|11 3|21 0|31 4|0 LINE|10 3|20 0|11 0|21 0|0 CIRCLE|10 9|20 0|40 3|0 ENDSEC|0 EOF"),
      "t.dxf:16:1: warning: entities whose Z changes: 1; they are read as seen from above "
      "[DGT1534]\n"
      "t.dxf:16:1: warning: open ends: 2; one lies at X0 Y0 [DGT1542]\n"
      "t.dxf:30:1: warning: drawn twice, and cut once: 1; the first stands here [DGT1536]\n");
}

TEST(DxfMessages, LinesOfNoLength) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 LINE|10 1|20 "
                 "1|11 1|21 1|0 CIRCLE|10 0|20 0|40 3|0 ENDSEC|0 EOF"),
            "t.dxf:16:1: note: left out, since they have no size: 1 [DGT1535]\n");
}

TEST(DxfMessages, CirclesDrawnTwice) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 CIRCLE|10 "
                 "0|20 0|40 3|0 CIRCLE|10 0|20 0|40 3.0000000001|0 ENDSEC|0 EOF"),
            "t.dxf:24:1: warning: drawn twice, and cut once: 1; the first stands here [DGT1536]\n");
}

TEST(DxfMessages, LinesThatRunAlongEachOther) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 LINE|10 0|20 "
                 "0|11 10|21 0|0 LINE|10 6|20 0|11 20|21 0|0 ENDSEC|0 EOF"),
            "t.dxf:16:1: warning: open ends: 4; the smallest gap between two, 4 mm, is at X10 Y0; "
            "'dxf.join_tolerance' is 0.01 mm [DGT1541]\n"
            "t.dxf:26:1: warning: places where one line or arc runs along another: 1; the longest, "
            "4 mm, begins with this one; there the cut goes twice [DGT1537]\n");
}

TEST(DxfMessages, ThreeEndsAtOnePlace) {
  EXPECT_EQ(
      told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 LINE|10 0|20 0|11 "
           "10|21 0|0 LINE|10 10|20 0|11 20|21 0|0 LINE|10 10|20 0|11 10|21 5|0 ENDSEC|0 EOF"),
      "t.dxf:16:1: warning: places where more than two ends meet: 1; here 3 do, at X10 Y0; "
      "contours end there [DGT1538]\n"
      "t.dxf:16:1: warning: open ends: 3; the smallest gap between two, 11.1803 mm, is at X0 Y0; "
      "'dxf.join_tolerance' is 0.01 mm [DGT1541]\n");
}

TEST(DxfMessages, ThreeLooseEnds) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 LINE|10 0|20 "
                 "0|11 10|21 0|0 LINE|10 10.004|20 0|11 20|21 0|0 LINE|10 10|20 0.004|11 10|21 5|0 "
                 "ENDSEC|0 EOF"),
            "t.dxf:16:1: warning: places where more than two loose ends lie within 0.01 mm of each "
            "other: 1; they are not joined [DGT1539]\n"
            "t.dxf:16:1: warning: open ends: 6; the smallest gap between two, 0.004 mm, is at X10 "
            "Y0; 'dxf.join_tolerance' is 0.01 mm [DGT1541]\n");
}

TEST(DxfMessages, AGapThatIsClosed) {
  EXPECT_EQ(
      told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 LINE|10 0|20 0|11 "
           "10|21 0|0 LINE|10 10.004|20 0.003|11 0|21 5|0 LINE|10 0|20 5|11 0|21 0|0 ENDSEC|0 EOF"),
      "t.dxf:26:1: note: ends moved together: 1; the largest gap, here, was 0.005 mm [DGT1540]\n");
}

TEST(DxfMessages, AGapThatIsNot) {
  EXPECT_EQ(
      told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 LINE|10 0|20 0|11 "
           "10|21 0|0 LINE|10 10.03|20 0.04|11 0|21 5|0 LINE|10 0|20 5|11 0|21 0|0 ENDSEC|0 EOF"),
      "t.dxf:16:1: warning: open ends: 2; the smallest gap between two, 0.05 mm, is at X10 Y0; "
      "'dxf.join_tolerance' is 0.01 mm [DGT1541]\n");
}

TEST(DxfMessages, AnOpenLine) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 LINE|8 0|10 "
                 "0|20 0|11 10|21 0|0 ENDSEC|0 EOF"),
            "t.dxf:16:1: warning: open ends: 2; one lies at X0 Y0 [DGT1542]\n");
}

TEST(DxfMessages, KerfOutsideAndInside) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 CIRCLE|10 "
                 "0|20 0|40 3|0 CIRCLE|10 0|20 0|40 9|0 ENDSEC|0 EOF",
                 {.kerf_width = Rational(1, 2)}),
            "t.dxf:16:1: note: closed contours are moved by 0.25 mm, half the kerf: outside 1, "
            "inside 1; 'dxf.kerf=off' leaves them where they are [DGT1543]\n");
}

TEST(DxfMessages, KerfBesideAnOpenLine) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 CIRCLE|10 "
                 "0|20 0|40 3|0 LINE|10 5|20 0|11 9|21 0|0 ENDSEC|0 EOF",
                 {.kerf_width = Rational(1, 2)}),
            "t.dxf:16:1: note: closed contours are moved by 0.25 mm, half the kerf: outside 1, "
            "inside 0; 'dxf.kerf=off' leaves them where they are [DGT1543]\n"
            "t.dxf:24:1: warning: open ends: 2; one lies at X5 Y0 [DGT1542]\n"
            "t.dxf:24:1: warning: open contours: 1; they have no inside, and the kerf does not "
            "move them [DGT1544]\n");
}

TEST(DxfMessages, KerfOfAContourThatEnclosesNothing) {
  EXPECT_EQ(told("0 SECTION|2 HEADER|9 $INSUNITS|70 4|0 ENDSEC|0 SECTION|2 ENTITIES|0 "
                 "LWPOLYLINE|70 1|10 0|20 0|10 5|20 0|0 ENDSEC|0 EOF",
                 {.kerf_width = Rational(1, 2)}),
            "t.dxf:20:1: note: closed contours are moved by 0.25 mm, half the kerf: outside 1, "
            "inside 0; 'dxf.kerf=off' leaves them where they are [DGT1543]\n"
            "t.dxf:20:1: error: this closed contour encloses nothing, so there is no side for the "
            "kerf [DGT1545]\n"
            "t.dxf:24:1: warning: places where one line or arc runs along another: 1; the longest, "
            "5 mm, begins with this one; there the cut goes twice [DGT1537]\n");
}

TEST(DxfMessages, AreInRussianToo) {
  EXPECT_EQ(told_of_file("0\nLINE\n", {}, Language::Russian),
            "t.dxf:2:1: error: «LINE» стоит там, где начинается секция SECTION [DGT1507]\n");
}

}  // namespace
}  // namespace dgt
