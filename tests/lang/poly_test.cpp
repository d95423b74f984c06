// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <chrono>
#include <string>

#include "lang/poly/reader.h"
#include "lang/poly/toolpath.h"
#include "lang/text/render.h"

namespace dgt {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A file `t.poly` from memory, read.
class ReadPoly {
 public:
  explicit ReadPoly(std::string_view text) : file_("t.poly", text) {
    loops = read_poly(file_, bag_);
  }
  [[nodiscard]] std::string messages(Language language = Language::English) const {
    return render(bag_, {language, Colour::Plain});
  }
  [[nodiscard]] const SourceFile& file() const { return file_; }

  std::vector<PolyLoop> loops;

 private:
  SourceFile file_;
  DiagnosticBag bag_;
};

RationalPoint at(const char* x, const char* y) { return {*parse_decimal(x), *parse_decimal(y)}; }

// --- what is read -------------------------------------------------------------------------------

TEST(PolyReader, VerticesAreExact) {
  const ReadPoly read("0.1 -.25 0\n+7 5. 0\n2e-5 1.5E+3 0\n0.12345678901234567890123 1e2 0\n");
  EXPECT_EQ(read.messages(), "");
  ASSERT_THAT(read.loops, SizeIs(1));
  const auto& edges = read.loops[0].chain.edges;
  ASSERT_THAT(edges, SizeIs(4));
  EXPECT_EQ(edges[0].from, at("0.1", "-0.25"));
  EXPECT_EQ(edges[1].from, at("7", "5"));
  EXPECT_EQ(edges[2].from, at("0.00002", "1500"));
  EXPECT_EQ(edges[3].from, at("0.12345678901234567890123", "100"));
  EXPECT_EQ(edges[3].to, edges[0].from);
}

TEST(PolyReader, TheBulgeIsTheTangentOfAQuarterOfTheSweep) {
  const ReadPoly read("-5 0 1\n5 0 -1\n");  // half a turn to the left, half a turn to the right
  ASSERT_THAT(read.loops, SizeIs(1));
  const auto& edges = read.loops[0].chain.edges;
  ASSERT_THAT(edges, SizeIs(2));
  EXPECT_EQ(edges[0].radius, 5);
  EXPECT_EQ(edges[1].radius, -5);
  EXPECT_EQ(edges[0].centre(), at("0", "0"));
}

TEST(PolyReader, ArcsOfMoreThanHalfATurnAreHalvedAndKeepTheirPlace) {
  const ReadPoly read("0 0 2\n1 0 0\n");
  ASSERT_THAT(read.loops, SizeIs(1));
  ASSERT_THAT(read.loops[0].chain.edges, SizeIs(3));
  ASSERT_THAT(read.loops[0].places, SizeIs(3));
  EXPECT_EQ(read.loops[0].places[0].place().line, 1U);
  EXPECT_EQ(read.loops[0].places[1].place().line, 1U);
  EXPECT_EQ(read.loops[0].places[2].place().line, 2U);
}

TEST(PolyReader, AMinuteBulgeIsALine) {
  const ReadPoly read("0 0 1e-30\n1 0 -1e-300\n1 1 0\n");
  ASSERT_THAT(read.loops, SizeIs(1));
  for (const ChainEdge& edge : read.loops[0].chain.edges) EXPECT_TRUE(edge.is_line());
}

TEST(PolyReader, BlankLinesEndLoopsAndCommentsDoNot) {
  const ReadPoly read(
      "# head\n\n\n0 0 0\n1 0 0 # corner\n# between\n0 1 0\n\n \t\n5 5 0\n6 5 0\n5 6 0\n\n");
  EXPECT_EQ(read.messages(), "");
  ASSERT_THAT(read.loops, SizeIs(2));
  EXPECT_THAT(read.loops[0].chain.edges, SizeIs(3));
  EXPECT_THAT(read.loops[1].chain.edges, SizeIs(3));
  EXPECT_EQ(read.loops[0].places[2].place().line, 7U);
}

TEST(PolyReader, CarriageReturnsTabsAndAByteOrderMarkAreRead) {
  const ReadPoly read("\xEF\xBB\xBF\t0\t0  0\r\n1 0 0\t\r\n0 1 0\r\n\r\nopen\r\n5 5 0\r\n6 5 0");
  EXPECT_EQ(read.messages(), "");
  ASSERT_THAT(read.loops, SizeIs(2));
  EXPECT_TRUE(read.loops[0].chain.closed);
  EXPECT_FALSE(read.loops[1].chain.closed);
}

TEST(PolyReader, OpenHoldsForOneLoop) {
  const ReadPoly read("open\n0 0 0\n1 0 0\n\n0 0 0\n1 0 0\n0 1 0\n");
  ASSERT_THAT(read.loops, SizeIs(2));
  EXPECT_FALSE(read.loops[0].chain.closed);
  EXPECT_THAT(read.loops[0].chain.edges, SizeIs(1));
  EXPECT_TRUE(read.loops[1].chain.closed);
}

TEST(PolyReader, CoincidentVerticesBeginNoEdge) {
  const ReadPoly read("0 0 0\n0 0 0\n1 0 0\n1.0 0e5 0\n1 1 0\n0 0 0\n");
  EXPECT_EQ(read.messages(), "");
  ASSERT_THAT(read.loops, SizeIs(1));
  EXPECT_THAT(read.loops[0].chain.edges, SizeIs(3));
  EXPECT_EQ(read.loops[0].places[1].place().line, 3U);
  EXPECT_EQ(read.loops[0].places[2].place().line, 5U);
}

TEST(PolyReader, AFileWithoutVerticesHasNoLoops) {
  for (const char* text : {"", "\n\n", "# nothing is left\n"}) {
    const ReadPoly read(text);
    EXPECT_THAT(read.loops, IsEmpty());
    EXPECT_EQ(read.messages(), "");
  }
}

TEST(PolyReader, ReadsAMillionVerticesInSeconds) {
  std::string text;
  constexpr int kVertices = 1'000'000;
  for (int i = 0; i < kVertices; ++i) {
    text += std::to_string(i % 1000) + "." + std::to_string(100000 + i) + " " +
            std::to_string(i / 1000) + ".25 x\n";  // not a number: no chain is made
  }
  const auto begin = std::chrono::steady_clock::now();
  const ReadPoly read(text);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  EXPECT_THAT(read.loops, IsEmpty());
  // Ten times what it takes here, so that a loaded machine passes and quadratic growth does not.
  EXPECT_LT(taken.count(), 30);
}

// --- faults -------------------------------------------------------------------------------------

TEST(PolyMessages, WhatIsNoNumber) {
  const ReadPoly read("0 0 0\n1,5 0 0\n0x1F nan 0\n1e999 1 0\n");
  EXPECT_EQ(read.messages(),
            "t.poly:2:1: error: '1,5' is no number [DGT1001]\n"
            "1,5 0 0\n"
            "^~~\n"
            "t.poly:3:1: error: '0x1F' is no number [DGT1001]\n"
            "0x1F nan 0\n"
            "^~~~\n"
            "t.poly:3:6: error: 'nan' is no number [DGT1001]\n"
            "0x1F nan 0\n"
            "     ^~~\n"
            "t.poly:4:1: error: '1e999' is no number [DGT1001]\n"
            "1e999 1 0\n"
            "^~~~~\n");
  EXPECT_THAT(read.loops, IsEmpty());
}

TEST(PolyMessages, MissingBulgeAndSurplusWords) {
  const ReadPoly read("0 0\n1\n1 1 0 7 left # to here\n");
  EXPECT_EQ(read.messages(),
            "t.poly:1:4: error: a vertex is three numbers, x y bulge; here are 2 [DGT1002]\n"
            "0 0\n"
            "   ^\n"
            "t.poly:2:2: error: a vertex is three numbers, x y bulge; here are 1 [DGT1002]\n"
            "1\n"
            " ^\n"
            "t.poly:3:7: error: '7 left' is too much on this line [DGT0207]\n"
            "1 1 0 7 left # to here\n"
            "      ^~~~~~\n");
}

TEST(PolyMessages, OpenInTheWrongPlace) {
  const ReadPoly read("0 0 0\nopen\n1 1 0\n\nopen\nopen\n0 0 0\n1 0 0\n\nopen 5 5\n\nopen\n");
  EXPECT_EQ(read.messages(),
            "t.poly:2:1: error: 'open' stands once in a loop, alone on the line before its first "
            "vertex [DGT1003]\n"
            "open\n"
            "^~~~\n"
            "t.poly:6:1: error: 'open' stands once in a loop, alone on the line before its first "
            "vertex [DGT1003]\n"
            "open\n"
            "^~~~\n"
            "t.poly:10:1: error: 'open' stands once in a loop, alone on the line before its first "
            "vertex [DGT1003]\n"
            "open 5 5\n"
            "^~~~\n"
            "t.poly:12:1: error: 'open' stands once in a loop, alone on the line before its first "
            "vertex [DGT1003]\n"
            "open\n"
            "^~~~\n");
  EXPECT_THAT(read.loops, IsEmpty());
}

TEST(PolyMessages, FewerThanTwoDistinctVertices) {
  const ReadPoly read("1 1 0\n\n2 2 0\n2.0 2 1\n\n0 0 0\n1 0 0\n0 1 0\n");
  EXPECT_EQ(read.messages(),
            "t.poly:1:1: error: this loop has fewer than two distinct vertices [DGT1004]\n"
            "1 1 0\n"
            "^~~~~\n"
            "t.poly:3:1: error: this loop has fewer than two distinct vertices [DGT1004]\n"
            "2 2 0\n"
            "^~~~~\n");
  EXPECT_THAT(read.loops, SizeIs(1));  // the others are read all the same
}

TEST(PolyMessages, NumbersOfTooManyDigits) {
  const ReadPoly read("0 0 0\n" + std::string(201, '1') + " 0 0\n");
  EXPECT_THAT(read.messages(),
              ::testing::StartsWith("t.poly:2:1: error: the number has 201 digits; at most 200 can "
                                    "be read [DGT0105]\n"));
}

TEST(PolyMessages, SpeakRussian) {
  const ReadPoly read("0 0\n\n1 1 x\n\n2 2 0\n\nopen\n");
  EXPECT_EQ(read.messages(Language::Russian),
            "t.poly:1:4: error: вершина задаётся тремя числами x y bulge; здесь их 2 [DGT1002]\n"
            "0 0\n"
            "   ^\n"
            "t.poly:3:5: error: «x» — не число [DGT1001]\n"
            "1 1 x\n"
            "    ^\n"
            "t.poly:5:1: error: в этом контуре меньше двух различных вершин [DGT1004]\n"
            "2 2 0\n"
            "^~~~~\n"
            "t.poly:7:1: error: open ставится один раз, отдельной строкой перед первой вершиной "
            "контура [DGT1003]\n"
            "open\n"
            "^~~~\n");
}

// --- as a tool path -----------------------------------------------------------------------------

TEST(PolyToolpath, LoopsAreContoursWithRapidsBetween) {
  const ReadPoly read("0 0 0\n4 0 0\n0 3 0\n\nopen\n10 0 1\n12 0 0\n");
  EXPECT_EQ(to_text(toolpath_of(read.loops, read.file())),
            "start X0.000000 Y0.000000\n"
            "contour 1 offset 0 side none closed\n"
            "1 line X4.000000 Y0.000000 contour  ; t.poly:1:1\n"
            "2 line X0.000000 Y3.000000 contour  ; t.poly:2:1\n"
            "3 line X0.000000 Y0.000000 contour  ; t.poly:3:1\n"
            "4 rapid X10.000000 Y0.000000 position  ; t.poly:6:1\n"
            "contour 2 offset 0 side none open\n"
            "5 arc X12.000000 Y0.000000 centre X11.000000 Y0.000000 radius 1.000000 sweep "
            "180.000000 contour  ; t.poly:6:1\n");
}

}  // namespace
}  // namespace dgt
