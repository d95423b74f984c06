// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dxf/overlaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include "lang/dxf/grouping.h"

namespace dgt {
namespace {

/// Doubles of coordinates lie this near the numbers they stand for, and more.
constexpr double kNearby = 2e-6;

// --- duplicates

/// A place that two strands of one shape share, within the rounding of doubles, and a size that
/// tells many that share it apart.
struct Feature {
  RationalPoint middle;
  double size = 0;
};

Feature feature_of(const DxfStrand& strand) {
  double x = 0;
  double y = 0;
  const auto count = static_cast<double>(2 * strand.pieces.size());
  double size = 0;
  for (const DxfPiece& piece : strand.pieces) {
    const RationalPoint& from = piece.is_whole_circle() ? piece.circle->centre() : piece.from;
    const RationalPoint& to = piece.is_whole_circle() ? piece.circle->centre() : piece.to;
    const Spotted a = spotted(from);
    const Spotted b = spotted(to);
    x += a.x + b.x;
    y += a.y + b.y;
    size += distance_between(from, to);
    if (piece.circle) size += std::fabs(nearest_double(piece.circle->radius()));
  }
  return {{Rational(x / count), Rational(y / count)}, size};
}

bool are_one(const DxfPiece& a, const DxfPiece& b) {
  if (a.circle.has_value() != b.circle.has_value()) return false;
  if (a.circle) {
    const Rational& one = dxf_one_place();
    if (!are_within(a.circle->centre(), b.circle->centre(), one)) return false;
    if (abs(a.circle->radius() - b.circle->radius()) > one) return false;
  }
  if (a.is_whole_circle() || b.is_whole_circle()) return a.is_whole_circle() && b.is_whole_circle();
  return are_within(a.from, b.from, dxf_one_place()) && are_within(a.to, b.to, dxf_one_place());
}

/// Beginning at any piece of a closed one.
bool are_one_way(const DxfStrand& a, const DxfStrand& b) {
  const std::size_t n = a.pieces.size();
  const std::size_t shifts = a.closed && b.closed ? n : 1;
  for (std::size_t shift = 0; shift < shifts; ++shift) {
    std::size_t i = 0;
    while (i < n && are_one(a.pieces[i], b.pieces[(i + shift) % n])) ++i;
    if (i == n) return true;
  }
  return false;
}

bool are_one(const DxfStrand& a, const DxfStrand& b) {
  if (a.pieces.size() != b.pieces.size() || a.closed != b.closed) return false;
  return are_one_way(a, b) || are_one_way(a, reversed(b)) ||
         (a.pieces.front().is_whole_circle() && are_one(a.pieces.front(), b.pieces.front()));
}

// --- overlaps

/// A stretch of a line or of a circle that carries several pieces.
struct Interval {
  double begin = 0;
  double end = 0;
  const DxfPiece* piece = nullptr;
};

/// What pieces on one curve have in common, exactly.
using Curve = std::tuple<int, Rational, Rational, Rational>;

Curve line_of(const DxfPiece& piece) {
  const Vector w = piece.to - piece.from;
  if (abs(w.x) >= abs(w.y)) {
    const Rational slope = w.y / w.x;
    return {0, slope, piece.from.y - slope * piece.from.x, 0};
  }
  const Rational slope = w.x / w.y;
  return {1, slope, piece.from.x - slope * piece.from.y, 0};
}

Interval interval_on_line(const DxfPiece& piece, int kind) {
  const Spotted from = spotted(piece.from);
  const Spotted to = spotted(piece.to);
  const auto [low, high] = kind == 0 ? std::minmax(from.x, to.x) : std::minmax(from.y, to.y);
  return {low, high, &piece};
}

/// In mm along the circle, from the angle 0; what passes it goes on beyond the whole length.
Interval interval_on_circle(const DxfPiece& piece) {
  const double radius = std::fabs(nearest_double(piece.circle->radius()));
  const double turn = 2 * std::numbers::pi;
  if (piece.is_whole_circle()) return {0, turn * radius, &piece};
  const auto angle = [&](const RationalPoint& p) {
    const Spotted out = spotted(p - piece.circle->centre());
    const double a = std::atan2(out.y, out.x);
    return a < 0 ? a + turn : a;
  };
  const bool ccw = piece.circle->counter_clockwise();
  const double begin = angle(ccw ? piece.from : piece.to);
  double end = angle(ccw ? piece.to : piece.from);
  if (end <= begin) end += turn;
  return {begin * radius, end * radius, &piece};
}

struct Overlap {
  std::size_t count = 0;
  double longest = 0;
  const DxfPiece* piece = nullptr;

  void add(double length, const DxfPiece* at) {
    if (length <= kNearby) return;
    ++count;
    if (length <= longest) return;
    longest = length;
    piece = at;
  }
};

/// Each stretch against the one that reaches farthest of those that begin before it.
void sweep(std::vector<Interval>& intervals, Overlap& overlap) {
  std::ranges::sort(intervals, {}, &Interval::begin);
  double reach = intervals.front().end;
  for (std::size_t i = 1; i < intervals.size(); ++i) {
    overlap.add(std::min(reach, intervals[i].end) - intervals[i].begin, intervals[i].piece);
    reach = std::max(reach, intervals[i].end);
  }
}

}  // namespace

void remove_duplicates(std::vector<DxfStrand>& strands, DiagnosticBag& bag) {
  std::vector<RationalPoint> middles;
  std::vector<double> sizes;
  std::vector<std::size_t> all;
  for (const DxfStrand& strand : strands) {
    Feature feature = feature_of(strand);
    all.push_back(middles.size());
    middles.push_back(std::move(feature.middle));
    sizes.push_back(feature.size);
  }
  Groups groups = grouped(middles, all, dxf_one_place());
  std::ranges::stable_sort(all, {},
                           [&](std::size_t i) { return std::pair(groups.of(i), sizes[i]); });
  std::vector<bool> is_double(strands.size(), false);
  std::size_t count = 0;
  std::size_t first = strands.size();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (is_double[all[i]]) continue;
    const double slack = kNearby * static_cast<double>(3 * strands[all[i]].pieces.size());
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      if (groups.of(all[j]) != groups.of(all[i]) || sizes[all[j]] > sizes[all[i]] + slack) break;
      if (is_double[all[j]] || !are_one(strands[all[i]], strands[all[j]])) continue;
      const std::size_t later = std::max(all[i], all[j]);
      is_double[later] = true;
      ++count;
      first = std::min(first, later);
      if (later == all[i]) break;
    }
  }
  if (count == 0) return;
  bag.add({Message::DxfDuplicates, strands[first].place(), {std::to_string(count)}});
  std::vector<DxfStrand> kept;
  for (std::size_t i = 0; i < strands.size(); ++i)
    if (!is_double[i]) kept.push_back(std::move(strands[i]));
  strands = std::move(kept);
}

void report_overlaps(const std::vector<DxfStrand>& strands, DiagnosticBag& bag) {
  std::map<Curve, std::vector<Interval>> curves;
  for (const DxfStrand& strand : strands) {
    for (const DxfPiece& piece : strand.pieces) {
      if (piece.circle) {
        const Circle& circle = *piece.circle;
        curves[{2, circle.centre().x, circle.centre().y, abs(circle.radius())}].push_back(
            interval_on_circle(piece));
      } else {
        Curve line = line_of(piece);
        const int kind = std::get<0>(line);
        curves[std::move(line)].push_back(interval_on_line(piece, kind));
      }
    }
  }
  Overlap overlap;
  for (auto& [curve, intervals] : curves) {
    if (std::get<0>(curve) == 2) {
      // What passes the angle 0 is seen from behind it, too.
      const double turn = 2 * std::numbers::pi * nearest_double(std::get<3>(curve));
      const std::size_t count = intervals.size();
      for (std::size_t i = 0; i < count && count > 1; ++i) {
        const Interval on = intervals[i];
        if (on.end > turn) intervals.push_back({0, on.end - turn, on.piece});
      }
    }
    sweep(intervals, overlap);
  }
  if (overlap.count == 0) return;
  bag.add({Message::DxfOverlaps,
           overlap.piece->place,
           {std::to_string(overlap.count), fmt::format("{:.6g}", overlap.longest)}});
}

}  // namespace dgt
