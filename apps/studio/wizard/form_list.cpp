// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/wizard/form_list.h"

#include <QKeyEvent>
#include <QPixmap>
#include <algorithm>

namespace dgt::studio {
namespace {

constexpr int kLettersWide = 15;  // of a picture
constexpr int kWidth = 4;         // to a height of 3
constexpr int kHeight = 3;
constexpr int kGap = 10;

}  // namespace

FormList::FormList(QWidget* parent) : QListWidget(parent) {
  setViewMode(QListView::IconMode);
  setMovement(QListView::Static);
  setResizeMode(QListView::Adjust);
  setWordWrap(true);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  measure();
  connect(this, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { emit chosen(row(item)); });
}

void FormList::measure() {
  const int width = fontMetrics().horizontalAdvance(u'0') * kLettersWide;
  setIconSize({width, width * kHeight / kWidth});
  const int room = viewport()->width() - kGap;  // some of it the list keeps for itself
  const int columns = std::max(1, room / (width + kGap));
  setGridSize({std::max(width + kGap, room / columns),
               width * kHeight / kWidth + fontMetrics().height() * 2 + kGap});
  for (int i = 0; i < count(); ++i) item(i)->setSizeHint(gridSize());
}

QSize FormList::picture_size() const { return iconSize(); }

void FormList::add(const QString& caption) {
  auto* item = new QListWidgetItem(caption, this);
  item->setSizeHint(gridSize());
  item->setTextAlignment(Qt::AlignHCenter | Qt::AlignTop);
  QPixmap blank(iconSize());  // the place of the picture until it is drawn
  blank.fill(Qt::transparent);
  item->setIcon(blank);
}

void FormList::set_tip(int row, const QString& tip) { item(row)->setToolTip(tip); }

// The same picture when chosen: a tint would change the colours that mean something.
void FormList::set_picture(int row, const QImage& picture) {
  const QPixmap pixmap = QPixmap::fromImage(picture);
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);
  item(row)->setIcon(icon);
}

void FormList::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  const bool chooses = key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter;
  if (chooses && currentRow() >= 0) {
    emit confirmed(currentRow());
  } else {
    QListWidget::keyPressEvent(event);
  }
}

void FormList::resizeEvent(QResizeEvent* event) {
  measure();
  QListWidget::resizeEvent(event);
}

bool FormList::event(QEvent* event) {
  if (event->type() == QEvent::FontChange) measure();
  return QListWidget::event(event);
}

}  // namespace dgt::studio
