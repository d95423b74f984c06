// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/status_fields.h"

#include <QActionGroup>
#include <QLabel>
#include <QMenu>
#include <QStatusBar>
#include <QToolButton>
#include <algorithm>
#include <array>

#include "apps/studio/window/icons.h"

namespace dgt::studio {
namespace {

constexpr std::array kLineEnds = {LineEnd::Lf, LineEnd::CrLf, LineEnd::Cr};

QString label_of(Encoding encoding) {
  return QString::fromUtf8(name_of(encoding).data(),
                           static_cast<qsizetype>(name_of(encoding).size()));
}

QString label_of(LineEnd end) {
  switch (end) {
    case LineEnd::Lf:
      return QStringLiteral("LF");
    case LineEnd::CrLf:
      return QStringLiteral("CRLF");
    case LineEnd::Cr:
      break;
  }
  return QStringLiteral("CR");
}

QToolButton* button(QStatusBar* bar) {
  auto* const made = new QToolButton(bar);
  made->setAutoRaise(true);
  made->setPopupMode(QToolButton::InstantPopup);
  made->setFocusPolicy(Qt::NoFocus);
  return made;
}

}  // namespace

StatusFields::StatusFields(QStatusBar* bar, QObject* parent)
    : QObject(parent),
      verdict_(button(bar)),
      cursor_(new QLabel(bar)),
      encoding_(button(bar)),
      line_end_(button(bar)),
      encodings_(new QMenu(bar)),
      line_ends_(new QMenu(bar)) {
  verdict_->setObjectName(QStringLiteral("verdict"));
  cursor_->setObjectName(QStringLiteral("cursor"));
  encoding_->setObjectName(QStringLiteral("encoding"));
  line_end_->setObjectName(QStringLiteral("line_end"));
  verdict_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  verdict_->setPopupMode(QToolButton::DelayedPopup);
  connect(verdict_, &QToolButton::clicked, this, &StatusFields::faults_wanted);
  for (QWidget* const field :
       std::initializer_list<QWidget*>{verdict_, cursor_, encoding_, line_end_}) {
    bar->addPermanentWidget(field);
  }
  encoding_->setMenu(encodings_);
  line_end_->setMenu(line_ends_);
  retranslate();
}

void StatusFields::retranslate() {
  encoding_->setToolTip(tr("Encoding of the file"));
  line_end_->setToolTip(tr("Line ends of the file"));
  verdict_->setToolTip(tr("What the compiler says"));
  fill_encodings();
  fill_line_ends();
  show_form(form_);
  show_cursor(line_, column_);
  show_verdict();
}

void StatusFields::fill_encodings() {
  encodings_->clear();
  encodings_->setTitle(tr("&Encoding"));
  encodings_->addSection(tr("Read the file again as"));
  for (const Encoding encoding : kEncodings) {
    connect(encodings_->addAction(label_of(encoding)), &QAction::triggered, this,
            [this, encoding] { emit read_again_wanted(encoding); });
  }
  encodings_->addSection(tr("Save as"));
  auto* const group = new QActionGroup(encodings_);
  for (const Encoding encoding : kEncodings) {
    QAction* const action = encodings_->addAction(label_of(encoding));
    action->setCheckable(true);
    action->setChecked(encoding == form_.encoding);
    group->addAction(action);
    connect(action, &QAction::triggered, this,
            [this, encoding] { emit encoding_chosen(encoding); });
  }
}

void StatusFields::fill_line_ends() {
  line_ends_->clear();
  line_ends_->setTitle(tr("Line end&s"));
  auto* const group = new QActionGroup(line_ends_);
  for (const LineEnd end : kLineEnds) {
    QAction* const action = line_ends_->addAction(label_of(end));
    action->setCheckable(true);
    action->setChecked(end == form_.line_end);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, end] { emit line_end_chosen(end); });
  }
}

void StatusFields::show_cursor(int line, int column) {
  line_ = line;
  column_ = column;
  cursor_->setText(tr("line %1, column %2").arg(line).arg(column));
}

void StatusFields::show_form(const TextForm& form) {
  const bool same = form == form_;
  form_ = form;
  encoding_->setText(label_of(form.encoding));
  line_end_->setText(label_of(form.line_end));
  if (same) return;
  fill_encodings();
  fill_line_ends();
}

void StatusFields::show_working(bool at_work) {
  at_work_ = at_work;
  show_verdict();
}

void StatusFields::show_faults(const std::vector<Fault>& faults) {
  errors_ = static_cast<int>(std::ranges::count(faults, Severity::Error, &Fault::severity));
  warnings_ = static_cast<int>(std::ranges::count(faults, Severity::Warning, &Fault::severity));
  show_verdict();
}

void StatusFields::show_verdict() {
  if (errors_ > 0) {
    verdict_->setIcon(sign_icon(QStringLiteral("error"), &Colours::error));
  } else if (warnings_ > 0) {
    verdict_->setIcon(sign_icon(QStringLiteral("warning"), &Colours::warning));
  } else {
    verdict_->setIcon(sign_icon(QStringLiteral("good"), &Colours::programmed));
  }
  QStringList said;
  if (errors_ > 0) said.push_back(tr("errors: %1").arg(errors_));
  if (warnings_ > 0) said.push_back(tr("warnings: %1").arg(warnings_));
  if (said.isEmpty()) said.push_back(tr("no errors"));
  verdict_->setText(at_work_ ? tr("compiling…") : said.join(QStringLiteral(", ")));
}

}  // namespace dgt::studio
