// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFontMetrics>
#include <QLabel>
#include <QPainter>

namespace dgt::studio {

/// One line that never makes its window wider: what has no room is told by its tool tip.
class ElidedLabel : public QLabel {
 public:
  explicit ElidedLabel(QWidget* parent = nullptr) : QLabel(parent) {
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    setTextFormat(Qt::PlainText);
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    const QString seen = fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width());
    setToolTip(seen == text() ? QString() : text());
    QPainter(this).drawText(contentsRect(), int(Qt::AlignVCenter | Qt::AlignLeft), seen);
  }
};

}  // namespace dgt::studio
