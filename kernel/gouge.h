// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "kernel/stretch.h"

/// Whether the tool, a disc on its way along the equidistant, cuts into the programmed contour. The
/// equidistant of a contour is local: each element is offset and met with its neighbours. This
/// looks at all the others.
namespace dgt {

/// A tool that comes nearer to the contour than its radius by no more than this does no harm that
/// anything could show. 10⁻⁸ mm: ten times kLegResolution, by which legs that were left out may
/// move their neighbours' ends, and far above the 2⁻⁷⁰ of a contact.
[[nodiscard]] const Rational& gouge_resolution();

/// One stretch of a path with what it comes from.
struct CutPiece {
  Stretch stretch;
  Rational reach;        ///< |offset| of its element, mm: the tool keeps at least this far away
  std::size_t item = 0;  ///< of the contour
};

struct Gouge {
  std::size_t path = 0;        ///< the stretch of the equidistant
  std::size_t programmed = 0;  ///< the stretch of the contour it cuts into
  double depth = 0;            ///< mm, as measured; that it is one is exact
  double x = 0, y = 0;         ///< where the tool stands then
};

/// The stretches of a programmed contour, ready to be asked which of them a tool cuts into.
class Walls {
 public:
  /// `tolerance`, in mm, is allowed on top of the resolution.
  Walls(std::vector<CutPiece> programmed, Rational tolerance);

  /// Calls visit(wall) for each stretch that `path` comes nearer to than their reach: exactly, by
  /// more than the resolution and the tolerance. Of two different reaches the smaller counts: the
  /// larger is an allowance there. Stretches that the item of `path` crosses on the programmed
  /// contour already do not count: a loop about a corner is meant.
  void cut_by(const CutPiece& path, const std::function<void(std::size_t)>& visit) const;
  [[nodiscard]] bool any_cut_by(const CutPiece& path) const;

  [[nodiscard]] const std::vector<CutPiece>& pieces() const { return pieces_; }

 private:
  /// What decides about one stretch: its balls, and the distance to keep from or with it.
  struct Gauge {
    StretchBalls balls;
    Rational kept;
    Ball kept_ball;
  };
  [[nodiscard]] Gauge gauge_of(const CutPiece& piece) const;
  [[nodiscard]] bool too_near(const CutPiece& path, const Gauge& gauge, std::size_t wall) const;
  [[nodiscard]] bool meant(std::size_t item, std::size_t wall) const;

  std::vector<CutPiece> pieces_;
  Rational allowed_;
  std::vector<Gauge> gauges_;
  BoxTree tree_;
  std::vector<std::pair<std::size_t, std::size_t>> pieces_of_;  ///< item, piece; sorted
};

/// Every stretch of `path` that cuts into one of the walls, each pair of items once, at its
/// deepest, in the order of the path.
[[nodiscard]] std::vector<Gouge> find_gouges(const std::vector<CutPiece>& path, const Walls& walls);

}  // namespace dgt
