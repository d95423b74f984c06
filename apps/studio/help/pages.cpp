// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/help/pages.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <optional>

#include "apps/studio/help/made_pages.h"

namespace dgt::studio {
namespace {

const auto kFolder = QStringLiteral(":/studio/help/");

QString text_of(const QString& name) {
  QFile file(name);
  const bool is_open = file.open(QIODevice::ReadOnly);
  return is_open ? QString::fromUtf8(file.readAll()) : QString();
}

/// `<!-- key rest -->`
std::optional<QString> remark(const QString& line, QStringView key) {
  static const QRegularExpression kForm(QStringLiteral("^<!-- (\\S+) (.*) -->$"));
  const auto match = kForm.match(line);
  if (!match.hasMatch() || match.captured(1) != key) return std::nullopt;
  return match.captured(2);
}

/// Puts a page together, line by line.
class Binder {
 public:
  explicit Binder(HelpBook& book) : book_(book) {}

  void add(const QString& source) {
    HelpPage page;
    QStringList topics;
    bool in_code = false;
    for (const QString& line : source.split(u'\n')) {
      if (line.startsWith(QStringLiteral("```"))) in_code = !in_code;
      if (const auto words = remark(line, u"topics")) {
        topics = words->split(u' ', Qt::SkipEmptyParts);
      } else if (const auto sample = remark(line, u"sample")) {
        append(page, sample_text(*sample));
      } else if (remark(line, u"generated")) {
        append(page, table_of_dialects());
      } else {
        const int level = in_code ? 0 : level_of(line);
        if (level > 0) {
          page.sections.push_back({level, line.mid(level + 1), std::exchange(topics, {}), {}});
        }
        append(page, line);
      }
    }
    book_.pages.push_back(std::move(page));
  }

 private:
  static int level_of(const QString& line) {
    int level = 0;
    while (level < line.size() && line[level] == u'#') ++level;
    return level > 0 && level < line.size() && line[level] == u' ' ? level : 0;
  }
  static void append(HelpPage& page, const QString& text) {
    page.markdown += text + u'\n';
    if (!page.sections.empty()) page.sections.back().text += text + u'\n';
  }
  QString sample_text(const QString& name) {
    const auto found = samples_.find(name);
    if (found == samples_.end()) return {};
    QString text;
    for (const auto& [file, content] : found->second.files) text += file_text(file, content);
    if (!text.isEmpty()) text += bridge_to_program() + QStringLiteral("\n\n");
    text += code(QString::fromStdString(found->second.program));
    book_.figures.insert(*found);
    return text + QStringLiteral("\n![%1](figure:%1)\n").arg(name);
  }
  static QString code(const QString& text) { return QStringLiteral("```\n%1```\n").arg(text); }
  static QString file_text(const std::string& file, const std::string& content) {
    return QStringLiteral("`%1`:\n\n").arg(QString::fromStdString(file)) +
           code(QString::fromStdString(content)) + u'\n';
  }

  HelpBook& book_;
  std::map<QString, Figure> samples_ = help_samples();
};

}  // namespace

std::map<QString, Figure> help_samples() {
  static const QRegularExpression kPart(
      QStringLiteral("^## (\\S+)$|^```dgt-file (\\S+)\\n([^`]*)```$|^```dgt\\n([^`]*)```$"),
      QRegularExpression::MultilineOption);
  std::map<QString, Figure> samples;
  QString name;
  auto parts = kPart.globalMatch(text_of(kFolder + QStringLiteral("samples.md")));
  while (parts.hasNext()) {
    const auto part = parts.next();
    if (!part.captured(1).isEmpty()) {
      name = part.captured(1);
    } else if (!part.captured(2).isEmpty()) {
      samples[name].files.emplace(part.captured(2).toStdString(), part.captured(3).toStdString());
    } else {
      samples[name].program = part.captured(4).toStdString();
    }
  }
  return samples;
}

HelpBook help_book(Language language) {
  HelpBook book;
  Binder binder(book);
  const QString folder =
      kFolder + (language == Language::Russian ? QStringLiteral("ru/") : QStringLiteral("en/"));
  for (const QString& name :
       QDir(folder).entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name)) {
    // The forms of definitions come third, where their number is missing.
    if (name.startsWith(u'4')) binder.add(page_of_definitions(book.figures));
    binder.add(text_of(folder + name));
  }
  binder.add(page_of_messages(language));
  return book;
}

std::optional<HelpPlace> HelpBook::place_of(const QString& word) const {
  const QString wanted = word.trimmed();
  const auto find = [this](const QString& topic) -> std::optional<HelpPlace> {
    for (std::size_t page = 0; page < pages.size(); ++page) {
      for (std::size_t section = 0; section < pages[page].sections.size(); ++section) {
        if (pages[page].sections[section].topics.contains(topic, Qt::CaseInsensitive))
          return HelpPlace{page, section};
      }
    }
    return std::nullopt;
  };
  if (wanted.isEmpty()) return std::nullopt;
  if (const auto place = find(wanted)) return place;
  static const QRegularExpression kNumbered(QStringLiteral("^([A-Za-z]+)[-+]?[0-9.]*$"));
  const auto numbered = kNumbered.match(wanted);
  return numbered.hasMatch() ? find(numbered.captured(1)) : std::nullopt;
}

}  // namespace dgt::studio
