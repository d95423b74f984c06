// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "apps/studio/part.h"

namespace dgt::studio {

/// The calculated control points as a table, numbered as in the drawing and by `dgt points`.
class PointsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PointsPanel(QWidget* parent = nullptr);

  void show_part(PartPtr part);

 signals:
  /// A row was chosen: the number of the point, from 1.
  void point_chosen(int number);
  /// Where the move that leads to the chosen point was asked for; see DrawingPanel.
  void place_chosen(int file, int line, int column);

 private:
  PartPtr part_;
};

}  // namespace dgt::studio
