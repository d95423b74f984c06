// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>
#include <QWidget>

#include "apps/studio/part.h"

namespace dgt::studio {

/// The drawing of the guide: the programmed contour, the equidistant, rapids and the tool.
class DrawingPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DrawingPanel(QWidget* parent = nullptr);

  /// A part with errors leaves the last good drawing, greyed.
  void show_part(PartPtr part);
  /// Lights the moves that were asked for in a line of the source (`file` counts into
  /// Toolpath::files, lines from 1; line 0: none).
  void light_line(int file, int line);
  /// The whole drawing on paper: black and coloured lines on white.
  void paint(QPainter& painter, const QRect& where);

 public slots:
  void show_programmed(bool shown);  ///< the contour with W = 0
  void fit();                        ///< the whole part in view

 signals:
  /// A move was clicked: where it was asked for. Counted as in light_line, columns from 1.
  void place_chosen(int file, int line, int column);
  void programmed_shown(bool shown);

 private:
  PartPtr part_;
};

}  // namespace dgt::studio
