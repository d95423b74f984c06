// SPDX-License-Identifier: GPL-3.0-or-later
// Languages, themes and files of the drawing.
#include <gmock/gmock.h>

#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QRegularExpression>
#include <QTimer>
#include <QToolButton>

#include "apps/studio/drawing/internal_form.h"
#include "apps/studio/drawing/points_panel.h"
#include "apps/studio/window/languages.h"
#include "tests/studio/drawing_parts.h"
#include "tests/studio/qt_values.h"

namespace dgt::studio {
namespace {

/// Everything a person can read in a widget.
QStringList texts_of(const QWidget& widget) {
  QStringList texts;
  for (const auto* label : widget.findChildren<QLabel*>()) texts << label->text();
  for (const auto* button : widget.findChildren<QToolButton*>())
    texts << button->text() << button->toolTip() << button->accessibleName();
  return texts;
}

bool has_cyrillic(const QString& text) {
  return std::ranges::any_of(text, [](QChar c) { return c.script() == QChar::Script_Cyrillic; });
}

template <class Panel>
void expect_both_languages(Panel& panel) {
  const QStringList english = texts_of(panel);
  for (const QString& text : english) EXPECT_FALSE(has_cyrillic(text)) << text.toStdString();
  use_language(Language::Russian);
  QApplication::processEvents();
  const QStringList russian = texts_of(panel);
  use_language(Language::English);
  QApplication::processEvents();
  EXPECT_EQ(texts_of(panel), english) << "and back";
  ASSERT_EQ(russian.size(), english.size());
  static const QRegularExpression word(QStringLiteral("[A-Za-z]{4,}"));
  static const QRegularExpression keys(QStringLiteral("Shift|Home|Enter|Ctrl"));
  for (QString text : russian) {
    EXPECT_FALSE(text.remove(keys).contains(word)) << "not translated: " << text.toStdString();
  }
}

TEST(DrawingLooks, ChangesItsLanguageWithoutARestart) {
  ShownPanel shown_panel(corpus_part("4P.bgt"));
  ASSERT_TRUE(QTest::qWaitFor([&] {
    return shown_panel.panel.findChild<QLabel*>(QStringLiteral("lengths"))->text().contains(u'P');
  }));
  expect_both_languages(shown_panel.panel);
}

TEST(DrawingLooks, ListsChangeTheirLanguageToo) {
  PointsPanel points;
  points.show_part(part_of(kRectangle));
  ASSERT_TRUE(QTest::qWaitFor([&] { return points.is_settled(); }));
  expect_both_languages(points);
  InternalForm form;
  form.show_part(part_of(kRectangle));
  ASSERT_TRUE(QTest::qWaitFor([&] { return form.is_settled(); }));
  expect_both_languages(form);
}

TEST(DrawingLooks, ThemesChangeTheSheetAtOnce) {
  ShownPanel shown_panel(part_of(kRectangle));
  Appearance& appearance = Appearance::of_program();
  for (const Theme theme : {Theme::Dark, Theme::Light}) {
    appearance.set(theme, standard_colours(theme));
    QApplication::processEvents();
    const QImage image = shown_panel.canvas().grab().toImage();
    // Just inside the window's border, beside the lines of the grid.
    int sheet = 0;
    for (int x = 0; x < image.width(); ++x)
      sheet += image.pixelColor(x, 3) == standard_colours(theme).sheet ? 1 : 0;
    EXPECT_GT(sheet, image.width() / 2);
  }
}

TEST(DrawingLooks, WhatIsShownAndTheFactorAreRememberedForTheNextWindow) {
  {
    ShownPanel first(part_of(kRectangle));
    for (QAction* action : first.panel.show_menu().actions()) {
      if (action->text().contains(QStringLiteral("Kerf"))) action->trigger();
    }
    for (auto* box : first.panel.findChildren<QDoubleSpinBox*>()) {
      if (box->prefix().startsWith(u'×')) box->setValue(5);
    }
  }
  ShownPanel second(part_of(kRectangle));
  EXPECT_TRUE(second.canvas().shown().kerf);
  EXPECT_TRUE(second.canvas().shown().programmed) << "as before";
  const double scale = second.canvas().view().scale;
  QTest::mouseClick(&second.canvas(), Qt::LeftButton, {}, second.pixel(20, 10));
  EXPECT_DOUBLE_EQ(second.canvas().view().scale, 5 * scale);
}

/// Acts on the next dialog of that kind. It looks now and then and never waits: the loop of another
/// dialog could not end meanwhile.
template <class Dialog, class Act>
void when_seen(Act act) {
  auto* timer = new QTimer(qApp);
  QObject::connect(timer, &QTimer::timeout, timer, [timer, act] {
    auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    timer->stop();
    timer->deleteLater();
    act(*dialog);
  });
  timer->start(10);
}

/// Types a name into the file dialog that comes up.
void answer_with(const QString& name) {
  when_seen<QFileDialog>([name](QFileDialog& dialog) {
    auto* edit = dialog.findChild<QLineEdit*>();
    edit->setText(name);
    QTest::keyClick(edit, Qt::Key_Return);
  });
}

TEST(DrawingLooks, SavesTheDrawingThatTheCommandPlots) {
  const support::TemporaryFolder folder;
  ShownPanel shown_panel(corpus_part("4P.bgt"));
  for (const char* extension : {".svg", ".dxf", ".png"}) {
    const std::string ours = folder.name(std::string("ours") + extension);
    const std::string theirs = folder.name(std::string("theirs") + extension);
    answer_with(QString::fromStdString(ours));
    shown_panel.panel.save_picture();
    ASSERT_TRUE(QTest::qWaitFor([&] { return std::filesystem::exists(ours); })) << extension;
    const auto plotted = support::run_dgt({"plot", support::corpus("4P.bgt"), "-o", theirs});
    ASSERT_EQ(plotted.exit_code, 0);
    EXPECT_TRUE(support::read_text(ours) == support::read_text(theirs)) << extension;
  }
}

TEST(DrawingLooks, ANameThatTellsNoKindOfDrawingIsRefused) {
  const support::TemporaryFolder folder;
  ShownPanel shown_panel(part_of(kRectangle));
  answer_with(QString::fromStdString(folder.name("drawing.doc")));
  QString said;
  when_seen<QMessageBox>([&said](QMessageBox& box) {
    said = box.text();
    box.accept();
  });
  shown_panel.panel.save_picture();
  EXPECT_TRUE(said.contains(QStringLiteral(".dxf")));
  EXPECT_TRUE(folder.entries().empty());
}

}  // namespace
}  // namespace dgt::studio
