// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/wizard/template_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>
#include <utility>

#include "apps/studio/flow_layout.h"
#include "apps/studio/language.h"
#include "apps/studio/window/theme.h"
#include "apps/studio/wizard/definition_forms.h"
#include "lang/dgt/parser.h"

namespace dgt::studio {
namespace {

constexpr int kNumberLetters = 4;  // of an element: 0…9999
constexpr int kValueLetters = 7;

bool is_on_to_next(int key) {
  return key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter;
}

}  // namespace

TemplateBar::TemplateBar(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  row_ = new QWidget(this);
  message_ = new QLabel(this);
  message_->setWordWrap(true);
  message_->setTextFormat(Qt::PlainText);
  message_->setObjectName(QStringLiteral("message"));
  keys_ = new QLabel(this);
  keys_->setWordWrap(true);
  for (QWidget* const part : {static_cast<QWidget*>(row_), static_cast<QWidget*>(message_),
                              static_cast<QWidget*>(keys_)}) {
    column->addWidget(part);
  }
  new FlowLayout(row_);
  retranslate();
  end();
}

void TemplateBar::clear() {
  // Line edits may be on the stack of the key that ends them.
  for (const Field& field : fields_) field.edit->removeEventFilter(this);
  fields_.clear();
  while (QLayoutItem* const item = row_->layout()->takeAt(0)) {
    if (QWidget* const part = item->widget()) {
      part->setParent(nullptr);
      part->deleteLater();
    }
    delete item;
  }
}

QLineEdit* TemplateBar::add_field(const QString& sign, char letter, int letters_wide) {
  auto* pair = new QWidget(row_);
  auto* row = new QHBoxLayout(pair);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(3);
  auto* label = new QLabel(sign, pair);
  QFont bold = label->font();
  bold.setBold(true);
  label->setFont(bold);
  auto* edit = new QLineEdit(pair);
  row->addWidget(label);
  row->addWidget(edit);
  edit->setObjectName(QStringLiteral("field%1").arg(fields_.size()));
  edit->setFixedWidth(edit->fontMetrics().horizontalAdvance(u'0') * (letters_wide + 2));
  edit->installEventFilter(this);
  row_->layout()->addWidget(pair);
  pair->show();  // now, not in the next round of events: it gets the focus
  fields_.push_back({letter, edit});
  return edit;
}

void TemplateBar::begin(const std::string& pattern, int number) {
  clear();
  pattern_ = pattern;
  const QString target(QChar::fromLatin1(pattern.front()));
  add_field(target, pattern.front(), kNumberLetters)->setText(QString::number(number));
  QString equals = QStringLiteral("= ");
  for (const char letter : pattern.substr(2)) {
    const QString sign = std::exchange(equals, QString()) + QChar::fromLatin1(letter);
    const int width = names_an_element(letter) ? kNumberLetters : kValueLetters;
    QLineEdit* const edit = add_field(sign, letter, width);
    // The guide's second solution; the other choices are typed over it.
    if (letter == 'I') edit->setText(QStringLiteral("2"));
  }
  show();
  focus_on(1);
}

void TemplateBar::end() {
  clear();
  pattern_.clear();
  tell({}, false);
  hide();
}

TemplateBar::Line TemplateBar::line(std::size_t typed) const {
  Line line;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (i == 1) line.text += '=';
    if (i > 1) line.text += ' ';
    line.text += fields_[i].letter;
    const std::size_t begin = line.text.size();
    line.text += i < typed ? fields_[i].edit->text().trimmed().toStdString() : "1";
    line.values.emplace_back(begin, line.text.size());
  }
  return line;
}

/// Asks the parser of the language, with the values so far; a fault is told and shown at its value.
bool TemplateBar::accepts(std::size_t typed) {
  const Line made = line(typed);
  const SourceFile file("line", made.text, Encoding::Utf8);
  DiagnosticBag bag;
  const language::Program program = language::parse(file, bag);
  for (const Diagnostic& diagnostic : bag.all()) {
    if (diagnostic.severity() != Severity::Error) continue;
    tell(QString::fromStdString(text(diagnostic.message, diagnostic.arguments, message_language())),
         true);
    for (std::size_t i = 0; i < typed; ++i) {
      const auto [begin, end] = made.values[i];
      if (diagnostic.range.begin > end || diagnostic.range.end < begin) continue;
      focus_on(i);
      return false;
    }
    focus_on(typed - 1);
    return false;
  }
  const bool is_one = program.statements.size() == 1 &&
                      std::holds_alternative<language::Definition>(program.statements[0].body);
  if (!is_one) tell(tr("This is no definition."), true);
  return is_one;
}

void TemplateBar::go_on(std::size_t from) {
  if (!accepts(from + 1)) return;
  tell({}, false);
  if (from + 1 == fields_.size()) {
    complete();
  } else {
    focus_on(from + 1);
  }
}

void TemplateBar::go_back(std::size_t from) {
  if (from > 0) focus_on(from - 1);
}

void TemplateBar::focus_on(std::size_t index) {
  QLineEdit* const edit = fields_.at(index).edit;
  edit->setFocus(Qt::OtherFocusReason);
  edit->selectAll();
}

/// The number may be larger than the language takes; accepts() has looked at it.
void TemplateBar::complete() {
  for (std::size_t i = 1; i < fields_.size(); ++i) {
    const char letter = fields_[i].letter;
    const int number = std::abs(fields_[i].edit->text().toInt());
    if (letter == 'I' || !names_an_element(letter) || program_.defines(letter, number)) continue;
    tell(tr("%1%2 is not defined in the program yet.")
             .arg(QChar::fromLatin1(letter))
             .arg(fields_[i].edit->text()),
         false);
  }
  const int number = fields_.front().edit->text().toInt();
  emit finished(QString::fromStdString(line(fields_.size()).text), number);
}

void TemplateBar::tell(const QString& message, bool is_error) {
  QPalette palette = message_->palette();
  palette.setColor(QPalette::WindowText, is_error ? colours().error : colours().warning);
  message_->setPalette(palette);
  message_->setText(message);
  message_->setVisible(!message.isEmpty());
}

std::optional<std::size_t> TemplateBar::index_of(const QObject* edit) const {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (fields_[i].edit == edit) return i;
  }
  return std::nullopt;
}

bool TemplateBar::eventFilter(QObject* watched, QEvent* event) {
  const auto index = index_of(watched);
  if (!index) return QWidget::eventFilter(watched, event);
  auto* const key = static_cast<QKeyEvent*>(event);
  if (event->type() == QEvent::ShortcutOverride) {
    // The window's own keys have to wait.
    if (key->key() == Qt::Key_Escape || is_on_to_next(key->key())) event->accept();
    return false;
  }
  if (event->type() != QEvent::KeyPress) return false;
  QLineEdit* const edit = fields_[*index].edit;
  if (is_on_to_next(key->key())) {
    go_on(*index);
  } else if (key->key() == Qt::Key_Escape) {
    end();
    emit left();
  } else if (key->key() == Qt::Key_Backspace && edit->text().isEmpty()) {
    go_back(*index);
  } else if (key->key() == Qt::Key_Comma && key->modifiers() == Qt::NoModifier) {
    edit->insert(QStringLiteral("."));  // the decimal key of many keyboards
  } else {
    return false;
  }
  return true;
}

void TemplateBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void TemplateBar::retranslate() {
  keys_->setText(tr("Space: next value. Esc: done."));
  tell({}, false);
}

}  // namespace dgt::studio
