// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "apps/driver/certificate.h"

class QLabel;
class QListWidget;
class QPlainTextEdit;

namespace dgt::studio {

/// The proof of an NC program: whether it holds, what is wrong, the page of figures.
class CertificatePage : public QWidget {
  Q_OBJECT

 public:
  explicit CertificatePage(QWidget* parent = nullptr);

  void show_proof(const Certificate& proof);
  /// Why there is no proof.
  void show_refusal(const QString& why);
  /// The text is another now: what is shown held for the one before.
  void outdate();
  void clear();
  [[nodiscard]] bool is_clear() const { return state_ == State::None; }

 signals:
  /// A block that is to blame, from 1.
  void line_chosen(int line);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  enum class State : std::uint8_t { None, Refused, Current, Outdated };
  void show_all();
  void show_banner(const QString& text, const QColor& colour);
  void show_faults();

  State state_ = State::None;
  Certificate proof_;
  QString why_;
  QLabel* banner_;
  QListWidget* faults_;
  QPlainTextEdit* page_;
};

}  // namespace dgt::studio
