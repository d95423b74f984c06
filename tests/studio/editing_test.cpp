// SPDX-License-Identifier: GPL-3.0-or-later
// The editor in its window: faults as one types, cures, completion, formatting, finding.
#include <gmock/gmock.h>

#include <QCheckBox>
#include <QLineEdit>
#include <QTextBlock>
#include <QToolTip>

#include "apps/studio/editor/completion.h"
#include "tests/studio/studio_window.h"

namespace dgt::studio {
namespace {

using testing::Contains;
using testing::IsEmpty;

class Editing : public StudioWindow {
 protected:
  [[nodiscard]] std::vector<std::string> codes() const {
    std::vector<std::string> found;
    for (const Fault& fault : window->editor().faults()) found.push_back(fault.code.toStdString());
    return found;
  }
  /// Whether the characters of a line are underlined in a colour of the theme.
  [[nodiscard]] bool is_underlined(int line, int column, const QColor& colour) const {
    window->editor().grab();  // lines in view get their formats when they are painted
    const QTextBlock block = window->editor().document()->findBlockByNumber(line - 1);
    for (const QTextLayout::FormatRange& range : block.layout()->formats()) {
      const bool covers = range.start < column && column <= range.start + range.length;
      if (covers && range.format.underlineStyle() == QTextCharFormat::WaveUnderline &&
          range.format.underlineColor() == colour) {
        return true;
      }
    }
    return false;
  }
};

TEST_F(Editing, ASlipIsUnderlinedListedAndTold) {
  type(QStringLiteral("L1=X0\nL2=Y0\nP1=L1 L3\n"));
  ASSERT_TRUE(compiled());
  EXPECT_TRUE(is_underlined(3, 7, colours().error));
  EXPECT_FALSE(is_underlined(3, 4, colours().error));
  FaultList* const list = window->panels().faults;
  ASSERT_EQ(list->topLevelItemCount(), 1);
  EXPECT_EQ(list->topLevelItem(0)->text(1), QStringLiteral("3"));
  const auto fault =
      window->editor().fault_at(window->editor().document()->findBlockByNumber(2).position() + 7);
  ASSERT_TRUE(fault);
  EXPECT_TRUE(tip_of(window->editor().faults()[*fault]).contains(QStringLiteral("L3")));
}

TEST_F(Editing, SquigglesMoveWithTheTextUntilTheCompilerAnswers) {
  type(QStringLiteral("P1=L1 L3"));
  ASSERT_TRUE(compiled());
  window->editor().moveCursor(QTextCursor::Start);
  QTest::keyClick(&window->editor(), Qt::Key_Return);
  EXPECT_TRUE(is_underlined(2, 4, colours().error));
  EXPECT_FALSE(is_underlined(1, 4, colours().error));
}

TEST_F(Editing, AClickInTheListGoesToThePlaceAndF4GoesRound) {
  type(QStringLiteral("L1=Q5\nL2=X7\nC1=P9 R5\n"));
  ASSERT_TRUE(compiled());
  FaultList* const list = window->panels().faults;
  ASSERT_GE(list->topLevelItemCount(), 2);
  const QRect second = list->visualItemRect(list->topLevelItem(1));
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, second.center());
  EXPECT_EQ(window->editor().current_line(), 3);
  press(Qt::Key_F4);
  EXPECT_EQ(window->editor().current_line(), 1);
  press(Qt::Key_F4, Qt::ShiftModifier);
  EXPECT_EQ(window->editor().current_line(), 3);
}

TEST_F(Editing, ASureCureIsPutInPlaceAtOnceAndUndone) {
  window->editor().insertPlainText(QStringLiteral("С1=X0Y0R5"));  // a Cyrillic С
  ASSERT_TRUE(compiled());
  ASSERT_THAT(codes(), testing::Not(IsEmpty()));
  press(Qt::Key_Return, Qt::AltModifier);
  EXPECT_EQ(text(), QStringLiteral("C1=X0Y0R5"));
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(text(), QStringLiteral("С1=X0Y0R5"));
}

TEST_F(Editing, ACureOfWhatHasChangedSinceIsNotPutInPlace) {
  window->editor().insertPlainText(QStringLiteral("С1=X0Y0R5"));
  ASSERT_TRUE(compiled());
  window->editor().moveCursor(QTextCursor::Start);
  type(QStringLiteral("L"));
  const QString before = text();
  press(Qt::Key_Return, Qt::AltModifier);
  EXPECT_EQ(text(), before);
}

TEST_F(Editing, ACureThatChangesWhatIsCutIsAskedAbout) {
  const QString program = QStringLiteral(
      "L1=X0\nL2=Y0\nL3=X40\nL4=Y30\nP1=X20 Y-5\nG54 P1\nK1 W0.1 P1 L2 R5 L-3 R5 L4 R5 L1 R5 L2 "
      "P1");
  type(program);
  ASSERT_TRUE(compiled());
  for (const char* const answer : {"Cancel", "Write"}) {
    EXPECT_EQ(text(), program);
    QString asked;
    NextDialog dialog([&](QDialog& box) {
      asked = qobject_cast<QMessageBox*>(&box)->informativeText();
      click(box, QString::fromLatin1(answer));
    });
    press(Qt::Key_Return, Qt::AltModifier);
    EXPECT_TRUE(asked.contains(QStringLiteral("L-4"))) << asked.toStdString();
  }
  EXPECT_TRUE(text().contains(QStringLiteral("R5 L-4 R5")));
}

TEST_F(Editing, FormattingIsOneStepOfUndo) {
  const QString rough = QStringLiteral("l1 = x 5 ,\n\n\np1=x0y0\n");
  window->editor().insertPlainText(rough);
  press(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(QTest::qWaitFor([&] { return text() != rough; }, 10000));
  EXPECT_EQ(text(), QStringLiteral("L1=X5\n\nP1=X0 Y0\n"));
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(text(), rough);
}

TEST_F(Editing, CompletionOffersWhatIsDefined) {
  type(QStringLiteral("L1=X0\nL12=Y0\n"));
  ASSERT_TRUE(compiled());
  const auto offered = [&](const char* before) {
    std::vector<std::string> words;
    for (const Proposal& one :
         proposals_for(QString::fromUtf8(before), window->compiler().current().get())) {
      words.push_back(one.whole.toStdString());
    }
    return words;
  };
  EXPECT_EQ(offered("P1=L"), (std::vector<std::string>{"L1", "L12"}));
  EXPECT_EQ(offered("P1=L1"), (std::vector<std::string>{"L12"}));
  EXPECT_THAT(offered(""), Contains("L13="));
  EXPECT_THAT(offered("F"), testing::ElementsAre("F0 ", "FOR "));
  EXPECT_THAT(offered("C1="), Contains("L R C"));
  EXPECT_THAT(offered("C1=L1 "), Contains("R C"));
  EXPECT_THAT(offered("C1=L1 R5 "), testing::ElementsAre("L", "C"));
  EXPECT_THAT(offered("' L"), IsEmpty());
}

TEST_F(Editing, TheListOpensBehindALetterAndTabTakes) {
  type(QStringLiteral("L1=X0\nL12=Y0\n"));
  ASSERT_TRUE(compiled());
  type(QStringLiteral("P1=L"));
  press(Qt::Key_Down);
  press(Qt::Key_Down);
  press(Qt::Key_Tab);
  EXPECT_EQ(text(), QStringLiteral("L1=X0\nL12=Y0\nP1=L12"));
  type(QStringLiteral(" L\n"));  // nothing was chosen, so Enter ends the line
  EXPECT_EQ(text(), QStringLiteral("L1=X0\nL12=Y0\nP1=L12 L\n"));
}

TEST_F(Editing, FindsGoesRoundAndReplacesAllInOneStep) {
  type(QStringLiteral("L1=X0\nL2=X10\nL3=Y0"));
  press(Qt::Key_H, Qt::ControlModifier);
  auto* const sought = window->findChild<QLineEdit*>(QStringLiteral("sought"));
  auto* const put = window->findChild<QLineEdit*>(QStringLiteral("replacement"));
  ASSERT_TRUE(sought->isVisible());
  QTest::keyClicks(sought, QStringLiteral("x"));
  QTest::keyClick(sought, Qt::Key_Return);
  EXPECT_EQ(window->editor().current_line(), 1);
  QTest::keyClick(sought, Qt::Key_Return);
  EXPECT_EQ(window->editor().current_line(), 2);
  QTest::keyClick(sought, Qt::Key_Return);
  EXPECT_EQ(window->editor().current_line(), 1);
  QTest::keyClicks(put, QStringLiteral("Y"));
  window->findChild<FindBar*>()->replace_all();
  EXPECT_EQ(text(), QStringLiteral("L1=Y0\nL2=Y10\nL3=Y0"));
  QTest::keyClick(sought, Qt::Key_Escape);
  EXPECT_TRUE(editor_has_keyboard());
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(text(), QStringLiteral("L1=X0\nL2=X10\nL3=Y0"));
}

TEST_F(Editing, AWordIsLookedUpByItsLetter) {
  type(QStringLiteral("C12=L1 R5"));
  window->editor().go_to(1, 2);
  EXPECT_EQ(window->editor().word_at_cursor(), QStringLiteral("C"));
  window->editor().go_to(1, 9);
  EXPECT_EQ(window->editor().word_at_cursor(), QStringLiteral("R"));
  type(QStringLiteral("\nFOR 5\nG54 P1"));
  window->editor().go_to(2, 3);
  EXPECT_EQ(window->editor().word_at_cursor(), QStringLiteral("FOR"));
  window->editor().go_to(3, 1);
  EXPECT_EQ(window->editor().word_at_cursor(), QStringLiteral("G54"));
}

TEST_F(Editing, TextKeepsEveryCharacter) {
  const QString odd = QStringLiteral("' a\u00a0b \u2013 \U0001F600\nL1=X5");
  window->editor().setPlainText(odd);
  EXPECT_EQ(text(), odd);
}

}  // namespace
}  // namespace dgt::studio
