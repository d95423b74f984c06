// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/raw_curve.h"

#include <algorithm>
#include <array>

namespace dgt {
namespace {

/// With c the chord, an arc of at most half a turn rises by c²/4 / (r + √(r² − c²/4)) ≤ c²/4r, and
/// by no more than r.
void set_rise(RawStrand& s, double to_x, double to_y) {
  if (s.is_line) return;
  const double most = s.radius + s.radius_rad;
  const double least = s.radius - s.radius_rad;
  const double wx = std::fabs(to_x - s.x) + 2.0 * s.ends_rad;
  const double wy = std::fabs(to_y - s.y) + 2.0 * s.ends_rad;
  const double square = (wx * wx + wy * wy) * kUp;
  s.rise = rounded_up(4 * least * most <= square ? most : square / (4 * least) * kUp);
}

/// p + d n: what n is off by, what d is, and three roundings.
double moved_rad(const EdgeInDoubles& e, double size, const Enclosed<double>& d) {
  return d.mid * (e.normal_rad + 0x1p-51) + d.rad * kUp + 0x1p-51 * size;
}

}  // namespace

RawCurve::RawCurve(const OffsetSource& source) {
  strands_.reserve(2 * source.edges() + source.loops());
  first_.reserve(source.loops() + 1);
  for (std::size_t loop = 0; loop < source.loops(); ++loop) lay(source, loop);
  first_.push_back(static_cast<std::uint32_t>(strands_.size()));
}

void RawCurve::lay(const OffsetSource& source, std::size_t loop) {
  const Enclosed<double>& d = source.decisive_distance<double>();
  const double slack = source.slack();
  const std::uint32_t first = source.first(loop);
  const std::uint32_t end = source.first(loop + 1);
  const std::size_t begin = strands_.size();
  first_.push_back(static_cast<std::uint32_t>(begin));
  const auto begin_at = [&](RawStrand& s, double x, double y, double nx, double ny, double rad) {
    s.x = x + d.mid * nx;
    s.y = y + d.mid * ny;
    s.ends_rad = rounded_up(rad);
  };

  const EdgeInDoubles first_edge = source.in_doubles(first);
  std::array<EdgeInDoubles, 2> edges = {source.in_doubles(end - 1), first_edge};
  JointTurn joint = source.joint(end - 1, edges[0], edges[1]);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  double twice_area = 0;
  double most_of_arcs = 0;  // segments of arcs take no more than π/8 of the square of their chord
  for (std::uint32_t i = first; i < end; ++i) {
    // The edge, from the normal at its beginning, which a tangent joint shares with the one before.
    EdgeInDoubles& next = edges[(i - first) % 2];  // for now, the one before
    const EdgeInDoubles& e = edges[(i - first + 1) % 2];
    RawStrand& s = strands_.emplace_back();
    const double size = std::fabs(e.x) + std::fabs(e.y) + slack;
    if (joint == JointTurn::Tangent)
      begin_at(s, e.x, e.y, next.end_x, next.end_y, moved_rad(next, size, d));
    else
      begin_at(s, e.x, e.y, e.start_x, e.start_y, moved_rad(e, size, d));
    low = std::min(low, e.x);
    high = std::max(high, e.x);
    s.key = RawKey(i, 0);
    s.is_line = e.is_line || source.shrinks_to_chord(e);
    if (!s.is_line) {
      s.counter_clockwise = e.counter_clockwise;
      s.centre_x = e.x + e.radius * e.start_x;
      s.centre_y = e.y + e.radius * e.start_y;
      const double r = std::fabs(e.radius);
      s.centre_rad = rounded_up(r * (e.normal_rad + 0x1p-51) + e.radius_rad * kUp + 0x1p-51 * size);
      s.radius = std::fabs(e.radius - d.mid);
      s.radius_rad = rounded_up(e.radius_rad + d.rad + 0x1p-52 * (r + d.mid));
    }
    // The corner behind it.
    source.in_doubles(i + 1 == end ? first : i + 1, next);
    twice_area += (e.x - first_edge.x) * (next.y - first_edge.y) -
                  (next.x - first_edge.x) * (e.y - first_edge.y);
    if (!e.is_line)
      most_of_arcs += (next.x - e.x) * (next.x - e.x) + (next.y - e.y) * (next.y - e.y);
    joint = source.joint(i, e, next);
    if (joint == JointTurn::Tangent) continue;
    if (joint == JointTurn::Right && source.options().corner != OffsetCorner::Round &&
        lay_corner(source, i))
      continue;
    const double to_size = std::fabs(next.x) + std::fabs(next.y) + slack;
    RawStrand& c = strands_.emplace_back();
    begin_at(c, next.x, next.y, e.end_x, e.end_y, moved_rad(e, to_size, d));
    c.key = RawKey(i, 1);
    c.is_line = false;
    c.counter_clockwise = joint == JointTurn::Left;
    c.centre_x = next.x;
    c.centre_y = next.y;
    c.centre_rad = rounded_up(0x1p-52 * to_size);
    c.radius = d.mid;
    c.radius_rad = rounded_up(d.rad);
  }
  strands_[begin].first = true;
  strands_.back().last = true;
  RawStrand& copy = strands_.emplace_back(strands_[begin]);
  copy.first = false;
  copy.rise = -1;  // no strand
  for (std::size_t i = begin; i + 1 < strands_.size(); ++i) {
    strands_[i].ends_rad = std::max(strands_[i].ends_rad, strands_[i + 1].ends_rad);
    set_rise(strands_[i], strands_[i + 1].x, strands_[i + 1].y);
  }
  if (high - low > width_) {
    width_ = high - low;
    const double sense = std::fabs(twice_area) > most_of_arcs ? twice_area : source.area(loop);
    region_number_ = sense < 0 || source.is_slit() ? 0 : 1;
  }
}

bool RawCurve::lay_corner(const OffsetSource& source, std::uint32_t i) {
  const auto parts =
      source.corner_parts(i, source.decisive_distance<DoubleDouble>(), Vertices::Decisive);
  const auto rad = [](const auto& v) { return rounded_up(v.rad + 0x1p-52 * v.size()); };
  std::uint32_t part = 0;
  for (const Strand<DoubleDouble>& p : parts) {
    RawStrand& s = strands_.emplace_back();
    s.x = p.from.x.hi;
    s.y = p.from.y.hi;
    s.ends_rad = rad(p.from);
    s.key = RawKey(i, ++part);
    s.is_line = p.is_line;
    s.counter_clockwise = p.counter_clockwise;
    if (p.is_line) continue;
    s.centre_x = p.centre.x.hi;
    s.centre_y = p.centre.y.hi;
    s.centre_rad = rad(p.centre);
    s.radius = p.radius.mid.hi;
    s.radius_rad = rad(p.radius);
  }
  return !parts.empty();
}

std::size_t RawCurve::loop_of(std::uint32_t strand) const {
  const auto behind = std::upper_bound(first_.begin(), first_.end(), strand);
  return static_cast<std::size_t>(behind - first_.begin()) - 1;
}

Bounds RawCurve::box(std::uint32_t i) const {
  const RawStrand& s = strands_[i];
  if (s.rise < 0) {
    constexpr double kFar = 1e30;  // within a float
    return {kFar, kFar, -kFar, -kFar};
  }
  const RawStrand& to = strands_[i + 1];
  Bounds box{std::min(s.x, to.x), std::min(s.y, to.y), std::max(s.x, to.x), std::max(s.y, to.y)};
  const double out = (static_cast<double>(s.ends_rad) + s.centre_rad + s.radius_rad) * kUp;
  if (!s.is_line) {
    // The arc reaches an extreme of its circle unless that lies surely to the chord's other side.
    // Flat arcs need no such care.
    const double sense = s.counter_clockwise ? 1 : -1;
    const double wx = sense * (to.x - s.x);
    const double wy = sense * (to.y - s.y);
    const double chord = std::fabs(wx) + std::fabs(wy);
    if (s.rise < 0.05 * chord) return box.grown(s.rise + out);
    const double margin = 4 * out * (chord + s.radius + out) + 0x1p-49 * chord * (chord + s.radius);
    // cross(w, c + r e − from) for the four directions e
    const double base = wx * (s.centre_y - s.y) - wy * (s.centre_x - s.x) - margin;
    if (base <= wy * s.radius) box.max_x = std::max(box.max_x, s.centre_x + s.radius);
    if (base <= -wy * s.radius) box.min_x = std::min(box.min_x, s.centre_x - s.radius);
    if (base <= -wx * s.radius) box.max_y = std::max(box.max_y, s.centre_y + s.radius);
    if (base <= wx * s.radius) box.min_y = std::min(box.min_y, s.centre_y - s.radius);
  }
  return box.grown(out);
}

}  // namespace dgt
