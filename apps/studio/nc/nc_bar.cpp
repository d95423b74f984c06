// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/nc/nc_bar.h"

#include <QComboBox>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "apps/studio/flow_layout.h"
#include "apps/studio/window/icons.h"

namespace dgt::studio {

NcBar::NcBar(QWidget* parent) : QWidget(parent) {
  new FlowLayout(this);
  dialect_ = add("dialect", QStringLiteral("nc"));
  auto* pair = new QWidget(this);
  auto* row = new QHBoxLayout(pair);
  row->setContentsMargins(0, 0, 0, 0);
  compensation_label_ = new QLabel(pair);
  compensation_ = new QComboBox(pair);
  compensation_->setObjectName(QStringLiteral("compensation"));
  compensation_->addItems({QString(), QString()});
  compensation_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  compensation_label_->setBuddy(compensation_);
  row->addWidget(compensation_label_);
  row->addWidget(compensation_);
  layout()->addWidget(pair);
  save_ = add("save", QStringLiteral("save"));
  save_as_ = add("save_as", QStringLiteral("save_as"));
  copy_ = add("copy", QStringLiteral("copy"));
  print_ = add("print", QStringLiteral("print"));
  punch_ = add("punch", QStringLiteral("tape"));
  verify_ = add("verify", QStringLiteral("good"));
  of_program_ = {save_, save_as_, copy_, print_, punch_, verify_};
  connect(dialect_, &QToolButton::clicked, this, &NcBar::dialect_wanted);
  connect(compensation_, &QComboBox::activated, this, [this](int index) {
    emit compensation_chosen(index == 0 ? Compensation::Computed : Compensation::Control);
  });
  connect(save_, &QToolButton::clicked, this, &NcBar::save_wanted);
  connect(save_as_, &QToolButton::clicked, this, &NcBar::save_as_wanted);
  connect(copy_, &QToolButton::clicked, this, &NcBar::copy_wanted);
  connect(print_, &QToolButton::clicked, this, &NcBar::print_wanted);
  connect(punch_, &QToolButton::clicked, this, &NcBar::punch_wanted);
  connect(verify_, &QToolButton::clicked, this, &NcBar::verify_wanted);
  retranslate();
}

QToolButton* NcBar::add(const char* name, const QString& picture) {
  auto* button = new QToolButton(this);
  button->setObjectName(QString::fromLatin1(name));
  button->setIcon(icon(picture));
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);
  layout()->addWidget(button);
  return button;
}

void NcBar::show_dialect(const QString& name) {
  dialect_name_ = name.endsWith(QStringLiteral(".toml")) ? QFileInfo(name).fileName() : name;
  retranslate();
}

void NcBar::show_compensation(Compensation compensation) {
  compensation_->setCurrentIndex(compensation == Compensation::Computed ? 0 : 1);
}

void NcBar::enable(bool has_program) {
  for (QToolButton* const button : of_program_) button->setEnabled(has_program);
  if (has_program) verify_->setEnabled(!is_verifying_);
}

void NcBar::show_verifying(bool busy) {
  is_verifying_ = busy;
  verify_->setEnabled(!busy && save_->isEnabled());
  retranslate();
}

void NcBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void NcBar::retranslate() {
  dialect_->setText(dialect_name_.isEmpty() ? tr("Choose the control…") : dialect_name_);
  dialect_->setToolTip(tr("Write the program for another control (F8)"));
  compensation_label_->setText(tr("Offset:"));
  compensation_->setItemText(0, tr("computed"));
  compensation_->setItemText(1, tr("by the control"));
  compensation_->setToolTip(tr(
      "Who offsets contours with W: the equidistant is written, or the contour with the words by "
      "which the control offsets it itself"));
  save_->setText(tr("Save"));
  save_->setToolTip(tr("Save the NC program as it stands (Ctrl+S)"));
  save_as_->setText(tr("Save as…"));
  save_as_->setToolTip(tr("Save the NC program under another name"));
  copy_->setText(tr("Copy"));
  copy_->setToolTip(tr("Copy the whole NC program, or what is selected of it"));
  print_->setText(tr("Print…"));
  print_->setToolTip(tr("Print the NC program"));
  punch_->setText(tr("Punch…"));
  punch_->setToolTip(tr("Punch the NC program onto paper tape"));
  verify_->setText(is_verifying_ ? tr("Verifying…") : tr("Verify"));
  verify_->setToolTip(
      tr("Prove that the text, as it stands, runs the exact path of the part: every block"));
  updateGeometry();
}

}  // namespace dgt::studio
