// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/path_json.h"

#include <fmt/format.h>

#include <iterator>
#include <span>

#include "apps/driver/move_json.h"
#include "post/figures.h"

namespace dgt {
namespace {

void append_contour(MoveJson& json, const Toolpath& path, const Contour& contour) {
  fmt::format_to(std::back_inserter(json.out), "  {{\"id\": {}, \"offset\": ", contour.id);
  json.number(coordinate(contour.offset));
  fmt::format_to(std::back_inserter(json.out), ", \"side\": \"{}\", \"closed\": {},\n",
                 name_of(contour.side), contour.closed);
  json.out += "   \"programmed\": ";
  json.moves(programmed_moves(path, contour));
  json.out += ",\n   \"moves\": ";
  json.moves(moves_of(path, contour));
  json.out += '}';
}

}  // namespace

std::string to_json(const Toolpath& path) {
  MoveJson json(path.files);
  json.out = "{\"schema\": \"dgt-path/1\", \"units\": \"mm\",\n \"start\": ";
  json.point(coordinate(path.start.x), coordinate(path.start.y));
  json.out += ",\n \"contours\": [";
  for (std::size_t i = 0; i < path.contours.size(); ++i) {
    const Contour& contour = path.contours[i];
    json.out += i == 0 ? "\n" : ",\n";
    append_contour(json, path, contour);
  }
  json.out += "],\n \"moves\": ";
  json.moves(path.moves);
  const Lengths sums = lengths(path.moves);
  json.out += ",\n \"length\": {\"cut\": ";
  json.number(sums.cut);
  json.out += ", \"rapid\": ";
  json.number(sums.rapid);
  json.out += "}}\n";
  return std::move(json.out);
}

}  // namespace dgt
