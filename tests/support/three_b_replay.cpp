// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "tests/support/nc_replay.h"

namespace dgt::replay {
namespace {

struct Words {
  std::int64_t x = 0, y = 0, count = 0;
  bool along_x = false;
  std::string kind;  ///< L, SR, NR
  int quadrant = 0;
};

[[noreturn]] void refuse(const std::string& line, const char* why) {
  throw std::runtime_error("block `" + line + "`: " + why);
}

Words words_of(const std::string& line) {
  Words w;
  std::istringstream in(line);
  char b = 0, g = 0, axis = 0;
  for (std::int64_t* value : {&w.x, &w.y, &w.count}) {
    if (!(in >> b >> *value) || b != 'B' || *value < 0) refuse(line, "not B and a number");
  }
  std::string rest;
  if (!(in >> g >> axis >> rest) || g != 'G' || (axis != 'X' && axis != 'Y'))
    refuse(line, "no axis");
  w.along_x = axis == 'X';
  w.quadrant = rest.back() - '0';
  w.kind = rest.substr(0, rest.size() - 1);
  if (w.quadrant < 1 || w.quadrant > 4) refuse(line, "no quadrant");
  if (w.kind != "L" && w.kind != "SR" && w.kind != "NR") refuse(line, "neither line nor arc");
  return w;
}

struct Cell {
  std::int64_t x, y;
};
Cell signs_of(int quadrant) {
  return {quadrant == 1 || quadrant == 4 ? 1 : -1, quadrant <= 2 ? 1 : -1};
}

/// Quadrant by quadrant, until the count is used up: where the arc ends, seen from its centre.
Cell end_of_arc(const Words& w, const std::string& line) {
  const double square = static_cast<double>(w.x) * static_cast<double>(w.x) +
                        static_cast<double>(w.y) * static_cast<double>(w.y);
  const auto extreme = static_cast<std::int64_t>(std::llround(std::sqrt(square)));
  int quadrant = w.quadrant;
  std::int64_t along = (w.along_x ? w.x * signs_of(quadrant).x : w.y * signs_of(quadrant).y);
  std::int64_t left = w.count;
  for (int turns = 0; turns < 9; ++turns) {
    const Cell sign = signs_of(quadrant);
    const bool ccw = w.kind == "NR";
    // Counter-clockwise x falls where y is positive, and y rises where x is.
    const std::int64_t step = w.along_x ? (ccw ? -sign.y : sign.y) : (ccw ? sign.x : -sign.x);
    const std::int64_t side = w.along_x ? sign.x : sign.y;
    const std::int64_t border = step == side ? side * extreme : 0;
    const std::int64_t room = (border - along) * step;
    if (room < 0) refuse(line, "begins in another quadrant");
    if (left <= room) {
      along += step * left;
      const auto other = static_cast<std::int64_t>(std::llround(std::sqrt(
          std::max(0.0, square - static_cast<double>(along) * static_cast<double>(along)))));
      return w.along_x ? Cell{along, other * sign.y} : Cell{other * sign.x, along};
    }
    left -= room;
    along = border;
    quadrant = ccw ? quadrant % 4 + 1 : (quadrant + 2) % 4 + 1;
  }
  refuse(line, "counts more than two turns");
}

}  // namespace

Run three_b(std::string_view text, double unit, Spot start) {
  Run run;
  run.end = start;
  bool is_out = false;
  std::istringstream in{std::string(text)};
  for (std::string line; std::getline(in, line);) {
    Step s;
    s.text = line;
    s.from = s.to = run.end;
    if (line == "D" || line == "DD") {
      if (line == "D") is_out = !is_out;
      run.steps.push_back(s);
      continue;
    }
    const Words w = words_of(line);
    const Cell sign = signs_of(w.quadrant);
    Cell way{};
    if (w.kind == "L") {
      if (w.count != (w.along_x ? w.x : w.y)) refuse(line, "counts another length");
      if ((w.along_x ? w.y : w.x) > w.count) refuse(line, "counts along the shorter side");
      if (w.count == 0) refuse(line, "goes nowhere");
      way = {w.x * sign.x, w.y * sign.y};
      s.kind = is_out ? Step::Kind::Rapid : Step::Kind::Line;
    } else {
      const Cell begin{w.x * sign.x, w.y * sign.y};
      const Cell end = end_of_arc(w, line);
      way = {end.x - begin.x, end.y - begin.y};
      s.kind = Step::Kind::Arc;
      s.ccw = w.kind == "NR";
      s.centre = {s.from.x - unit * static_cast<double>(begin.x),
                  s.from.y - unit * static_cast<double>(begin.y)};
    }
    run.sum_x += way.x;
    run.sum_y += way.y;
    s.torch = !is_out;
    s.to = {start.x + unit * static_cast<double>(run.sum_x),
            start.y + unit * static_cast<double>(run.sum_y)};
    if (s.kind == Step::Kind::Arc) finish_arc(s);
    run.end = s.to;
    run.steps.push_back(s);
  }
  return run;
}

}  // namespace dgt::replay
