// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/path_json.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "post/figures.h"

namespace dgt {
namespace {

// Written straight into the text: a path of 10⁵ moves as a tree of JSON values would take twenty
// times its memory.
class PathPrinter {
 public:
  explicit PathPrinter(const Toolpath& path) : path_(path) {
    for (const std::string& file : path.files) quoted_files_.push_back(quoted(file));
  }

  std::string print() {
    out_ = "{\"schema\": \"dgt-path/1\", \"units\": \"mm\",\n \"start\": ";
    point(coordinate(path_.start.x), coordinate(path_.start.y));
    out_ += ",\n \"contours\": [";
    for (std::size_t i = 0; i < path_.contours.size(); ++i) {
      out_ += i == 0 ? "\n" : ",\n";
      contour(path_.contours[i]);
    }
    out_ += "],\n \"moves\": ";
    moves(path_.moves);
    const Lengths sums = lengths(path_.moves);
    out_ += ",\n \"length\": {\"cut\": ";
    number(sums.cut);
    out_ += ", \"rapid\": ";
    number(sums.rapid);
    out_ += "}}\n";
    return std::move(out_);
  }

 private:
  static std::string quoted(const std::string& text) {
    using Json = nlohmann::json;  // names of files may hold anything
    return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  // With a point or an exponent, so that readers that tell the two apart see no whole numbers.
  void number(double value) {
    const std::size_t begin = out_.size();
    append_number(out_, value);
    if (out_.find_first_of(".e", begin) == std::string::npos) out_ += ".0";
  }
  void point(double x, double y) {
    out_ += '[';
    number(x);
    out_ += ", ";
    number(y);
    out_ += ']';
  }
  void point(const char* key, const Point& p) {
    out_ += key;
    point(p.x(), p.y());
  }
  void value(const char* key, const RationalPtr& v) {
    if (!v) return;
    out_ += key;
    number(coordinate(*v));
  }

  void contour(const Contour& c) {
    fmt::format_to(std::back_inserter(out_), "  {{\"id\": {}, \"offset\": ", c.id);
    number(coordinate(c.offset));
    fmt::format_to(std::back_inserter(out_), ", \"side\": \"{}\", \"closed\": {},\n",
                   name_of(c.side), c.closed);
    out_ += "   \"programmed\": ";
    moves(c.programmed);
    out_ += ",\n   \"moves\": ";
    moves(std::span(path_.moves).subspan(c.first, c.last - c.first));
    out_ += '}';
  }

  void moves(std::span<const Move> list) {
    out_ += '[';
    for (std::size_t i = 0; i < list.size(); ++i) {
      out_ += i == 0 ? "\n    " : ",\n    ";
      move(list[i]);
    }
    out_ += ']';
  }

  void move(const Move& m) {
    fmt::format_to(std::back_inserter(out_), "{{\"kind\": \"{}\"", name_of(m.kind));
    point(", \"from\": ", m.from);
    point(", \"to\": ", m.to);
    value(", \"z\": ", m.z);
    if (m.kind == MoveKind::Arc) arc(m);
    value(", \"seconds\": ", m.seconds);
    if (!m.code.empty()) out_ += ", \"code\": " + quoted(m.code);
    value(", \"feed\": ", m.feed);
    fmt::format_to(std::back_inserter(out_), ", \"role\": \"{}\"", name_of(m.role));
    source(m.source);
    out_ += '}';
  }

  void arc(const Move& m) {
    const ArcFigures circle = figures(m);
    out_ += ", \"center\": ";
    point(circle.centre_x, circle.centre_y);
    out_ += ", \"radius\": ";
    number(circle.radius);
    fmt::format_to(std::back_inserter(out_),
                   ", \"ccw\": {}, \"sweep\": ", circle.counter_clockwise);
    number(sweep_degrees(m));
  }

  void source(const SourcePlace& place) {
    if (place.line == 0) return;
    fmt::format_to(std::back_inserter(out_),
                   ", \"source\": {{\"file\": {}, \"line\": {}, \"column\": {}}}",
                   quoted_files_.at(place.file), place.line, place.column);
  }

  const Toolpath& path_;
  std::vector<std::string> quoted_files_;
  std::string out_;
};

}  // namespace

std::string to_json(const Toolpath& path) { return PathPrinter(path).print(); }

}  // namespace dgt
