// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "kernel/cgal/raw_crossing.h"
#include "kernel/check.h"
#include "kernel/offset.h"
#include "kernel/offset_raw.h"
#include "kernel/offset_source.h"

namespace dgt {
namespace {

/// The double nearest to an enclosed number, unless the ends of the enclosure round differently.
std::optional<double> rounded(const DoubleDouble& value, double rad) {
  const double low = value.hi + (value.lo - rad * kUp);
  const double high = value.hi + (value.lo + rad * kUp);
  if (low != high) return std::nullopt;
  static const double kZero = std::ldexp(1.0, kZeroExponent);
  if (std::fabs(low) > 2 * kZero) return low;
  return std::nullopt;
}

/// Of two supports that meet at a vertex, the exact crossing lies no farther than this from where
/// doubles have it; those that coincide but for what stand-ins are off cross anywhere. Unit: mm.
constexpr double kSpread = 1e-6;

/// Precondition: the square of a rational.
Rational root_of_square(const Rational& square) {
  return {sqrt(square.get_num()), sqrt(square.get_den())};
}

/// A vertex as the source has it: where two raw pieces cross, or where one begins.
class Vertex {
 public:
  Vertex(std::shared_ptr<const OffsetSource> source, const RegionPiece& piece)
      : source_(std::move(source)), piece_(piece) {}

  [[nodiscard]] Point point() const {
    const EnclosedVector<DoubleDouble> at = fine();
    const auto x = rounded(at.x, at.rad);
    const auto y = rounded(at.y, at.rad);
    if (x && y) return Point::on_demand(*x, *y, [*this] { return exact(); });
    return Point(exact());
  }

 private:
  /// Where double-doubles have the vertex for the distance asked for, as a rule to 2⁻⁹⁰ mm; an
  /// endless radius where they cannot tell.
  [[nodiscard]] EnclosedVector<DoubleDouble> fine() const {
    constexpr double kEndless = 1e300;
    const Enclosed<DoubleDouble> d = source_->fine_distance();
    const Strand<DoubleDouble> a = source_->strand(piece_.cut, d, Vertices::Given);
    if (piece_.cut == piece_.by) return a.from;
    const Crossings<DoubleDouble> c = cross(a, source_->strand(piece_.by, d, Vertices::Given));
    if (!c.decided || c.count == 0) return {0, 0, kEndless};
    const auto far = [&](int i) {
      const auto& at = c.found[static_cast<std::size_t>(i)].at;
      return std::hypot(at.x.hi - piece_.x, at.y.hi - piece_.y);
    };
    return c.found[c.count == 2 && far(1) < far(0) ? 1 : 0].at;
  }

  [[nodiscard]] ExactPoint exact() const {
    if (piece_.cut == piece_.by) return ExactPoint(source_->exact_beginning(piece_.cut));
    // What only touches when the distance is exact may be apart by what stand-ins are off, or
    // shrunk to a point; beyond it, the two cross.
    for (const Rational& beyond : {Rational(0), power_of_two(kContactExponent)}) {
      const Rational d = source_->distance() + beyond;
      const auto one = source_->exact_piece(piece_.cut, d);
      const auto other = source_->exact_piece(piece_.by, d);
      if (!one || !other) continue;
      const auto places = cgal::support_crossings(*one, *other);
      if (!places.empty()) {
        const auto nearest =
            std::ranges::min_element(places, {}, [&](const auto& p) { return off(p); });
        if (!source_->is_parted() || off(*nearest) <= kSpread) return *nearest;
      }
      // The two run along one line or circle: a vertex that only the parting made.
      if (source_->is_parted()) return ExactPoint(nearest_on(*one));
    }
    DGT_CHECK(false);
  }
  [[nodiscard]] double off(const ExactPoint& p) const {
    return std::hypot(nearest_double(p.x) - piece_.x, nearest_double(p.y) - piece_.y);
  }
  /// The place of the support of a raw piece that is nearest to where doubles have the vertex.
  [[nodiscard]] RationalPoint nearest_on(const RawPiece& raw) const {
    const RationalPoint at{Rational(piece_.x), Rational(piece_.y)};
    if (raw.is_line) {
      const Vector w = raw.to - raw.from;
      return raw.from + (dot(at - raw.from, w) / squared_length(w)) * w;
    }
    const Vector out = at == raw.centre ? raw.from - raw.centre : at - raw.centre;
    return raw.centre + root_of_square(raw.squared_radius) * direction_of(out).unit.vector();
  }

  std::shared_ptr<const OffsetSource> source_;
  RegionPiece piece_;
};

}  // namespace

OffsetRegion OffsetRegion::of(std::vector<OffsetLoop> loops) {
  OffsetRegion region;
  for (const OffsetLoop& loop : loops) {
    for (const OffsetPiece& p : loop.pieces) {
      RegionPiece& piece = region.pieces_.emplace_back();
      piece.x = p.from.x();
      piece.y = p.from.y();
      piece.radius = p.is_line ? 0 : nearest_double(p.radius);
    }
    region.first_.push_back(region.pieces_.size());
  }
  region.exact_ = std::move(loops);
  return region;
}

void OffsetRegion::reverse() {
  reverse_loops(exact_);
  for (std::size_t i = 0; i < loops(); ++i) {
    const std::span<RegionPiece> loop{pieces_.data() + first_[i], first_[i + 1] - first_[i]};
    std::ranges::reverse(loop);
    // A piece now begins where the one before it did.
    const RegionPiece last = loop.back();
    for (std::size_t k = loop.size(); k-- > 0;) {
      const RegionPiece& begins = k == 0 ? last : loop[k - 1];
      RegionPiece& piece = loop[k];
      piece.radius = -piece.radius;
      piece.x = begins.x;
      piece.y = begins.y;
      piece.cut = begins.cut;
      piece.by = begins.by;
    }
  }
}

void OffsetRegion::drop(const std::vector<bool>& which) {
  if (std::ranges::find(which, true) == which.end()) return;
  std::vector<std::size_t> first = {0};
  std::size_t kept = 0;
  for (std::size_t i = 0; i < loops(); ++i) {
    if (which[i]) continue;
    for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) pieces_[kept++] = pieces_[k];
    first.push_back(kept);
  }
  pieces_.resize(kept);
  first_ = std::move(first);
}

/// The circle of a raw piece that is an arc, run counter-clockwise: about a corner, or of an edge
/// and of what a sharp corner prolongs it by.
Circle OffsetRegion::circle_of(RawKey on) const {
  const Rational& distance = source_->distance();
  const ChainEdge edge = source_->exact_edge(on.edge());
  const bool round =
      on.part() > 0 &&
      source_
          ->corner_parts(on.edge(), source_->decisive_distance<DoubleDouble>(), Vertices::Decisive)
          .empty();
  if (round) return Circle(edge.to, distance);
  const ChainEdge& own = on.part() == 2 ? source_->exact_edge(source_->next(on.edge())) : edge;
  return Circle(own.centre(), abs(own.radius - distance));
}

std::vector<OffsetLoop> OffsetRegion::exact() const {
  std::vector<OffsetLoop> result = exact_pieces();
  for (OffsetLoop& loop : result) tidy(loop);
  return result;
}

std::vector<OffsetLoop> OffsetRegion::exact_pieces() const {
  if (!source_) return exact_;
  std::vector<OffsetLoop> result;
  for (std::size_t i = 0; i < loops(); ++i) {
    OffsetLoop& exact = result.emplace_back();
    for (const RegionPiece& piece : loop(i)) {
      OffsetPiece& p = exact.pieces.emplace_back();
      p.from = Vertex(source_, piece).point();
      p.on = piece.on;
      p.is_line = piece.radius == 0;
      if (p.is_line) continue;
      const Circle circle = circle_of(piece.on);
      p.centre = circle.centre();
      p.radius = piece.radius < 0 ? Rational(-circle.radius()) : circle.radius();
    }
    for (std::size_t k = 0; k < exact.pieces.size(); ++k)
      exact.pieces[k].to = exact.pieces[(k + 1) % exact.pieces.size()].from;
  }
  return result;
}

}  // namespace dgt
