// SPDX-License-Identifier: GPL-3.0-or-later
// Everything a person reads is in one language, and goes into the other at once.
#include "apps/studio/window/languages.h"

#include <gmock/gmock.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>
#include <QTabBar>
#include <QTreeWidget>
#include <QXmlStreamReader>

#include "apps/studio/help/help_window.h"
#include "apps/studio/tape/tape_dialog.h"
#include "apps/studio/window/colours_dialog.h"
#include "apps/studio/window/machine_dialog.h"
#include "tests/studio/studio_window.h"

namespace dgt::studio {
namespace {

using Texts = std::map<QString, QString>;  // what is read, and where

void add(Texts& texts, const QString& text, const QObject& where) {
  if (!text.trimmed().isEmpty()) {
    texts.emplace(text,
                  QString::fromLatin1(where.metaObject()->className()) + u' ' + where.objectName());
  }
}

void add_widget(Texts& texts, const QWidget& widget) {
  add(texts, widget.toolTip(), widget);
  add(texts, widget.statusTip(), widget);
  if (widget.isWindow() || qobject_cast<const QDockWidget*>(&widget) != nullptr) {
    add(texts, widget.windowTitle(), widget);
  }
  if (const auto* const label = qobject_cast<const QLabel*>(&widget)) {
    add(texts, label->text(), widget);
  } else if (const auto* const button = qobject_cast<const QAbstractButton*>(&widget)) {
    add(texts, button->text(), widget);
  } else if (const auto* const group = qobject_cast<const QGroupBox*>(&widget)) {
    add(texts, group->title(), widget);
  } else if (const auto* const line = qobject_cast<const QLineEdit*>(&widget)) {
    add(texts, line->placeholderText(), widget);
  } else if (const auto* const menu = qobject_cast<const QMenu*>(&widget)) {
    add(texts, menu->title(), widget);
  } else if (const auto* const tabs = qobject_cast<const QTabBar*>(&widget)) {
    for (int i = 0; i < tabs->count(); ++i) add(texts, tabs->tabText(i), widget);
  } else if (const auto* const choice = qobject_cast<const QComboBox*>(&widget)) {
    for (int i = 0; i < choice->count(); ++i) add(texts, choice->itemText(i), widget);
  } else if (const auto* const tree = qobject_cast<const QTreeWidget*>(&widget)) {
    for (int i = 0; i < tree->columnCount(); ++i) {
      add(texts, tree->headerItem()->text(i), widget);
    }
    for (int i = 0; i < tree->topLevelItemCount(); ++i) {
      add(texts, tree->topLevelItem(i)->text(0), widget);
    }
  }
  for (const QAction* const action : widget.actions()) {
    add(texts, action->text(), *action);
    add(texts, action->toolTip(), *action);
  }
}

Texts texts_of(const QWidget& window) {
  Texts texts;
  add_widget(texts, window);
  for (const QWidget* const widget : window.findChildren<QWidget*>()) add_widget(texts, *widget);
  return texts;
}

/// What is the same in both languages: names, units, keys, words of DGT and of the control.
QString without_names(QString text) {
  static const QRegularExpression kNames(QStringLiteral(
      "DGT Studio|DGT\\d+|Русский|English|G-code|UTF-8|utf-8|windows-1251|cp866|koi8-r|CRLF|TOML|"
      "SVG|PDF|PNG|DXF|ESSI|essi-iso|GNU|Ctrl|Shift|Alt|Enter|Return|Space|Home|End|Esc|Del|PgUp|"
      "PgDown|"
      "<[^>]*>|&nbsp;|\\*\\.\\w+|/dev/\\w+|\\.[a-z0-9]+\\b|[\\w/"
      "-]+\\.(bgt|toml|txt)|[A-Z]+\\d*(=[A-Z0-9.,-]+)?"));
  return text.remove(QLatin1Char('&')).remove(kNames);
}

class Languages : public StudioWindow {
 protected:
  /// Widgets are told of it as of any event.
  static void choose(QAction* language) {
    language->trigger();
    QCoreApplication::processEvents();
  }
  void TearDown() override {
    use_language(Language::English);
    StudioWindow::TearDown();
  }
};

/// The texts that have letters of the wrong alphabet.
std::string foreign(const QWidget& window, Language language) {
  // A word of two letters or more; single ones are names of elements and axes.
  static const QRegularExpression kCyrillic(QStringLiteral("[А-Яа-яЁё]{2,}"));
  static const QRegularExpression kLatin(QStringLiteral("[A-Za-z]{2,}"));
  const QRegularExpression& wrong = language == Language::Russian ? kLatin : kCyrillic;
  std::string found;
  for (const auto& [text, where] : texts_of(window)) {
    if (without_names(text).contains(wrong)) {
      found += where.toStdString() + ": " + text.toStdString() + "\n";
    }
  }
  return found;
}

TEST_F(Languages, NothingOfTheOtherStaysInTheMainWindow) {
  type(QStringLiteral("L1=X0\nP1=L1 L3\n"));
  ASSERT_TRUE(compiled());
  EXPECT_EQ(foreign(*window, Language::English), "");
  choose(window->actions().russian);
  EXPECT_TRUE(window->windowTitle().contains(QStringLiteral("Новая программа")));
  EXPECT_EQ(foreign(*window, Language::Russian), "");
  choose(window->actions().english);
  EXPECT_EQ(foreign(*window, Language::English), "");
}

TEST_F(Languages, DialogsAreInTheLanguageOfTheWindow) {
  for (const Language language : {Language::Russian, Language::English}) {
    use_language(language);
    EXPECT_EQ(foreign(ColoursDialog(), language), "");
    EXPECT_EQ(foreign(MachineDialog({}), language), "");
    EXPECT_EQ(foreign(HelpWindow(), language), "");
    for (const TapeJob job : {TapeJob::Read, TapeJob::Punch, TapeJob::Duplicate}) {
      EXPECT_EQ(foreign(TapeDialog(job, Settings()), language), "");
    }
  }
}

TEST_F(Languages, MessagesOfTheCompilerGoAlong) {
  type(QStringLiteral("P1=L1 L3\n"));
  ASSERT_TRUE(compiled());
  const QString english = window->panels().faults->topLevelItem(0)->text(0);
  choose(window->actions().russian);
  EXPECT_NE(window->panels().faults->topLevelItem(0)->text(0), english);
  choose(window->actions().english);
  EXPECT_EQ(window->panels().faults->topLevelItem(0)->text(0), english);
}

TEST_F(Languages, TheChoiceIsRemembered) {
  choose(window->actions().russian);
  window->close();
  window = std::make_unique<MainWindow>(MainWindow::Options{{}, Theme::Light, {}});
  EXPECT_TRUE(window->actions().russian->isChecked());
  EXPECT_TRUE(window->windowTitle().contains(QStringLiteral("Новая программа")));
}

TEST(Translations, AreComplete) {
  const QDir studio(QStringLiteral(DGT_SOURCE_DIR "/apps/studio"));
  int files = 0;
  for (const QString& folder : studio.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QString name = studio.filePath(folder + u'/' + folder + QStringLiteral("_ru.ts"));
    if (!QFileInfo::exists(name)) continue;
    ++files;
    QFile file(name);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QString source;
    while (!xml.atEnd()) {
      xml.readNext();
      if (xml.isStartElement() && xml.name() == QStringLiteral("source")) {
        source = xml.readElementText();
      } else if (xml.isStartElement() && xml.name() == QStringLiteral("translation")) {
        const bool unfinished = xml.attributes().hasAttribute(QStringLiteral("type"));
        const QString text = xml.readElementText(QXmlStreamReader::IncludeChildElements);
        EXPECT_FALSE(unfinished || text.trimmed().isEmpty())
            << name.toStdString() << ": " << source.toStdString();
        // What is put in has a place in both.
        for (const char* const place : {"%1", "%2", "%3", "%n"}) {
          EXPECT_EQ(source.contains(QLatin1String(place)), text.contains(QLatin1String(place)))
              << source.toStdString();
        }
      }
    }
    EXPECT_FALSE(xml.hasError()) << name.toStdString();
  }
  EXPECT_GE(files, 2);
}

}  // namespace
}  // namespace dgt::studio
