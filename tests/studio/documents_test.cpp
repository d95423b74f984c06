// SPDX-License-Identifier: GPL-3.0-or-later
// Files: nothing that was typed is lost, and nothing else changes in them.
#include <gmock/gmock.h>

#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

#include "tests/studio/studio_window.h"

namespace dgt::studio {
namespace {

class DocumentsOfAWindow : public StudioWindow {
 protected:
  [[nodiscard]] std::string on_disk(const char* name) const {
    return support::read_text(folder.path() / name);
  }
  /// The notice bar, when it shows something.
  [[nodiscard]] NoticeBar* notice() const {
    auto* const bar = &window->notices();
    return bar->isVisible() ? bar : nullptr;
  }
  void answer(int which) {
    auto* const button = notice()->findChild<QPushButton*>(QStringLiteral("answer%1").arg(which));
    ASSERT_NE(button, nullptr);
    QTest::mouseClick(button, Qt::LeftButton);
  }
  [[nodiscard]] bool is_modified() const { return window->editor().document()->isModified(); }
};

TEST_F(DocumentsOfAWindow, EveryEncodingAndLineEndIsKept) {
  const std::string text = "' Контур детали по чертежу, обход снаружи\r\nL1=X5 ' прямая\r\n";
  for (const Encoding encoding : kEncodings) {
    for (const LineEnd end : {LineEnd::Lf, LineEnd::CrLf, LineEnd::Cr}) {
      TextForm form;
      form.encoding = encoding;
      form.line_end = end;
      const std::string bytes = encode(text, form).bytes;
      folder.write("part.bgt", bytes);
      ASSERT_TRUE(window->open_file(file("part.bgt")));
      EXPECT_EQ(window->documents().document().form().encoding, encoding);
      EXPECT_TRUE(text.find("Контур") != std::string::npos &&
                  this->text().contains(QStringLiteral("Контур")));
      window->editor().moveCursor(QTextCursor::End);
      type(QStringLiteral("L2=Y1\n"));
      press(Qt::Key_S, Qt::ControlModifier);
      form.line_end = end;
      EXPECT_EQ(on_disk("part.bgt"), bytes + encode("L2=Y1\n", form).bytes);
      EXPECT_FALSE(is_modified());
    }
  }
}

TEST_F(DocumentsOfAWindow, MarksOfOldEditorsStay) {
  folder.write("part.bgt", "\xEF\xBB\xBFL1=X5\r\n\x1A");
  ASSERT_TRUE(window->open_file(file("part.bgt")));
  type(QStringLiteral("L2=Y7\n"));
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(on_disk("part.bgt"), "\xEF\xBB\xBFL2=Y7\r\nL1=X5\r\n\x1A");
}

TEST_F(DocumentsOfAWindow, UndoReachesBackBehindASave) {
  folder.write("part.bgt", "L1=X5\n");
  ASSERT_TRUE(window->open_file(file("part.bgt")));
  type(QStringLiteral("L2=Y7\n"));
  press(Qt::Key_S, Qt::ControlModifier);
  while (window->editor().document()->isUndoAvailable()) press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(text(), QStringLiteral("L1=X5\n"));
  EXPECT_TRUE(is_modified());
  EXPECT_EQ(on_disk("part.bgt"), "L2=Y7\nL1=X5\n");
}

TEST_F(DocumentsOfAWindow, SaveAsAsksForANameAndBecomesARecentFile) {
  type(QStringLiteral("L1=X5"));
  NextDialog dialog([&](QDialog& box) {
    auto* const name = box.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    ASSERT_NE(name, nullptr);
    name->setText(file("new"));  // the extension comes by itself
    QTest::keyClick(name, Qt::Key_Return);
  });
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_TRUE(dialog.came());
  EXPECT_EQ(on_disk("new.bgt"), "L1=X5");
  EXPECT_TRUE(window->windowTitle().contains(QStringLiteral("new.bgt")));
  EXPECT_EQ(window->actions().recent[0]->data().toString(), file("new.bgt"));
  EXPECT_TRUE(window->actions().recent[0]->isVisible());
  EXPECT_FALSE(window->actions().recent[1]->isVisible());
}

TEST_F(DocumentsOfAWindow, FourRecentFilesAreKeptAndOpened) {
  for (int i = 1; i <= 6; ++i) {
    const std::string name = std::to_string(i) + ".bgt";
    folder.write(name, "' " + std::to_string(i));
    ASSERT_TRUE(window->open_file(file(name.c_str())));
  }
  open_window();
  const auto& recent = window->actions().recent;
  ASSERT_EQ(recent.size(), 4U);
  EXPECT_EQ(recent[3]->data().toString(), file("3.bgt"));
  recent[3]->trigger();
  EXPECT_EQ(text(), QStringLiteral("' 3"));
  EXPECT_EQ(recent[0]->data().toString(), file("3.bgt"));
}

TEST_F(DocumentsOfAWindow, ASaveThatFailsIsToldAndLosesNothing) {
  ASSERT_TRUE(QDir(file("")).mkdir(QStringLiteral("stick")));
  folder.write("stick/part.bgt", "L1=X5\n");
  ASSERT_TRUE(window->open_file(file("stick/part.bgt")));
  type(QStringLiteral("L2=Y7\n"));
  ASSERT_TRUE(QDir(file("stick")).removeRecursively());  // it was pulled out
  QString told;
  NextDialog dialog([&](QDialog& box) {
    told = said_by(box);
    box.accept();
  });
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_TRUE(told.contains(QStringLiteral("no such file or folder"))) << told.toStdString();
  EXPECT_EQ(text(), QStringLiteral("L2=Y7\nL1=X5\n"));
  EXPECT_TRUE(is_modified());
  ASSERT_TRUE(QDir(file("")).mkdir(QStringLiteral("stick")));  // and put in again
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(on_disk("stick/part.bgt"), "L2=Y7\nL1=X5\n");
}

TEST_F(DocumentsOfAWindow, LettersThatTheEncodingLacksAreAskedAbout) {
  folder.write("part.bgt",
               encode("' Контур детали по чертежу\n", {.encoding = Encoding::Cp866}).bytes);
  ASSERT_TRUE(window->open_file(file("part.bgt")));
  ASSERT_EQ(window->documents().document().form().encoding, Encoding::Cp866);
  window->editor().insertPlainText(QStringLiteral("' ∅5\n"));
  QString told;
  NextDialog dialog([&](QDialog& box) {
    told = said_by(box);
    click(box, QStringLiteral("As UTF-8"));
  });
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_TRUE(told.contains(QStringLiteral("∅"))) << told.toStdString();
  EXPECT_EQ(on_disk("part.bgt"), "' ∅5\n' Контур детали по чертежу\n");
}

TEST_F(DocumentsOfAWindow, UnsavedTextIsAskedAboutBeforeItGoes) {
  folder.write("other.bgt", "L9=X9\n");
  type(QStringLiteral("L1=X5"));
  {
    NextDialog dialog([](QDialog& box) { click(box, QStringLiteral("Cancel")); });
    EXPECT_FALSE(window->open_file(file("other.bgt")));
    EXPECT_TRUE(dialog.came());
  }
  EXPECT_EQ(text(), QStringLiteral("L1=X5"));
  {
    NextDialog dialog([](QDialog& box) { click(box, QStringLiteral("Cancel")); });
    EXPECT_FALSE(window->close());
    EXPECT_TRUE(dialog.came());
  }
  NextDialog dialog([](QDialog& box) { click(box, QStringLiteral("Discard")); });
  EXPECT_TRUE(window->open_file(file("other.bgt")));
  EXPECT_EQ(text(), QStringLiteral("L9=X9\n"));
}

TEST_F(DocumentsOfAWindow, AFileThatCannotBeOpenedLeavesTheTextAlone) {
  folder.write("utf16.bgt", std::string("\xFF\xFEL\0001\0=\0X\0", 10));
  folder.write("wide.bgt", std::string(200'000, 'X'));
  type(QStringLiteral("L1=X5"));
  window->editor().document()->setModified(false);
  for (const char* const name : {"none.bgt", "utf16.bgt", "wide.bgt", "."}) {
    NextDialog dialog([](QDialog& box) { box.accept(); });
    EXPECT_FALSE(window->open_file(file(name))) << name;
    EXPECT_TRUE(dialog.came()) << name;
    EXPECT_EQ(text(), QStringLiteral("L1=X5"));
    EXPECT_TRUE(window->documents().document().name().isEmpty());
  }
}

TEST_F(DocumentsOfAWindow, AFileChangedOnDiskIsOfferedAndNotTaken) {
  folder.write("part.bgt", "L1=X5\n");
  ASSERT_TRUE(window->open_file(file("part.bgt")));
  folder.write("part.bgt", "L1=X6\n");
  ASSERT_TRUE(QTest::qWaitFor([&] { return notice() != nullptr; }, 5000));
  EXPECT_EQ(text(), QStringLiteral("L1=X5\n"));
  answer(0);
  EXPECT_EQ(text(), QStringLiteral("L1=X6\n"));
  EXPECT_FALSE(is_modified());
  EXPECT_EQ(notice(), nullptr);
}

TEST_F(DocumentsOfAWindow, ASaveOverAnothersWorkIsAskedAbout) {
  folder.write("part.bgt", "L1=X5\n");
  ASSERT_TRUE(window->open_file(file("part.bgt")));
  type(QStringLiteral("L2=Y7\n"));
  folder.write("part.bgt", "L1=X6\n");
  {
    NextDialog dialog([](QDialog& box) { click(box, QStringLiteral("Cancel")); });
    press(Qt::Key_S, Qt::ControlModifier);
    EXPECT_TRUE(dialog.came());
    EXPECT_EQ(on_disk("part.bgt"), "L1=X6\n");
  }
  NextDialog dialog([](QDialog& box) { click(box, QStringLiteral("Write over")); });
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(on_disk("part.bgt"), "L2=Y7\nL1=X5\n");
}

TEST_F(DocumentsOfAWindow, ReadsAgainInTheEncodingThatIsChosen) {
  const std::string text = "' Контур\n";
  folder.write("part.bgt", encode(text, {.encoding = Encoding::Koi8R}).bytes);
  ASSERT_TRUE(window->open_file(file("part.bgt")));
  auto* const fields = window->findChild<StatusFields*>();
  emit fields->read_again_wanted(Encoding::Windows1251);
  EXPECT_NE(this->text().toStdString(), text);
  emit fields->read_again_wanted(Encoding::Koi8R);
  EXPECT_EQ(this->text().toStdString(), text);
  EXPECT_EQ(window->findChild<QToolButton*>(QStringLiteral("encoding"))->text(),
            QStringLiteral("koi8-r"));
  EXPECT_FALSE(is_modified());
}

TEST_F(DocumentsOfAWindow, BytesThatAreNoTextAreTold) {
  folder.write("part.bgt", "' \x98\x98 Контур детали\n");
  ASSERT_TRUE(window->open_file(file("part.bgt")));
  EXPECT_NE(notice(), nullptr);
}

}  // namespace
}  // namespace dgt::studio
