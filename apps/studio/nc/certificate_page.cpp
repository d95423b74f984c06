// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/nc/certificate_page.h"

#include <QEvent>
#include <QFontDatabase>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QVBoxLayout>

#include "apps/studio/language.h"
#include "apps/studio/window/theme.h"

namespace dgt::studio {
namespace {

constexpr int kLine = Qt::UserRole;
constexpr int kFaultLines = 4;  // of the list that are seen at once
constexpr double kTint = 0.2;   // of the banner's colour in the window's

QColor mixed(const QColor& a, const QColor& b, double part) {
  const auto mix = [part](int x, int y) { return static_cast<int>(x * part + y * (1 - part)); };
  return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

}  // namespace

CertificatePage::CertificatePage(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  banner_ = new QLabel(this);
  banner_->setObjectName(QStringLiteral("banner"));
  banner_->setWordWrap(true);
  banner_->setAutoFillBackground(true);
  banner_->setMargin(fontMetrics().height() / 3);
  faults_ = new QListWidget(this);
  faults_->setObjectName(QStringLiteral("proof_faults"));
  faults_->setWordWrap(true);
  page_ = new QPlainTextEdit(this);
  page_->setObjectName(QStringLiteral("proof_page"));
  page_->setReadOnly(true);
  page_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  column->addWidget(banner_);
  column->addWidget(faults_);
  column->addWidget(page_, 1);
  const auto go = [this](const QListWidgetItem* item) {
    const int line = item->data(kLine).toInt();
    if (line > 0) emit line_chosen(line);
  };
  connect(faults_, &QListWidget::itemClicked, this, go);
  connect(faults_, &QListWidget::itemActivated, this, go);
  connect(&Appearance::of_program(), &Appearance::changed, this, [this] { show_all(); });
  show_all();
}

void CertificatePage::show_proof(const Certificate& proof) {
  proof_ = proof;
  state_ = State::Current;
  show_all();
}

void CertificatePage::show_refusal(const QString& why) {
  why_ = why;
  state_ = State::Refused;
  show_all();
}

void CertificatePage::outdate() {
  if (state_ != State::Current) return;
  state_ = State::Outdated;
  show_all();
}

void CertificatePage::clear() {
  state_ = State::None;
  show_all();
}

void CertificatePage::show_banner(const QString& text, const QColor& colour) {
  QPalette look = palette();
  look.setColor(QPalette::Window, mixed(colour, look.color(QPalette::Window), kTint));
  banner_->setPalette(look);
  banner_->setText(text);
}

void CertificatePage::show_all() {
  const bool has_proof = state_ == State::Current || state_ == State::Outdated;
  faults_->setVisible(has_proof && !proof_.faults.empty());
  page_->setVisible(has_proof);
  page_->setPlainText(has_proof ? QString::fromStdString(to_text(proof_, message_language()))
                                : QString());
  show_faults();
  switch (state_) {
    case State::None:
      show_banner(tr("Not verified yet."), colours().note);
      break;
    case State::Refused:
      show_banner(why_, colours().error);
      break;
    case State::Outdated:
      show_banner(tr("The text was changed after this proof. Verify again."), colours().warning);
      break;
    case State::Current:
      show_banner(proof_.holds() ? tr("Proved: the program runs the exact path.")
                                 : tr("Not proved: the program does not run the exact path."),
                  proof_.holds() ? colours().programmed : colours().error);
      break;
  }
}

void CertificatePage::show_faults() {
  faults_->clear();
  for (const VerifyFault& fault : proof_.faults) {
    auto* item = new QListWidgetItem(
        QString::fromStdString(to_text(fault, proof_, message_language())), faults_);
    item->setData(kLine, fault.first_line);
  }
  const auto rows = std::min<std::size_t>(proof_.faults.size(), kFaultLines);
  faults_->setMaximumHeight(fontMetrics().lineSpacing() * static_cast<int>(rows + 1) * 3 / 2);
}

void CertificatePage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) show_all();
  QWidget::changeEvent(event);
}

}  // namespace dgt::studio
