// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "kernel/chain.h"

namespace dgt {

/// A control point of a rational Bézier curve in homogeneous form: it stands for (x/w, y/w).
struct BezierPoint {
  Rational x;
  Rational y;
  Rational w = 1;
};

/// The curve Σ Bᵢ(t) (x, y)ᵢ / Σ Bᵢ(t) wᵢ for t from 0 to 1, with the Bernstein polynomials Bᵢ of
/// the degree, one less than there are points. All weights are positive.
using RationalCurve = std::vector<BezierPoint>;

/// Lines and arcs along a curve.
///  (1) Every point of the curve lies within `tolerance` of them, and every point of them within it
///      of the curve. This is proved, not sampled; curve_fit.cpp says how.
///  (2) They begin and end at the ends of the curve, within 2⁻⁵⁶ mm, and follow each other exactly.
///  (3) Pairs of arcs (biarcs) with one tangent, exactly, where they meet; pairs follow each other
///      with one tangent, exactly, where the curve turns by less than 2⁻²⁰. What is straight is one
///      segment.
/// Nothing when more than `most` edges would be needed. A curve of no size has no edges. The curve
/// is given in pieces, each beginning where the one before ends.
/// Preconditions (checked): the pieces follow each other, each has 2 to 33 points and positive
/// weights; tolerance > 0.
[[nodiscard]] std::optional<std::vector<ChainEdge>> arcs_along(
    const std::vector<RationalCurve>& pieces, const Rational& tolerance, std::size_t most);

}  // namespace dgt
