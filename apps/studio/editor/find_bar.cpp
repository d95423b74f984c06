// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/editor/find_bar.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QTextBlock>
#include <QToolButton>

#include "apps/studio/editor/source_editor.h"

namespace dgt::studio {
namespace {

QToolButton* button(QWidget* parent) {
  auto* const made = new QToolButton(parent);
  made->setToolButtonStyle(Qt::ToolButtonTextOnly);
  made->setAutoRaise(true);
  return made;
}

}  // namespace

FindBar::FindBar(SourceEditor* editor, QWidget* parent)
    : QWidget(parent),
      editor_(editor),
      sought_(new QLineEdit(this)),
      replacement_(new QLineEdit(this)),
      case_(new QCheckBox(this)),
      expression_(new QCheckBox(this)),
      previous_(button(this)),
      next_(button(this)),
      replace_(button(this)),
      replace_all_(button(this)),
      close_(button(this)),
      result_(new QLabel(this)) {
  setObjectName(QStringLiteral("find_bar"));
  sought_->setObjectName(QStringLiteral("sought"));
  replacement_->setObjectName(QStringLiteral("replacement"));
  auto* const grid = new QGridLayout(this);
  grid->setContentsMargins(4, 2, 4, 2);
  grid->addWidget(sought_, 0, 0);
  grid->addWidget(previous_, 0, 1);
  grid->addWidget(next_, 0, 2);
  grid->addWidget(close_, 0, 4);
  grid->addWidget(replacement_, 1, 0);
  grid->addWidget(replace_, 1, 1);
  grid->addWidget(replace_all_, 1, 2);
  auto* const how = new QHBoxLayout;
  how->addWidget(case_);
  how->addWidget(expression_);
  how->addWidget(result_, 1);
  grid->addLayout(how, 2, 0, 1, 5);
  grid->setColumnStretch(0, 1);
  connect(sought_, &QLineEdit::textChanged, this, &FindBar::show_found);
  connect(case_, &QCheckBox::toggled, this, &FindBar::show_found);
  connect(expression_, &QCheckBox::toggled, this, &FindBar::show_found);
  connect(previous_, &QToolButton::clicked, this, [this] { find(false); });
  connect(next_, &QToolButton::clicked, this, [this] { find(true); });
  connect(replace_, &QToolButton::clicked, this, &FindBar::replace);
  connect(replace_all_, &QToolButton::clicked, this, &FindBar::replace_all);
  connect(close_, &QToolButton::clicked, this, &FindBar::close_bar);
  retranslate();
  hide();
}

void FindBar::retranslate() {
  sought_->setPlaceholderText(tr("Find"));
  replacement_->setPlaceholderText(tr("Replace with"));
  case_->setText(tr("Match case"));
  expression_->setText(tr("Regular expression"));
  previous_->setText(QStringLiteral("▲"));
  previous_->setToolTip(tr("Previous place (Shift+F3)"));
  next_->setText(QStringLiteral("▼"));
  next_->setToolTip(tr("Next place (F3)"));
  replace_->setText(tr("Replace"));
  replace_all_->setText(tr("Replace all"));
  close_->setText(QStringLiteral("✕"));
  close_->setToolTip(tr("Close (Esc)"));
  result_->clear();
}

void FindBar::open(bool to_replace) {
  const QString selected = editor_->textCursor().selectedText();
  if (!selected.isEmpty() && !selected.contains(QChar::ParagraphSeparator)) {
    sought_->setText(expression_->isChecked() ? QRegularExpression::escape(selected) : selected);
  }
  for (QWidget* const w : std::initializer_list<QWidget*>{replacement_, replace_, replace_all_}) {
    w->setVisible(to_replace);
  }
  show();
  sought_->setFocus();
  sought_->selectAll();
  show_found();
}

void FindBar::close_bar() {
  editor_->show_found({});
  hide();
  editor_->setFocus();
}

QRegularExpression FindBar::pattern() const {
  QRegularExpression pattern(
      expression_->isChecked() ? sought_->text() : QRegularExpression::escape(sought_->text()));
  QRegularExpression::PatternOptions options = QRegularExpression::UseUnicodePropertiesOption;
  options.setFlag(QRegularExpression::CaseInsensitiveOption, !case_->isChecked());
  pattern.setPatternOptions(options);
  return pattern;
}

void FindBar::show_found() {
  const QRegularExpression sought = pattern();
  result_->setText(sought.isValid() ? QString() : tr("This is no regular expression"));
  editor_->show_found(sought.isValid() ? sought : QRegularExpression());
}

void FindBar::find(bool forward) {
  const QRegularExpression sought = pattern();
  if (!sought.isValid() || sought_->text().isEmpty()) {
    open(false);
    return;
  }
  QTextDocument::FindFlags flags;
  flags.setFlag(QTextDocument::FindBackward, !forward);
  QTextDocument* const document = editor_->document();
  QTextCursor found = document->find(sought, editor_->textCursor(), flags);
  bool wrapped = false;
  if (found.isNull()) {
    QTextCursor end(document);
    if (!forward) end.movePosition(QTextCursor::End);
    found = document->find(sought, end, flags);
    wrapped = !found.isNull();
  }
  if (found.isNull()) {
    result_->setText(tr("Not found"));
    return;
  }
  result_->setText(wrapped ? tr("Went on from the other end") : QString());
  editor_->setTextCursor(found);
}

QString FindBar::replacement_for(const QRegularExpressionMatch& match) const {
  QString text = replacement_->text();
  if (!expression_->isChecked()) return text;
  for (int i = match.lastCapturedIndex(); i >= 0; --i) {
    text.replace(QStringLiteral("\\%1").arg(i), match.captured(i));
  }
  return text;
}

void FindBar::replace() {
  QTextCursor cursor = editor_->textCursor();
  const auto match = pattern().match(cursor.selectedText());
  const bool is_found = match.hasMatch() && match.capturedLength() > 0 &&
                        match.capturedLength() == cursor.selectedText().size();
  if (is_found) cursor.insertText(replacement_for(match));
  find(true);
}

void FindBar::replace_all() {
  const QRegularExpression sought = pattern();
  if (!sought.isValid() || sought_->text().isEmpty()) return;
  const QString before = editor_->text();
  QString after;
  qsizetype done = 0;
  int count = 0;
  for (auto matches = sought.globalMatch(before); matches.hasNext(); ++count) {
    const QRegularExpressionMatch match = matches.next();
    after += QStringView(before).mid(done, match.capturedStart() - done);
    after += replacement_for(match);
    done = match.capturedEnd();
  }
  after += QStringView(before).mid(done);
  if (count > 0) editor_->replace_text(after);
  result_->setText(tr("Replaced: %1").arg(count));
}

void FindBar::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape:
      close_bar();
      return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      find(!event->modifiers().testFlag(Qt::ShiftModifier));
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

void FindBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

}  // namespace dgt::studio
