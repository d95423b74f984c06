// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/internal_form.h"

#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMessageBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "apps/driver/file_io.h"

namespace dgt::studio {
namespace {

QToolButton* button(QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setAutoRaise(true);
  return button;
}

}  // namespace

InternalForm::InternalForm(QWidget* parent)
    : QWidget(parent),
      wanted_(new QLineEdit(this)),
      next_(button(this)),
      previous_(button(this)),
      copy_(button(this)),
      save_(button(this)),
      note_(new QLabel(this)),
      view_(new QListView(this)) {
  view_->setModel(&lines_);
  view_->setUniformItemSizes(true);
  view_->setTextElideMode(Qt::ElideNone);
  view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  view_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  view_->installEventFilter(this);
  wanted_->setClearButtonEnabled(true);
  wanted_->installEventFilter(this);
  next_->setArrowType(Qt::DownArrow);
  previous_->setArrowType(Qt::UpArrow);
  note_->setWordWrap(true);

  auto* row = new QHBoxLayout;
  row->setContentsMargins(4, 2, 4, 2);
  row->addWidget(wanted_, 1);
  for (QWidget* widget : {previous_, next_, copy_, save_}) row->addWidget(widget);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addLayout(row);
  column->addWidget(note_);
  column->addWidget(view_, 1);
  setFocusProxy(view_);

  connect(wanted_, &QLineEdit::returnPressed, this, &InternalForm::find_next);
  connect(next_, &QToolButton::clicked, this, &InternalForm::find_next);
  connect(previous_, &QToolButton::clicked, this, &InternalForm::find_previous);
  connect(copy_, &QToolButton::clicked, this, &InternalForm::copy);
  connect(save_, &QToolButton::clicked, this, &InternalForm::save);
  connect(view_, &QListView::activated, this,
          [this](const QModelIndex& chosen) { go_to_source(chosen.row()); });
  retranslate();
}

void InternalForm::show_part(PartPtr part) {
  is_good_ = part && part->path() != nullptr;
  work_.forget();
  show_note();
  if (!is_good_) return;
  work_.ask([this, part = std::move(part)]() -> Background::Outcome {
    return [this, name = part->name, text = std::make_shared<const InternalText>(*part->path())] {
      name_ = name;
      const QFontMetrics metrics = view_->fontMetrics();
      const int columns = static_cast<int>(text->longest()) + 2;
      lines_.set_size({columns * metrics.horizontalAdvance(u'0'), metrics.height()});
      lines_.show_text(text);
      emit settled();
    };
  });
}

void InternalForm::light_line(int file, int line) {
  const auto number = [](int value) { return static_cast<std::uint32_t>(std::max(value, 0)); };
  lines_.light({number(file), number(line), 1});
  if (!lines_.text() || line <= 0) return;
  const std::size_t first = lines_.text()->first_of(number(file), number(line));
  if (first == lines_.text()->lines()) return;
  view_->scrollTo(lines_.index(static_cast<int>(first)));
}

void InternalForm::go_to_source(int row) {
  const SourcePlace place = lines_.text()->source(static_cast<std::size_t>(row));
  if (place.line == 0) return;
  emit place_chosen(static_cast<int>(place.file), static_cast<int>(place.line),
                    static_cast<int>(place.column));
}

QString InternalForm::text() const {
  if (!lines_.text()) return {};
  QModelIndexList rows = view_->selectionModel()->selectedRows();
  if (rows.size() < 2) return QString::fromStdString(lines_.text()->text());
  std::ranges::sort(rows, {}, &QModelIndex::row);
  QString text;
  for (const QModelIndex& row : rows) text += row.data().toString() + u'\n';
  return text;
}

void InternalForm::copy() { QGuiApplication::clipboard()->setText(text()); }

void InternalForm::find_next() { find(false); }
void InternalForm::find_previous() { find(true); }

void InternalForm::find(bool backwards) {
  const QByteArray wanted = wanted_->text().toUtf8();
  if (!lines_.text() || wanted.isEmpty()) return;
  const std::size_t count = lines_.text()->lines();
  const auto now = static_cast<std::size_t>(view_->currentIndex().row() + 1);
  const std::size_t from = backwards ? (now + count - 2) % count : now % count;
  const std::size_t found = lines_.text()->find(wanted.toStdString(), from, backwards);
  is_missing_ = found == count;
  if (!is_missing_) view_->setCurrentIndex(lines_.index(static_cast<int>(found)));
  show_note();
}

void InternalForm::save() {
  if (!lines_.text()) return;
  const QString proposed =
      QFileInfo(QString::fromStdString(name_)).completeBaseName() + QStringLiteral(".txt");
  const QString name = QFileDialog::getSaveFileName(this, tr("Save the internal form"), proposed,
                                                    tr("Texts (*.txt);;All files (*)"));
  if (name.isEmpty()) return;
  const auto written = write_file(name.toStdString(), lines_.text()->text());
  if (written) return;
  QMessageBox::critical(this, tr("Save the internal form"),
                        QString::fromStdString(written.error().text()));
}

bool InternalForm::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const auto& key = static_cast<QKeyEvent&>(*event);
  if (watched == view_ && key.matches(QKeySequence::Copy)) {
    copy();
    return true;
  }
  if (watched == wanted_ && key.key() == Qt::Key_Escape && !wanted_->text().isEmpty()) {
    wanted_->clear();
    view_->setFocus();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void InternalForm::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Find)) {
    wanted_->setFocus();
    wanted_->selectAll();
  } else if (event->matches(QKeySequence::FindNext)) {
    find_next();
  } else if (event->matches(QKeySequence::FindPrevious)) {
    find_previous();
  } else {
    QWidget::keyPressEvent(event);
  }
}

void InternalForm::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void InternalForm::retranslate() {
  wanted_->setPlaceholderText(tr("Find"));
  wanted_->setAccessibleName(tr("Text to find"));
  next_->setToolTip(tr("Find next (F3)"));
  next_->setAccessibleName(tr("Find next"));
  previous_->setToolTip(tr("Find previous (Shift+F3)"));
  previous_->setAccessibleName(tr("Find previous"));
  copy_->setText(tr("&Copy"));
  copy_->setToolTip(tr("The chosen lines, or all of them (Ctrl+C)"));
  save_->setText(tr("&Save…"));
  save_->setToolTip(tr("All of it as a file"));
  view_->setAccessibleName(tr("Internal form of the program"));
  show_note();
}

void InternalForm::show_note() {
  QString text;
  if (!is_good_) text = tr("The program has errors: this is of an earlier text.");
  if (is_missing_) text = tr("Not found.");
  note_->setText(text);
  note_->setVisible(!text.isEmpty());
}

}  // namespace dgt::studio
