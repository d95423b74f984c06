// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/readout.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QStringList>
#include <QVBoxLayout>
#include <algorithm>

#include "apps/studio/drawing/figure_text.h"
#include "apps/studio/window/settings_store.h"

namespace dgt::studio {
namespace {

const QString kFactorKey = QStringLiteral("drawing/factor");

}  // namespace

Readout::Readout(QWidget* parent)
    : QWidget(parent),
      x_(new QLabel(this)),
      y_(new QLabel(this)),
      factor_name_(new QLabel(this)),
      factor_(new QDoubleSpinBox(this)),
      told_(new QLabel(this)) {
  factor_->setRange(1.1, 100);
  factor_->setDecimals(1);
  factor_->setSingleStep(0.5);
  factor_->setValue(SettingsStore().panel(kFactorKey, 2.0).toDouble());
  factor_name_->setBuddy(factor_);
  told_->setWordWrap(true);
  for (QLabel* label : {x_, y_}) label->setTextFormat(Qt::PlainText);
  x_->setObjectName(QStringLiteral("x"));
  y_->setObjectName(QStringLiteral("y"));
  told_->setObjectName(QStringLiteral("lengths"));

  auto* upper = new QHBoxLayout;
  upper->addWidget(x_);
  upper->addWidget(y_);
  upper->addStretch(1);
  upper->addWidget(factor_name_);
  upper->addWidget(factor_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 2, 4, 2);
  column->setSpacing(2);
  column->addLayout(upper);
  column->addWidget(told_);
  connect(factor_, &QDoubleSpinBox::valueChanged, this, [this](double factor) {
    SettingsStore().set_panel(kFactorKey, factor);
    emit factor_changed(factor);
  });
  retranslate();
}

void Readout::show_scene(const ScenePtr& scene) {
  part_ = scene ? scene->path.part_box() : Box{};
  all_ = scene ? scene->path.box() : Box{};
  lengths_ = scene ? scene->lengths : std::nullopt;
  refresh();
}

void Readout::show_lengths(const std::optional<WayLengths>& lengths) {
  lengths_ = lengths;
  refresh();
}

void Readout::set_decimals(int decimals) {
  decimals_ = decimals;
  refresh();
}

double Readout::factor() const { return factor_->value(); }

void Readout::show_pointer(double x, double y) {
  pointer_ = {x, y};
  refresh();
}

void Readout::show_no_pointer() {
  pointer_.reset();
  refresh();
}

void Readout::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  if (event->type() == QEvent::FontChange) refresh();
  QWidget::changeEvent(event);
}

void Readout::retranslate() {
  factor_name_->setText(tr("&Zoom by a click:"));
  factor_->setPrefix(QStringLiteral("× "));
  factor_->setAccessibleName(tr("Factor by which a click magnifies"));
  factor_->setToolTip(factor_->accessibleName());
  x_->setAccessibleName(tr("X of the pointer, mm"));
  y_->setAccessibleName(tr("Y of the pointer, mm"));
  told_->setToolTip(
      tr("Contour: what is programmed (W = 0). Path: what the tool cuts. Approaches and "
         "departures are counted in both."));
  refresh();
}

void Readout::refresh() {
  const auto text = [this](const QString& axis, double value) {
    return axis + u' ' + figure_text(value, decimals_);
  };
  const QString none = QStringLiteral("—");
  x_->setText(pointer_ ? text(QStringLiteral("X"), pointer_->x) : QStringLiteral("X ") + none);
  y_->setText(pointer_ ? text(QStringLiteral("Y"), pointer_->y) : QStringLiteral("Y ") + none);
  // As wide as the longest they will show, so that nothing jumps about.
  for (QLabel* label : {x_, y_}) {
    double far = 1;
    if (!all_.empty())
      far = std::max({far, std::abs(all_.left), std::abs(all_.right), std::abs(all_.bottom),
                      std::abs(all_.top)});
    const QString longest = text(QStringLiteral("Y"), -20 * far);
    label->setMinimumWidth(label->fontMetrics().horizontalAdvance(longest));
  }
  told_->setText(lengths_text());
}

QString Readout::lengths_text() const {
  QStringList parts;
  if (lengths_) {
    parts << tr("Contour %1 mm").arg(figure_text(lengths_->programmed, decimals_))
          << tr("Path %1 mm").arg(figure_text(lengths_->cut, decimals_));
    if (lengths_->rapid > 0)
      parts << tr("Rapids %1 mm").arg(figure_text(lengths_->rapid, decimals_));
  }
  if (!part_.empty())
    parts << tr("Part %1 × %2 mm")
                 .arg(figure_text(part_.width(), decimals_))
                 .arg(figure_text(part_.height(), decimals_));
  // A line ends between two of them, never within.
  for (QString& part : parts) part.replace(u' ', QChar::Nbsp);
  return parts.join(QStringLiteral("    "));
}

}  // namespace dgt::studio
