// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/points_panel.h"

#include <QClipboard>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <memory>
#include <span>
#include <utility>

namespace dgt::studio {

PointsPanel::PointsPanel(QWidget* parent)
    : QWidget(parent),
      count_(new QLabel(this)),
      copy_(new QToolButton(this)),
      table_(new QTableView(this)) {
  table_->setModel(&model_);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setAlternatingRowColors(true);
  table_->setTabKeyNavigation(false);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);  // rows are many and alike
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() * 3 / 2);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->installEventFilter(this);
  copy_->setAutoRaise(true);

  auto* row = new QHBoxLayout;
  row->setContentsMargins(4, 2, 4, 2);
  row->addWidget(count_, 1);
  row->addWidget(copy_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addLayout(row);
  column->addWidget(table_, 1);
  setFocusProxy(table_);

  connect(copy_, &QToolButton::clicked, this, &PointsPanel::copy);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& now) {
            if (now.isValid()) emit point_chosen(now.row() + 1);
          });
  connect(table_, &QTableView::activated, this,
          [this](const QModelIndex& chosen) { go_to_source(chosen.row()); });
  retranslate();
}

void PointsPanel::show_part(PartPtr part) {
  is_good_ = part && part->path() != nullptr;
  work_.forget();
  show_count();
  if (!is_good_) return;
  work_.ask([this, part = std::move(part)]() -> Background::Outcome {
    auto points = std::make_shared<std::vector<ControlPoint>>(control_points(*part->path()));
    return [this, points] {
      const bool has_heights =
          std::ranges::any_of(*points, [](const auto& p) { return p.z.has_value(); });
      model_.show_points(std::move(*points));
      table_->setColumnHidden(PointsModel::Height, !has_heights);
      table_->resizeColumnsToContents();
      show_count();
      emit settled();
    };
  });
}

void PointsPanel::choose_point(int number) {
  if (number < 1 || number > model_.rowCount()) return;
  table_->selectRow(number - 1);
}

void PointsPanel::go_to_source(int row) {
  const SourcePlace& place = model_.points()[static_cast<std::size_t>(row)].source;
  if (place.line == 0) return;
  emit place_chosen(static_cast<int>(place.file), static_cast<int>(place.line),
                    static_cast<int>(place.column));
}

QString PointsPanel::text() const {
  const std::span<const ControlPoint> points = model_.points();
  QModelIndexList rows = table_->selectionModel()->selectedRows();
  if (rows.size() < 2) return QString::fromStdString(list_points(points));
  std::ranges::sort(rows, {}, &QModelIndex::row);
  std::string text;
  for (const QModelIndex& index : rows) {
    const auto row = static_cast<std::size_t>(index.row());
    text += list_points(points.subspan(row, 1), row + 1);
  }
  return QString::fromStdString(text);
}

void PointsPanel::copy() { QGuiApplication::clipboard()->setText(text()); }

bool PointsPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_ && event->type() == QEvent::KeyPress) {
    if (static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
      copy();
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void PointsPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void PointsPanel::retranslate() {
  copy_->setText(tr("&Copy"));
  copy_->setToolTip(tr("The chosen points as text, or all of them (Ctrl+C)"));
  table_->setAccessibleName(tr("Control points"));
  model_.retranslate();
  table_->resizeColumnsToContents();
  show_count();
}

void PointsPanel::show_count() {
  QString text = tr("Points: %1").arg(model_.rowCount());
  if (!is_good_)
    text += QStringLiteral(". ") + tr("The program has errors: they are of an earlier text.");
  count_->setText(text);
}

}  // namespace dgt::studio
