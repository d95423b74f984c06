// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/editor/completion.h"

#include <QAbstractItemView>
#include <QKeyEvent>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBlock>
#include <algorithm>
#include <array>

#include "apps/studio/editor/source_editor.h"

namespace dgt::studio {
namespace {

using language::ElementEntry;
using language::ElementKind;
using language::Form;

constexpr std::array kKinds = {ElementKind::Line, ElementKind::Circle, ElementKind::Point,
                               ElementKind::Frame};
constexpr std::size_t kMostProposals = 500;  // nobody reads more

QString qt(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString letter_of(ElementKind kind) { return QString(QLatin1Char(static_cast<char>(kind))); }

bool is_defined(const ElementEntry& entry) { return entry.state == ElementEntry::State::Defined; }

/// The source line of a definition, as the person wrote it.
QString definition_of(const ElementEntry& entry) {
  if (entry.place.file == nullptr) return {};
  const Place place = entry.place.place();
  return qt(entry.place.file->line_text(place.line)).trimmed();
}

int next_free(const Part* part, ElementKind kind) {
  if (part == nullptr) return 1;
  const auto& entries = part->compilation.result.elements.all(kind);
  for (std::size_t i = entries.size(); i > 1; --i) {
    if (entries[i - 1].state != ElementEntry::State::Undefined) return static_cast<int>(i);
  }
  return 1;
}

void add_elements(std::vector<Proposal>& proposals, const Part* part, ElementKind kind,
                  const QString& sign, const QString& digits) {
  if (part == nullptr) return;
  const auto& entries = part->compilation.result.elements.all(kind);
  for (std::size_t i = 0; i < entries.size() && proposals.size() < kMostProposals; ++i) {
    const QString number = QString::number(i);
    if (!is_defined(entries[i]) || !number.startsWith(digits) || number == digits) continue;
    proposals.push_back(
        {letter_of(kind) + sign + number, number.mid(digits.size()), definition_of(entries[i])});
  }
}

/// Operands as letters: those of elements and quantities, X and Y being one point.
QString operands_in(const QString& written) {
  QString letters;
  bool behind_x = false;
  for (const QChar c : written.toUpper()) {
    if (!c.isLetter() || c == u'I') continue;
    if (c == u'X') letters += u'P';
    if (c != u'X' && !(c == u'Y' && behind_x)) letters += c;
    behind_x = c == u'X';
  }
  return letters;
}

/// What a form needs besides; nothing when it has no use for what is written.
std::optional<QString> rest_of(const Form& form, const QString& written) {
  QString rest = qt(form.operands);
  for (const QChar c : written) {
    const qsizetype at = rest.indexOf(c);
    if (at < 0) return std::nullopt;
    rest.remove(at, 1);
  }
  return rest.isEmpty() ? std::nullopt : std::optional(rest);
}

void add_forms(std::vector<Proposal>& proposals, char kind, const QString& written) {
  const QString operands = operands_in(written);
  for (const Form& form : language::all_forms()) {
    if (static_cast<char>(form.result) != kind) continue;
    const auto rest = rest_of(form, operands);
    if (!rest) continue;
    QStringList letters;
    for (const QChar c : *rest) letters.push_back(QString(c));
    const QString text = letters.join(u' ');
    proposals.push_back({text, text, qt(form.pattern)});
  }
}

void add_beginnings(std::vector<Proposal>& proposals, const Part* part, const QString& begun) {
  const auto add = [&](const QString& word, const QString& note) {
    if (word.startsWith(begun) && word != begun) {
      proposals.push_back({word, word.mid(begun.size()), note});
    }
  };
  for (const ElementKind kind : kKinds) {
    add(letter_of(kind) + QString::number(next_free(part, kind)) + u'=', {});
  }
  static const std::array kWords = {QStringLiteral("G54 "), QStringLiteral("G0 "),
                                    QStringLiteral("F0 "),  QStringLiteral("FOR "),
                                    QStringLiteral("NEXT"), QStringLiteral("MAC "),
                                    QStringLiteral("OPR "), QStringLiteral("K1 ")};
  for (const QString& word : kWords) add(word, {});
}

}  // namespace

std::vector<Proposal> proposals_for(const QString& before, const Part* part) {
  static const QRegularExpression kDefinition(
      QStringLiteral("^\\s*([LCPOlcpo])\\s*\\d+\\s*=(.*)$"));
  static const QRegularExpression kElement(QStringLiteral("([LCPOlcpo])(-?)(\\d*)$"));
  static const QRegularExpression kBeginning(QStringLiteral("^\\s*([A-Za-z]*)$"));
  std::vector<Proposal> proposals;
  if (before.contains(u'\'')) return proposals;  // in a comment
  const auto definition = kDefinition.match(before);
  if (const auto element = kElement.match(before); element.hasMatch()) {
    const auto kind = static_cast<ElementKind>(element.captured(1).at(0).toUpper().toLatin1());
    add_elements(proposals, part, kind, element.captured(2), element.captured(3));
  } else if (definition.hasMatch()) {
    add_forms(proposals, definition.captured(1).at(0).toUpper().toLatin1(), definition.captured(2));
  } else if (!kBeginning.match(before).hasMatch() && before.endsWith(u' ')) {
    for (const ElementKind kind : kKinds) {
      std::vector<Proposal> of_kind;
      add_elements(of_kind, part, kind, {}, {});
      for (Proposal& one : of_kind) {
        one.inserted = one.whole;
        proposals.push_back(std::move(one));
      }
    }
  }
  if (const auto beginning = kBeginning.match(before); beginning.hasMatch()) {
    add_beginnings(proposals, part, beginning.captured(1).toUpper());
  }
  return proposals;
}

Completion::Completion(SourceEditor* editor) : QObject(editor), editor_(editor) {
  list_.setModel(&model_);
  list_.setWidget(editor);
  list_.setCompletionMode(QCompleter::UnfilteredPopupCompletion);
  connect(&list_, qOverload<const QModelIndex&>(&QCompleter::activated), this, &Completion::take);
}

void Completion::offer() {
  const QTextCursor cursor = editor_->textCursor();
  const QString before = cursor.block().text().left(cursor.positionInBlock());
  show(proposals_for(before, part_.get()));
}

void Completion::show(const std::vector<Proposal>& proposals) {
  if (proposals.empty()) {
    list_.popup()->hide();
    return;
  }
  model_.clear();
  qsizetype longest = 0;
  for (const Proposal& one : proposals) longest = std::max(longest, one.whole.size());
  for (const Proposal& one : proposals) {
    const QString label =
        one.note.isEmpty() ? one.whole : one.whole.leftJustified(longest + 3) + one.note;
    auto* const item = new QStandardItem(label);
    item->setData(one.inserted, Qt::UserRole);
    model_.appendRow(item);
  }
  QAbstractItemView* const popup = list_.popup();
  popup->setFont(editor_->font());
  QRect where = editor_->cursorRect();
  where.translate(editor_->viewport()->pos());
  where.setWidth(popup->sizeHintForColumn(0) + popup->verticalScrollBar()->sizeHint().width() + 8);
  list_.complete(where);
  popup->setCurrentIndex({});
}

void Completion::take(const QModelIndex& index) {
  editor_->textCursor().insertText(index.data(Qt::UserRole).toString());
  list_.popup()->hide();
}

bool Completion::takes(QKeyEvent* event) {
  QAbstractItemView* const popup = list_.popup();
  if (!popup->isVisible()) return false;
  switch (event->key()) {
    case Qt::Key_Tab:
      take(popup->currentIndex().isValid() ? popup->currentIndex()
                                           : list_.completionModel()->index(0, 0));
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (!popup->currentIndex().isValid()) {
        popup->hide();  // nothing was chosen: the line ends
        return false;
      }
      take(popup->currentIndex());
      return true;
    case Qt::Key_Escape:
      popup->hide();
      return true;
    default:
      return false;
  }
}

void Completion::follow(const QKeyEvent* event) {
  const QString typed = event->text();
  const bool is_word = !typed.isEmpty() && typed.at(0).isLetterOrNumber();
  const bool erases = event->key() == Qt::Key_Backspace;
  if (list_.popup()->isVisible()) {
    if (is_word || erases) {
      offer();
    } else if (!typed.isEmpty()) {
      list_.popup()->hide();
    }
    return;
  }
  // Behind a letter of an element there is a number to choose; elsewhere the list waits to be
  // asked.
  static const QString kElements = QStringLiteral("LCPlcp");
  const QTextCursor cursor = editor_->textCursor();
  const QString before = cursor.block().text().left(cursor.positionInBlock());
  if (is_word && typed.size() == 1 && kElements.contains(typed) && before.trimmed().size() > 1) {
    offer();
  }
}

}  // namespace dgt::studio
