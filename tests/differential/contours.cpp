// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/differential/contours.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "kernel/contour_legs.h"
#include "kernel/offset.h"

namespace dgt::differential {
namespace {

using Loop = std::vector<BulgeVertex>;

/// Numbers from the generator's own bits: library distributions differ between machines.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : random_(seed) {}
  /// 0 … count − 1.
  int below(int count) { return static_cast<int>(random_() % static_cast<std::uint32_t>(count)); }
  bool one_in(int count) { return below(count) == 0; }
  double within(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
  }
  template <class T, std::size_t n>
  const T& pick(const std::array<T, n>& from) {
    return from[static_cast<std::size_t>(below(static_cast<int>(n)))];
  }

 private:
  std::mt19937 random_;
};

Rational decimal(double value, int digits = 4) {
  const long scale = std::lround(std::pow(10, digits));
  Rational r(std::lround(value * static_cast<double>(scale)), scale);
  r.canonicalize();
  return r;
}

/// tan(90°/4), as a drawing's decimals would say it.
const Rational kQuarter = *parse_decimal("0.41421356237309503");

/// Whether the edge from p turns about the origin all the way: then a star of such edges is simple.
bool turns_about_origin(const BulgeVertex& p, const BulgeVertex& q) {
  const double b = p.bulge.get_d();
  const double px = p.at.x.get_d(), py = p.at.y.get_d();
  const double wx = q.at.x.get_d() - px, wy = q.at.y.get_d() - py;
  double x = px, y = py;
  constexpr int kSteps = 64;
  for (int i = 1; i <= kSteps; ++i) {
    // The point of the arc whose own bulge from p is t b, on the way there: by half tangents.
    const double turn = 4 * std::atan(b);
    const double part = static_cast<double>(i) / kSteps;
    double nx = px + part * wx, ny = py + part * wy;
    if (b != 0) {
      const double k = (1 - b * b) / (4 * b);
      const double cx = px + wx / 2 - k * wy, cy = py + wy / 2 + k * wx;
      const double c = std::cos(part * turn), s = std::sin(part * turn);
      nx = cx + (px - cx) * c - (py - cy) * s;
      ny = cy + (px - cx) * s + (py - cy) * c;
    }
    if (x * ny - y * nx <= 2e-2 * (std::hypot(nx, ny) + std::hypot(x, y)) / kSteps) return false;
    x = nx;
    y = ny;
  }
  return true;
}

Loop star(Dice& dice, double radius, int vertices, int digits) {
  Loop loop;
  for (int i = 0; i < vertices; ++i) {
    // Less than half a turn from one to the next.
    const double sway = vertices < 5 ? 0.2 : 0.35;
    const double angle = 2 * std::numbers::pi * (i + dice.within(-sway, sway)) / vertices;
    const double r = radius * dice.within(0.5, 1.3);
    loop.push_back(
        {{decimal(r * std::cos(angle), digits), decimal(r * std::sin(angle), digits)}, 0});
  }
  static const std::array<Rational, 5> kBulges = {Rational(1), Rational(1, 2), Rational(-1, 2),
                                                  kQuarter, Rational(-1, 4)};
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (dice.one_in(2)) continue;
    loop[i].bulge = dice.one_in(3) ? dice.pick(kBulges) : decimal(dice.within(-0.5, 0.5), digits);
    if (!turns_about_origin(loop[i], loop[(i + 1) % loop.size()])) loop[i].bulge = 0;
  }
  return loop;
}

const std::array<const char*, 10> kDistances = {"0.05", "0.25", "0.5", "1",          "1.5",
                                                "2",    "2.5",  "4",   "0.99999999", "0.0001"};

Rational distance(Dice& dice) {
  const Rational d = *parse_decimal(dice.pick(kDistances));
  return dice.one_in(2) ? d : Rational(-d);
}

/// A comb: teeth of whole-number sizes over a straight back, run counter-clockwise.
Loop grid(Dice& dice) {
  Loop loop;
  long x = 0;
  const int teeth = 3 + dice.below(5);
  for (int i = 0; i < teeth; ++i) {
    const long height = 2 + dice.below(6);
    const long width = 1 + dice.below(4);
    loop.push_back({{Rational(x), Rational(height)}, 0});
    loop.push_back({{Rational(x + width), Rational(height)}, 0});
    x += width;
  }
  loop.push_back({{Rational(x), Rational(-4)}, 0});
  loop.push_back({{Rational(0), Rational(-4)}, 0});
  std::ranges::reverse(loop);
  return loop;
}

/// The same with its corners rounded where there is room.
Loop rounded(Dice& dice) {
  const Loop sharp = grid(dice);
  static const std::array<Rational, 4> kRadii = {Rational(1, 2), Rational(1, 4), Rational(1),
                                                 Rational(3, 10)};
  const Rational bulge = dice.one_in(2) ? kQuarter : *parse_decimal("0.414214");
  Loop loop;
  for (std::size_t i = 0; i < sharp.size(); ++i) {
    const RationalPoint& a = sharp[(i + sharp.size() - 1) % sharp.size()].at;
    const RationalPoint& b = sharp[i].at;
    const RationalPoint& c = sharp[(i + 1) % sharp.size()].at;
    const Vector back = a - b;
    const Vector on = c - b;
    const Rational one = abs(back.x) + abs(back.y);
    const Rational two = abs(on.x) + abs(on.y);
    const Rational r = dice.pick(kRadii);
    const int turn = sgn(cross(on, back));
    if (turn == 0 || 2 * r >= one || 2 * r >= two || dice.one_in(4)) {
      loop.push_back({b, 0});
      continue;
    }
    loop.push_back({b + (r / one) * back, turn > 0 ? bulge : Rational(-bulge)});
    loop.push_back({b + (r / two) * on, 0});
  }
  return loop;
}

/// A plate with round-ended slots from above, the walls between them at times as thin.
Loop slots(Dice& dice) {
  const int count = 1 + dice.below(4);
  static const std::array<const char*, 4> kWidths = {"2", "2.000000001", "1.999999999", "1"};
  Loop loop = {{{0, 0}, 0}};
  Rational x = 0;
  Loop top;
  for (int i = 0; i < count; ++i) {
    x += 2 + dice.below(3);
    const Rational w = *parse_decimal(dice.pick(kWidths));
    const Rational bottom = 3 + dice.below(4);
    top.push_back({{x, 12}, 0});
    top.push_back({{x, bottom}, 1});  // seen from the right: turned below
    top.push_back({{x + w, bottom}, 0});
    top.push_back({{x + w, 12}, 0});
    x += w;
  }
  x += 3;
  loop.push_back({{x, 0}, 0});
  loop.push_back({{x, 12}, 0});
  for (std::size_t i = top.size(); i > 0; i -= 4) {
    loop.push_back(top[i - 1]);
    loop.push_back({top[i - 2].at, Rational(-1)});
    loop.push_back({top[i - 3].at, 0});
    loop.push_back(top[i - 4]);
  }
  loop.push_back({{0, 12}, 0});
  return loop;
}

Loop reversed(const Loop& loop) {
  Loop result;
  for (std::size_t i = loop.size(); i-- > 0;)
    result.push_back({loop[(i + 1) % loop.size()].at, -loop[i].bulge});
  return result;
}

Loop moved(Loop loop, const Vector& by) {
  for (BulgeVertex& v : loop) v.at = v.at + by;
  return loop;
}

Loop scaled(Loop loop, const Rational& by) {
  for (BulgeVertex& v : loop) v.at = by * v.at;
  return loop;
}

std::vector<Loop> islands(Dice& dice) {
  std::vector<Loop> loops = {star(dice, 20, 8 + dice.below(10), 3)};
  for (BulgeVertex& v : loops.front()) v.bulge = abs(v.bulge);  // no nearer than its vertices
  static const std::array<std::array<int, 2>, 4> kPlaces = {{{-4, 0}, {4, 0}, {0, -4}, {0, 4}}};
  const int count = 1 + dice.below(4);
  for (int i = 0; i < count; ++i) {
    const auto& place = kPlaces[static_cast<std::size_t>(i)];
    loops.push_back(moved(reversed(star(dice, 1.2, 3 + dice.below(5), 2)),
                          {Rational(place[0]), Rational(place[1])}));
  }
  return loops;
}

/// Where the equidistant of a star lies, to the nearest double.
std::vector<Loop> offset(Dice& dice) {
  std::vector<Loop> loops;
  const Chain chain = chain_of(star(dice, 6, 5 + dice.below(7), 2), true).value();
  for (const OffsetLoop& found : reference_offset({chain}, distance(dice))) {
    Loop& loop = loops.emplace_back();
    for (const OffsetPiece& piece : found.pieces) {
      double bulge = 0;
      if (!piece.is_line) {
        const Circle circle(piece.centre, piece.radius);
        bulge = std::tan(coarse_sweep(circle, piece.from, piece.to) * std::numbers::pi / 720);
      }
      loop.push_back({{Rational(piece.from.x()), Rational(piece.from.y())}, Rational(bulge)});
    }
  }
  return loops;
}

/// Squares of a board, some of them: they meet at corners and along sides.
std::vector<Loop> board(Dice& dice) {
  std::vector<Loop> loops;
  const int side = 2 + dice.below(4);
  const auto corner = [&](int x, int y) {
    return BulgeVertex{{Rational(side * x), Rational(side * y)}, 0};
  };
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 3; ++y) {
      if (!dice.one_in(2)) continue;
      loops.push_back({corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)});
    }
  }
  if (loops.empty()) loops.push_back({corner(0, 0), corner(1, 0), corner(0, 1)});
  return loops;
}

/// Sectors about the origin, as loops of their own or as one that comes back to it again and again.
std::vector<Loop> fan(Dice& dice) {
  static const std::array<std::array<int, 2>, 8> kCompass = {
      {{4, 0}, {3, 3}, {0, 4}, {-3, 3}, {-4, 0}, {-3, -3}, {0, -4}, {3, -3}}};
  const bool to_compass = dice.one_in(2);
  const bool one_loop = dice.one_in(2);
  std::vector<Loop> loops;
  const int sectors = 2 + dice.below(3);
  Loop all;
  for (int i = 0; i < sectors; ++i) {
    Loop sector = {{{0, 0}, 0}};
    for (int k = 2 * i; k < 2 * i + 2; ++k) {
      if (to_compass) {
        const auto& at = kCompass[static_cast<std::size_t>(k)];
        sector.push_back({{Rational(at[0]), Rational(at[1])}, 0});
      } else {
        const double angle = std::numbers::pi * (k + dice.within(0, 0.9)) / sectors;
        const double r = dice.within(3, 7);
        sector.push_back({{decimal(r * std::cos(angle)), decimal(r * std::sin(angle))}, 0});
      }
    }
    if (dice.one_in(3)) sector[1].bulge = kQuarter;
    if (one_loop)
      all.insert(all.end(), sector.begin(), sector.end());
    else
      loops.push_back(std::move(sector));
  }
  if (one_loop) loops.push_back(std::move(all));
  return loops;
}

}  // namespace

std::vector<Chain> Case::chains() const {
  std::vector<Chain> result;
  for (const Loop& loop : loops) {
    if (auto chain = chain_of(loop, true)) result.push_back(*std::move(chain));
  }
  return result;
}

std::string Case::to_text() const {
  std::string text = fmt::format("# distance {}\n", to_short_decimal(distance, 20));
  for (const Loop& loop : loops) {
    for (const BulgeVertex& v : loop)
      text += fmt::format("{} {} {}\n", to_short_decimal(v.at.x, 60), to_short_decimal(v.at.y, 60),
                          to_short_decimal(v.bulge, 60));
    text += "\n";
  }
  return text;
}

Case make(Family family, std::uint32_t seed) {
  Dice dice(seed * 7U + static_cast<std::uint32_t>(family));
  switch (family) {
    case Family::Star:
      return {{star(dice, 6, 4 + dice.below(10), 3)}, distance(dice)};
    case Family::Grid:
      return {{grid(dice)}, distance(dice)};
    case Family::Rounded:
      return {{rounded(dice)}, distance(dice)};
    case Family::Slots: {
      static const std::array<const char*, 5> kReach = {"1", "-1", "0.5", "-1.5", "-0.999999999"};
      return {{slots(dice)}, *parse_decimal(dice.pick(kReach))};
    }
    case Family::Islands:
      return {islands(dice), distance(dice)};
    case Family::Minute: {
      Case c{{star(dice, 6, 4 + dice.below(10), 3)}, distance(dice) / 10000};
      for (Loop& loop : c.loops) loop = scaled(std::move(loop), Rational(1, 10000));
      return c;
    }
    case Family::Offset:
      return {offset(dice), distance(dice)};
    case Family::Touching:
      return {dice.one_in(2) ? board(dice) : fan(dice), distance(dice)};
  }
  return {};
}

}  // namespace dgt::differential
