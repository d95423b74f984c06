// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dxf/nesting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "kernel/box_tree.h"
#include "lang/dxf/grouping.h"

namespace dgt {
namespace {

Bounds box_of(const DxfPiece& piece) {
  const Spotted from = spotted(piece.from);
  const Spotted to = spotted(piece.to);
  Bounds box{std::min(from.x, to.x), std::min(from.y, to.y), std::max(from.x, to.x),
             std::max(from.y, to.y)};
  if (!piece.circle) return box;
  // A box may be too large: a minor arc leaves its chord by its sagitta, any arc lies on its
  // circle.
  const Vector a = piece.from - piece.circle->centre();
  const Vector b = piece.to - piece.circle->centre();
  const bool ccw = piece.circle->counter_clockwise();
  if (sgn(cross(a, b)) * (ccw ? 1 : -1) > 0) {
    const double half = distance_between(piece.from, piece.to) / 2;
    const double size = std::fabs(nearest_double(piece.circle->radius()));
    // r − √(r² − h²) = h²/(r + √(r² − h²)) ≤ h²/r, and h where that is less.
    return box.grown(std::min(half, half * half / size));
  }
  const Spotted centre = spotted(piece.circle->centre());
  const double radius = std::fabs(nearest_double(piece.circle->radius()));
  return box.united({centre.x - radius, centre.y - radius, centre.x + radius, centre.y + radius});
}

Bounds box_of(const DxfContour& contour) {
  Bounds box = box_of(contour.pieces.front());
  for (const DxfPiece& piece : contour.pieces) box = box.united(box_of(piece));
  return box;
}

/// Whether the ray from `q` along +X crosses the segment. Of its ends the lower belongs to it.
bool crosses_segment(const RationalPoint& q, const RationalPoint& from, const RationalPoint& to) {
  const bool up = from.y < to.y;
  const RationalPoint& low = up ? from : to;
  const RationalPoint& high = up ? to : from;
  if (!(low.y <= q.y && q.y < high.y)) return false;
  return sgn(cross(high - low, q - low)) > 0;  // q lies to the left of the way up
}

/// The same of a part of a circle that runs from `low` up to `high` on one side of its centre.
bool crosses_flank(const RationalPoint& q, const Circle& circle, bool right, const Rational& low,
                   const Rational& high) {
  if (!(low <= q.y && q.y < high)) return false;
  const Vector v = q - circle.centre();
  const bool inside = squared_length(v) < circle.radius() * circle.radius();
  return right ? inside || sgn(v.x) < 0 : !inside && sgn(v.x) < 0;
}

/// How often, modulo 2, the ray crosses an arc: it is cut where it turns from up to down.
bool crosses_arc(const RationalPoint& q, const DxfPiece& piece) {
  const Circle& circle = *piece.circle;
  const RationalPoint& centre = circle.centre();
  const Rational radius = abs(circle.radius());
  const bool ccw = circle.counter_clockwise();
  const RationalPoint& from = ccw ? piece.from : piece.to;
  const RationalPoint& to = ccw ? piece.to : piece.from;
  const Rational bottom = centre.y - radius;
  const Rational top = centre.y + radius;
  if (piece.is_whole_circle()) {
    return crosses_flank(q, circle, true, bottom, top) !=
           crosses_flank(q, circle, false, bottom, top);
  }
  const bool from_right = from.x > centre.x || (from.x == centre.x && from.y < centre.y);
  const bool to_right = to.x > centre.x || (to.x == centre.x && to.y > centre.y);
  bool odd = false;
  const auto flank = [&](bool right, const Rational& a, const Rational& b) {
    odd ^= crosses_flank(q, circle, right, std::min(a, b), std::max(a, b));
  };
  // Counter-clockwise the right flank runs up and the left one down.
  if (from_right == to_right && (from_right ? from.y <= to.y : from.y >= to.y)) {
    flank(from_right, from.y, to.y);
  } else if (from_right == to_right) {
    flank(from_right, from.y, from_right ? top : bottom);
    flank(!from_right, bottom, top);
    flank(to_right, to_right ? bottom : top, to.y);
  } else {
    flank(from_right, from.y, from_right ? top : bottom);
    flank(to_right, to_right ? bottom : top, to.y);
  }
  return odd;
}

bool contains(const DxfContour& contour, const RationalPoint& q) {
  bool odd = false;
  for (const DxfPiece& piece : contour.pieces)
    odd ^= piece.circle ? crosses_arc(q, piece) : crosses_segment(q, piece.from, piece.to);
  return odd;
}

/// The contours that are left, by where they begin, in squares of a size that holds about one.
class NearestFirst {
 public:
  NearestFirst(const std::vector<DxfContour>& contours, const std::vector<std::size_t>& members) {
    for (const std::size_t i : members) {
      const Spotted at = spotted(contours[i].pieces.front().from);
      places_.push_back({at.x, at.y, i});
    }
    if (places_.empty()) return;
    double right = places_.front().x;
    double high = places_.front().y;
    left_ = right;
    low_ = high;
    for (const Place& p : places_) {
      left_ = std::min(left_, p.x);
      low_ = std::min(low_, p.y);
      right = std::max(right, p.x);
      high = std::max(high, p.y);
    }
    side_ = static_cast<long>(std::ceil(std::sqrt(static_cast<double>(places_.size()))));
    step_ = std::max({right - left_, high - low_, std::numeric_limits<double>::min()}) /
            static_cast<double>(side_);
    squares_.resize(static_cast<std::size_t>(side_ * side_));
    for (std::size_t k = 0; k < places_.size(); ++k)
      square(column(places_[k].x, left_), column(places_[k].y, low_)).push_back(k);
    rest_ = places_.size();
  }

  [[nodiscard]] bool empty() const { return rest_ == 0; }

  /// Takes the one that begins nearest; of equals the first in the file.
  std::size_t take(const Spotted& at) {
    const long x = column(at.x, left_);
    const long y = column(at.y, low_);
    double best = std::numeric_limits<double>::infinity();
    std::size_t found = places_.size();
    for (long ring = 0; ring <= side_; ++ring) {
      // What lies in farther rings is no nearer than this.
      if (found < places_.size() && best < static_cast<double>(ring - 1) * step_) break;
      look_at_ring(x, y, ring, at, best, found);
    }
    const Place& place = places_[found];
    std::erase(square(column(place.x, left_), column(place.y, low_)), found);
    --rest_;
    return place.contour;
  }

 private:
  struct Place {
    double x = 0;
    double y = 0;
    std::size_t contour = 0;
  };

  [[nodiscard]] long column(double x, double origin) const {
    const double at = std::clamp((x - origin) / step_, 0.0, static_cast<double>(side_ - 1));
    return static_cast<long>(at);
  }
  std::vector<std::size_t>& square(long x, long y) {
    return squares_[static_cast<std::size_t>(y * side_ + x)];
  }

  void look_at_ring(long x, long y, long ring, const Spotted& at, double& best,
                    std::size_t& found) {
    for (long j = std::max(y - ring, 0L); j <= std::min(y + ring, side_ - 1); ++j) {
      const bool is_edge = j == y - ring || j == y + ring;
      for (long i = x - ring; i <= x + ring; i += is_edge || ring == 0 ? 1 : 2 * ring) {
        if (i < 0 || i >= side_) continue;
        for (const std::size_t k : square(i, j)) {
          const double distance = std::hypot(places_[k].x - at.x, places_[k].y - at.y);
          const bool is_first = distance == best && places_[k].contour < places_[found].contour;
          if (distance > best || (distance == best && !is_first)) continue;
          best = distance;
          found = k;
        }
      }
    }
  }

  std::vector<Place> places_;
  std::vector<std::vector<std::size_t>> squares_;
  double left_ = 0;
  double low_ = 0;
  double step_ = 1;
  long side_ = 1;
  std::size_t rest_ = 0;
};

class InsideOut {
 public:
  InsideOut(const std::vector<DxfContour>& contours, const Nesting& nesting)
      : contours_(contours), inside_(contours.size()) {
    for (std::size_t i = 0; i < contours.size(); ++i) {
      if (nesting.parent[i] == i)
        outermost_.push_back(i);
      else
        inside_[nesting.parent[i]].push_back(i);
    }
  }

  std::vector<std::size_t> run() {
    if (contours_.empty()) return {};
    at_ = spotted(contours_.front().pieces.front().from);
    // A contour waits on the stack until all that lies in it is cut.
    stack_.push_back({NearestFirst(contours_, outermost_), contours_.size()});
    while (!stack_.empty()) {
      Level& level = stack_.back();
      if (level.rest.empty()) {
        if (level.around < contours_.size()) cut(level.around);
        stack_.pop_back();
        continue;
      }
      const std::size_t next = level.rest.take(at_);
      if (inside_[next].empty())
        cut(next);
      else
        stack_.push_back({NearestFirst(contours_, inside_[next]), next});
    }
    return std::move(order_);
  }

 private:
  struct Level {
    NearestFirst rest;
    std::size_t around = 0;
  };

  void cut(std::size_t contour) {
    order_.push_back(contour);
    at_ = spotted(contours_[contour].pieces.back().to);
  }

  const std::vector<DxfContour>& contours_;
  std::vector<std::vector<std::size_t>> inside_;
  std::vector<std::size_t> outermost_;
  std::vector<Level> stack_;
  Spotted at_;
  std::vector<std::size_t> order_;
};

}  // namespace

Nesting nesting_of(const std::vector<DxfContour>& contours) {
  std::vector<Bounds> boxes;
  for (const DxfContour& contour : contours) boxes.push_back(box_of(contour));
  std::vector<double> areas;
  for (const DxfContour& contour : contours)
    areas.push_back(contour.closed ? std::fabs(doubled_area(contour)) : 0);
  Nesting nesting;
  nesting.parent.resize(contours.size());
  std::iota(nesting.parent.begin(), nesting.parent.end(), 0);
  nesting.depth.assign(contours.size(), 0);
  const BoxTree tree(boxes);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const RationalPoint& q = contours[i].pieces.front().from;
    const Spotted at = spotted(q);
    tree.overlapping({at.x, at.y, at.x, at.y}, [&](std::size_t j) {
      if (j == i || !contours[j].closed || !contains(contours[j], q)) return;
      // Of two that begin on each other the larger one is outside.
      const bool is_larger = areas[j] > areas[i] || (areas[j] == areas[i] && j < i);
      if (!is_larger) return;
      ++nesting.depth[i];
      const std::size_t parent = nesting.parent[i];
      if (parent == i || areas[j] < areas[parent]) nesting.parent[i] = j;
    });
  }
  return nesting;
}

double doubled_area(const DxfContour& contour) {
  const Spotted origin = spotted(contour.pieces.front().from);
  double area = 0;
  double size = 0;
  for (const DxfPiece& piece : contour.pieces) {
    const Spotted from = spotted(piece.from);
    const Spotted to = spotted(piece.to);
    const double term =
        (from.x - origin.x) * (to.y - origin.y) - (from.y - origin.y) * (to.x - origin.x);
    area += term;
    size += std::fabs(term);
    if (!piece.circle) continue;
    const double radius = nearest_double(piece.circle->radius());
    double sweep = 2 * std::acos(-1.0);
    if (!piece.is_whole_circle()) {
      const Spotted a = spotted(piece.from - piece.circle->centre());
      const Spotted b = spotted(piece.to - piece.circle->centre());
      const double turn = std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
      const double ahead = radius > 0 ? turn : -turn;
      sweep = ahead < 0 ? ahead + sweep : ahead;
    }
    const double segment = radius * std::fabs(radius) * (sweep - std::sin(sweep));
    area += segment;
    size += std::fabs(segment);
  }
  constexpr double kNothing = 1e-9;
  return std::fabs(area) <= kNothing * size ? 0 : area;
}

std::vector<std::size_t> inside_out(const std::vector<DxfContour>& contours,
                                    const Nesting& nesting) {
  return InsideOut(contours, nesting).run();
}

}  // namespace dgt
