// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <deque>
#include <functional>
#include <vector>

class QHBoxLayout;
class QLabel;

namespace dgt::studio {

/// Something that waits for a decision and stops nobody until then. Texts are asked for anew when
/// the language changes.
struct Notice {
  using Words = std::function<QString()>;
  struct Answer {
    Words label;
    std::function<void()> act;
  };
  QString subject;  ///< a later notice about the same takes its place
  Words text;
  std::vector<Answer> answers;
};

/// The bar above the text: one notice at a time, those that came first in front.
class NoticeBar : public QFrame {
  Q_OBJECT

 public:
  explicit NoticeBar(QWidget* parent = nullptr);

  void show_notice(Notice notice);
  void withdraw(const QString& subject);
  [[nodiscard]] bool is_empty() const { return notices_.empty(); }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void show_first();
  void answer(std::size_t which);

  std::deque<Notice> notices_;
  QLabel* text_;
  QWidget* buttons_ = nullptr;
  QHBoxLayout* row_;
};

}  // namespace dgt::studio
