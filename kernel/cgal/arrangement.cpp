// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/cgal/arrangement.h"

#include <CGAL/Arr_circle_segment_traits_2.h>
#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arrangement_2.h>

#include <map>
#include <queue>
#include <set>

#include "kernel/box_tree.h"
#include "kernel/cgal/types.h"

namespace dgt::cgal {
namespace {

/// How often, net, the raw curves run along an edge of the arrangement from left to right, and the
/// first and last raw piece that does.
struct Count {
  int net = 0;
  RawKey piece;
  RawKey last;
};
struct AddCounts {
  Count operator()(const Count& a, const Count& b) const {
    return {a.net + b.net, a.piece, b.last};
  }
};

using BaseTraits = CGAL::Arr_circle_segment_traits_2<LinearKernel>;
using Traits = CGAL::Arr_curve_data_traits_2<BaseTraits, Count, AddCounts>;
using Arrangement = CGAL::Arrangement_2<Traits>;
using Halfedge = Arrangement::Halfedge_const_handle;
using Face = Arrangement::Face_const_handle;

BaseTraits::Curve_2 to_curve(const RawPiece& piece) {
  using Point = LinearKernel::Point_2;
  const Point from(piece.from.x, piece.from.y);
  const Point to(piece.to.x, piece.to.y);
  if (piece.is_line) return {from, to};
  const LinearKernel::Circle_2 circle(
      Point(piece.centre.x, piece.centre.y), piece.squared_radius,
      piece.counter_clockwise ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE);
  return {circle, BaseTraits::Point_2(from.x(), from.y()), BaseTraits::Point_2(to.x(), to.y())};
}

std::vector<Traits::X_monotone_curve_2> monotone_pieces(const std::vector<RawPiece>& pieces) {
  const BaseTraits traits;
  std::vector<Traits::X_monotone_curve_2> result;
  for (const RawPiece& piece : pieces) {
    std::vector<CGAL::Object> parts;
    traits.make_x_monotone_2_object()(to_curve(piece), std::back_inserter(parts));
    for (const CGAL::Object& part : parts) {
      BaseTraits::X_monotone_curve_2 curve;
      if (CGAL::assign(curve, part))
        result.emplace_back(curve, Count{curve.is_directed_right() ? 1 : -1, piece.key, piece.key});
    }
  }
  return result;
}

/// The winding number rises by the net count of curves from right to left across them.
int step_to_left(Halfedge e) {
  const int count = e->curve().data().net;
  return e->direction() == CGAL::ARR_LEFT_TO_RIGHT ? count : -count;
}

std::map<Face, int> winding_numbers(const Arrangement& arrangement) {
  std::map<Face, int> numbers;
  std::queue<Face> open;
  const Face outside = arrangement.unbounded_face();
  numbers[outside] = 0;
  open.push(outside);
  while (!open.empty()) {
    const Face face = open.front();
    open.pop();
    const int here = numbers.at(face);
    const auto cross_boundary = [&](Arrangement::Ccb_halfedge_const_circulator first) {
      auto e = first;
      do {  // e has the face on its left
        const Face beyond = e->twin()->face();
        if (numbers.try_emplace(beyond, here - step_to_left(e)).second) open.push(beyond);
      } while (++e != first);
    };
    for (auto ccb = face->outer_ccbs_begin(); ccb != face->outer_ccbs_end(); ++ccb)
      cross_boundary(*ccb);
    for (auto ccb = face->inner_ccbs_begin(); ccb != face->inner_ccbs_end(); ++ccb)
      cross_boundary(*ccb);
  }
  return numbers;
}

ExactPoint to_point(const Traits::Point_2& p) {
  const auto coordinate = [](const auto& c) {
    return c.is_extended() ? OneRoot(c.a0(), c.a1(), c.root()) : OneRoot(c.a0());
  };
  return {coordinate(p.x()), coordinate(p.y())};
}

OffsetPiece to_piece(Halfedge e) {
  OffsetPiece piece;
  piece.from = Point(to_point(e->source()->point()));
  piece.to = Point(to_point(e->target()->point()));
  const auto& curve = e->curve();
  piece.on = curve.data().piece;
  piece.is_line = curve.is_linear();
  if (piece.is_line) return piece;
  const auto circle = curve.supporting_circle();
  piece.centre = {circle.center().x(), circle.center().y()};
  // The radii of raw pieces are rational by construction.
  piece.radius = exact_sqrt(circle.squared_radius()).value();
  const bool along = (e->direction() == CGAL::ARR_LEFT_TO_RIGHT) == curve.is_directed_right();
  const bool ccw = (curve.orientation() == CGAL::COUNTERCLOCKWISE) == along;
  if (!ccw) piece.radius = -piece.radius;
  return piece;
}

/// The box of a boundary's vertices, and its lowest vertex with the pieces that meet there.
class Boundary {
 public:
  explicit Boundary(Arrangement::Ccb_halfedge_const_circulator first) {
    auto e = first;
    do {
      all_ = e == first ? box_of(e) : all_.united(box_of(e));
      look_at(e);
    } while (++e != first);
  }
  [[nodiscard]] bool is_minute() const {
    return all_.max_x - all_.min_x < kOffsetResolution &&
           all_.max_y - all_.min_y < kOffsetResolution;
  }
  [[nodiscard]] const OddFace& corner() const { return corner_; }

 private:
  /// Of the ends: CGAL's box of an arc is that of its circle's half. Between its ends an arc that
  /// is monotone in x rises over them by no more than it is wide.
  static Bounds box_of(Halfedge e) {
    const auto& from = e->source()->point();
    const auto& to = e->target()->point();
    const auto [left, right] = std::minmax({CGAL::to_double(from.x()), CGAL::to_double(to.x())});
    const auto [low, high] = std::minmax({CGAL::to_double(from.y()), CGAL::to_double(to.y())});
    return {left, low - (right - left), right, high + (right - left)};
  }
  /// Where two pieces meet comes before where one goes on.
  void look_at(Halfedge e) {
    const auto& at = e->target()->point();
    const Count& count = e->curve().data();
    const bool overlaps = std::abs(count.net) > 1;
    const OddFace here{CGAL::to_double(at.x()), CGAL::to_double(at.y()), count.piece,
                       overlaps ? count.last : e->next()->curve().data().piece,
                       overlaps || e->target()->degree() > 2};
    const auto rank = [](const OddFace& f) { return std::tuple(!f.at_crossing, f.y, f.x); };
    if (!found_ || rank(here) < rank(corner_)) corner_ = here;
    found_ = true;
  }

  Bounds all_;
  OddFace corner_;
  bool found_ = false;
};

}  // namespace

std::optional<OddFace> find_odd_face(const std::vector<RawPiece>& pieces, int wanted) {
  Arrangement arrangement;
  const auto curves = monotone_pieces(pieces);
  CGAL::insert(arrangement, curves.begin(), curves.end());
  std::optional<OddFace> lowest;
  for (const auto& [face, number] : winding_numbers(arrangement)) {
    if (number == wanted || number == wanted - 1 || face->is_unbounded()) continue;
    const Boundary boundary(face->outer_ccb());
    if (boundary.is_minute()) continue;
    const OddFace& corner = boundary.corner();
    if (!lowest || std::pair(corner.y, corner.x) < std::pair(lowest->y, lowest->x)) lowest = corner;
  }
  return lowest;
}

std::vector<OffsetLoop> faces_with_winding_number(const std::vector<RawPiece>& pieces, int wanted) {
  Arrangement arrangement;
  const auto curves = monotone_pieces(pieces);
  CGAL::insert(arrangement, curves.begin(), curves.end());
  const std::map<Face, int> numbers = winding_numbers(arrangement);
  const auto inside = [&](Halfedge e) { return numbers.at(e->face()) == wanted; };

  std::vector<OffsetLoop> loops;
  std::set<Halfedge> used;
  for (auto it = arrangement.halfedges_begin(); it != arrangement.halfedges_end(); ++it) {
    const Halfedge first = it;
    if (!inside(first) || inside(first->twin()) || used.contains(first)) continue;
    OffsetLoop& loop = loops.emplace_back();
    Halfedge e = first;
    do {
      used.insert(e);
      loop.pieces.push_back(to_piece(e));
      // Round the end vertex within the region, over edges that have it on both sides.
      e = e->next();
      while (inside(e->twin())) e = e->twin()->next();
    } while (e != first);
  }
  return loops;
}

}  // namespace dgt::cgal
