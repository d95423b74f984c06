// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/figures.h"

#include <array>
#include <charconv>
#include <cmath>

namespace dgt {
namespace {

constexpr int kSectors = 8;

int order(double a, double b) { return (a > b) - (a < b); }

/// Where a point of a circle lies seen from the centre, counter-clockwise: 0 at +X, 1 in the first
/// quadrant, 2 at +Y and so on. Rounding keeps order, so different doubles decide rightly; equal
/// ones put a point at the end of an axis that is less than an ulp beside it.
int sector_of(const ArcFigures& arc, const Point& point) {
  constexpr std::array<std::array<int, 3>, 3> kSectorOf = {{{5, 4, 3}, {6, 0, 2}, {7, 0, 1}}};
  const int dx = order(point.x(), arc.centre_x);
  const int dy = order(point.y(), arc.centre_y);
  return kSectorOf.at(static_cast<std::size_t>(dx + 1)).at(static_cast<std::size_t>(dy + 1));
}

/// How many sectors the arc goes on from the one it begins in.
int sectors_passed(const Move& move, int first, int last) {
  const int passed = ((last - first) % kSectors + kSectors) % kSectors;
  if (passed > 0) return passed;
  return move.full_circle || half_turn_order(move) > 0 ? kSectors : 0;
}

void add_extremes(Box& box, const Move& move) {
  constexpr std::array<std::array<int, 2>, 4> kAxes = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  const ArcFigures arc = figures(move);
  const bool forward = arc.counter_clockwise;
  const int first = sector_of(arc, forward ? move.from : move.to);
  const int last = sector_of(arc, forward ? move.to : move.from);
  const int passed = sectors_passed(move, first, last);
  for (int i = first + 1; i < first + passed || (passed == kSectors && i <= first + passed); ++i) {
    if (i % 2 != 0) continue;
    const auto [x, y] = kAxes.at(static_cast<std::size_t>(i % kSectors / 2));
    box.add(arc.centre_x + x * arc.radius, arc.centre_y + y * arc.radius);
  }
}

}  // namespace

double coordinate(const Rational& value) {
  const double nearest = nearest_double(value);
  return std::abs(nearest) <= std::ldexp(1.0, kZeroExponent) ? 0.0 : nearest;
}

ArcFigures figures(const Move& arc) {
  const Circle circle = arc.circle();
  return {coordinate(circle.centre().x), coordinate(circle.centre().y),
          nearest_double(abs(circle.radius())), circle.counter_clockwise()};
}

void append_number(std::string& out, double value) {
  std::array<char, 32> buffer{};
  const double shown = value == 0 ? 0.0 : value;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), shown).ptr;
  out.append(buffer.data(), end);
}

Box box_of(std::span<const Move> moves) {
  Box box;
  for (const Move& move : moves) {
    if (!move.travels()) continue;
    box.add(move.from.x(), move.from.y());
    box.add(move.to.x(), move.to.y());
    if (move.kind == MoveKind::Arc) add_extremes(box, move);
  }
  return box;
}

}  // namespace dgt
