// SPDX-License-Identifier: GPL-3.0-or-later
// A morning's work: a program is typed, mended, drawn, stepped through, written for a control and
// saved; the file is the command's.
#include <gmock/gmock.h>

#include <QFile>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTextBlock>
#include <QTreeWidget>

#include "apps/studio/drawing/canvas.h"
#include "tests/studio/studio_window.h"

namespace dgt::studio {
namespace {

using Panel = Panels::Panel;

class Machinist : public StudioWindow {
 protected:
  [[nodiscard]] bool draws() const {
    return QTest::qWaitFor(
        [this] {
          return window->panels().drawing->is_settled() &&
                 window->panels().drawing->tool().steps() > 0;
        },
        20000);
  }
  /// F8, and the dialect of that name in the dialog that comes.
  void choose_dialect(const QString& name) {
    NextDialog dialog([&](QDialog& box) {
      auto* const list = box.findChild<QTreeWidget*>();
      ASSERT_NE(list, nullptr);
      const auto found = list->findItems(name, Qt::MatchExactly);
      ASSERT_FALSE(found.isEmpty());
      list->setCurrentItem(found.first());
      QTest::keyClick(list, Qt::Key_Return);
      if (box.isVisible()) box.accept();
    });
    press(Qt::Key_F8);
    EXPECT_TRUE(QTest::qWaitFor([&] { return dialog.came(); }, 20000));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window->panels().nc->program().isEmpty(); }, 20000));
  }
  /// Ctrl+S, and the name in the dialog that comes.
  void save_as(const QString& name) {
    NextDialog dialog([&](QDialog& box) {
      auto* const line = box.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
      ASSERT_NE(line, nullptr);
      line->setText(name);
      QTest::keyClick(line, Qt::Key_Return);
    });
    press(Qt::Key_S, Qt::ControlModifier);
    EXPECT_TRUE(QTest::qWaitFor([&] { return dialog.came(); }, 20000));
  }
};

TEST_F(Machinist, TypesMendsDrawsStepsAndSavesWhatTheCommandWrites) {
  type(
      QStringLiteral("L1=X0\nL2=Y0\nL3=X40\nL4=Y30\nP1=X20 Y-5\nG54 P1\n"
                     "K1 W0.1 P1 L2 R5 L-3 R5 L-4 R5 L1 R5 L22 P1\n"));
  ASSERT_TRUE(compiled());
  ASSERT_EQ(window->compiler().current()->path(), nullptr);
  // The slip has a squiggle; F4 goes there, and the number is put right.
  press(Qt::Key_F4);
  EXPECT_EQ(window->editor().current_line(), 7);
  const QString line = window->editor().textCursor().block().text();
  EXPECT_EQ(window->editor().textCursor().positionInBlock(), line.indexOf(QStringLiteral("L22")));
  for (int i = 0; i < 3; ++i) press(Qt::Key_Delete);
  type(QStringLiteral("L2"));
  ASSERT_TRUE(compiled());
  ASSERT_NE(window->compiler().current()->path(), nullptr)
      << tip_of(window->editor().faults().front()).toStdString();
  save_as(file("plate.bgt"));
  EXPECT_EQ(support::read_text(folder.path() / "plate.bgt"), text().toStdString());

  press(Qt::Key_F5);
  ASSERT_TRUE(draws());
  ToolRun& tool = window->panels().drawing->tool();
  press(Qt::Key_Home);
  const std::size_t before = tool.place().steps;
  press(Qt::Key_Space);
  press(Qt::Key_Space);
  EXPECT_EQ(tool.place().steps, before + 2);

  choose_dialect(QStringLiteral("essi"));
  EXPECT_TRUE(window->panels().is_shown(Panel::Nc));
  activate();
  EXPECT_TRUE(window->panels().has_keyboard(Panel::Nc));
  save_as(file("plate.ess"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(file("plate.ess")); }, 10000));
  const support::Outcome command = support::run_dgt(
      {"compile", folder.name("plate.bgt"), "--post", "essi", "-o", folder.name("command.ess")});
  ASSERT_EQ(command.exit_code, 0) << command.err;
  EXPECT_EQ(support::read_text(folder.path() / "plate.ess"),
            support::read_text(folder.path() / "command.ess"));

  press(Qt::Key_Escape);
  EXPECT_FALSE(window->panels().is_shown(Panel::Nc));
  EXPECT_TRUE(editor_has_keyboard());
}

TEST_F(Machinist, GetsTheCommandsBytesInEveryDialectForEverySample) {
  for (const char* const sample : {"1P.bgt", "3P.bgt", "5P.bgt"}) {
    ASSERT_TRUE(window->open_file(QString::fromStdString(support::corpus(sample))));
    ASSERT_TRUE(compiled());
    press(Qt::Key_F5);
    for (const char* const dialect : {"essi", "plasmatic", "linuxcnc"}) {
      window->panels().show(Panel::Nc);
      window->panels().nc->set_dialect(QString::fromLatin1(dialect));
      QSignalSpy written(window->panels().nc, &NcPanel::written);
      const support::Outcome command =
          support::run_dgt({"compile", support::corpus(sample), "--post", dialect});
      ASSERT_EQ(command.exit_code, 0) << command.err;
      EXPECT_TRUE(QTest::qWaitFor(
          [&] { return window->panels().nc->program().toStdString() == command.out; }, 10000))
          << sample << " " << dialect;
    }
  }
}

TEST_F(Machinist, ClicksTheWizardAndTheLineStandsInTheProgram) {
  emit window->panels().wizard->line_finished(QStringLiteral("L1=X72"));
  emit window->panels().wizard->line_finished(QStringLiteral("L2=Y5"));
  EXPECT_EQ(text(), QStringLiteral("L1=X72\nL2=Y5"));
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(text(), QStringLiteral("L1=X72"));
}

TEST_F(Machinist, ClicksAMoveAndItsLineIsFound) {
  ASSERT_TRUE(window->open_file(QString::fromStdString(support::corpus("5P.bgt"))));
  ASSERT_TRUE(compiled());
  press(Qt::Key_F5);
  ASSERT_TRUE(draws());
  emit window->panels().drawing->place_chosen(0, 13, 12);
  EXPECT_EQ(window->editor().current_line(), 13);
  // Space goes on stepping, and never into the program.
  EXPECT_TRUE(window->panels().has_keyboard(Panel::Drawing));
}

TEST_F(Machinist, SeesTheFaultsOfAProgramThatCannotBeWritten) {
  type(QStringLiteral("L1=X\n"));
  press(Qt::Key_F8);
  ASSERT_TRUE(compiled());
  EXPECT_FALSE(window->panels().is_shown(Panel::Nc));
  EXPECT_EQ(window->editor().current_line(), 1);
}

}  // namespace
}  // namespace dgt::studio
