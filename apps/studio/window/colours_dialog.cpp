// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/colours_dialog.h"

#include <QColorDialog>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace dgt::studio {

ColoursDialog::ColoursDialog(QWidget* parent)
    : QDialog(parent),
      before_(colours()),
      chosen_(before_),
      standard_(new QPushButton(this)),
      ends_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
  auto* const grid = new QGridLayout(this);
  const auto rows = colour_rows();
  const int half = static_cast<int>(rows.size() + 1) / 2;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    auto* const label = new QLabel(this);
    auto* const button = new QPushButton(this);
    button->setObjectName(QString::fromLatin1(rows[i].key));
    label->setBuddy(button);
    const int at = static_cast<int>(i);
    grid->addWidget(label, at % half, at / half * 3);
    grid->addWidget(button, at % half, at / half * 3 + 1);
    connect(button, &QPushButton::clicked, this, [this, i] { choose(i); });
    labels_.push_back(label);
    buttons_.push_back(button);
  }
  grid->setColumnMinimumWidth(2, fontMetrics().averageCharWidth() * 4);
  ends_->addButton(standard_, QDialogButtonBox::ResetRole);
  grid->addWidget(ends_, half, 0, 1, 5);
  connect(standard_, &QPushButton::clicked, this, [this] {
    chosen_ = standard_colours(Appearance::of_program().theme());
    show_chosen();
  });
  connect(ends_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(ends_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(this, &QDialog::rejected, this, [this] {
    chosen_ = before_;
    show_chosen();
  });
  retranslate();
  show_chosen();
}

void ColoursDialog::retranslate() {
  setWindowTitle(tr("Colours"));
  const auto rows = colour_rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    labels_[i]->setText(QCoreApplication::translate("Colours", rows[i].label));
  }
  standard_->setText(tr("Standard colours"));
}

void ColoursDialog::choose(std::size_t row) {
  const QString what = labels_[row]->text();
  QColor& colour = chosen_.*colour_rows()[row].colour;
  const QColor picked = QColorDialog::getColor(colour, this, what);
  if (!picked.isValid()) return;
  colour = picked;
  show_chosen();
}

void ColoursDialog::show_chosen() {
  Appearance& appearance = Appearance::of_program();
  if (appearance.colours() != chosen_) appearance.set(appearance.theme(), chosen_);
  const auto rows = colour_rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    QPixmap sample(fontMetrics().averageCharWidth() * 8, fontMetrics().height());
    sample.fill(chosen_.*rows[i].colour);
    buttons_[i]->setIcon(sample);
    buttons_[i]->setIconSize(sample.size());
  }
}

void ColoursDialog::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

}  // namespace dgt::studio
