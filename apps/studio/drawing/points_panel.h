// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "apps/studio/background.h"
#include "apps/studio/drawing/points_model.h"
#include "apps/studio/part.h"

class QLabel;
class QTableView;
class QToolButton;

namespace dgt::studio {

/// The calculated control points as a table, numbered as in the drawing and by `dgt points`.
class PointsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PointsPanel(QWidget* parent = nullptr);

  /// A part with errors leaves the last good points.
  void show_part(PartPtr part);
  /// The chosen points, or all of them, as `dgt points` lists them.
  [[nodiscard]] QString text() const;
  [[nodiscard]] QTableView& table() { return *table_; }
  [[nodiscard]] bool is_settled() const { return !work_.is_busy(); }

 public slots:
  void choose_point(int number);  ///< from 1

 signals:
  /// A row was chosen: the number of the point, from 1.
  void point_chosen(int number);
  /// Enter or a double click on a row: where the move that leads to its point was asked for; see
  /// DrawingPanel.
  void place_chosen(int file, int line, int column);
  void settled();

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void retranslate();
  void copy();
  void go_to_source(int row);
  void show_count();

  bool is_good_ = true;
  PointsModel model_;
  QLabel* count_;
  QToolButton* copy_;
  QTableView* table_;
  Background work_{this};
};

}  // namespace dgt::studio
