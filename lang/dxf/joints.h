// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lang/dxf/chaining.h"

namespace dgt {

/// A contour as it grows strand by strand, its ends moved together.
class Joining {
 public:
  /// Behind what there is.
  void add(DxfStrand strand);
  /// Joins the end to the beginning.
  void close();
  /// The contour; arcs with moved ends are put right. Empty afterwards.
  [[nodiscard]] DxfContour finish();

  [[nodiscard]] bool empty() const { return pieces_.empty(); }
  [[nodiscard]] bool ends_in_circle() const { return pieces_.back().piece.is_whole_circle(); }
  [[nodiscard]] const RationalPoint& end() const { return pieces_.back().piece.to; }
  [[nodiscard]] const RationalPoint& begin() const { return pieces_.front().piece.from; }
  /// The first strand, the other way round. Precondition: it is the only one.
  void turn_round();

  /// Tells how many ends were moved in all contours, and by how much at most.
  void tell_gaps(DiagnosticBag& bag) const;

 private:
  struct Kept {
    DxfPiece piece;
    bool given = true;  ///< its ends are coordinates of the drawing
    bool minor = true;  ///< an arc of less than half a turn, as drawn
    double moved = 0;   ///< how far its ends are from where the drawing has them, together; mm
  };
  void meet(Kept& before, Kept& behind);
  void count(double gap, const Range& place);
  static void append_fitted(std::vector<DxfPiece>& out, const Kept& kept);

  std::vector<Kept> pieces_;
  bool closed_ = false;
  std::size_t joined_ = 0;
  double largest_gap_ = 0;
  Range widest_;
};

}  // namespace dgt
