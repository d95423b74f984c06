// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/nc/nc_panel.h"

#include <gmock/gmock.h>

#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBlock>
#include <QToolButton>
#include <QTreeWidget>

#include "apps/studio/editor/fault_list.h"
#include "apps/studio/editor/source_editor.h"
#include "apps/studio/nc/certificate_page.h"
#include "apps/studio/nc/dialect_dialog.h"
#include "tests/studio/qt_values.h"
#include "tests/support/command.h"

namespace dgt::studio {
namespace {

using support::corpus;

PartPtr part_of(const std::string& file) {
  auto part = std::make_shared<Part>();
  part->name = file;
  part->compilation = *compile_file(file, part->settings.source);
  return part;
}

PartPtr part_of_text(const std::string& text) {
  auto part = std::make_shared<Part>();
  part->name = "part.bgt";
  part->compilation = compile_bytes(part->name, text, part->settings.source);
  return part;
}

struct OpenNc {
  OpenNc() {
    panel.resize(700, 700);
    panel.show();
    (void)QTest::qWaitForWindowExposed(&panel);
  }
  /// Writes in a dialect and waits for it.
  void write(const PartPtr& part, const char* dialect) {
    QSignalSpy written(&panel, &NcPanel::written);
    panel.set_dialect(QString::fromLatin1(dialect));
    panel.show_part(part);
    // Without a part the first one is told at once; the newest request is answered last.
    while (panel.findChild<Background*>() != nullptr && is_busy())
      ASSERT_TRUE(QTest::qWaitFor([&] { return !is_busy(); }, 30000));
  }
  bool is_busy() {
    for (const Background* const work : panel.findChildren<Background*>())
      if (work->is_busy()) return true;
    return false;
  }
  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !is_busy(); }, 30000));
  }

  SourceEditor& editor() { return *panel.findChild<SourceEditor*>(); }
  QString why_not() { return panel.findChild<QLabel*>(QStringLiteral("why_not"))->text(); }
  QString certificate() { return panel.findChild<QLabel*>(QStringLiteral("certificate"))->text(); }
  QString banner() { return panel.findChild<QLabel*>(QStringLiteral("banner"))->text(); }
  void click(const char* button) {
    QTest::mouseClick(panel.findChild<QToolButton*>(QString::fromLatin1(button)), Qt::LeftButton);
  }
  void answer(const QString& label) {
    for (QPushButton* const button : panel.findChildren<QPushButton*>())
      if (button->text() == label && button->isVisible())
        return QTest::mouseClick(button, Qt::LeftButton);
    FAIL() << label.toStdString();
  }
  /// Puts the cursor behind the text and types there.
  void type_behind(const QString& text, const QString& keys) {
    QTextCursor cursor = editor().document()->find(text);
    ASSERT_FALSE(cursor.isNull()) << text.toStdString();
    cursor.clearSelection();
    editor().setTextCursor(cursor);
    QTest::keyClicks(&editor(), keys);
  }

  NcPanel panel;
};

// --- the same bytes as the command's

TEST(NcPanel, TheTextIsByteForByteThatOfTheCommand) {
  OpenNc nc;
  for (const char* program : {"1P.bgt", "2P.bgt", "5P.bgt", "kvad-square.bgt",
                              "rows/contour_cvc.bgt", "rows/contour_t.bgt", "rows/contour_z.bgt"}) {
    const PartPtr part = part_of(corpus(program));
    for (const Dialect& dialect : dialects()) {
      const auto run = support::run_dgt({"compile", corpus(program), "--post", dialect.name});
      nc.write(part, dialect.name.c_str());
      EXPECT_EQ(nc.panel.program().toStdString(), run.out) << program << ' ' << dialect.name;
      EXPECT_EQ(nc.panel.program().isEmpty(), run.exit_code != 0) << program << ' ' << dialect.name;
    }
  }
}

TEST(NcPanel, AMachineFileCountsAsForTheCommand) {
  QTemporaryDir folder;
  const QString machine = folder.filePath(QStringLiteral("saw.toml"));
  ASSERT_TRUE(write_file(machine.toStdString(), "decimals = 2\nline_end = \"crlf\"\n"));
  OpenNc nc;
  nc.panel.set_machine(machine);
  nc.write(part_of(corpus("1P.bgt")), "plasmatic");
  const auto run = support::run_dgt(
      {"compile", corpus("1P.bgt"), "--post", "plasmatic", "--machine", machine.toStdString()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(nc.panel.program().toStdString(), run.out);
}

TEST(NcPanel, CompensationByTheControlIsThatOfTheCommand) {
  OpenNc nc;
  nc.write(part_of(corpus("1P.bgt")), "linuxcnc");
  auto* const box = nc.panel.findChild<QComboBox*>(QStringLiteral("compensation"));
  QTest::keyClick(box, Qt::Key_Down);
  nc.settle();
  const auto run = support::run_dgt(
      {"compile", corpus("1P.bgt"), "--post", "linuxcnc", "--compensation", "control"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(nc.panel.program().toStdString(), run.out);
}

// --- what is told

TEST(NcPanel, ARefusalSaysWhyAndShowsNoText) {
  OpenNc nc;
  nc.write(part_of(corpus("rows/contour_z.bgt")), "essi");
  EXPECT_TRUE(nc.panel.program().isEmpty());
  EXPECT_TRUE(nc.editor().toPlainText().isEmpty());
  EXPECT_TRUE(nc.why_not().startsWith(QStringLiteral("Nothing was written.")))
      << nc.why_not().toStdString();
  auto* const list = nc.panel.findChild<FaultList*>();
  ASSERT_GE(list->topLevelItemCount(), 1);
  QSignalSpy place(&nc.panel, &NcPanel::place_chosen);
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                    list->visualItemRect(list->topLevelItem(0)).center());
  ASSERT_EQ(place.count(), 1);
  EXPECT_EQ(place[0][0].toInt(), 0);
  EXPECT_GT(place[0][1].toInt(), 1);
}

TEST(NcPanel, AProgramWithErrorsHasNoText) {
  OpenNc nc;
  nc.write(part_of(corpus("1P.bgt")), "essi");
  ASSERT_FALSE(nc.panel.program().isEmpty());
  nc.panel.show_part(part_of_text("L1=\n"));
  EXPECT_TRUE(nc.panel.program().isEmpty());
  EXPECT_TRUE(nc.editor().toPlainText().isEmpty());
}

TEST(NcPanel, AnUnknownDialectIsTold) {
  OpenNc nc;
  nc.write(part_of(corpus("1P.bgt")), "esi");
  EXPECT_TRUE(nc.why_not().contains(QStringLiteral("esi"))) << nc.why_not().toStdString();
}

TEST(NcPanel, TheCertificateStandsAboveTheText) {
  OpenNc nc;
  nc.write(part_of(corpus("1P.bgt")), "essi");
  EXPECT_TRUE(nc.certificate().contains(QStringLiteral("certified")))
      << nc.certificate().toStdString();
}

// --- changed by hand

TEST(NcPanel, WhatWasTypedIsReadBackAndDrawn) {
  OpenNc nc;
  nc.write(part_of(corpus("kvad-square.bgt")), "linuxcnc");
  QSignalSpy read(&nc.panel, &NcPanel::part_read);
  nc.type_behind(QStringLiteral("M02"), QString());
  QTest::keyClick(&nc.editor(), Qt::Key_Home);
  QTest::keyClicks(&nc.editor(), QStringLiteral("G00 X50 Y50"));
  QTest::keyClick(&nc.editor(), Qt::Key_Return);
  ASSERT_TRUE(read.wait(10000));
  const auto part = read.last()[0].value<PartPtr>();
  ASSERT_NE(part->path(), nullptr);
  EXPECT_EQ(part->path()->moves.back().to, Point(RationalPoint{50, 50}));
  EXPECT_TRUE(nc.certificate().contains(QStringLiteral("Edited by hand")));
  // And back: what is drawn is the part again.
  read.clear();
  while (nc.panel.is_edited()) nc.editor().undo();
  ASSERT_TRUE(read.wait(10000));
  EXPECT_TRUE(read.last()[0].value<PartPtr>()->name.ends_with("kvad-square.bgt"));
}

TEST(NcPanel, WhatNoControlReadsIsMarkedInTheText) {
  OpenNc nc;
  nc.write(part_of(corpus("1P.bgt")), "linuxcnc");
  QSignalSpy read(&nc.panel, &NcPanel::read_back);
  nc.type_behind(QStringLiteral("G21"), QStringLiteral(" G77"));
  ASSERT_TRUE(read.wait(10000));
  ASSERT_FALSE(nc.editor().faults().empty());
  EXPECT_EQ(nc.editor().faults().front().severity, Severity::Error);
  EXPECT_EQ(nc.editor().faults().front().at.place.line,
            1U + nc.editor()
                     .toPlainText()
                     .left(nc.editor().toPlainText().indexOf(QStringLiteral("G77")))
                     .count(u'\n'));
}

TEST(NcPanel, LettersThatControlsLackAreTold) {
  OpenNc nc;
  nc.write(part_of(corpus("1P.bgt")), "linuxcnc");
  QSignalSpy read(&nc.panel, &NcPanel::read_back);
  QTextCursor cursor(nc.editor().document());
  nc.editor().setTextCursor(cursor);
  nc.editor().insertPlainText(QStringLiteral("(контур)\n"));
  ASSERT_TRUE(read.wait(10000));
  const auto& faults = nc.editor().faults();
  EXPECT_TRUE(std::ranges::any_of(faults, [](const Fault& fault) {
    return fault.at.place.line == 1 && fault.text.contains(QStringLiteral("UTF-8"));
  }));
}

TEST(NcPanel, ANewProgramAsksBeforeItOverwritesWhatWasTyped) {
  OpenNc nc;
  nc.write(part_of(corpus("1P.bgt")), "essi");
  nc.type_behind(QStringLiteral("53"), QStringLiteral("0"));
  const QString typed = nc.editor().toPlainText();
  nc.write(part_of(corpus("5P.bgt")), "essi");
  EXPECT_EQ(nc.editor().toPlainText(), typed);
  nc.answer(QStringLiteral("Write anew, lose the changes"));
  nc.settle();
  EXPECT_EQ(nc.panel.program().toStdString(),
            support::run_dgt({"compile", corpus("5P.bgt"), "--post", "essi"}).out);
}

TEST(NcPanel, WhatWasTypedStaysWhenThePersonWantsItSo) {
  OpenNc nc;
  nc.write(part_of(corpus("1P.bgt")), "essi");
  nc.type_behind(QStringLiteral("53"), QStringLiteral("0"));
  const QString typed = nc.editor().toPlainText();
  nc.panel.set_dialect(QStringLiteral("linuxcnc"));
  nc.answer(QStringLiteral("Keep the text"));
  EXPECT_EQ(nc.editor().toPlainText(), typed);
  EXPECT_EQ(nc.panel.dialect(), QStringLiteral("essi"));
}

// --- proved

TEST(NcPanel, WhatIsWrittenIsProvedInEveryDialect) {
  OpenNc nc;
  const PartPtr part = part_of(corpus("1P.bgt"));
  for (const Dialect& dialect : dialects()) {
    nc.write(part, dialect.name.c_str());
    nc.click("verify");
    nc.settle();
    EXPECT_EQ(nc.banner(), QStringLiteral("Proved: the program runs the exact path."))
        << dialect.name;
  }
}

TEST(NcPanel, OneAlteredDigitIsFoundAndTheBlockNamed) {
  OpenNc nc;
  nc.write(part_of(corpus("kvad-square.bgt")), "plasmatic");
  nc.click("verify");
  nc.settle();
  ASSERT_EQ(nc.banner(), QStringLiteral("Proved: the program runs the exact path."));
  // The last digit of the third cut's block.
  QTextCursor cursor(nc.editor().document());
  for (int i = 0; i < 3; ++i) cursor = nc.editor().document()->find(QStringLiteral("G01"), cursor);
  const int line = cursor.blockNumber() + 1;
  cursor.movePosition(QTextCursor::EndOfBlock);
  nc.editor().setTextCursor(cursor);
  const QString old = cursor.block().text().right(1);
  QTest::keyClick(&nc.editor(), Qt::Key_Backspace);
  QTest::keyClicks(&nc.editor(),
                   old == QStringLiteral("9") ? QStringLiteral("1") : QStringLiteral("9"));
  EXPECT_TRUE(nc.banner().contains(QStringLiteral("changed after this proof")));
  nc.click("verify");
  nc.settle();
  EXPECT_TRUE(nc.banner().startsWith(QStringLiteral("Not proved"))) << nc.banner().toStdString();
  auto* const faults = nc.panel.findChild<QListWidget*>(QStringLiteral("proof_faults"));
  ASSERT_GE(faults->count(), 1);
  EXPECT_TRUE(faults->item(0)->text().contains(QString::number(line)))
      << faults->item(0)->text().toStdString();
  nc.editor().moveCursor(QTextCursor::End);
  QTest::mouseClick(faults->viewport(), Qt::LeftButton, {},
                    faults->visualItemRect(faults->item(0)).center());
  EXPECT_EQ(nc.editor().current_line(), line);
}

TEST(NcPanel, ATextWithErrorsIsNotProved) {
  OpenNc nc;
  nc.write(part_of(corpus("1P.bgt")), "linuxcnc");
  nc.type_behind(QStringLiteral("G21"), QStringLiteral(" G77"));
  nc.click("verify");
  nc.settle();
  EXPECT_TRUE(nc.banner().startsWith(QStringLiteral("The text has errors")))
      << nc.banner().toStdString();
}

// --- files

TEST(NcPanel, SavingWritesTheCommandsBytes) {
  QTemporaryDir folder;
  OpenNc nc;
  nc.write(part_of(corpus("1P.bgt")), "linuxcnc");
  const QString file = folder.filePath(QStringLiteral("1P.ngc"));
  ASSERT_TRUE(nc.panel.save_to(file));
  EXPECT_EQ(*read_file(file.toStdString()),
            support::run_dgt({"compile", corpus("1P.bgt"), "--post", "linuxcnc"}).out);
}

TEST(NcPanel, CtrlSInTheTextAsksForTheNameThenSavesUnderIt) {
  QTemporaryDir folder;
  OpenNc nc;
  nc.write(part_of(corpus("1P.bgt")), "essi");
  nc.type_behind(QStringLiteral("53"), QStringLiteral("0"));
  EXPECT_TRUE(nc.panel.has_unsaved_edits());
  QTest::keyClick(&nc.editor(), Qt::Key_S, Qt::ControlModifier);
  auto* const dialog = nc.panel.findChild<QFileDialog*>();
  ASSERT_NE(dialog, nullptr);
  auto* const name = dialog->findChild<QLineEdit*>();
  EXPECT_EQ(QFileInfo(name->text()).fileName(), QStringLiteral("1P.ess"));
  name->setText(folder.filePath(QStringLiteral("mine.ess")));  // typed, its completer pops up
  QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save),
                    Qt::LeftButton);
  const auto saved = read_file(folder.filePath(QStringLiteral("mine.ess")).toStdString());
  ASSERT_TRUE(saved) << saved.error().text();
  EXPECT_EQ(*saved, nc.panel.program().toStdString());
  EXPECT_FALSE(nc.panel.has_unsaved_edits());
}

TEST(NcPanel, AFileThatCannotBeWrittenIsTold) {
  OpenNc nc;
  nc.write(part_of(corpus("1P.bgt")), "linuxcnc");
  EXPECT_FALSE(nc.panel.save_to(QStringLiteral("/proc/none/1P.ngc")));
  bool told = false;
  for (const QLabel* const label : nc.panel.findChildren<QLabel*>())
    told = told || label->text().contains(QStringLiteral("/proc/none/1P.ngc"));
  EXPECT_TRUE(told);
}

TEST(NcPanel, PunchHandsOverTheProgram) {
  OpenNc nc;
  nc.write(part_of(corpus("1P.bgt")), "essi");
  QSignalSpy punch(&nc.panel, &NcPanel::punch_wanted);
  nc.click("punch");
  ASSERT_EQ(punch.count(), 1);
  EXPECT_EQ(punch[0][0].toByteArray(), nc.panel.program());
}

TEST(DialectDialog, ListsAllWithWhatTheyAre) {
  DialectDialog dialog(QStringLiteral("linuxcnc"), {});
  dialog.show();
  auto* const list = dialog.findChild<QTreeWidget*>();
  ASSERT_EQ(list->topLevelItemCount(), static_cast<int>(dialects().size()));
  for (int i = 0; i < list->topLevelItemCount(); ++i) {
    const Dialect& dialect = dialects()[static_cast<std::size_t>(i)];
    EXPECT_EQ(list->topLevelItem(i)->text(0).toStdString(), dialect.name);
    EXPECT_EQ(list->topLevelItem(i)->text(1).toStdString(), dialect.about);
  }
  EXPECT_EQ(dialog.dialect(), QStringLiteral("linuxcnc"));
  QTest::keyClick(list, Qt::Key_Home);
  QTest::keyClick(list, Qt::Key_Return);
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
  EXPECT_EQ(dialog.dialect(), QStringLiteral("essi"));
}

TEST(DialectDialog, AFileOfOnesOwnIsWrittenWith) {
  QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("my-saw.toml"));
  ASSERT_TRUE(write_file(file.toStdString(),
                         "base = \"linuxcnc\"\nabout = \"My saw\"\nabout_ru = \"Мой станок\"\n"));
  DialectDialog dialog(file, {});
  auto* const list = dialog.findChild<QTreeWidget*>();
  EXPECT_EQ(list->currentItem()->text(1), QStringLiteral("My saw"));
  OpenNc nc;
  nc.write(part_of(corpus("1P.bgt")), file.toStdString().c_str());
  EXPECT_EQ(nc.panel.program().toStdString(),
            support::run_dgt({"compile", corpus("1P.bgt"), "--post", file.toStdString()}).out);
}

}  // namespace
}  // namespace dgt::studio
