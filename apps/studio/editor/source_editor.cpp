// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colours and squiggles are laid on the lines in view alone, just before they are painted: a line
// costs microseconds, so typing at the top of a long program waits for nothing.
#include "apps/studio/editor/source_editor.h"

#include <QFontDatabase>
#include <QPainter>
#include <QScrollBar>
#include <QTextBlock>
#include <algorithm>

#include "apps/studio/editor/completion.h"
#include "apps/studio/editor/inks.h"
#include "apps/studio/editor/line_margin.h"
#include "apps/studio/window/theme.h"

namespace dgt::studio {
namespace {

QColor colour_of(Severity severity) {
  const Colours& inks = colours();
  switch (severity) {
    case Severity::Error:
      return inks.error;
    case Severity::Warning:
      return inks.warning;
    case Severity::Note:
      break;
  }
  return inks.note;
}

/// Columns count code points, the document UTF-16 units.
int units_of(const QString& line, std::uint32_t column) {
  qsizetype at = 0;
  for (std::uint32_t i = 1; i < column && at < line.size(); ++i) {
    at += line[at].isHighSurrogate() ? 2 : 1;
  }
  return static_cast<int>(std::min(at, line.size()));
}

}  // namespace

SourceEditor::SourceEditor(QWidget* parent)
    : QPlainTextEdit(parent), margin_(new LineMargin(this)), completion_(new Completion(this)) {
  setObjectName(QStringLiteral("source"));
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  setMouseTracking(true);
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, [this] {
    highlight_line();
    emit current_line_changed(current_line());
  });
  connect(this, &QPlainTextEdit::blockCountChanged, this, &SourceEditor::lay_out_margin);
  connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect& where, int dy) {
    if (dy != 0) {
      margin_->scroll(0, dy);
    } else {
      margin_->update(0, where.y(), margin_->width(), where.height());
    }
  });
  const auto repaint = [this] {
    QPalette paper = palette();
    paper.setColor(QPalette::Base, colours().paper);
    paper.setColor(QPalette::Text, colours().text);
    setPalette(paper);
    highlight_line();
    viewport()->update();
    margin_->update();
  };
  connect(&Appearance::of_program(), &Appearance::changed, this, repaint);
  repaint();
  lay_out_margin();
}

QTextCursor SourceEditor::cursor_at(const Place& place) const {
  QTextBlock block = document()->findBlockByNumber(static_cast<int>(place.line) - 1);
  if (!block.isValid()) block = document()->lastBlock();
  QTextCursor cursor(block);
  cursor.setPosition(block.position() + units_of(block.text(), place.column));
  return cursor;
}

void SourceEditor::go_to(int line, int column) {
  setTextCursor(cursor_at({static_cast<std::uint32_t>(std::max(line, 1)),
                           static_cast<std::uint32_t>(std::max(column, 1)), 0}));
  centerCursor();
}

int SourceEditor::current_line() const { return textCursor().blockNumber() + 1; }

QString SourceEditor::word_at_cursor() const {
  const QTextCursor cursor = textCursor();
  const int at = cursor.positionInBlock();
  const QString line = cursor.block().text();
  const auto in_word = [&line](int i) {
    return i >= 0 && i < line.size() && (line[i].isLetterOrNumber() || line[i] == u'_');
  };
  int begin = at;
  while (in_word(begin - 1)) --begin;
  int end = at;
  while (in_word(end)) ++end;
  const QString word = line.mid(begin, end - begin).toUpper();
  // `G54`, `FOR` and `DGT0203` are looked up whole, of `L12` and `X5Y7` the letter at the cursor.
  if (word.startsWith(u'G') || word.startsWith(u'M') || word.startsWith(u'F')) return word;
  if (word.size() > 1 && word[1].isLetter() && !word.contains(u'0')) return word;
  for (int i = std::min(at, end - 1); i >= begin; --i) {
    if (line[i].isLetter()) return QString(line[i].toUpper());
  }
  return word;
}

void SourceEditor::add_line(const QString& line) {
  QTextCursor cursor = textCursor();
  cursor.beginEditBlock();
  cursor.movePosition(QTextCursor::EndOfBlock);
  if (!cursor.block().text().trimmed().isEmpty()) cursor.insertBlock();
  cursor.insertText(line);
  cursor.endEditBlock();
  setTextCursor(cursor);
}

// toPlainText() would turn no-break spaces into blanks.
QString SourceEditor::text() const {
  QString text = document()->toRawText();
  text.replace(QChar::ParagraphSeparator, u'\n');
  return text;
}

void SourceEditor::replace_text(const QString& text) {
  const QString before = this->text();
  qsizetype same = 0;
  const qsizetype shorter = std::min(before.size(), text.size());
  while (same < shorter && before[same] == text[same]) ++same;
  qsizetype tail = 0;
  while (tail < shorter - same &&
         before[before.size() - 1 - tail] == text[text.size() - 1 - tail]) {
    ++tail;
  }
  const int line = current_line();
  QTextCursor cursor(document());
  cursor.setPosition(static_cast<int>(same));
  cursor.setPosition(static_cast<int>(before.size() - tail), QTextCursor::KeepAnchor);
  cursor.insertText(text.mid(same, text.size() - same - tail));
  go_to(line);
}

void SourceEditor::set_language(InputLanguage language) {
  language_ = language;
  viewport()->update();
}

void SourceEditor::set_part(PartPtr part) { completion_->set_part(std::move(part)); }

void SourceEditor::complete() { completion_->offer(); }

void SourceEditor::show_found(const QRegularExpression& pattern) {
  found_ = pattern;
  viewport()->update();
}

void SourceEditor::set_font_size(int points) {
  QFont font = this->font();
  if (font.pointSize() == points) return;
  font.setPointSize(points);
  setFont(font);
  emit font_size_changed(points);
}

// A place without extent shows at the character before it, or at the one behind.
QTextCursor SourceEditor::range_of(const Place& place) const {
  QTextCursor cursor = cursor_at(place);
  const QTextBlock block = cursor.block();
  const int end = units_of(block.text(), place.column + place.length);
  cursor.setPosition(block.position() + end, QTextCursor::KeepAnchor);
  if (cursor.hasSelection()) return cursor;
  const bool at_end = cursor.positionInBlock() == block.length() - 1;
  if (block.length() > 1) {
    cursor.movePosition(at_end ? QTextCursor::Left : QTextCursor::Right, QTextCursor::KeepAnchor);
  }
  return cursor;
}

void SourceEditor::show_faults(std::vector<Fault> faults) {
  faults_ = std::move(faults);
  marks_.clear();
  for (std::size_t i = 0; i < faults_.size(); ++i) {
    const Fault& fault = faults_[i];
    if (!fault.at.file.isEmpty()) continue;
    marks_.push_back({range_of(fault.at.place), fault.severity, i});
    if (fault.other) marks_.push_back({range_of(*fault.other), fault.severity, i});
  }
  viewport()->update();
  margin_->update();
}

std::optional<QTextCursor> SourceEditor::place_of(std::size_t fault) const {
  const auto mark = std::ranges::find(marks_, fault, &Mark::fault);
  return mark == marks_.end() ? std::nullopt : std::optional(mark->range);
}

std::optional<std::size_t> SourceEditor::fault_at(int position) const {
  const Mark* worst = nullptr;
  for (const Mark& mark : marks_) {
    const bool holds =
        mark.range.selectionStart() <= position && position < mark.range.selectionEnd();
    if (holds && (worst == nullptr || mark.severity > worst->severity)) worst = &mark;
  }
  return worst == nullptr ? std::nullopt : std::optional(worst->fault);
}

void SourceEditor::go_to_fault(bool forward) {
  const int here = textCursor().selectionStart();
  const auto start = [](const Mark& mark) { return mark.range.selectionStart(); };
  const Mark* best = nullptr;
  const Mark* other_end = nullptr;
  for (const Mark& mark : marks_) {
    const auto nearer = [&](const Mark* than) {
      return than == nullptr || (forward ? start(mark) < start(*than) : start(mark) > start(*than));
    };
    if ((forward ? start(mark) > here : start(mark) < here) && nearer(best)) best = &mark;
    if (nearer(other_end)) other_end = &mark;
  }
  const Mark* const reached = best != nullptr ? best : other_end;
  if (reached == nullptr) return;
  QTextCursor cursor = reached->range;
  cursor.setPosition(reached->range.selectionStart());
  setTextCursor(cursor);
  centerCursor();
  emit fault_reached(static_cast<int>(reached->fault));
}

std::optional<std::size_t> SourceEditor::curable_fault() const {
  const QTextCursor here = textCursor();
  std::optional<std::size_t> nearest;
  int least = 0;
  for (const Mark& mark : marks_) {
    const bool in_line = document()->findBlock(mark.range.selectionStart()) == here.block();
    if (!in_line || !faults_[mark.fault].cure) continue;
    const int away = std::max({mark.range.selectionStart() - here.position(),
                               here.position() - mark.range.selectionEnd(), 0});
    if (!nearest || away < least) nearest = mark.fault;
    if (nearest == mark.fault) least = away;
  }
  return nearest;
}

bool SourceEditor::cure(std::size_t fault) {
  const Cure& cure = *faults_[fault].cure;
  QTextCursor cursor = cursor_at(cure.begin);
  cursor.setPosition(cursor_at(cure.end).position(), QTextCursor::KeepAnchor);
  QString there = cursor.selectedText();
  there.replace(QChar::ParagraphSeparator, u'\n');
  if (there != cure.was) return false;
  cursor.insertText(cure.replacement);
  setTextCursor(cursor);
  return true;
}

QList<QTextLayout::FormatRange> SourceEditor::formats_of(const QTextBlock& block) const {
  QList<QTextLayout::FormatRange> formats;
  const QString line = block.text();
  for (const InkedRange& range : inks_of(line, language_)) {
    QTextLayout::FormatRange format{range.begin, range.length, {}};
    format.format.setForeground(studio::colour_of(range.ink));
    formats.push_back(format);
  }
  const int begin = block.position();
  const int end = begin + block.length();
  for (const Mark& mark : marks_) {
    const int from = std::max(mark.range.selectionStart(), begin);
    const int to = std::min(mark.range.selectionEnd(), end - 1);
    if (from >= to) continue;
    QTextLayout::FormatRange format{from - begin, to - from, {}};
    format.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
    format.format.setUnderlineColor(colour_of(mark.severity));
    formats.push_back(format);
  }
  if (found_.pattern().isEmpty()) return formats;
  for (auto matches = found_.globalMatch(line); matches.hasNext();) {
    const QRegularExpressionMatch match = matches.next();
    if (match.capturedLength() == 0) continue;
    QTextLayout::FormatRange format{
        static_cast<int>(match.capturedStart()), static_cast<int>(match.capturedLength()), {}};
    format.format.setBackground(colours().found);
    formats.push_back(format);
  }
  return formats;
}

void SourceEditor::format_visible() {
  const int bottom = viewport()->height();
  QTextBlock block = firstVisibleBlock();
  for (qreal top = blockBoundingGeometry(block).translated(contentOffset()).top();
       block.isValid() && top <= bottom; block = block.next()) {
    auto formats = formats_of(block);
    if (block.layout()->formats() != formats) block.layout()->setFormats(formats);
    top += blockBoundingRect(block).height();
  }
}

void SourceEditor::lay_out_margin() {
  const int width = margin_->wanted_width();
  setViewportMargins(width, 0, 0, 0);
  const QRect inside = contentsRect();
  margin_->setGeometry(inside.left(), inside.top(), width, inside.height());
}

void SourceEditor::highlight_line() {
  QTextEdit::ExtraSelection line;
  line.format.setBackground(colours().current_line);
  line.format.setProperty(QTextFormat::FullWidthSelection, true);
  line.cursor = textCursor();
  line.cursor.clearSelection();
  setExtraSelections({line});
  margin_->update();
}

void SourceEditor::paint_margin(QPaintEvent* event) {
  QPainter painter(margin_);
  painter.fillRect(event->rect(), colours().paper);
  painter.setFont(font());
  std::vector<std::pair<int, Severity>> marked;  // line and how bad
  for (const Mark& mark : marks_) {
    marked.emplace_back(document()->findBlock(mark.range.selectionStart()).blockNumber(),
                        mark.severity);
  }
  const int digit = fontMetrics().horizontalAdvance(u'9');
  const int here = textCursor().blockNumber();
  QTextBlock block = firstVisibleBlock();
  qreal top = blockBoundingGeometry(block).translated(contentOffset()).top();
  while (block.isValid() && top <= event->rect().bottom()) {
    const qreal height = blockBoundingRect(block).height();
    const int number = block.blockNumber();
    painter.setPen(number == here ? colours().text : colours().line_numbers);
    painter.drawText(QRectF(0, top, margin_->width() - digit, height),
                     static_cast<int>(Qt::AlignRight) | static_cast<int>(Qt::AlignVCenter),
                     QString::number(number + 1));
    std::optional<Severity> worst;
    for (const auto& [line, severity] : marked) {
      if (line == number && (!worst || severity > *worst)) worst = severity;
    }
    if (worst) {
      painter.fillRect(QRectF(margin_->width() - digit * 0.6, top + 1, digit * 0.35, height - 2),
                       colour_of(*worst));
    }
    top += height;
    block = block.next();
  }
}

void SourceEditor::paintEvent(QPaintEvent* event) {
  format_visible();
  QPlainTextEdit::paintEvent(event);
}

void SourceEditor::resizeEvent(QResizeEvent* event) {
  QPlainTextEdit::resizeEvent(event);
  lay_out_margin();
}

}  // namespace dgt::studio
