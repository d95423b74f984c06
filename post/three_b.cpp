// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/three_b.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "post/program_text.h"

namespace dgt {
namespace {

// Coordinates up to 2·10¹² have squares that fit.
__extension__ using Wide = __int128;

Wide square(std::int64_t v) { return static_cast<Wide>(v) * v; }

/// The largest whole number whose square is at most `n`.
std::int64_t floor_sqrt(Wide n) {
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<long double>(n)));
  while (square(root) > n) --root;
  while (square(root + 1) <= n) ++root;
  return root;
}

/// Where a control turns at an extreme of the circle with radius² `n`, if all turn there.
std::optional<std::int64_t> extreme_of(Wide n) {
  const std::int64_t below = floor_sqrt(n);
  // ⌈√(n−1)⌉ and √n rounded: n > below² + below is nearer to below + 1.
  const std::int64_t outside = floor_sqrt(n - 2) + 1;
  const std::int64_t beside = n > square(below) + below ? below + 1 : below;
  return outside == beside ? std::optional(beside) : std::nullopt;
}

/// The quadrant of a direction; along an axis the one that begins there counter-clockwise.
int quadrant_of(std::int64_t x, std::int64_t y) {
  if (x > 0 && y >= 0) return 1;
  if (x <= 0 && y > 0) return 2;
  if (x < 0) return 3;
  return 4;
}
/// Along an axis the one that begins there clockwise.
int clockwise_quadrant_of(std::int64_t x, std::int64_t y) {
  if (x >= 0 && y > 0) return 1;
  if (x < 0 && y >= 0) return 2;
  if (x <= 0) return 3;
  return 4;
}

struct Seen {
  std::int64_t x;
  std::int64_t y;
};

/// Whether the arc from `a` to `b` about 0 runs through the direction `p`, its ends left out.
/// Whole turns are none of these: a and b differ.
bool passes(const Seen& a, const Seen& b, bool ccw, const Seen& p) {
  const auto cross = [](const Seen& u, const Seen& v) {
    return static_cast<Wide>(u.x) * v.y - static_cast<Wide>(u.y) * v.x;
  };
  const auto dot = [](const Seen& u, const Seen& v) {
    return static_cast<Wide>(u.x) * v.x + static_cast<Wide>(u.y) * v.y;
  };
  // Half turns from a, 0 to 2: order of directions by (half, cross).
  const auto half = [&](const Seen& v) {
    const Wide c = ccw ? cross(a, v) : -cross(a, v);
    if (c == 0) return dot(a, v) > 0 ? 0 : 2;
    return c > 0 ? 1 : 3;
  };
  const int of_p = half(p);
  const int of_b = half(b) == 0 ? 4 : half(b);
  if (of_p == 0) return false;
  if (of_p != of_b) return of_p < of_b;
  const Wide c = ccw ? cross(p, b) : -cross(p, b);
  return c > 0;
}

/// The way along one axis of an arc between coordinates `a` and `b` that turns at `extreme` once
/// for each entry of `turns`, +1 or −1, in order.
std::int64_t way(std::int64_t a, std::int64_t b, std::int64_t extreme,
                 const std::vector<int>& turns) {
  std::int64_t sum = 0;
  for (const int turn : turns) {
    sum += std::llabs(turn * extreme - a);
    a = turn * extreme;
  }
  return sum + std::llabs(b - a);
}

CountedAxis axis_of_arc(const Seen& end) {
  const std::int64_t x = std::llabs(end.x);
  const std::int64_t y = std::llabs(end.y);
  if (x != y) return x < y ? CountedAxis::X : CountedAxis::Y;
  return (end.x > 0) == (end.y > 0) ? CountedAxis::X : CountedAxis::Y;
}

CountedAxis axis_of_line(const Seen& end) {
  const std::int64_t x = std::llabs(end.x);
  const std::int64_t y = std::llabs(end.y);
  if (x != y) return x > y ? CountedAxis::X : CountedAxis::Y;
  return (end.x > 0) == (end.y > 0) ? CountedAxis::Y : CountedAxis::X;
}

/// The extremes along the counted axis that the arc passes, in order.
std::vector<int> turns_of(const Seen& from, const Seen& to, bool ccw, bool along_x) {
  const auto direction = [&](int sign) { return along_x ? Seen{sign, 0} : Seen{0, sign}; };
  const bool positive = passes(from, to, ccw, direction(1));
  const bool negative = passes(from, to, ccw, direction(-1));
  if (!positive || !negative)
    return positive ? std::vector{1} : negative ? std::vector{-1} : std::vector<int>{};
  const bool positive_first = passes(from, direction(-1), ccw, direction(1));
  return positive_first ? std::vector{1, -1} : std::vector{-1, 1};
}

class Writer {
 public:
  Writer(const Dialect& dialect, ProgramText& text) : dialect_(dialect), text_(text) {}

  void write(const Block& block) {
    switch (block.kind) {
      case BlockKind::Arc:
        return write_arc(block);
      case BlockKind::Line:
      case BlockKind::Rapid:
        return write_line(block);
      default:
        text_.add(block.words, block.move);
    }
  }

 private:
  void write_line(const Block& block) {
    const Seen end{block.path.to.x - block.path.from.x, block.path.to.y - block.path.from.y};
    const CountedAxis axis = axis_of_line(end);
    const std::int64_t x = std::llabs(end.x);
    const std::int64_t y = std::llabs(end.y);
    append(block, x, y, axis == CountedAxis::X ? x : y, axis, "L", quadrant_of(end.x, end.y));
  }

  void write_arc(const Block& block) {
    const auto arc = counted_arc(block.path);
    DGT_CHECK(arc.has_value());
    append(block, arc->x, arc->y, arc->count, arc->axis, block.path.ccw ? "NR" : "SR",
           arc->quadrant);
  }

  void append(const Block& block, std::int64_t x, std::int64_t y, std::int64_t count,
              CountedAxis axis, std::string_view kind, int quadrant) {
    const std::string& gap = dialect_.spelling.separator;
    text_.check_size(std::max({x, y, count}), block.move);
    text_.add(fmt::format("B{1}{0}B{2}{0}B{3}{0}G{4}{0}{5}{6}", gap, x, y, count,
                          axis == CountedAxis::X ? 'X' : 'Y', kind, quadrant),
              block.move);
  }

  const Dialect& dialect_;
  ProgramText& text_;
};

}  // namespace

std::optional<CountedArc> counted_arc(const WrittenArc& arc) {
  const Seen from{arc.from.x - arc.centre.x, arc.from.y - arc.centre.y};
  const Seen to{arc.to.x - arc.centre.x, arc.to.y - arc.centre.y};
  constexpr int kLeastSquare = 4;  // nothing of a smaller circle is left on the grid
  const Wide n = square(from.x) + square(from.y);
  if (arc.from == arc.to || n < kLeastSquare) return std::nullopt;
  CountedArc counted{std::llabs(from.x), std::llabs(from.y), 0, axis_of_arc(to), 1};
  counted.quadrant = arc.ccw ? quadrant_of(from.x, from.y) : clockwise_quadrant_of(from.x, from.y);
  const bool along_x = counted.axis == CountedAxis::X;
  // (1): 2|other| − 1 < 2√(n − along²) < 2|other| + 1
  const std::int64_t other = std::llabs(along_x ? to.y : to.x);
  const Wide height = 4 * (n - square(along_x ? to.x : to.y));
  if (other == 0 || height <= square(2 * other - 1) || height >= square(2 * other + 1))
    return std::nullopt;
  const auto turns = turns_of(from, to, arc.ccw, along_x);
  std::int64_t extreme = 0;
  if (!turns.empty()) {
    const auto found = extreme_of(n);
    if (!found) return std::nullopt;
    extreme = *found;
  }
  counted.count = along_x ? way(from.x, to.x, extreme, turns) : way(from.y, to.y, extreme, turns);
  return counted.count > 0 ? std::optional(counted) : std::nullopt;
}

std::string three_b_text(const Plan& plan, const Dialect& dialect,
                         std::vector<WriteFault>& faults) {
  ProgramText text(plan, dialect, faults);
  Writer writer(dialect, text);
  for (const Block& block : plan.blocks) writer.write(block);
  return text.finish();
}

}  // namespace dgt
