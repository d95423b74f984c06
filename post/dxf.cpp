// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/dxf.h"

#include <cmath>
#include <numbers>
#include <span>
#include <string_view>

#include "post/figures.h"

namespace dgt {
namespace {

struct Layer {
  std::string_view name;
  int colour = 7;  ///< of the AutoCAD colour index
  std::string_view line = "CONTINUOUS";
};
constexpr Layer kContour{"CONTOUR", 3};
constexpr Layer kEquidistant{"EQUIDISTANT", 2};
constexpr Layer kRapids{"RAPIDS", 8, "DASHED"};

/// The text of a DXF file as it grows: pairs of a group code and a value, a line each.
class Groups {
 public:
  void add(int code, std::string_view value) {
    out_.append(std::to_string(code)).append("\n").append(value).append("\n");
  }
  void add(int code, int value) { add(code, std::to_string(value)); }
  void add(int code, double value) {
    out_.append(std::to_string(code)).append("\n");
    const std::size_t begin = out_.size();
    append_number(out_, value);
    if (out_.find_first_of(".e", begin) == std::string::npos) out_ += ".0";
    out_ += '\n';
  }
  void place(double x, double y, int first_code = 10) {
    add(first_code, x);
    add(first_code + 10, y);
    add(first_code + 20, 0.0);
  }
  [[nodiscard]] std::string finish() { return std::move(out_); }

 private:
  std::string out_;
};

double degrees(const ArcFigures& circle, const Point& p) {
  const double angle =
      std::atan2(p.y() - circle.centre_y, p.x() - circle.centre_x) * 180 / std::numbers::pi;
  return angle < 0 ? angle + 360 : angle;
}

class DxfDrawing {
 public:
  std::string run(const Toolpath& path) {
    groups_.add(999, "dgt plot");
    header(path);
    tables();
    section("ENTITIES");
    for (const Contour& contour : path.contours)
      draw(programmed_moves(path, contour), MoveKind::Line, kContour);
    draw(path.moves, MoveKind::Line, kEquidistant);
    draw(path.moves, MoveKind::Rapid, kRapids);
    groups_.add(0, "ENDSEC");
    groups_.add(0, "EOF");
    return groups_.finish();
  }

 private:
  void section(std::string_view name) {
    groups_.add(0, "SECTION");
    groups_.add(2, name);
  }

  void header(const Toolpath& path) {
    section("HEADER");
    groups_.add(9, "$ACADVER");
    groups_.add(1, "AC1009");
    groups_.add(9, "$INSUNITS");
    groups_.add(70, 4);  // millimetres
    const Box box = box_of(path.moves);
    if (!box.empty()) {
      groups_.add(9, "$EXTMIN");
      groups_.place(box.left, box.bottom);
      groups_.add(9, "$EXTMAX");
      groups_.place(box.right, box.top);
    }
    groups_.add(0, "ENDSEC");
  }

  void tables() {
    section("TABLES");
    groups_.add(0, "TABLE");
    groups_.add(2, "LTYPE");
    groups_.add(70, 2);
    line_type("CONTINUOUS", "Solid", 0);
    line_type("DASHED", "Dashed", 2);
    groups_.add(0, "ENDTAB");
    groups_.add(0, "TABLE");
    groups_.add(2, "LAYER");
    groups_.add(70, 3);
    for (const Layer& layer : {kContour, kEquidistant, kRapids}) {
      groups_.add(0, "LAYER");
      groups_.add(2, layer.name);
      groups_.add(70, 0);
      groups_.add(62, layer.colour);
      groups_.add(6, layer.line);
    }
    groups_.add(0, "ENDTAB");
    groups_.add(0, "ENDSEC");
  }

  /// `dash`: mm, as long as the gap behind it; 0: none.
  void line_type(std::string_view name, std::string_view about, double dash) {
    groups_.add(0, "LTYPE");
    groups_.add(2, name);
    groups_.add(70, 0);
    groups_.add(3, about);
    groups_.add(72, 65);
    groups_.add(73, dash > 0 ? 2 : 0);
    groups_.add(40, 2 * dash);
    if (dash <= 0) return;
    groups_.add(49, dash);
    groups_.add(49, -dash);
  }

  /// The cuts or the rapids.
  void draw(std::span<const Move> moves, MoveKind kind, const Layer& layer) {
    for (const Move& move : moves) {
      if (kind == MoveKind::Rapid ? move.kind != kind : !move.cuts()) continue;
      move.kind == MoveKind::Arc ? arc(move, layer) : line(move, layer);
    }
  }

  void begin(std::string_view entity, const Layer& layer) {
    groups_.add(0, entity);
    groups_.add(8, layer.name);
  }

  void line(const Move& move, const Layer& layer) {
    if (move.from == move.to) return;  // a change of height
    begin("LINE", layer);
    groups_.place(move.from.x(), move.from.y());
    groups_.place(move.to.x(), move.to.y(), 11);
  }

  void arc(const Move& move, const Layer& layer) {
    const ArcFigures circle = figures(move);
    begin(move.full_circle ? "CIRCLE" : "ARC", layer);
    groups_.place(circle.centre_x, circle.centre_y);
    groups_.add(40, circle.radius);
    if (move.full_circle) return;
    const bool ccw = circle.counter_clockwise;
    groups_.add(50, degrees(circle, ccw ? move.from : move.to));
    groups_.add(51, degrees(circle, ccw ? move.to : move.from));
  }

  Groups groups_;
};

}  // namespace

std::string draw_dxf(const Toolpath& path) { return DxfDrawing().run(path); }

}  // namespace dgt
