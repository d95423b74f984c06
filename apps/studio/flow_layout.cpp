// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/flow_layout.h"

#include <QStyle>
#include <QWidget>
#include <algorithm>

namespace dgt::studio {

FlowLayout::FlowLayout(QWidget* parent) : QLayout(parent) { setContentsMargins(0, 0, 0, 0); }
FlowLayout::~FlowLayout() = default;

void FlowLayout::addItem(QLayoutItem* item) { items_.emplace_back(item); }

QLayoutItem* FlowLayout::itemAt(int index) const {
  return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)].get() : nullptr;
}

QLayoutItem* FlowLayout::takeAt(int index) {
  if (index < 0 || index >= count()) return nullptr;
  const auto at = items_.begin() + index;
  QLayoutItem* const item = at->release();
  items_.erase(at);
  return item;
}

int FlowLayout::heightForWidth(int width) const { return lay_out({0, 0, width, 0}, false); }

QSize FlowLayout::minimumSize() const {
  QSize size;
  for (const auto& item : items_) size = size.expandedTo(item->minimumSize());
  return size;
}

void FlowLayout::setGeometry(const QRect& place) {
  QLayout::setGeometry(place);
  (void)lay_out(place, true);
}

int FlowLayout::lay_out(const QRect& place, bool moves) const {
  const int gap = parentWidget()->style()->pixelMetric(QStyle::PM_LayoutHorizontalSpacing) + 4;
  int x = place.x();
  int y = place.y();
  int row_height = 0;
  for (const auto& item : items_) {
    const QSize size = item->sizeHint();
    if (x > place.x() && x + size.width() > place.right() + 1) {
      x = place.x();
      y += row_height + gap / 2;
      row_height = 0;
    }
    if (moves) item->setGeometry({{x, y}, size});
    x += size.width() + gap;
    row_height = std::max(row_height, size.height());
  }
  return y + row_height - place.y();
}

}  // namespace dgt::studio
