// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/winding_numbers.h"

#include <cmath>

namespace dgt {
namespace {

/// Of the curve's left, going on along the strand. The second strand passes to the left of the
/// first: going on along the first leaves its left.
int step(const RawPassings& passings, RawPassings::Event e) {
  const int turn = passings.passing(e).turn;
  return e % 2 == 0 ? -turn : turn;
}

template <class Real>
std::optional<EnclosedVector<Real>> middle_of(const Strand<Real>& s) {
  const Enclosed<Real> half{Real(0.5), 0};
  if (s.is_line) return half * (s.from + s.to);
  const EnclosedVector<Real> chord = s.to - s.from;
  const Enclosed<Real> square = dot(chord, chord);
  if (square.sign() <= 0) return std::nullopt;
  const EnclosedVector<Real> out = (s.radius / root(square)) * turned_left(chord);
  return s.counter_clockwise ? s.centre - out : s.centre + out;
}

/// A ray that starts on an arc may meet it once more, mirrored in the vertical through its
/// centre.
template <class Real>
Crossings<Real> own_return(const Strand<Real>& arc, const Strand<Real>& ray) {
  if (arc.is_line) return {};
  const EnclosedVector<Real> out = arc.centre - ray.from;
  const Enclosed<Real> back{out.x, out.rad};
  if (back.sign() < 0) return {};
  EnclosedVector<Real> at = arc.centre;
  at.x = at.x + back.mid;
  at.y = ray.from.y;
  at.rad = (arc.centre.rad + out.rad + ray.from.rad + 0x1p-52 * at.size()) * kUp;
  const int on = crossing::on_arc(arc, at);
  if (on < 0) return {};
  if (on == 0 || back.sign() == 0) return crossing::undecided<Real>();
  Crossings<Real> result;
  result.add({at, {}, arc.counter_clockwise ? 1 : -1});
  return result;
}

}  // namespace

template <class Real>
Strand<Real> WindingNumbers::strand_in(std::uint32_t s) const {
  if constexpr (std::is_same_v<Real, double>)
    return curve_.strand(s);
  else
    return source_.decisive_strand(curve_[s].key);
}

template <class Real>
std::optional<int> WindingNumbers::number_left_of(std::uint32_t probe) const {
  const Strand<Real> s = strand_in<Real>(probe);
  const auto middle = middle_of(s);
  if (!middle) return std::nullopt;
  Strand<Real> ray;
  ray.from = *middle;
  ray.to = {Real(right_ + 1), middle->y, middle->rad};
  // What the strand heads at its middle is its chord.
  const int heading = Enclosed<Real>{s.to.y - s.from.y, 2 * (s.from.rad + s.to.rad)}.sign();
  if (heading == 0) return std::nullopt;
  // The ray leaves to the right of a strand that heads up, to the left of one that heads down.
  int number = heading < 0 ? 0 : 1;
  bool decided = true;
  const double y = coarse(middle->y);
  const double slack = middle->rad + 0x1p-52 * std::fabs(y);
  const Bounds box{coarse(middle->x) - slack - 0x1p-52 * std::fabs(coarse(middle->x)), y - slack,
                   right_ + 1, y + slack};
  tree_->overlapping(box, [&](std::size_t i) {
    if (!decided) return;
    const auto other = static_cast<std::uint32_t>(i);
    const Crossings<Real> c =
        other == probe ? own_return(s, ray) : cross(ray, strand_in<Real>(other));
    decided = c.decided;
    for (int k = 0; k < c.count; ++k) number += c.found[static_cast<std::size_t>(k)].turn;
  });
  if (!decided) return std::nullopt;
  return number;
}

/// The rank of the first event behind the middle of the strand, which halves its chord.
std::optional<std::uint32_t> WindingNumbers::first_behind_middle(std::uint32_t strand) const {
  const Strand<double> s = curve_.strand(strand);
  const EnclosedVector<double> chord = s.to - s.from;
  const Enclosed<double> middle = Enclosed<double>{0.5, 0} * dot(chord, chord);
  std::uint32_t k = passings_.first_rank(strand);
  for (; k < passings_.first_rank(strand + 1); ++k) {
    const int behind =
        (Enclosed<double>{passings_.order()[k].at, passings_.order()[k].rad} - middle).sign();
    if (behind == 0) return std::nullopt;
    if (behind > 0) break;
  }
  return k;
}

/// The winding number left of the middle of some strand of the loop, by a ray to the right.
std::optional<WindingNumbers::Number> WindingNumbers::number_on(std::size_t loop) {
  const std::uint32_t begin = curve_.begin(loop);
  const std::uint32_t end = curve_.end(loop);
  constexpr std::uint32_t kTries = 12;
  for (std::uint32_t n = 0; n < kTries; ++n) {
    // Not at regular steps: contours repeat themselves.
    const std::uint32_t count = end - begin;
    const std::uint32_t probe =
        begin + static_cast<std::uint32_t>(std::uint64_t{count} * n / kTries + n) % count;
    ++counts_.decisions;
    if (!first_behind_middle(probe)) continue;
    if (const auto left = number_left_of<double>(probe)) return Number{probe, *left};
    ++counts_.fine;
    if (const auto left = number_left_of<DoubleDouble>(probe)) return Number{probe, *left};
  }
  return std::nullopt;
}

bool WindingNumbers::carry(const BoxTree& tree, double right) {
  tree_ = &tree;
  right_ = right;
  const auto& order = passings_.order();
  behind_.resize(order.size());
  of_loop_.resize(source_.loops());
  for (std::size_t loop = 0; loop < source_.loops(); ++loop) {
    const auto start = number_on(loop);
    if (!start) return false;
    const auto [probe, number] = *start;
    of_loop_[loop] = number;
    const std::uint32_t begin = passings_.first_rank(curve_.begin(loop));
    const std::uint32_t count = passings_.first_rank(curve_.end(loop)) - begin;
    if (count == 0) continue;
    const auto first = first_behind_middle(probe);
    if (!first) return false;
    int left = number;
    std::uint32_t k = *first == begin + count ? begin : *first;
    for (std::uint32_t n = 0; n < count; ++n) {
      left += step(passings_, order[k].event);
      const std::uint32_t end = k + 1 == begin + count ? begin : k + 1;
      behind_[k] = {left, end};
      k = end;
    }
    // Once round. Where not, the joined curve is not the exact one in something that matters.
    if (left != number) return false;
  }
  return true;
}

}  // namespace dgt
