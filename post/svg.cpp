// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/svg.h"

#include <span>
#include <string_view>

#include "post/figures.h"

namespace dgt {
namespace {

/// Data of one `d` attribute: a pen that goes on where it stands and jumps where it must.
class PathData {
 public:
  void draw(const Move& move) {
    if (!drawing_) begin(move.from.x(), move.from.y());
    move.kind == MoveKind::Arc ? arc(move) : line_to(move.to.x(), move.to.y());
  }
  void lift() { drawing_ = false; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void command(char letter) {
    if (!text_.empty()) text_ += letter == 'M' ? '\n' : ' ';
    text_ += letter;
  }
  void point(double x, double y) {
    append_number(text_, x);
    text_ += ' ';
    append_number(text_, y);
  }
  void begin(double x, double y) {
    command('M');
    point(x, y);
    drawing_ = true;
  }
  void line_to(double x, double y) {
    command('L');
    point(x, y);
  }
  void arc_to(double radius, bool large, bool counter_clockwise, double x, double y) {
    command('A');
    point(radius, radius);
    text_ += large ? " 0 1 " : " 0 0 ";
    // The drawing stands in a frame with y up, where a positive angle is counter-clockwise.
    text_ += counter_clockwise ? "1 " : "0 ";
    point(x, y);
  }
  void arc(const Move& move) {
    const ArcFigures circle = figures(move);
    const double x = move.to.x();
    const double y = move.to.y();
    if (move.full_circle) {
      arc_to(circle.radius, false, circle.counter_clockwise, 2 * circle.centre_x - x,
             2 * circle.centre_y - y);
      arc_to(circle.radius, false, circle.counter_clockwise, x, y);
    } else {
      arc_to(circle.radius, half_turn_order(move) > 0, circle.counter_clockwise, x, y);
    }
  }

  std::string text_;
  bool drawing_ = false;
};

using Wanted = bool (*)(const Move&);
bool is_cut(const Move& move) { return move.cuts(); }
bool is_rapid(const Move& move) { return move.kind == MoveKind::Rapid; }

std::string path_data(std::span<const Move> moves, Wanted wanted) {
  PathData data;
  for (const Move& move : moves) {
    if (wanted(move)) {
      data.draw(move);
    } else if (move.travels()) {
      data.lift();
    }
  }
  return data.text();
}

void append_path(std::string& out, const std::string& data) {
  if (!data.empty()) out.append("    <path d=\"").append(data).append("\"/>\n");
}

struct Pen {
  std::string_view name;
  const std::string& colour;
  double width;
  std::string_view dashes = "";
};

void open_group(std::string& out, const Pen& pen) {
  out.append("  <g class=\"").append(pen.name).append("\" stroke=\"").append(pen.colour);
  out.append("\" stroke-width=\"");
  append_number(out, pen.width);
  out.append("\"");
  if (!pen.dashes.empty()) out.append(" stroke-dasharray=\"").append(pen.dashes).append("\"");
  out.append(">\n");
}

void append_attribute(std::string& out, std::string_view name, double value) {
  out.append(" ").append(name).append("=\"");
  append_number(out, value);
  out.append("\"");
}

void append_head(std::string& out, const Box& box, const DrawingStyle& style) {
  constexpr double kLeastSide = 1;  // mm: a path that goes nowhere still has a sheet
  const double longer = std::max({box.width(), box.height(), kLeastSide});
  const double margin = style.margin * longer;
  const double width = box.width() + 2 * margin;
  const double height = box.height() + 2 * margin;
  const double scale = style.size / std::max(width, height);
  out.append("<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\"");
  append_attribute(out, "width", width * scale);
  append_attribute(out, "height", height * scale);
  const double left = box.left - margin;
  const double upper = -box.top - margin;
  out.append(" viewBox=\"");
  for (const double value : {left, upper, width}) {
    append_number(out, value);
    out += ' ';
  }
  append_number(out, height);
  out.append("\">\n<rect");
  append_attribute(out, "x", left);
  append_attribute(out, "y", upper);
  append_attribute(out, "width", width);
  append_attribute(out, "height", height);
  out.append(" fill=\"").append(style.background).append("\"/>\n");
  out.append(
      "<style>path { vector-effect: non-scaling-stroke; fill: none; stroke-linecap: round; "
      "stroke-linejoin: round; }</style>\n<g transform=\"scale(1,-1)\">\n");
}

void append_programmed(std::string& out, const Toolpath& path, const DrawingStyle& style) {
  open_group(out, {"programmed", style.programmed, style.programmed_width});
  for (const Contour& contour : path.contours) {
    append_path(out, path_data(contour.programmed, is_cut));
  }
  out.append("  </g>\n");
}

/// One path a contour, and one for what is cut between two contours.
void append_equidistant(std::string& out, const Toolpath& path, const DrawingStyle& style) {
  const std::span<const Move> moves = path.moves;
  open_group(out, {"equidistant", style.equidistant, style.equidistant_width});
  std::size_t at = 0;
  for (const Contour& contour : path.contours) {
    append_path(out, path_data(moves.subspan(at, contour.first - at), is_cut));
    append_path(out, path_data(moves.subspan(contour.first, contour.last - contour.first), is_cut));
    at = contour.last;
  }
  append_path(out, path_data(moves.subspan(at), is_cut));
  out.append("  </g>\n");
}

void append_rapids(std::string& out, const Toolpath& path, const DrawingStyle& style) {
  open_group(out, {"rapid", style.rapid, style.rapid_width, "6 5"});
  append_path(out, path_data(path.moves, is_rapid));
  out.append("  </g>\n");
}

/// A stroke without length and with round ends: a dot of the same size at any scale.
void append_start(std::string& out, const Toolpath& path, const DrawingStyle& style) {
  constexpr double kDot = 8;
  open_group(out, {"start", style.start, kDot});
  std::string data = "M";
  append_number(data, coordinate(path.start.x));
  data += ' ';
  append_number(data, coordinate(path.start.y));
  append_path(out, data + " h0");
  out.append("  </g>\n");
}

Box sheet(const Toolpath& path) {
  Box box = box_of(path.moves);
  const auto add = [&box](const Box& other) {
    if (other.empty()) return;
    box.add(other.left, other.bottom);
    box.add(other.right, other.top);
  };
  box.add(coordinate(path.start.x), coordinate(path.start.y));
  for (const Contour& contour : path.contours) add(box_of(contour.programmed));
  return box;
}

}  // namespace

std::string draw_svg(const Toolpath& path, const DrawingStyle& style) {
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  append_head(out, sheet(path), style);
  append_programmed(out, path, style);
  append_equidistant(out, path, style);
  append_rapids(out, path, style);
  append_start(out, path, style);
  out.append("</g>\n</svg>\n");
  return out;
}

}  // namespace dgt
