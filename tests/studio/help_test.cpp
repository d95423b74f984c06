// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <QApplication>
#include <QLineEdit>
#include <QScrollBar>
#include <QTest>
#include <QTextBlock>
#include <QTreeWidget>

#include "apps/studio/help/help_view.h"
#include "apps/studio/help/help_window.h"
#include "apps/studio/window/languages.h"
#include "lang/dgt/forms.h"
#include "tests/studio/qt_values.h"

namespace dgt::studio {
namespace {

constexpr Language kLanguages[] = {Language::English, Language::Russian};

struct InLanguage {
  explicit InLanguage(Language language) { use_language(language); }
  ~InLanguage() { use_language(Language::English); }
};

QString qt(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

TEST(Help, EveryLetterAndKeywordHasATopicInBothLanguages) {
  for (const Language language : kLanguages) {
    const InLanguage in(language);
    const HelpBook book = help_book(language);
    for (const char letter : std::string("ABCDFGIKLMNOPRSTUVWXYZ"))
      EXPECT_TRUE(book.place_of(QString(QChar::fromLatin1(letter)))) << letter;
    for (const char* word :
         {"FOR", "NEXT", "MAC", "OPR", "G0", "G54", "F0",   "X>",   "Y>", "X<",    "Y<",
          "'",   ",",    "=",   "'@",  "I2", "nc",  "tape", "keys", "F5", "verify"}) {
      EXPECT_TRUE(book.place_of(QString::fromLatin1(word))) << word;
    }
  }
}

TEST(Help, EveryFormOfDefinitionHasATopicAndAFigure) {
  for (const Language language : kLanguages) {
    const InLanguage in(language);
    const HelpBook book = help_book(language);
    for (const language::Form& form : language::all_forms()) {
      for (const QString& pattern : qt(form.pattern).split(u' ')) {
        EXPECT_TRUE(book.place_of(pattern)) << pattern.toStdString();
        EXPECT_TRUE(book.figures.contains(QStringLiteral("form:") + pattern));
      }
    }
  }
}

TEST(Help, EveryMessageHasATopic) {
  const HelpBook book = help_book(Language::English);
  for (const MessageInfo& message : all_messages())
    EXPECT_TRUE(book.place_of(qt(message.code))) << message.code;
}

TEST(Help, ATopicIsExplainedInOnePlace) {
  for (const Language language : kLanguages) {
    const InLanguage in(language);
    const HelpBook book = help_book(language);
    std::map<QString, int> count;
    for (const HelpPage& page : book.pages) {
      for (const HelpSection& section : page.sections)
        for (const QString& topic : section.topics) ++count[topic.toUpper()];
    }
    for (const auto& [topic, times] : count) EXPECT_EQ(times, 1) << topic.toStdString();
  }
}

TEST(Help, BothLanguagesSayTheSameThings) {
  const InLanguage in(Language::Russian);
  const HelpBook russian = help_book(Language::Russian);
  const HelpBook english = help_book(Language::English);
  ASSERT_EQ(russian.pages.size(), english.pages.size());
  for (std::size_t page = 0; page < english.pages.size(); ++page) {
    const auto& en = english.pages[page].sections;
    const auto& ru = russian.pages[page].sections;
    ASSERT_EQ(en.size(), ru.size()) << en[0].title.toStdString();
    for (std::size_t i = 0; i < en.size(); ++i) {
      EXPECT_EQ(en[i].topics, ru[i].topics) << en[i].title.toStdString();
      EXPECT_EQ(en[i].text.count(QStringLiteral("figure:")),
                ru[i].text.count(QStringLiteral("figure:")));
    }
  }
}

TEST(Help, EverySampleCompilesAndIsShown) {
  const HelpBook book = help_book(Language::English);
  const DrawingStyle style = figure_style(standard_colours(Theme::Light), 200);
  for (const auto& [name, figure] : help_samples()) {
    EXPECT_FALSE(draw_figure(figure, style).isNull()) << name.toStdString();
    EXPECT_TRUE(book.figures.contains(name)) << name.toStdString() << " is on no page";
  }
}

TEST(Help, EveryFigureOfAPageExists) {
  for (const Language language : kLanguages) {
    const HelpBook book = help_book(language);
    for (const HelpPage& page : book.pages) {
      EXPECT_FALSE(page.markdown.contains(QStringLiteral("<!--"))) << page.title().toStdString();
    }
  }
}

TEST(HelpWindow, ShowsTheTopicOfAWord) {
  HelpWindow window;
  window.show();
  window.show_topic(QStringLiteral("FOR"));
  const auto* const view = window.findChild<HelpView*>();
  EXPECT_TRUE(view->textCursor().block().text().startsWith(QStringLiteral("FOR")))
      << view->textCursor().block().text().toStdString();
  window.show_topic(QStringLiteral("C12"));
  EXPECT_TRUE(view->textCursor().block().text().contains(QStringLiteral("Circles")));
  window.show_topic(QStringLiteral("g54"));
  EXPECT_TRUE(view->textCursor().block().text().startsWith(QStringLiteral("G:")));
  window.show_topic(QStringLiteral("nonsense!"));
  EXPECT_EQ(window.place(), HelpPlace{});
}

TEST(HelpWindow, GoesBackAndForth) {
  HelpWindow window;
  window.show();
  window.show_topic(QStringLiteral("FOR"));
  const HelpPlace loop = window.place();
  window.show_topic(QStringLiteral("W"));
  QTest::keyClick(&window, Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(window.place(), loop);
  QTest::keyClick(&window, Qt::Key_Right, Qt::AltModifier);
  EXPECT_NE(window.place(), loop);
}

TEST(HelpWindow, SearchFindsWordsOfTheText) {
  HelpWindow window;
  window.show();
  auto* const wanted = window.findChild<QLineEdit*>();
  QTest::keyClicks(wanted, QStringLiteral("spliced"));
  auto* const contents = window.findChild<QTreeWidget*>();
  int shown = 0;
  for (int i = 0; i < contents->topLevelItemCount(); ++i)
    shown += contents->topLevelItem(i)->isHidden() ? 0 : 1;
  EXPECT_GE(shown, 1);
  EXPECT_LT(shown, contents->topLevelItemCount());
  QTest::keyClick(wanted, Qt::Key_Return);
  EXPECT_EQ(window.findChild<HelpView*>()->textCursor().selectedText(), QStringLiteral("spliced"));
}

TEST(HelpWindow, DrawsTheFiguresOfThePage) {
  HelpWindow window;
  window.show();
  window.show_topic(QStringLiteral("V"));
  const auto* const view = window.findChild<HelpView*>();
  EXPECT_TRUE(QTest::qWaitFor([&] { return view->has_figure(QStringLiteral("chamfer")); }, 10000));
}

TEST(HelpWindow, SpeaksTheLanguageOfTheProgram) {
  HelpWindow window;
  window.show();
  window.show_topic(QStringLiteral("W"));
  const HelpPlace place = window.place();
  const InLanguage in(Language::Russian);
  QApplication::processEvents();  // windows are told by an event
  EXPECT_EQ(window.place(), place);
  EXPECT_EQ(window.findChild<HelpView*>()->textCursor().block().text(),
            QStringLiteral("W: эквидистанта"));
}

}  // namespace
}  // namespace dgt::studio
