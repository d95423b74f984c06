// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/svg_names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "post/figures.h"

namespace dgt {
namespace {

/// What it costs a name to stand across another, or beyond the sheet; a point of the path costs 1.
constexpr int kOverName = 1000;
constexpr int kOffSheet = 1'000'000;

struct Spot {
  double x = 0, y = 0;
};
Spot operator+(Spot a, Spot b) { return {a.x + b.x, a.y + b.y}; }
Spot operator*(double k, Spot a) { return {k * a.x, k * a.y}; }
Spot left_of(Spot direction) { return {-direction.y, direction.x}; }

/// A place on a shape, and which way the shape runs there.
struct Place {
  Spot at;
  Spot direction;
};

/// Figures of a drawing need no more than a thousandth of a pixel, and are the same on every
/// machine then.
double rounded(double value, double pixel) {
  const double grid = std::exp2(std::floor(std::log2(pixel)) - 10);
  return std::round(value / grid) * grid;
}

/// The stretch of a line on the sheet.
std::optional<std::array<Spot, 2>> clipped(const Line& line, const Sheet& sheet) {
  const Spot d = {nearest_double(line.direction().x()), nearest_double(line.direction().y())};
  const double p = nearest_double(line.p());
  const Spot foot = p * left_of(d);
  double first = -1e300;
  double last = 1e300;
  const auto cut = [&](double from, double way, double low, double high) {
    if (way == 0) {
      if (from < low || from > high) last = first - 1;
      return;
    }
    const double a = (low - from) / way;
    const double b = (high - from) / way;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  };
  cut(foot.x, d.x, sheet.left, sheet.right());
  cut(foot.y, d.y, sheet.bottom(), sheet.top);
  if (first >= last) return std::nullopt;
  return std::array{foot + first * d, foot + last * d};
}

class NamesWriter {
 public:
  NamesWriter(const Sheet& sheet, double letter) : sheet_(sheet), letter_(letter) {}

  /// Half-way along each cut; and what the names had better not cover.
  void pass(std::span<const Move> moves, bool with_heads) {
    for (const Move& move : moves) {
      if (!move.travels()) continue;
      const double way = length(move);
      const int steps = std::clamp(static_cast<int>(way / (letter_ / 2)), 1, 200);
      for (int i = 0; i <= steps; ++i) crowd_.push_back(at(move, double(i) / steps).at);
      // Approach and departure often lie on one another.
      const bool lead = move.role == Role::LeadIn || move.role == Role::LeadOut;
      const bool has_head = with_heads && move.cuts() && !lead && way > 3 * letter_;
      if (has_head) head(out_.heads, at(move, 0.5));
    }
  }

  void draw(const NamedShape& named) {
    elements_ = named.lit ? &out_.lit : &out_.elements;
    dots_ = named.lit ? &out_.lit_dots : &out_.dots;
    std::visit([&](const auto& shape) { draw(named.name, shape); }, named.shape);
  }
  NamesLayout finish() { return std::move(out_); }

 private:
  struct Candidate {
    Spot middle;
    std::optional<Place> arrow;
  };

  void draw(const std::string& name, const Line& line) {
    const auto ends = clipped(line, sheet_);
    if (!ends) return;
    const auto [from, to] = *ends;
    stroke(*elements_, {from, to});
    const Spot d = {nearest_double(line.direction().x()), nearest_double(line.direction().y())};
    const double whole = std::hypot(to.x - from.x, to.y - from.y);
    std::vector<Candidate> candidates;
    // Best near the end that the line runs to, beside it.
    for (double back = 1.5 * letter_; back < whole; back += letter_) {
      const Spot on = to + (-back) * d;
      for (const double side : {1.0, -1.0}) {
        candidates.push_back({on + side * gap(name, d) * left_of(d), Place{on, d}});
      }
    }
    place(name, candidates);
  }

  void draw(const std::string& name, const Circle& circle) {
    const Spot centre = {coordinate(circle.centre().x), coordinate(circle.centre().y)};
    const double radius = nearest_double(abs(circle.radius()));
    round(centre, radius);
    std::vector<Candidate> candidates;
    constexpr int kSectors = 24;
    for (int i = 0; i < kSectors; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 3) / kSectors;
      const Spot out = {std::cos(angle), std::sin(angle)};
      const Spot direction = (circle.counter_clockwise() ? 1 : -1) * left_of(out);
      const Spot on = centre + radius * out;
      for (const double side : {1.0, -1.0}) {
        candidates.push_back({on + side * gap(name, direction) * out, Place{on, direction}});
      }
    }
    place(name, candidates);
  }

  void draw(const std::string& name, const NamedSpot& spot) {
    const Spot at{spot.x, spot.y};
    if (spot.dot) {
      move_to(*dots_, at);
      *dots_ += " h0";
      crowd_.push_back(at);
    }
    place(name, around(at, spot.dot ? 1.0 : 0.9));
  }

  void draw(const std::string& name, const NamedAxes& axes) {
    const Spot at{axes.x, axes.y};
    const Spot x{axes.along_x, axes.along_y};
    for (const Spot& axis : {x, left_of(x)}) {
      const Spot tip = at + 2.5 * letter_ * axis;
      stroke(out_.arrows, {at, tip});
      head(out_.arrows, {tip, axis});
    }
    place(name, around(at, 1.2));
  }

  std::vector<Candidate> around(Spot at, double letters) const {
    std::vector<Candidate> candidates;
    for (const double far : {1.0, 1.7}) {
      for (const Spot& out : {Spot{1, 1}, Spot{-1, 1}, Spot{1, -1}, Spot{-1, -1}, Spot{0, 1},
                              Spot{1, 0}, Spot{0, -1}, Spot{-1, 0}}) {
        candidates.push_back({at + far * letters * letter_ * out, std::nullopt});
      }
    }
    return candidates;
  }

  double width(const std::string& name) const {
    return 0.62 * letter_ * static_cast<double>(name.size());
  }
  /// From an element to the middle of a name beside it.
  double gap(const std::string& name, Spot direction) const {
    return 0.35 * letter_ +
           0.5 * (std::fabs(direction.y) * width(name) + std::fabs(direction.x) * letter_);
  }

  int cost(const std::string& name, Spot middle) const {
    const double w = 0.5 * width(name);
    const double h = 0.5 * letter_;
    if (!sheet_.holds(middle.x - w, middle.y - h) || !sheet_.holds(middle.x + w, middle.y + h)) {
      return kOffSheet;
    }
    int covered = 0;
    for (const Spot& spot : crowd_) {
      covered += std::fabs(spot.x - middle.x) < w + 0.2 * letter_ &&
                 std::fabs(spot.y - middle.y) < h + 0.2 * letter_;
    }
    for (const Taken& taken : taken_) {
      if (std::fabs(taken.middle.x - middle.x) < w + taken.half_width + 0.3 * letter_ &&
          std::fabs(taken.middle.y - middle.y) < 1.1 * letter_) {
        covered += kOverName;
      }
    }
    return covered;
  }

  void place(const std::string& name, const std::vector<Candidate>& candidates) {
    const Candidate* best = nullptr;
    int least = kOffSheet;
    for (const Candidate& candidate : candidates) {
      const int here = cost(name, candidate.middle);
      if (here >= least) continue;
      least = here;
      best = &candidate;
    }
    // A crowd of elements of one name needs it once.
    const auto is_same = [&](const PlacedName& other) { return other.text == name; };
    const bool known = std::ranges::any_of(out_.names, is_same);
    if (best == nullptr || (known && least >= kOverName)) return;
    taken_.push_back({best->middle, 0.5 * width(name)});
    out_.names.push_back({name, rounded(best->middle.x, sheet_.pixel),
                          rounded(best->middle.y - 0.36 * letter_, sheet_.pixel)});
    if (best->arrow) head(out_.arrows, *best->arrow);
  }

  /// `part` of the way along a move, 0 to 1.
  static Place at(const Move& move, double part) {
    const Spot from{move.from.x(), move.from.y()};
    const Spot to{move.to.x(), move.to.y()};
    if (move.kind != MoveKind::Arc) {
      const double way = std::max(std::hypot(to.x - from.x, to.y - from.y), 1e-300);
      const Spot d{(to.x - from.x) / way, (to.y - from.y) / way};
      return {(1 - part) * from + part * to, d};
    }
    const ArcFigures arc = figures(move);
    const double turn = part * sweep_degrees(move) * std::numbers::pi / 180;
    const Spot out{(from.x - arc.centre_x) / arc.radius, (from.y - arc.centre_y) / arc.radius};
    const Spot there = std::cos(turn) * out + std::sin(turn) * left_of(out);
    return {Spot{arc.centre_x, arc.centre_y} + arc.radius * there,
            (arc.counter_clockwise ? 1 : -1) * left_of(there)};
  }

  void point(std::string& out, Spot at) const {
    append_number(out, rounded(at.x, sheet_.pixel));
    out += ' ';
    append_number(out, rounded(at.y, sheet_.pixel));
  }
  void move_to(std::string& out, Spot at) const {
    if (!out.empty()) out += '\n';
    out += 'M';
    point(out, at);
  }
  void stroke(std::string& out, std::initializer_list<Spot> spots) const {
    bool first = true;
    for (const Spot& spot : spots) {
      if (first) {
        move_to(out, spot);
      } else {
        out += " L";
        point(out, spot);
      }
      first = false;
    }
  }
  void head(std::string& out, const Place& place) const {
    const double size = 0.4 * letter_;
    const Spot tip = place.at + 0.5 * size * place.direction;
    const Spot foot = tip + (-size) * place.direction;
    const Spot wing = 0.5 * size * left_of(place.direction);
    stroke(out, {foot + wing, tip, foot + (-1) * wing});
  }
  void round(Spot centre, double radius) {
    const double r = rounded(radius, sheet_.pixel);
    move_to(*elements_, centre + Spot{radius, 0});
    for (const double sign : {-1.0, 1.0}) {
      *elements_ += " A";
      point(*elements_, {r, r});
      *elements_ += " 0 0 1 ";
      point(*elements_, centre + Spot{sign * radius, 0});
    }
  }

  struct Taken {
    Spot middle;
    double half_width = 0;
  };

  const Sheet& sheet_;
  double letter_;
  NamesLayout out_;
  std::string* elements_ = &out_.elements;  // where the shape in hand goes
  std::string* dots_ = &out_.dots;
  std::vector<Spot> crowd_;  ///< points of the path
  std::vector<Taken> taken_;
};

}  // namespace

NamesLayout lay_out_names(std::span<const NamedShape> shapes, const Toolpath& path,
                          const Sheet& sheet, double letter) {
  NamesWriter writer(sheet, letter);
  writer.pass(path.moves, true);
  for (const Contour& contour : path.contours) writer.pass(programmed_moves(path, contour), false);
  for (const NamedShape& named : shapes) writer.draw(named);
  return writer.finish();
}

}  // namespace dgt
