// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace dgt::studio {

class SourceEditor;

/// The line numbers at the left of the editor, with a mark at lines that have faults. A click
/// selects the line.
class LineMargin : public QWidget {
 public:
  explicit LineMargin(SourceEditor* editor);

  [[nodiscard]] int wanted_width() const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  SourceEditor* editor_;
};

}  // namespace dgt::studio
