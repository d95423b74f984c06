// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dgt::studio {
namespace {

constexpr double kLeastSide = 1e-3;  // mm: a drawing of one point is shown about that large

double reach(const Box& box) {
  if (box.empty()) return 1;
  const double far = std::max(
      {std::fabs(box.left), std::fabs(box.right), std::fabs(box.bottom), std::fabs(box.top)});
  return std::max(far, kLeastSide);
}

}  // namespace

Box SheetView::window(double pixels) const {
  const double half_width = (size.width() / 2 + pixels) / scale;
  const double half_height = (size.height() / 2 + pixels) / scale;
  return {centre.x - half_width, centre.y - half_height, centre.x + half_width,
          centre.y + half_height};
}

SheetView SheetView::zoomed(double factor, QPointF about) const {
  const DrawnPlace fixed = place(about);
  SheetView view = *this;
  view.scale *= factor;
  view.centre = {fixed.x - (about.x() - size.width() / 2) / view.scale,
                 fixed.y + (about.y() - size.height() / 2) / view.scale};
  return view;
}

SheetView SheetView::moved(QPointF by) const {
  SheetView view = *this;
  view.centre = {centre.x - by.x() / scale, centre.y + by.y() / scale};
  return view;
}

SheetView SheetView::fitting(const Box& box, QSizeF size, double margin) {
  SheetView view;
  view.size = size;
  if (box.empty()) return view;
  const double border = 2 * margin * std::min(size.width(), size.height());
  const double width = std::max(box.width(), kLeastSide);
  const double height = std::max(box.height(), kLeastSide);
  view.centre = {box.left + box.width() / 2, box.bottom + box.height() / 2};
  view.scale =
      std::max(std::min((size.width() - border) / width, (size.height() - border) / height),
               coarsest_scale(box));
  return view;
}

double finest_scale(const Box& box) {
  constexpr double kSteps = 16;
  return 1 / (kSteps * std::numeric_limits<double>::epsilon() * reach(box));
}

double coarsest_scale(const Box& box) {
  constexpr double kPixels = 1;
  return kPixels / (2 * reach(box));
}

}  // namespace dgt::studio
