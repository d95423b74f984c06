// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same drawings read by dxflib: the same entities, in the same order and blocks, with the same
// numbers as far as doubles hold them.
#include <dl_creationadapter.h>
#include <dl_dxf.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include "lang/dxf/drawing.h"
#include "tests/support/command.h"

namespace dgt {
namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;
using Drawing = std::map<std::string, Lines>;  ///< by block; the drawing itself has no name

std::string number(double value) { return fmt::format(" {:.9f}", value == 0 ? 0 : value + 1e-12); }
std::string number(const Rational& value) { return number(nearest_double(value)); }
template <class... Numbers>
std::string line(std::string_view kind, const Numbers&... numbers) {
  std::string text(kind);
  ((text += number(numbers)), ...);
  return text;
}

// --- what dxflib reads --------------------------------------------------------------------------

class Listener : public DL_CreationAdapter {
 public:
  Drawing drawing;

  void addBlock(const DL_BlockData& block) override { block_ = dxf_key(block.name); }
  void endBlock() override { block_.clear(); }
  void addLine(const DL_LineData& d) override { add(line("LINE", d.x1, d.y1, d.x2, d.y2)); }
  void addCircle(const DL_CircleData& d) override {
    add(line("ARC", d.cx, d.cy, d.radius, 1.0, 0.0, 1.0, 0.0));
  }
  void addArc(const DL_ArcData& d) override {
    add(line("ARC", d.cx, d.cy, d.radius, cosine(d.angle1), sine(d.angle1), cosine(d.angle2),
             sine(d.angle2)));
  }
  void addEllipse(const DL_EllipseData& d) override {
    add(line("ELLIPSE", d.cx, d.cy, d.mx, d.my, -d.my * d.ratio, d.mx * d.ratio, std::cos(d.angle1),
             std::sin(d.angle1), std::cos(d.angle2), std::sin(d.angle2)));
  }
  void addPolyline(const DL_PolylineData& d) override {
    add((d.flags & 1) != 0 ? "POLYLINE closed" : "POLYLINE open");
  }
  void addVertex(const DL_VertexData& d) override { add(line("VERTEX", d.x, d.y, d.bulge)); }
  void addSpline(const DL_SplineData& d) override {
    add(line("SPLINE", static_cast<double>(d.degree)));
  }
  void addControlPoint(const DL_ControlPointData& d) override { add(line("POINT", d.x, d.y, d.w)); }
  void addKnot(const DL_KnotData& d) override { add(line("KNOT", d.k)); }
  void addInsert(const DL_InsertData& d) override {
    add("INSERT " + dxf_key(d.name) +
        line("", d.ipx, d.ipy, d.sx, d.sy, cosine(d.angle), sine(d.angle),
             static_cast<double>(d.cols), static_cast<double>(d.rows), d.colSp, d.rowSp));
  }

 private:
  static double cosine(double degrees) { return std::cos(degrees * std::acos(-1.0) / 180); }
  static double sine(double degrees) { return std::sin(degrees * std::acos(-1.0) / 180); }
  void add(std::string text) { drawing[block_].push_back(std::move(text)); }

  std::string block_;
};

Drawing read_by_dxflib(const std::string& file) {
  Listener listener;
  DL_Dxf dxflib;
  EXPECT_TRUE(dxflib.in(file, &listener)) << file;
  return listener.drawing;
}

// --- what is read here --------------------------------------------------------------------------

struct Printer {
  Lines& lines;

  void operator()(const DxfOther&) const {}
  void operator()(const DxfFaulty&) const { lines.emplace_back("faulty"); }
  void operator()(const DxfLine& d) const {
    lines.push_back(line("LINE", d.from.x, d.from.y, d.to.x, d.to.y));
  }
  void operator()(const DxfArc& d) const {
    lines.push_back(line("ARC", d.centre.x, d.centre.y, d.radius, d.start.x(), d.start.y(),
                         d.end.x(), d.end.y()));
  }
  void operator()(const DxfPolyline& d) const {
    lines.emplace_back(d.closed ? "POLYLINE closed" : "POLYLINE open");
    for (const BulgeVertex& v : d.vertices)
      lines.push_back(line("VERTEX", v.at.x, v.at.y, v.bulge));
  }
  void operator()(const DxfEllipse& d) const {
    lines.push_back(line("ELLIPSE", d.centre.x, d.centre.y, d.major.x, d.major.y, d.minor.x,
                         d.minor.y, d.start.x(), d.start.y(), d.end.x(), d.end.y()));
  }
  void operator()(const DxfSpline& d) const {
    lines.push_back(line("SPLINE", static_cast<double>(d.degree)));
    for (const BezierPoint& p : d.points)
      lines.push_back(line("POINT", Rational(p.x / p.w), Rational(p.y / p.w), p.w));
    for (const Rational& knot : d.knots) lines.push_back(line("KNOT", knot));
  }
  void operator()(const DxfInsert& d) const {
    lines.push_back("INSERT " + dxf_key(d.block) +
                    line("", d.at.x, d.at.y, d.scale_x, d.scale_y, d.turn.x(), d.turn.y(),
                         static_cast<double>(d.columns), static_cast<double>(d.rows), d.column_step,
                         d.row_step));
  }
};

Drawing read_here(const std::string& file) {
  const SourceFile source(file, support::read_text(file));
  DiagnosticBag bag;
  const DxfDrawing read = read_dxf_drawing(source, bag);
  EXPECT_FALSE(bag.has_errors());
  Drawing drawing;
  const auto print = [&](const std::string& block, const std::vector<DxfEntity>& entities) {
    if (entities.empty()) return;
    for (const DxfEntity& entity : entities) std::visit(Printer{drawing[block]}, entity.shape);
  };
  print("", read.entities);
  for (const auto& [name, block] : read.blocks) print(name, block.entities);
  return drawing;
}

TEST(DxfWitness, DxflibReadsTheSameEntitiesOfTheCorpus) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(support::corpus("dxf"))) {
    if (entry.path().extension() != ".dxf") continue;
    EXPECT_EQ(read_here(entry.path()), read_by_dxflib(entry.path())) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 4U);
}

TEST(DxfWitness, DxflibReadsWhatIsPlotted) {
  const support::TemporaryFolder folder;
  const std::string name = folder.name("a.dxf");
  for (const char* program : {"1P.bgt", "5P.bgt", "essi/star.ess", "rows/contour_crc.bgt"}) {
    ASSERT_EQ(support::run_dgt({"plot", support::corpus(program), "-o", name}).exit_code, 0);
    EXPECT_EQ(read_here(name), read_by_dxflib(name)) << program;
  }
}

}  // namespace
}  // namespace dgt
