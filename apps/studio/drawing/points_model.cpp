// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/points_model.h"

#include <utility>

namespace dgt::studio {
namespace {

QString name_of(const std::optional<MoveKind>& kind) {
  if (!kind) return PointsModel::tr("start");
  switch (*kind) {
    case MoveKind::Line:
      return PointsModel::tr("line");
    case MoveKind::Arc:
      return PointsModel::tr("arc");
    case MoveKind::Rapid:
      return PointsModel::tr("rapid");
    case MoveKind::Dwell:
    case MoveKind::Code:
      break;  // they lead nowhere
  }
  return {};
}

QString figure(double value) { return QString::fromStdString(point_figure(value)); }

QString text(const ControlPoint& point, std::size_t number, int column) {
  switch (column) {
    case PointsModel::Number:
      return QString::number(number);
    case PointsModel::X:
      return figure(point.x);
    case PointsModel::Y:
      return figure(point.y);
    case PointsModel::Kind:
      return name_of(point.kind);
    case PointsModel::CentreX:
      return point.arc ? figure(point.arc->centre_x) : QString();
    case PointsModel::CentreY:
      return point.arc ? figure(point.arc->centre_y) : QString();
    case PointsModel::Radius:
      return point.arc ? figure(signed_radius(*point.arc)) : QString();
    case PointsModel::Height:
      return point.z ? figure(*point.z) : QString();
    default:
      return {};
  }
}

}  // namespace

void PointsModel::show_points(std::vector<ControlPoint> points) {
  beginResetModel();
  points_ = std::move(points);
  endResetModel();
}

void PointsModel::retranslate() {
  emit headerDataChanged(Qt::Horizontal, 0, Columns - 1);
  if (!points_.empty()) emit dataChanged(index(0, Kind), index(rowCount() - 1, Kind));
}

int PointsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(points_.size());
}

int PointsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : Columns;
}

QVariant PointsModel::data(const QModelIndex& index, int role) const {
  const auto row = static_cast<std::size_t>(index.row());
  if (role == Qt::DisplayRole) return text(points_[row], row + 1, index.column());
  if (role == Qt::TextAlignmentRole)
    return int(index.column() == Kind ? Qt::AlignLeft | Qt::AlignVCenter
                                      : Qt::AlignRight | Qt::AlignVCenter);
  return {};
}

QVariant PointsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return int(section == Kind ? Qt::AlignLeft | Qt::AlignVCenter
                               : Qt::AlignRight | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole && section == Radius) return tr("Negative: clockwise");
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case Number:
      return tr("No.");
    case X:
      return QStringLiteral("X");
    case Y:
      return QStringLiteral("Y");
    case Kind:
      return tr("Move");
    case CentreX:
      return tr("Centre X");
    case CentreY:
      return tr("Centre Y");
    case Radius:
      return tr("Radius");
    case Height:
      return QStringLiteral("Z");
    default:
      return {};
  }
}

}  // namespace dgt::studio
