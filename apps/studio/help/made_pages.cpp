// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/help/made_pages.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include "apps/studio/language.h"
#include "apps/studio/wizard/definition_forms.h"
#include "post/dialect.h"

namespace dgt::studio {
namespace {

/// The context of the sentences.
struct Help {
  Q_DECLARE_TR_FUNCTIONS(Help)
};

QString qt(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// As Markdown says it literally.
QString literal(QString text) {
  static const QRegularExpression kSigns(QStringLiteral("([\\\\*_`#|<>\\[\\]])"));
  return text.replace(kSigns, QStringLiteral("\\\\\\1"));
}

QString heading_of(char kind) {
  switch (kind) {
    case 'L':
      return Help::tr("Lines: L");
    case 'C':
      return Help::tr("Circles: C");
    case 'P':
      return Help::tr("Points: P");
    default:
      return Help::tr("Coordinate systems");
  }
}

QString name_of_severity(Severity severity) {
  switch (severity) {
    case Severity::Error:
      return Help::tr("error");
    case Severity::Warning:
      return Help::tr("warning");
    case Severity::Note:
      break;
  }
  return Help::tr("note");
}

}  // namespace

QString page_of_definitions(std::map<QString, Figure>& figures) {
  QString page = QStringLiteral("# %1\n\n%2\n\n")
                     .arg(Help::tr("Definitions"),
                          Help::tr("Operands of unlike kinds may stand in any order, those of one "
                                   "kind in the order that says which is first. `X… Y…` may stand "
                                   "for any point. An element may be defined again; what is cut "
                                   "already stays. Green is what is defined."));
  char kind = 0;
  for (const DefinitionForm& form : definition_forms()) {
    const QString pattern = qt(form.pattern);
    if (form.kind() != kind) {
      kind = form.kind();
      if (kind != 'O') page += QStringLiteral("<!-- topics %1 -->\n").arg(QChar::fromLatin1(kind));
      page += QStringLiteral("## %1\n\n").arg(heading_of(kind));
    }
    const QString figure = QStringLiteral("form:") + pattern;
    figures.emplace(figure, form.figure);
    page +=
        QStringLiteral("<!-- topics %1 -->\n### %1\n\n%2:\n\n```\n%3\n```\n\n![%1](figure:%4)\n\n")
            .arg(pattern, literal(form.description), qt(form.example()), figure);
  }
  return page;
}

QString page_of_messages(Language language) {
  QString page = QStringLiteral("<!-- topics messages -->\n# %1\n\n").arg(Help::tr("Messages"));
  static const QRegularExpression kPlaceholder(QStringLiteral("\\{\\d+\\}"));
  for (const MessageInfo& message : all_messages()) {
    const QString code = qt(message.code);
    QString text = qt(language == Language::Russian ? message.russian : message.english);
    text.replace(kPlaceholder, QStringLiteral("…"));
    page += QStringLiteral("<!-- topics %1 -->\n### %1 · %2\n\n%3\n\n")
                .arg(code, name_of_severity(message.severity), literal(text));
  }
  return page;
}

QString bridge_to_program() { return Help::tr("and the program that uses it:"); }

QString table_of_dialects() {
  QString table = QStringLiteral("| %1 | %2 |\n| --- | --- |\n")
                      .arg(Help::tr("dialect"), Help::tr("what it is"));
  const bool russian = message_language() == Language::Russian;
  for (const Dialect& dialect : dialects()) {
    table += QStringLiteral("| `%1` | %2 |\n")
                 .arg(qt(dialect.name), literal(qt(russian ? dialect.about_ru : dialect.about)));
  }
  return table;
}

}  // namespace dgt::studio
