// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/notice_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

namespace dgt::studio {

NoticeBar::NoticeBar(QWidget* parent)
    : QFrame(parent), text_(new QLabel(this)), row_(new QHBoxLayout(this)) {
  setObjectName(QStringLiteral("notice"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::ToolTipBase);
  text_->setWordWrap(true);
  row_->setContentsMargins(8, 4, 8, 4);
  row_->addWidget(text_, 1);
  hide();
}

void NoticeBar::show_notice(Notice notice) {
  const auto same = std::ranges::find(notices_, notice.subject, &Notice::subject);
  if (same != notices_.end()) {
    *same = std::move(notice);
  } else {
    notices_.push_back(std::move(notice));
  }
  show_first();
}

void NoticeBar::withdraw(const QString& subject) {
  std::erase_if(notices_, [&](const Notice& notice) { return notice.subject == subject; });
  show_first();
}

void NoticeBar::show_first() {
  if (buttons_ != nullptr) {
    buttons_->hide();
    buttons_->deleteLater();
    buttons_ = nullptr;
  }
  setVisible(!notices_.empty());
  if (notices_.empty()) return;
  const Notice& notice = notices_.front();
  text_->setText(notice.text());
  buttons_ = new QWidget(this);
  auto* const row = new QHBoxLayout(buttons_);
  row->setContentsMargins(0, 0, 0, 0);
  for (std::size_t i = 0; i < notice.answers.size(); ++i) {
    auto* const button = new QPushButton(notice.answers[i].label(), buttons_);
    button->setObjectName(QStringLiteral("answer%1").arg(i));
    connect(button, &QPushButton::clicked, this, [this, i] { answer(i); });
    row->addWidget(button);
  }
  row_->addWidget(buttons_);
  buttons_->show();
}

// The notice goes first: what is done may bring another.
void NoticeBar::answer(std::size_t which) {
  const Notice notice = notices_.front();
  notices_.pop_front();
  show_first();
  if (notice.answers[which].act) notice.answers[which].act();
}

void NoticeBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) show_first();
}

}  // namespace dgt::studio
