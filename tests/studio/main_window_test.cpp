// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/main_window.h"

#include <gmock/gmock.h>

#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolBar>

#include "apps/studio/help/help_window.h"
#include "apps/studio/window/colours_dialog.h"
#include "tests/studio/studio_window.h"

namespace dgt::studio {
namespace {

using Panel = Panels::Panel;

class MainWindowOfTheGuide : public StudioWindow {};

TEST_F(MainWindowOfTheGuide, HasThreeMenusAndFourGroupsOfTools) {
  EXPECT_EQ(window->menuBar()->actions().size(), 3);
  const auto* const tools = window->findChild<QToolBar*>(QStringLiteral("tools"));
  qsizetype separators = 0;
  for (const QAction* const action : tools->actions()) {
    separators += action->isSeparator() ? 1 : 0;
    if (action->isSeparator() || action->text().isEmpty()) continue;
    EXPECT_FALSE(action->icon().isNull()) << action->text().toStdString();
    EXPECT_FALSE(action->icon().pixmap(24).toImage().isNull());
  }
  EXPECT_EQ(separators, 3);
}

TEST_F(MainWindowOfTheGuide, F10OpensTheMenu) {
  press(Qt::Key_F10);
  EXPECT_EQ(window->menuBar()->activeAction(), window->menuBar()->actions().first());
}

TEST_F(MainWindowOfTheGuide, EscOffersToExit) {
  {
    NextDialog dialog([](QDialog& box) { click(box, QStringLiteral("No")); });
    press(Qt::Key_Escape);
    EXPECT_TRUE(dialog.came());
    EXPECT_TRUE(window->isVisible());
  }
  NextDialog dialog([](QDialog& box) { click(box, QStringLiteral("Yes")); });
  press(Qt::Key_Escape);
  EXPECT_TRUE(dialog.came());
  EXPECT_FALSE(window->isVisible());
}

TEST_F(MainWindowOfTheGuide, EscLeavesAPanelFirst) {
  press(Qt::Key_F7);
  EXPECT_TRUE(window->panels().is_shown(Panel::InternalForm));
  EXPECT_FALSE(editor_has_keyboard());
  press(Qt::Key_Escape);
  EXPECT_FALSE(window->panels().is_shown(Panel::InternalForm));
  EXPECT_TRUE(editor_has_keyboard());
  press(Qt::Key_F5);
  EXPECT_FALSE(editor_has_keyboard());
  press(Qt::Key_Escape);
  EXPECT_TRUE(window->panels().is_shown(Panel::Drawing));
  EXPECT_TRUE(editor_has_keyboard());
}

TEST_F(MainWindowOfTheGuide, AllOfItIsOnASmallScreen) {
  EXPECT_LE(window->minimumSizeHint().width(), 1366);
  EXPECT_LE(window->minimumSizeHint().height(), 768 - 40);  // the system's bar
  EXPECT_EQ(window->size(), QSize(1366, 768));
  EXPECT_GE(window->editor().viewport()->width(),
            40 * window->editor().fontMetrics().horizontalAdvance(u'0'));
}

TEST_F(MainWindowOfTheGuide, RemembersItsPanels) {
  window->findChild<QDockWidget*>(QStringLiteral("wizard_dock"))->hide();
  window->close();
  open_window();
  EXPECT_FALSE(window->findChild<QDockWidget*>(QStringLiteral("wizard_dock"))->isVisible());
  EXPECT_TRUE(window->findChild<QDockWidget*>(QStringLiteral("drawing_dock"))->isVisible());
}

TEST_F(MainWindowOfTheGuide, RemembersThemeFontAndColours) {
  window->actions().dark->trigger();
  EXPECT_EQ(Appearance::of_program().theme(), Theme::Dark);
  window->actions().font_larger->trigger();
  const int points = window->editor().font().pointSize();
  NextDialog dialog([](QDialog& box) {
    auto* const colour = box.findChild<QPushButton*>(QStringLiteral("equidistant"));
    NextDialog inner([](QDialog& picker) { picker.reject(); });
    QTest::mouseClick(colour, Qt::LeftButton);
    EXPECT_TRUE(inner.came());
    box.accept();
  });
  window->actions().colours->trigger();
  EXPECT_TRUE(dialog.came());
  SettingsStore().set_theme(Theme::Dark);
  Colours mine = standard_colours(Theme::Dark);
  mine.equidistant = QColor(Qt::cyan);
  SettingsStore().set_colours(Theme::Dark, mine);
  window.reset();
  window = std::make_unique<MainWindow>(MainWindow::Options{Language::English, {}, {}});
  EXPECT_EQ(Appearance::of_program().theme(), Theme::Dark);
  EXPECT_EQ(colours(), mine);
  EXPECT_EQ(window->editor().font().pointSize(), points);
  Appearance::of_program().set(Theme::Light, standard_colours(Theme::Light));
}

TEST_F(MainWindowOfTheGuide, DrawsAsOneTypesOnlyWhenThatIsWanted) {
  ASSERT_TRUE(window->actions().live->isChecked());
  window->actions().live->trigger();
  EXPECT_FALSE(SettingsStore().draws_live());
}

TEST_F(MainWindowOfTheGuide, AnswersToOlderTextAreDropped) {
  QSignalSpy made(&window->compiler(), &LiveCompiler::made);
  type(QStringLiteral("L1=X0\n"));
  window->actions().draw->trigger();
  window->editor().setFocus();
  type(QStringLiteral("L2=X0\n"));
  ASSERT_TRUE(compiled());
  for (const QList<QVariant>& answer : made) {
    const auto part = answer.at(0).value<PartPtr>();
    if (part == window->compiler().current()) continue;
    EXPECT_LT(part->revision, window->compiler().current()->revision);
  }
  EXPECT_EQ(window->compiler().current()->compilation.file->text(), "L1=X0\nL2=X0\n");
}

TEST_F(MainWindowOfTheGuide, F1ExplainsTheWordAtTheCursor) {
  type(QStringLiteral("C1=P1 R5"));
  press(Qt::Key_F1);
  bool shown = false;
  for (const QWidget* const top : QApplication::topLevelWidgets()) {
    shown = shown || (qobject_cast<const HelpWindow*>(top) != nullptr && top->isVisible());
  }
  EXPECT_TRUE(shown);
}

TEST_F(MainWindowOfTheGuide, ShowsWhatItWillPrint) {
  type(QStringLiteral("L1=X0\nP1=X0 Y0\nP2=X5 Y5\nG54 P1\nK1 P1 P2\n"));
  ASSERT_TRUE(compiled());
  for (QAction* const print : {window->actions().print_source, window->actions().print_drawing}) {
    QImage page;
    NextDialog dialog([&](QDialog& box) {
      QTest::qWait(200);  // the preview paints its pages when it is seen
      page = box.grab().toImage();
      box.reject();
    });
    print->trigger();
    EXPECT_TRUE(dialog.came());
    EXPECT_FALSE(page.isNull());
  }
}

TEST_F(MainWindowOfTheGuide, NoKeyOfAMenuIsGivenTwice) {
  for (const bool russian : {false, true}) {
    (russian ? window->actions().russian : window->actions().english)->trigger();
    QCoreApplication::processEvents();
    for (const QMenu* const menu : window->menuBar()->findChildren<QMenu*>()) {
      QString taken;
      for (const QAction* const action : menu->actions()) {
        const QString text = action->text();
        const qsizetype at = text.indexOf(u'&');
        if (action->isSeparator() || at < 0 || !action->isVisible()) continue;
        const QChar key = text[at + 1].toUpper();
        EXPECT_FALSE(taken.contains(key))
            << menu->title().toStdString() << ": " << text.toStdString();
        taken += key;
      }
    }
  }
  window->actions().english->trigger();
  QCoreApplication::processEvents();
}

TEST_F(MainWindowOfTheGuide, ABadMachineFileIsToldAndNotUsed) {
  folder.write("bad.toml", "rapid_spead = 5\n");
  window.reset();
  window = std::make_unique<MainWindow>(
      MainWindow::Options{Language::English, Theme::Light, file("bad.toml")});
  window->show();
  EXPECT_TRUE(window->notices().isVisible());
}

}  // namespace
}  // namespace dgt::studio
