// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/svg.h"

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>

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

struct Pen {
  std::string_view name;
  const std::string& colour;
  double width;     ///< pixels
  double dash = 0;  ///< pixels; 0: drawn through
};

void add(Box& box, const Box& other) {
  if (other.empty()) return;
  box.add(other.left, other.bottom);
  box.add(other.right, other.top);
}

/// Points and axes are on the sheet; of lines the foot of the normal from the origin, and circles,
/// when there is no path to show.
void add(Box& box, const NamedShape& named, bool alone) {
  if (const auto* spot = std::get_if<NamedSpot>(&named.shape)) box.add(spot->x, spot->y);
  if (const auto* axes = std::get_if<NamedAxes>(&named.shape)) box.add(axes->x, axes->y);
  if (!alone) return;
  if (const auto* line = std::get_if<Line>(&named.shape)) {
    const double p = nearest_double(line->p());
    box.add(-p * nearest_double(line->direction().y()), p * nearest_double(line->direction().x()));
  }
  const auto* circle = std::get_if<Circle>(&named.shape);
  if (circle == nullptr) return;
  const double x = coordinate(circle->centre().x);
  const double y = coordinate(circle->centre().y);
  const double radius = nearest_double(abs(circle->radius()));
  box.add(x - radius, y - radius);
  box.add(x + radius, y + radius);
}

/// What the drawing covers, and how many mm a pixel of it is.
Sheet sheet_of(const Toolpath& path, const DrawingStyle& style, std::span<const NamedShape> named) {
  Box box = box_of(path.moves);
  box.add(coordinate(path.start.x), coordinate(path.start.y));
  for (const Contour& contour : path.contours) add(box, box_of(programmed_moves(path, contour)));
  for (const NamedShape& shape : named) add(box, shape, path.moves.empty());
  constexpr double kLeastSide = 1;  // mm: a path that goes nowhere still has a sheet
  const double share = named.empty() ? style.margin : style.margin_named;
  const double margin = share * std::max({box.width(), box.height(), kLeastSide});
  const double wide = box.width() + 2 * margin;
  const double high = box.height() + 2 * margin;
  const double width = std::max(wide, style.aspect * high);
  const double height = style.aspect > 0 ? width / style.aspect : high;
  return {box.left - margin - (width - wide) / 2, box.top + margin + (height - high) / 2, width,
          height, std::max(width, height) / style.size};
}

void append_attribute(std::string& out, std::string_view name, double value) {
  out.append(" ").append(name).append("=\"");
  append_number(out, value);
  out.append("\"");
}

/// The text of an SVG file as it grows.
class Drawing {
 public:
  Drawing(const Sheet& sheet, const DrawingStyle& style) : sheet_(sheet), style_(style) {
    out_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    out_ += "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\"";
    const double longer = std::max(sheet.width, sheet.height);
    append_attribute(out_, "width", style.size * (sheet.width / longer));
    append_attribute(out_, "height", style.size * (sheet.height / longer));
    out_ += " viewBox=\"";
    for (const double value : {sheet.left, -sheet.top, sheet.width}) {
      append_number(out_, value);
      out_ += ' ';
    }
    append_number(out_, sheet.height);
    out_ += "\">\n";
  }

  /// Strokes have their width in mm, for viewers that know nothing better; the others keep it in
  /// pixels at any scale.
  void rule(std::initializer_list<Pen> pens) {
    out_ += "<style>\n@supports (vector-effect: non-scaling-stroke) {\n";
    out_ += "  path { vector-effect: non-scaling-stroke; }\n";
    for (const Pen& pen : pens) {
      out_.append("  .").append(pen.name).append(" { stroke-width: ");
      append_number(out_, pen.width);
      if (pen.dash > 0) {
        out_ += "px; stroke-dasharray: ";
        append_number(out_, pen.dash);
      }
      out_ += "px; }\n";
    }
    out_ += "}\n</style>\n<rect";
    append_attribute(out_, "x", sheet_.left);
    append_attribute(out_, "y", -sheet_.top);
    append_attribute(out_, "width", sheet_.width);
    append_attribute(out_, "height", sheet_.height);
    out_.append(" fill=\"").append(style_.background).append("\"/>\n");
    out_ += "<g transform=\"scale(1,-1)\" fill=\"none\" stroke-linecap=\"round\"";
    out_ += " stroke-linejoin=\"round\">\n";
  }

  void open(const Pen& pen) {
    out_.append("  <g class=\"").append(pen.name).append("\" stroke=\"").append(pen.colour);
    out_ += '"';
    append_attribute(out_, "stroke-width", pen.width * sheet_.pixel);
    if (pen.dash > 0) append_attribute(out_, "stroke-dasharray", pen.dash * sheet_.pixel);
    out_ += ">\n";
  }
  void path(const std::string& data) {
    if (!data.empty()) out_.append("    <path d=\"").append(data).append("\"/>\n");
  }
  void close() { out_ += "  </g>\n"; }
  void group(const Pen& pen, const std::string& data) {
    open(pen);
    path(data);
    close();
  }

  /// Upright, with a rim in the colour of the sheet so that strokes beneath do not disturb.
  void write(const std::vector<PlacedName>& names) {
    const double height = style_.letters_height * sheet_.pixel;
    out_.append("  <g class=\"names\" transform=\"scale(1,-1)\" text-anchor=\"middle\"");
    out_.append(" font-family=\"sans-serif\" paint-order=\"stroke\" fill=\"");
    out_.append(style_.letters).append("\" stroke=\"").append(style_.background).append("\"");
    append_attribute(out_, "font-size", height);
    append_attribute(out_, "stroke-width", height / 4);
    out_ += ">\n";
    for (const PlacedName& name : names) {
      out_ += "    <text";
      append_attribute(out_, "x", name.x);
      append_attribute(out_, "y", -name.y);
      out_.append(">").append(name.text).append("</text>\n");
    }
    close();
  }

  [[nodiscard]] std::string finish() {
    out_ += "</g>\n</svg>\n";
    return std::move(out_);
  }

 private:
  const Sheet& sheet_;
  const DrawingStyle& style_;
  std::string out_;
};

void draw_programmed(Drawing& drawing, const Toolpath& path) {
  for (const Contour& contour : path.contours) {
    drawing.path(path_data(programmed_moves(path, contour), is_cut));
  }
}

/// One path a contour, and one for what is cut between two contours.
void draw_equidistant(Drawing& drawing, const Toolpath& path) {
  const std::span<const Move> moves = path.moves;
  std::size_t at = 0;
  for (const Contour& contour : path.contours) {
    drawing.path(path_data(moves.subspan(at, contour.first - at), is_cut));
    drawing.path(path_data(moves_of(path, contour), is_cut));
    at = contour.last;
  }
  drawing.path(path_data(moves.subspan(at), is_cut));
}

/// A stroke without length and with round ends: a dot of the same size at any scale.
std::string start_data(const Toolpath& path) {
  std::string data = "M";
  append_number(data, coordinate(path.start.x));
  data += ' ';
  append_number(data, coordinate(path.start.y));
  return data + " h0";
}

}  // namespace

std::string draw_svg(const Toolpath& path, const DrawingStyle& style,
                     std::span<const NamedShape> named) {
  const Pen element{"element", style.named, style.named_width};
  const Pen arrow{"arrow", style.letters, style.arrow_width};
  const Pen head{"head", style.equidistant, style.arrow_width};
  const Pen dot{"dot", style.letters, style.dot_width};
  const Pen programmed{"programmed", style.programmed, style.programmed_width};
  const Pen equidistant{"equidistant", style.equidistant, style.equidistant_width};
  const Pen rapid{"rapid", style.rapid, style.rapid_width, style.rapid_dash};
  const Pen start{"start", style.start, style.start_width};
  const Sheet sheet = sheet_of(path, style, named);
  Drawing drawing(sheet, style);
  NamesLayout names;
  if (named.empty()) {
    drawing.rule({programmed, equidistant, rapid, start});
  } else {
    names = lay_out_names(named, path, sheet, style.letters_height * sheet.pixel);
    drawing.rule({element, arrow, head, dot, programmed, equidistant, rapid, start});
    drawing.group(element, names.elements);
    if (!names.lit.empty()) drawing.group(programmed, names.lit);
  }
  drawing.open(programmed);
  draw_programmed(drawing, path);
  drawing.close();
  drawing.open(equidistant);
  draw_equidistant(drawing, path);
  drawing.close();
  drawing.group(rapid, path_data(path.moves, is_rapid));
  const bool is_alone = !named.empty() && path.moves.empty();
  if (!is_alone) drawing.group(start, start_data(path));
  if (!named.empty()) {
    drawing.group(head, names.heads);
    drawing.group(arrow, names.arrows);
    drawing.group(dot, names.dots);
    if (!names.lit_dots.empty()) {
      drawing.group({"start", style.programmed, style.start_width}, names.lit_dots);
    }
    drawing.write(names.names);
  }
  return drawing.finish();
}

}  // namespace dgt
