// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/move_json.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "post/figures.h"

namespace dgt {
namespace {

std::string quoted(const std::string& text) {
  using Json = nlohmann::json;  // names of files may hold anything
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

MoveJson::MoveJson(const std::vector<std::string>& files) {
  for (const std::string& file : files) quoted_files_.push_back(quoted(file));
}

void MoveJson::number(double value) {
  const std::size_t begin = out.size();
  append_number(out, value);
  if (out.find_first_of(".e", begin) == std::string::npos) out += ".0";
}

void MoveJson::point(double x, double y) {
  out += '[';
  number(x);
  out += ", ";
  number(y);
  out += ']';
}

void MoveJson::point(const char* key, const Point& p) {
  out += key;
  point(p.x(), p.y());
}

void MoveJson::value(const char* key, const RationalPtr& v) {
  if (!v) return;
  out += key;
  number(coordinate(*v));
}

void MoveJson::moves(std::span<const Move> list) {
  out += '[';
  for (std::size_t i = 0; i < list.size(); ++i) {
    out += i == 0 ? "\n    " : ",\n    ";
    move(list[i]);
  }
  out += ']';
}

void MoveJson::move(const Move& m) {
  fmt::format_to(std::back_inserter(out), "{{\"kind\": \"{}\"", name_of(m.kind));
  point(", \"from\": ", m.from);
  point(", \"to\": ", m.to);
  value(", \"z\": ", m.z);
  if (m.kind == MoveKind::Arc) arc(m);
  value(", \"seconds\": ", m.seconds);
  if (!m.code.empty()) out += ", \"code\": " + quoted(m.code);
  value(", \"feed\": ", m.feed);
  fmt::format_to(std::back_inserter(out), ", \"role\": \"{}\"", name_of(m.role));
  source(m.source);
  out += '}';
}

void MoveJson::arc(const Move& m) {
  const ArcFigures circle = figures(m);
  out += ", \"center\": ";
  point(circle.centre_x, circle.centre_y);
  out += ", \"radius\": ";
  number(circle.radius);
  fmt::format_to(std::back_inserter(out), ", \"ccw\": {}, \"sweep\": ", circle.counter_clockwise);
  number(sweep_degrees(m));
}

void MoveJson::source(const SourcePlace& place) {
  if (place.line == 0) return;
  fmt::format_to(std::back_inserter(out),
                 ", \"source\": {{\"file\": {}, \"line\": {}, \"column\": {}}}",
                 quoted_files_.at(place.file), place.line, place.column);
}

}  // namespace dgt
