// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/wizard/wizard_panel.h"

#include <gmock/gmock.h>

#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabBar>
#include <QTest>

#include "apps/driver/pipeline.h"
#include "apps/studio/wizard/form_list.h"
#include "lang/text/render.h"
#include "tests/studio/qt_values.h"
#include "tests/studio/studio_window.h"

namespace dgt::studio {
namespace {

/// Of the tab that is shown.
FormList* list_of(const WizardPanel& panel) {
  for (FormList* const list : panel.findChildren<FormList*>())
    if (list->isVisible()) return list;
  return nullptr;
}

struct OpenWizard {
  OpenWizard() {
    panel.resize(400, 700);
    panel.show();
    (void)QTest::qWaitForWindowExposed(&panel);
    panel.activateWindow();
  }
  void tab(int index) {
    auto* const bar = panel.findChild<QTabBar*>();
    QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(index).center());
  }
  FormList* list() { return list_of(panel); }
  /// Clicks the picture above the caption.
  void click(const QString& caption) {
    const auto items = list()->findItems(caption, Qt::MatchExactly);
    ASSERT_EQ(items.size(), 1) << caption.toStdString();
    list()->scrollToItem(items[0]);
    QTest::mouseClick(list()->viewport(), Qt::LeftButton, {},
                      list()->visualItemRect(items[0]).center());
  }
  /// To whatever has the focus, as a person types.
  void type(const QString& keys) {
    for (const QChar key : keys) QTest::keyClick(panel.focusWidget(), key.toLatin1());
  }
  QString message() { return panel.findChild<QLabel*>(QStringLiteral("message"))->text(); }
  QString number() { return panel.findChild<QLineEdit*>(QStringLiteral("field0"))->text(); }

  WizardPanel panel;
  QSignalSpy lines{&panel, &WizardPanel::line_finished};
};

QString last(const QSignalSpy& spy) { return spy.isEmpty() ? QString() : spy.last()[0].toString(); }

TEST(WizardPanel, AClickAndAValueMakeALineAndTheNextTemplateFollows) {
  OpenWizard wizard;
  wizard.click(QStringLiteral("L6=X72"));
  wizard.type(QStringLiteral("72 "));
  EXPECT_EQ(last(wizard.lines), QStringLiteral("L1=X72"));
  EXPECT_EQ(wizard.number(), QStringLiteral("2"));
  wizard.type(QStringLiteral("-5.5 "));
  EXPECT_EQ(last(wizard.lines), QStringLiteral("L2=X-5.5"));
}

TEST(WizardPanel, TheSpaceBarGoesThroughAllValues) {
  OpenWizard wizard;
  wizard.tab(1);
  wizard.click(QStringLiteral("C1=X26 Y20 R14"));
  wizard.type(QStringLiteral("1 2 "));
  EXPECT_TRUE(wizard.lines.isEmpty());
  wizard.type(QStringLiteral("-7 "));
  EXPECT_EQ(last(wizard.lines), QStringLiteral("C1=X1 Y2 R-7"));
}

TEST(WizardPanel, NewElementsGetNumbersThatAreFree) {
  OpenWizard wizard;
  wizard.panel.show_source(QStringLiteral("L1=X0\nL2=Y0\nK1 L1 L2 L4\n"));
  wizard.click(QStringLiteral("L1=Y15"));
  wizard.type(QStringLiteral("1 2 3 "));
  ASSERT_EQ(wizard.lines.count(), 3);
  EXPECT_EQ(wizard.lines[0][0].toString(), QStringLiteral("L3=Y1"));
  EXPECT_EQ(wizard.lines[1][0].toString(), QStringLiteral("L5=Y2"));
}

TEST(WizardPanel, TheNumberCanBeChanged) {
  OpenWizard wizard;
  wizard.click(QStringLiteral("L6=X72"));
  auto* const number = wizard.panel.findChild<QLineEdit*>(QStringLiteral("field0"));
  QTest::mouseDClick(number, Qt::LeftButton);
  wizard.type(QStringLiteral("40 9 "));
  EXPECT_EQ(last(wizard.lines), QStringLiteral("L40=X9"));
}

TEST(WizardPanel, AWrongValueIsToldByTheLanguageAndStays) {
  OpenWizard wizard;
  wizard.click(QStringLiteral("L6=X72"));
  wizard.type(QStringLiteral("7q "));
  EXPECT_TRUE(wizard.lines.isEmpty());
  EXPECT_FALSE(wizard.message().isEmpty());
  wizard.type(QStringLiteral("7 "));  // the value was marked, so this replaces it
  EXPECT_EQ(last(wizard.lines), QStringLiteral("L1=X7"));
}

TEST(WizardPanel, AMissingValueIsTold) {
  OpenWizard wizard;
  wizard.click(QStringLiteral("L6=X72"));
  wizard.type(QStringLiteral(" "));
  EXPECT_TRUE(wizard.lines.isEmpty());
  EXPECT_FALSE(wizard.message().isEmpty());
}

TEST(WizardPanel, ACommaIsADecimalPointInAValue) {
  OpenWizard wizard;
  wizard.click(QStringLiteral("L6=X72"));
  wizard.type(QStringLiteral("0,5 "));
  EXPECT_EQ(last(wizard.lines), QStringLiteral("L1=X0.5"));
}

TEST(WizardPanel, EscEndsTheTemplateAndGivesTheFocusBack) {
  OpenWizard wizard;
  QSignalSpy left(&wizard.panel, &WizardPanel::left);
  wizard.click(QStringLiteral("L6=X72"));
  QTest::keyClick(wizard.panel.focusWidget(), Qt::Key_Escape);
  EXPECT_EQ(left.count(), 1);
  EXPECT_EQ(wizard.panel.focusWidget(), wizard.list());
  EXPECT_TRUE(wizard.lines.isEmpty());
}

TEST(WizardPanel, TheKeyboardAloneIsEnough) {
  OpenWizard wizard;
  wizard.list()->setFocus();
  QTest::keyClick(wizard.list(), Qt::Key_Home);
  QTest::keyClick(wizard.list(), Qt::Key_Right);
  QTest::keyClick(wizard.list(), Qt::Key_Space);
  wizard.type(QStringLiteral("15"));
  QTest::keyClick(wizard.panel.focusWidget(), Qt::Key_Return);
  EXPECT_EQ(last(wizard.lines), QStringLiteral("L1=Y15"));
}

TEST(WizardPanel, AnElementThatIsNotDefinedIsTold) {
  OpenWizard wizard;
  wizard.panel.show_source(QStringLiteral("P1=X0Y0\n"));
  wizard.click(QStringLiteral("L1=P1 P2"));
  wizard.type(QStringLiteral("1 2 "));
  EXPECT_EQ(last(wizard.lines), QStringLiteral("L1=P1 P2"));
  EXPECT_TRUE(wizard.message().contains(QStringLiteral("P2"))) << wizard.message().toStdString();
}

TEST(WizardPanel, EveryTemplateCanBeFilled) {
  OpenWizard wizard;
  for (int tab = 0; tab < 3; ++tab) {
    wizard.tab(tab);
    for (int row = 0; row < wizard.list()->count(); ++row) {
      const QString caption = wizard.list()->item(row)->text();
      wizard.click(caption);
      const qsizetype before = wizard.lines.count();
      for (int i = 0; i < 8 && wizard.lines.count() == before; ++i)
        wizard.type(QStringLiteral("1 "));
      EXPECT_EQ(wizard.lines.count(), before + 1) << caption.toStdString();
    }
  }
}

TEST(WizardPanel, AnExampleGoesInWithFreeNumbers) {
  OpenWizard wizard;
  wizard.panel.show_source(QStringLiteral("L1=X0\nP1=X0Y0\n"));
  wizard.tab(3);
  wizard.click(QStringLiteral("Plate"));
  EXPECT_TRUE(wizard.lines.isEmpty());
  QTest::mouseClick(wizard.panel.findChild<QPushButton*>(QStringLiteral("insert")), Qt::LeftButton);
  ASSERT_EQ(wizard.lines.count(), 1);
  const QString text = last(wizard.lines);
  EXPECT_TRUE(text.startsWith(QStringLiteral("L5=Y0\nL2=X40\n"))) << text.toStdString();
  EXPECT_TRUE(text.endsWith(QStringLiteral("K1 W0.2 P2 L5 L-2 L-3 L4 L5 P2")))
      << text.toStdString();
}

class WizardInTheWindow : public StudioWindow {};

TEST_F(WizardInTheWindow, LinesGoIntoTheProgramAndEscGoesBackToIt) {
  type(QStringLiteral("L1=Y0"));
  ASSERT_TRUE(compiled());
  auto* const wizard = window->findChild<WizardPanel*>();
  FormList* const list = list_of(*wizard);
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                    list->visualItemRect(list->item(0)).center());
  for (const Qt::Key key : {Qt::Key_7, Qt::Key_2, Qt::Key_Space, Qt::Key_9, Qt::Key_Space})
    press(key);
  EXPECT_EQ(text(), QStringLiteral("L1=Y0\nL2=X72\nL3=X9"));
  press(Qt::Key_Escape);
  EXPECT_TRUE(editor_has_keyboard());
}

TEST(ContourExamples, EachIsDrawn) {
  const DrawingStyle style = figure_style(standard_colours(Theme::Light), 120);
  for (const ContourExample& example : contour_examples()) {
    EXPECT_FALSE(draw_figure(example.figure, style).isNull()) << example.name.toStdString();
  }
}

TEST(ContourExamples, EachBehindAnotherCompilesWithItsFreeNumbers) {
  std::string program;
  for (const ContourExample& example : contour_examples()) {
    if (!example.figure.files.empty()) continue;  // needs a macro's file
    program += with_free_numbers(example.text(), UsedNumbers(program));
  }
  const Compilation made = compile_bytes("all.bgt", program, {});
  const std::string told = render(made.bag);
  EXPECT_FALSE(made.bag.has_errors()) << told;
}

TEST(UsedNumbers, AreFoundInContoursTextsAndVariables) {
  const UsedNumbers used("B1=\"C2 P4 L5,\"\nK3 W0.2 A N7, L-6 X N1\nN2=N3+4\n");
  EXPECT_TRUE(used.has('C', 2) && used.has('P', 4) && used.has('L', 5) && used.has('L', 6));
  EXPECT_TRUE(used.has('N', 7) && used.has('N', 1) && used.has('N', 3) && used.has('K', 3));
  EXPECT_FALSE(used.has('N', 4));
  EXPECT_TRUE(used.defines('N', 2) && !used.defines('N', 3));
}

}  // namespace
}  // namespace dgt::studio
