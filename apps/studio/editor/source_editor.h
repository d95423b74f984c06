// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QTextLayout>
#include <optional>
#include <vector>

#include "apps/studio/editor/faults.h"
#include "apps/studio/part.h"

namespace dgt::studio {

class Completion;
class LineMargin;

/// The source text of a program, with what the compiler says about it: colours, line numbers,
/// squiggles with their message on hover.
class SourceEditor : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit SourceEditor(QWidget* parent = nullptr);

  /// Puts the cursor there and shows the place. Lines and columns count from 1, columns in code
  /// points; what lies beyond the text is its end.
  void go_to(int line, int column = 1);
  /// The line with the cursor, from 1.
  [[nodiscard]] int current_line() const;
  /// The word at the cursor, as help looks it up: `C`, `FOR`, `G54`; empty between words.
  [[nodiscard]] QString word_at_cursor() const;
  /// Puts a line of its own below the line with the cursor, or into it when it is blank; one step
  /// of undo.
  void add_line(const QString& line);

  /// The text as it is to be saved: LF line ends, every character as it was typed.
  [[nodiscard]] QString text() const;
  /// Replaces the text as one step of undo; the cursor stays in its line.
  void replace_text(const QString& text);

  void set_language(InputLanguage language);
  [[nodiscard]] InputLanguage language() const { return language_; }
  void set_font_size(int points);

  /// Shows these as squiggles. They move with the text until others come.
  void show_faults(std::vector<Fault> faults);
  [[nodiscard]] const std::vector<Fault>& faults() const { return faults_; }
  /// Where a fault of the program stands now.
  [[nodiscard]] std::optional<QTextCursor> place_of(std::size_t fault) const;
  /// The worst fault at a position of the text.
  [[nodiscard]] std::optional<std::size_t> fault_at(int position) const;
  /// Goes to the next fault behind the cursor, or the last before it; past the end to the other.
  void go_to_fault(bool forward);
  /// The fault with a cure nearest to the cursor in its line.
  [[nodiscard]] std::optional<std::size_t> curable_fault() const;
  /// Puts a cure in place, one step of undo; false when the text there has changed since.
  bool cure(std::size_t fault);

  /// The program as last compiled: what completion offers.
  void set_part(PartPtr part);
  /// Offers what may stand at the cursor.
  void complete();
  /// Lays a colour behind every match; an empty pattern: none.
  void show_found(const QRegularExpression& pattern);

 signals:
  void current_line_changed(int line);
  void font_size_changed(int points);
  /// The list shows another fault: the cursor stands in it.
  void fault_reached(int fault);

 protected:
  bool viewportEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  friend class LineMargin;

  /// A squiggle; the cursor is its selection, and moves with the text.
  struct Mark {
    QTextCursor range;
    Severity severity;
    std::size_t fault;
  };

  [[nodiscard]] QTextCursor cursor_at(const Place& place) const;
  [[nodiscard]] QTextCursor range_of(const Place& place) const;
  [[nodiscard]] QList<QTextLayout::FormatRange> formats_of(const QTextBlock& block) const;
  void format_visible();
  void lay_out_margin();
  void highlight_line();
  void show_tip(const QPoint& where, const QPoint& global);
  void paint_margin(QPaintEvent* event);
  void indent_new_line();

  LineMargin* margin_;
  Completion* completion_;
  InputLanguage language_ = InputLanguage::Dgt;
  std::vector<Fault> faults_;
  std::vector<Mark> marks_;
  QRegularExpression found_;
};

}  // namespace dgt::studio
