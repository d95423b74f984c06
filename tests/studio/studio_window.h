// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QMessageBox>
#include <QTest>
#include <QTimer>
#include <functional>

#include "apps/studio/window/main_window.h"
#include "tests/studio/qt_values.h"
#include "tests/support/command.h"

namespace dgt::studio {

/// A window in English with settings of its own, as large as the smallest screen.
class StudioWindow : public testing::Test {
 protected:
  void SetUp() override { open_window(); }
  void TearDown() override {
    window->editor().document()->setModified(false);
    window->close();
  }

  /// Another window over the same settings; the one before is gone.
  void open_window() {
    window.reset();
    window = std::make_unique<MainWindow>(MainWindow::Options{Language::English, Theme::Light, {}});
    window->resize(1366, 768);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
    window->editor().setFocus();
  }

  /// Behind a dialog no window is active; elsewhere the desktop sees to that.
  void activate() {
    if (QApplication::activeWindow() != nullptr) return;
    window->activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(window.get()));
  }
  [[nodiscard]] bool editor_has_keyboard() {
    activate();
    return window->editor().hasFocus();
  }
  /// Types at the cursor of the editor, line ends being Enter.
  void type(const QString& text) {
    for (const QChar c : text) {
      if (c == u'\n') {
        press(Qt::Key_Return);
      } else {
        QTest::keyClick(&window->editor(), c.toLatin1());
      }
    }
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    activate();
    QWidget* focus = QApplication::activePopupWidget();
    if (focus == nullptr) focus = QApplication::focusWidget();
    QTest::keyClick(focus != nullptr ? focus : window.get(), key, modifiers);
  }
  /// Until the compiler has answered to the text as it stands.
  bool compiled() {
    return QTest::qWaitFor([this] { return window->compiler().current() != nullptr; }, 20000);
  }
  [[nodiscard]] QString file(const char* name) const {
    return QString::fromStdString(folder.name(name));
  }
  [[nodiscard]] QString text() const { return window->editor().text(); }

  support::TemporaryFolder folder;
  std::unique_ptr<MainWindow> window;
};

/// The dialog that will come up is handed to `answer`, which ends it. The result says whether one
/// came.
class NextDialog : public QObject {
 public:
  explicit NextDialog(std::function<void(QDialog&)> answer) : answer_(std::move(answer)) {
    timer_.setInterval(10);
    connect(&timer_, &QTimer::timeout, this, [this] {
      auto* const dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr || !dialog->isVisible()) return;
      timer_.stop();
      came_ = true;
      answer_(*dialog);
    });
    timer_.start();
  }
  [[nodiscard]] bool came() const { return came_; }

 private:
  std::function<void(QDialog&)> answer_;
  QTimer timer_;
  bool came_ = false;
};

/// What a message box says.
inline QString said_by(const QDialog& box) {
  const auto* const message = qobject_cast<const QMessageBox*>(&box);
  return message == nullptr ? QString() : message->text();
}

/// Clicks a button of a message box by its text.
inline void click(QDialog& box, const QString& label) {
  for (QAbstractButton* const button : box.findChildren<QAbstractButton*>()) {
    QString text = button->text();
    if (text.remove(u'&') != label) continue;
    QTest::mouseClick(button, Qt::LeftButton);
    return;
  }
  ADD_FAILURE() << "no button " << label.toStdString();
  box.reject();
}

}  // namespace dgt::studio
