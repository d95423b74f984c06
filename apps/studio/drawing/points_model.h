// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "apps/driver/points.h"

namespace dgt::studio {

/// Control points as rows; row r is point r + 1.
class PointsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column : int { Number, X, Y, Kind, CentreX, CentreY, Radius, Height, Columns };

  using QAbstractTableModel::QAbstractTableModel;
  void show_points(std::vector<ControlPoint> points);
  void retranslate();
  [[nodiscard]] const std::vector<ControlPoint>& points() const { return points_; }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;

 private:
  std::vector<ControlPoint> points_;
};

}  // namespace dgt::studio
