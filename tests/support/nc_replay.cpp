// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/nc_replay.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

namespace dgt::replay {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

[[noreturn]] void refuse(const std::string& line, const char* why) {
  throw std::runtime_error("block `" + line + "`: " + why);
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  std::string line;
  for (const char c : text) {
    if (c == '\n') {
      lines.push_back(line);
      line.clear();
    } else if (c != '\r') {
      line += c;
    }
  }
  if (!line.empty()) throw std::runtime_error("the last line has no end");
  return lines;
}

double sweep_between(const Spot& c, const Spot& a, const Spot& b, bool ccw) {
  double angle = std::atan2(b.y - c.y, b.x - c.x) - std::atan2(a.y - c.y, a.x - c.x);
  if (!ccw) angle = -angle;
  while (angle <= 0) angle += kTurn;
  while (angle > kTurn) angle -= kTurn;
  return angle;
}

/// The fields of an ESSI block: each a sign and its digits.
std::vector<std::string> signed_fields(const std::string& line) {
  std::vector<std::string> fields;
  for (const char c : line) {
    if (c == '+' || c == '-') {
      fields.emplace_back(1, c);
    } else if (c >= '0' && c <= '9' && !fields.empty()) {
      fields.back() += c;
    } else {
      refuse(line, "not a sign or a digit");
    }
  }
  return fields;
}

std::int64_t value_of(const std::string& field) {
  if (field.size() == 1) return 0;
  if (field[1] == '0') throw std::runtime_error("field " + field + ": zero is a sign alone");
  const std::int64_t v = std::stoll(field.substr(1));
  return field[0] == '-' ? -v : v;
}

void place_centre(Step& s, std::int64_t dx, std::int64_t dy, std::int64_t r, bool large,
                  double unit, const std::string& line) {
  const double chord = std::hypot(static_cast<double>(dx), static_cast<double>(dy));
  if (dx == 0 && dy == 0) refuse(line, "begins and ends in one point");
  const double under = 4.0 * static_cast<double>(r) * static_cast<double>(r) - chord * chord;
  if (under < 0) refuse(line, "chord longer than 2R");
  // Small and counter-clockwise: the centre lies to the left of the chord.
  const double height = std::sqrt(under) / 2 * (s.ccw != large ? 1 : -1) * unit;
  s.centre.x = (s.from.x + s.to.x) / 2 - height * static_cast<double>(dy) / chord;
  s.centre.y = (s.from.y + s.to.y) / 2 + height * static_cast<double>(dx) / chord;
  finish_arc(s);
  if (under == 0) s.sweep = kTurn / 2;
}

}  // namespace

void finish_arc(Step& s) {
  s.radius = std::hypot(s.from.x - s.centre.x, s.from.y - s.centre.y);
  s.mismatch = std::fabs(s.radius - std::hypot(s.to.x - s.centre.x, s.to.y - s.centre.y));
  s.sweep = sweep_between(s.centre, s.from, s.to, s.ccw);
}

Run essi(std::string_view text, double unit, Spot start, EssiArcs arcs) {
  Run run;
  run.end = start;
  bool torch = false;
  for (const std::string& line : lines_of(text)) {
    Step s;
    s.text = line;
    if (line.empty()) refuse(line, "empty");
    if (line[0] != '+' && line[0] != '-') {
      if (line == "53") torch = true;
      if (line == "54") torch = false;
      s.torch = torch;
      s.from = s.to = run.end;
      run.steps.push_back(s);
      continue;
    }
    const auto fields = signed_fields(line);
    if (fields.size() != 2 && fields.size() != 5) refuse(line, "2 or 5 fields");
    const std::int64_t dx = value_of(fields[0]);
    const std::int64_t dy = value_of(fields[1]);
    run.sum_x += dx;
    run.sum_y += dy;
    s.torch = torch;
    s.kind = torch ? Step::Kind::Line : Step::Kind::Rapid;
    s.from = run.end;
    s.to = {start.x + unit * static_cast<double>(run.sum_x),
            start.y + unit * static_cast<double>(run.sum_y)};
    if (fields.size() == 5) {
      if (fields[4].size() != 1) refuse(line, "arc fields");
      s.kind = Step::Kind::Arc;
      if (arcs == EssiArcs::ByCentre) {
        s.ccw = fields[4] == "+";
        s.centre = {s.from.x + unit * static_cast<double>(value_of(fields[2])),
                    s.from.y + unit * static_cast<double>(value_of(fields[3]))};
        finish_arc(s);
      } else {
        if (fields[2][0] != '+' || fields[3].size() != 1) refuse(line, "arc fields");
        s.ccw = fields[4] == "-";
        place_centre(s, dx, dy, value_of(fields[2]), fields[3] == "+", unit, line);
      }
    } else if (dx == 0 && dy == 0) {
      refuse(line, "goes nowhere");
    }
    run.end = s.to;
    run.steps.push_back(s);
  }
  return run;
}

Run gcode(std::string_view text, Spot start) {
  Run run;
  run.end = start;
  bool absolute = true;
  bool torch = false;
  double z = 0;
  int motion = -1;
  for (const std::string& line : lines_of(text)) {
    if (line == "%") continue;
    Step s;
    s.text = line;
    s.from = s.to = run.end;
    std::map<char, double> words;
    int g = -1;
    bool is_placing = false;
    for (std::size_t i = 0; i < line.size();) {
      if (line[i] == ' ') {
        ++i;
        continue;
      }
      std::size_t used = 0;
      const double v = std::stod(line.substr(i + 1), &used);
      if (line[i] == 'G') {
        if (v == 90) absolute = true;
        if (v == 91) absolute = false;
        if (v <= 4) g = static_cast<int>(v);
        if (v <= 3) motion = g;
        is_placing = is_placing || v == 92;
      } else if (line[i] == 'M') {
        if (v == 7 || v == 3 || v == 60) torch = true;
        if (v == 8 || v == 5 || v == 50) torch = false;
      } else {
        words[line[i]] = v;
      }
      i += 1 + used;
    }
    s.torch = torch;
    if (g < 0 && !is_placing && (words.contains('X') || words.contains('Y'))) g = motion;
    const auto word = [&](char c, double otherwise) {
      return words.contains(c) ? words[c] : otherwise;
    };
    if (is_placing) s.to = {word('X', run.end.x), word('Y', run.end.y)};
    if (g >= 0 && g <= 3) {
      s.kind = g == 0 ? Step::Kind::Rapid : g == 1 ? Step::Kind::Line : Step::Kind::Arc;
      s.to = absolute ? Spot{word('X', run.end.x), word('Y', run.end.y)}
                      : Spot{run.end.x + word('X', 0), run.end.y + word('Y', 0)};
      z = absolute ? word('Z', z) : z + word('Z', 0);
      if (g >= 2) {
        if (s.to.x == s.from.x && s.to.y == s.from.y) refuse(line, "a full circle in one block");
        s.ccw = g == 3;
        s.centre = {s.from.x + word('I', 0), s.from.y + word('J', 0)};
        finish_arc(s);
      } else if (words.contains('I') || words.contains('J')) {
        refuse(line, "a centre without an arc");
      }
    }
    s.z = z;
    run.end = s.to;
    run.steps.push_back(s);
  }
  return run;
}

std::vector<Spot> samples(const Step& step, int count) {
  std::vector<Spot> points;
  const double r2 = std::hypot(step.to.x - step.centre.x, step.to.y - step.centre.y);
  const double begin = std::atan2(step.from.y - step.centre.y, step.from.x - step.centre.x);
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    if (step.kind == Step::Kind::Arc) {
      const double angle = begin + (step.ccw ? t : -t) * step.sweep;
      const double r = step.radius + t * (r2 - step.radius);
      points.push_back({step.centre.x + r * std::cos(angle), step.centre.y + r * std::sin(angle)});
    } else {
      points.push_back({step.from.x + t * (step.to.x - step.from.x),
                        step.from.y + t * (step.to.y - step.from.y)});
    }
  }
  return points;
}

double distance(const Spot& p, const Step& step) {
  const double to_ends = std::min(std::hypot(p.x - step.from.x, p.y - step.from.y),
                                  std::hypot(p.x - step.to.x, p.y - step.to.y));
  if (step.kind == Step::Kind::Arc) {
    if (sweep_between(step.centre, step.from, p, step.ccw) > step.sweep) return to_ends;
    const double r =
        (step.radius + std::hypot(step.to.x - step.centre.x, step.to.y - step.centre.y)) / 2;
    return std::min(to_ends, std::fabs(std::hypot(p.x - step.centre.x, p.y - step.centre.y) - r));
  }
  const double dx = step.to.x - step.from.x;
  const double dy = step.to.y - step.from.y;
  const double square = dx * dx + dy * dy;
  if (square == 0) return to_ends;
  const double t = ((p.x - step.from.x) * dx + (p.y - step.from.y) * dy) / square;
  if (t <= 0 || t >= 1) return to_ends;
  return std::hypot(step.from.x + t * dx - p.x, step.from.y + t * dy - p.y);
}

}  // namespace dgt::replay
