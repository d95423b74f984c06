// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/piece.h"

#include <cmath>
#include <limits>

#include "kernel/stretch.h"

// The least distance of two pieces is taken at ends of either, where they cross (then it is 0), or
// where the line between the two places stands square on both: for a line and a circle on the
// normal through the centre, for two circles on the line of centres.
namespace dgt {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

double coarse(const Rational& value) { return static_cast<double>(Ball(value).mid); }

double cross(double ax, double ay, double bx, double by) { return ax * by - ay * bx; }

struct Nearest {
  Approach best{kFar, 0, 0};
  /// Offers (ax, ay) on the first piece against (bx, by) on the second.
  void offer(double ax, double ay, double bx, double by) {
    const double distance = std::hypot(ax - bx, ay - by);
    if (distance < best.distance) best = {distance, ax, ay};
  }
};

/// The point of `piece` nearest to (x, y).
void nearest_to(const Piece& piece, double x, double y, double& px, double& py) {
  if (!piece.arc) {
    const double dx = piece.x1 - piece.x0;
    const double dy = piece.y1 - piece.y0;
    const double square = dx * dx + dy * dy;
    double t = square > 0 ? ((x - piece.x0) * dx + (y - piece.y0) * dy) / square : 0;
    t = std::clamp(t, 0.0, 1.0);
    px = piece.x0 + t * dx;
    py = piece.y0 + t * dy;
    return;
  }
  const double dx = x - piece.cx;
  const double dy = y - piece.cy;
  const double length = std::hypot(dx, dy);
  if (length > 0 && in_sector(piece, dx, dy)) {
    const double k = std::fabs(piece.radius) / length;
    px = piece.cx + k * dx;
    py = piece.cy + k * dy;
    return;
  }
  const bool first =
      std::hypot(x - piece.x0, y - piece.y0) <= std::hypot(x - piece.x1, y - piece.y1);
  px = first ? piece.x0 : piece.x1;
  py = first ? piece.y0 : piece.y1;
}

void offer_ends(const Piece& a, const Piece& b, Nearest& nearest) {
  double px = 0;
  double py = 0;
  nearest_to(b, a.x0, a.y0, px, py);
  nearest.offer(a.x0, a.y0, px, py);
  nearest_to(b, a.x1, a.y1, px, py);
  nearest.offer(a.x1, a.y1, px, py);
  nearest_to(a, b.x0, b.y0, px, py);
  nearest.offer(px, py, b.x0, b.y0);
  nearest_to(a, b.x1, b.y1, px, py);
  nearest.offer(px, py, b.x1, b.y1);
}

bool within(const Piece& segment, double x, double y) {
  const double dx = segment.x1 - segment.x0;
  const double dy = segment.y1 - segment.y0;
  const double along = (x - segment.x0) * dx + (y - segment.y0) * dy;
  return along >= 0 && along <= dx * dx + dy * dy;
}

/// Calls visit(x, y) for each place that both pieces run through; those on one support meet
/// nowhere.
template <class Visit>
void cross_lines(const Piece& a, const Piece& b, Visit&& visit) {
  const double ax = a.x1 - a.x0;
  const double ay = a.y1 - a.y0;
  const double bx = b.x1 - b.x0;
  const double by = b.y1 - b.y0;
  const double det = cross(ax, ay, bx, by);
  if (det == 0) return;  // parallel: ends decide
  const double t = cross(b.x0 - a.x0, b.y0 - a.y0, bx, by) / det;
  const double s = cross(b.x0 - a.x0, b.y0 - a.y0, ax, ay) / det;
  if (t >= 0 && t <= 1 && s >= 0 && s <= 1) {
    visit(a.x0 + t * ax, a.y0 + t * ay);
  }
}

template <class Visit>
void cross_line_arc(const Piece& line, const Piece& arc, Visit&& visit) {
  const double dx = line.x1 - line.x0;
  const double dy = line.y1 - line.y0;
  const double square = dx * dx + dy * dy;
  if (square == 0) return;
  const double t = ((arc.cx - line.x0) * dx + (arc.cy - line.y0) * dy) / square;
  const double fx = line.x0 + t * dx;
  const double fy = line.y0 + t * dy;
  const double h = std::hypot(fx - arc.cx, fy - arc.cy);
  const double r = std::fabs(arc.radius);
  if (h >= r) return;
  const double s = std::sqrt((r - h) * (r + h) / square);
  for (const double sign : {-1.0, 1.0}) {
    const double x = fx + sign * s * dx;
    const double y = fy + sign * s * dy;
    if (within(line, x, y) && in_sector(arc, x - arc.cx, y - arc.cy)) visit(x, y);
  }
}

template <class Visit>
void cross_arcs(const Piece& a, const Piece& b, Visit&& visit) {
  const double vx = b.cx - a.cx;
  const double vy = b.cy - a.cy;
  const double square = vx * vx + vy * vy;
  if (square == 0) return;
  const double k = (square + (a.radius - b.radius) * (a.radius + b.radius)) / (2 * square);
  const double rest = a.radius * a.radius / square - k * k;
  if (rest < 0) return;
  const double s = std::sqrt(rest);
  for (const double sign : {-1.0, 1.0}) {
    const double x = a.cx + k * vx - sign * s * vy;
    const double y = a.cy + k * vy + sign * s * vx;
    if (in_sector(a, x - a.cx, y - a.cy) && in_sector(b, x - b.cx, y - b.cy)) visit(x, y);
  }
}

template <class Visit>
void for_each_crossing(const Piece& a, const Piece& b, Visit&& visit) {
  if (a.arc && b.arc)
    cross_arcs(a, b, visit);
  else if (a.arc)
    cross_line_arc(b, a, visit);
  else if (b.arc)
    cross_line_arc(a, b, visit);
  else
    cross_lines(a, b, visit);
}

/// Where the normal of the line goes through the centre. `line_first`: whether the line is the
/// first piece of the two.
void offer_normal(const Piece& line, const Piece& arc, bool line_first, Nearest& nearest) {
  const double dx = line.x1 - line.x0;
  const double dy = line.y1 - line.y0;
  const double square = dx * dx + dy * dy;
  if (square == 0) return;
  const double t = ((arc.cx - line.x0) * dx + (arc.cy - line.y0) * dy) / square;
  const double fx = line.x0 + t * dx;
  const double fy = line.y0 + t * dy;
  const double h = std::hypot(fx - arc.cx, fy - arc.cy);
  if (h == 0 || !within(line, fx, fy) || !in_sector(arc, fx - arc.cx, fy - arc.cy)) return;
  const double k = std::fabs(arc.radius) / h;
  const double ax = arc.cx + k * (fx - arc.cx);
  const double ay = arc.cy + k * (fy - arc.cy);
  if (line_first)
    nearest.offer(fx, fy, ax, ay);
  else
    nearest.offer(ax, ay, fx, fy);
}

void offer_line_of_centres(const Piece& a, const Piece& b, Nearest& nearest) {
  const double vx = b.cx - a.cx;
  const double vy = b.cy - a.cy;
  const double distance = std::hypot(vx, vy);
  if (distance == 0) return;  // concentric: ends decide
  const double ra = std::fabs(a.radius);
  const double rb = std::fabs(b.radius);
  for (const double sa : {-1.0, 1.0}) {
    if (!in_sector(a, sa * vx, sa * vy)) continue;
    for (const double sb : {-1.0, 1.0}) {
      if (!in_sector(b, sb * vx, sb * vy)) continue;
      nearest.offer(a.cx + sa * ra / distance * vx, a.cy + sa * ra / distance * vy,
                    b.cx + sb * rb / distance * vx, b.cy + sb * rb / distance * vy);
    }
  }
}

}  // namespace

Piece piece_of(const Stretch& stretch) {
  Piece piece{stretch.from.x(), stretch.from.y(), stretch.to.x(), stretch.to.y()};
  if (stretch.carrier.is_line()) return piece;
  const auto& circle = std::get<Circle>(*stretch.carrier.base);
  piece.arc = true;
  piece.full_circle = stretch.from == stretch.to;
  piece.cx = coarse(circle.centre().x);
  piece.cy = coarse(circle.centre().y);
  Ball radius(circle.radius());
  if (stretch.carrier.shift) radius = radius - Ball(*stretch.carrier.shift);
  piece.radius = static_cast<double>(radius.mid);
  return piece;
}

Piece piece_of(const Move& move) {
  if (move.kind != MoveKind::Arc)
    return {move.from.x(), move.from.y(), move.to.x(), move.to.y(), false, false, 0, 0, 0};
  return piece_of(stretch_of(move));
}

Bounds box_around(const Stretch& stretch) {
  const Bounds box = box_of(piece_of(stretch));
  // Coordinates are correctly rounded, and an extreme place taken for outside the sector lies
  // nearer to an end than rounding: a few units in the last place of the largest number cover all
  // of it.
  const double size =
      std::max({std::fabs(box.min_x), std::fabs(box.min_y), std::fabs(box.max_x),
                std::fabs(box.max_y), box.max_x - box.min_x, box.max_y - box.min_y});
  return box.grown(size * 0x1p-44);
}

Bounds box_of(const Piece& p) {
  Bounds box{std::min(p.x0, p.x1), std::min(p.y0, p.y1), std::max(p.x0, p.x1),
             std::max(p.y0, p.y1)};
  if (!p.arc) return box;
  const double r = std::fabs(p.radius);
  if (in_sector(p, 1, 0)) box.max_x = std::max(box.max_x, p.cx + r);
  if (in_sector(p, -1, 0)) box.min_x = std::min(box.min_x, p.cx - r);
  if (in_sector(p, 0, 1)) box.max_y = std::max(box.max_y, p.cy + r);
  if (in_sector(p, 0, -1)) box.min_y = std::min(box.min_y, p.cy - r);
  return box;
}

bool in_sector(const Piece& arc, double dx, double dy) {
  if (arc.full_circle) return true;
  double ux = arc.x0 - arc.cx;
  double uy = arc.y0 - arc.cy;
  double vx = arc.x1 - arc.cx;
  double vy = arc.y1 - arc.cy;
  if (arc.radius < 0) {  // the same points, counter-clockwise
    std::swap(ux, vx);
    std::swap(uy, vy);
  }
  const double turn = cross(ux, uy, vx, vy);
  const bool after_start = cross(ux, uy, dx, dy) >= 0;
  const bool before_end = cross(dx, dy, vx, vy) >= 0;
  const bool half_or_less = turn > 0 || (turn == 0 && ux * vx + uy * vy < 0);
  return half_or_less ? after_start && before_end : after_start || before_end;
}

Approach nearest(const Piece& a, const Piece& b) {
  Nearest result;
  offer_ends(a, b, result);
  for_each_crossing(a, b, [&](double x, double y) { result.offer(x, y, x, y); });
  if (a.arc && b.arc)
    offer_line_of_centres(a, b, result);
  else if (a.arc)
    offer_normal(b, a, false, result);
  else if (b.arc)
    offer_normal(a, b, true, result);
  return result.best;
}

}  // namespace dgt
