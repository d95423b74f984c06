// SPDX-License-Identifier: GPL-3.0-or-later
// A program that is killed: what was typed is offered again.
#include <gmock/gmock.h>

#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QPushButton>

#include "tests/studio/studio_window.h"

namespace dgt::studio {
namespace {

class KilledProgram : public StudioWindow {
 protected:
  void SetUp() override {
    QDir(Recovery::standard_folder()).removeRecursively();
    StudioWindow::SetUp();
  }

  /// Another process types this and is killed.
  void type_and_be_killed(const QString& typed, const QString& name = {}) {
    QProcess other;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("DGT_STUDIO_DOOMED"), typed);
    environment.insert(QStringLiteral("DGT_STUDIO_FILE"), name);
    other.setProcessEnvironment(environment);
    other.start(QCoreApplication::applicationFilePath(), {});
    ASSERT_TRUE(other.waitForReadyRead(30000)) << other.readAllStandardError().toStdString();
    ASSERT_EQ(other.readLine().trimmed(), "kept");
    // While it lives its text is nobody else's.
    window->offer_recovery();
    EXPECT_FALSE(window->notices().isVisible());
    other.kill();
    ASSERT_TRUE(other.waitForFinished());
  }
  void answer(int which) {
    auto* const bar = &window->notices();
    ASSERT_TRUE(bar->isVisible());
    QTest::mouseClick(bar->findChild<QPushButton*>(QStringLiteral("answer%1").arg(which)),
                      Qt::LeftButton);
  }
  [[nodiscard]] static qsizetype kept_texts() {
    return QDir(Recovery::standard_folder())
        .entryList({QStringLiteral("*.text")}, QDir::Files)
        .size();
  }
};

TEST_F(KilledProgram, LeavesANewTextThatComesBack) {
  type_and_be_killed(QStringLiteral("L1=X0 R7"));
  window->offer_recovery();
  answer(0);
  EXPECT_EQ(text(), QStringLiteral("L1=X0 R7"));
  EXPECT_TRUE(window->editor().document()->isModified());
  // It is kept under our name before the other goes.
  EXPECT_TRUE(QTest::qWaitFor([] { return kept_texts() == 1; }, 5000));
  window->editor().document()->setModified(false);
  window->close();
  EXPECT_TRUE(QTest::qWaitFor([] { return kept_texts() == 0; }, 5000));
}

TEST_F(KilledProgram, LeavesTheChangesOfAFileInItsForm) {
  const std::string bytes =
      encode("' Контур детали\nL1=X5\n", {.encoding = Encoding::Cp866, .line_end = LineEnd::CrLf})
          .bytes;
  folder.write("part.bgt", bytes);
  type_and_be_killed(QStringLiteral("L9=Y9 "), file("part.bgt"));
  EXPECT_EQ(support::read_text(folder.path() / "part.bgt"), bytes);
  window->offer_recovery();
  answer(0);
  EXPECT_EQ(text().toStdString(), "L9=Y9 ' Контур детали\nL1=X5\n");
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(support::read_text(folder.path() / "part.bgt"), "L9=Y9 " + bytes);
}

TEST_F(KilledProgram, TextThatNobodyWantsGoesForGood) {
  type_and_be_killed(QStringLiteral("L1=X0"));
  window->offer_recovery();
  answer(1);
  EXPECT_EQ(kept_texts(), 0);
  EXPECT_EQ(text(), QString());
}

TEST_F(KilledProgram, TextForLaterIsOfferedAgain) {
  type_and_be_killed(QStringLiteral("L1=X0"));
  window->offer_recovery();
  answer(2);
  EXPECT_FALSE(window->notices().isVisible());
  open_window();
  window->offer_recovery();
  EXPECT_TRUE(window->notices().isVisible());
}

TEST_F(KilledProgram, WhatIsSavedOrTakenBackIsNotKept) {
  type(QStringLiteral("L1=X5"));
  ASSERT_TRUE(QTest::qWaitFor([] { return kept_texts() == 1; }, 15000));
  while (window->editor().document()->isUndoAvailable()) press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(QTest::qWaitFor([] { return kept_texts() == 0; }, 5000));
}

}  // namespace
}  // namespace dgt::studio
