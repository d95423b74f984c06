// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/help/help_window.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSplitter>
#include <QToolButton>
#include <QTreeWidget>
#include <QUrl>
#include <QVBoxLayout>

#include "apps/studio/help/help_view.h"
#include "apps/studio/language.h"

namespace dgt::studio {
namespace {

constexpr int kPage = Qt::UserRole;
constexpr int kSection = Qt::UserRole + 1;
constexpr int kLettersWide = 120;
constexpr int kLinesHigh = 44;
constexpr int kFigureLetters = 44;     // width of a figure
constexpr int kFormLetters = 22;       // of a form of definition
constexpr int kDeepestInContents = 2;  // deeper headings only when searched for
constexpr double kAspect = 4.0 / 3;

}  // namespace

HelpWindow::HelpWindow(QWidget* parent) : QWidget(parent) {
  wanted_ = new QLineEdit(this);
  wanted_->setObjectName(QStringLiteral("wanted"));
  wanted_->setClearButtonEnabled(true);
  contents_ = new QTreeWidget(this);
  contents_->setHeaderHidden(true);
  contents_->setObjectName(QStringLiteral("contents"));
  view_ = new HelpView(this);
  back_ = new QToolButton(this);
  back_->setArrowType(Qt::LeftArrow);
  forward_ = new QToolButton(this);
  forward_->setArrowType(Qt::RightArrow);
  auto* left = new QWidget(this);
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  row->addWidget(back_);
  row->addWidget(forward_);
  row->addWidget(wanted_, 1);
  column->addLayout(row);
  column->addWidget(contents_, 1);
  auto* split = new QSplitter(this);
  split->addWidget(left);
  split->addWidget(view_);
  split->setStretchFactor(1, 1);
  split->setChildrenCollapsible(false);
  auto* all = new QHBoxLayout(this);
  all->addWidget(split);
  const int letter = fontMetrics().horizontalAdvance(u'0');
  resize(letter * kLettersWide, fontMetrics().lineSpacing() * kLinesHigh);
  split->setSizes({width() * 3 / 10, width() * 7 / 10});
  connect(wanted_, &QLineEdit::textChanged, this, &HelpWindow::search);
  connect(wanted_, &QLineEdit::returnPressed, this, &HelpWindow::go_to_first_found);
  connect(contents_, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
    if (item == nullptr) return;
    go_to({item->data(0, kPage).toULongLong(), item->data(0, kSection).toULongLong()});
  });
  connect(view_, &QTextBrowser::anchorClicked, this, &HelpWindow::follow);
  connect(back_, &QToolButton::clicked, this, [this] { step(-1); });
  connect(forward_, &QToolButton::clicked, this, [this] { step(1); });
  connect(&Appearance::of_program(), &Appearance::changed, this, [this] {
    view_->forget_figures();
    shown_page_.reset();
    show_place();
  });
  retranslate();
}

HelpWindow::~HelpWindow() = default;

void HelpWindow::show_topic(const QString& word) {
  go_to(book_.place_of(word).value_or(HelpPlace{}));
}

void HelpWindow::go_to(const HelpPlace& place) {
  if (place != history_[at_]) {
    history_.resize(at_ + 1);
    history_.push_back(place);
    ++at_;
  }
  show_place();
}

void HelpWindow::step(int by) {
  at_ = static_cast<std::size_t>(static_cast<int>(at_) + by);
  show_place();
}

void HelpWindow::show_place() {
  const HelpPlace& place = history_[at_];
  back_->setEnabled(at_ > 0);
  forward_->setEnabled(at_ + 1 < history_.size());
  if (shown_page_ != place.page) {
    shown_page_ = place.page;
    view_->show_page(book_.pages[place.page].markdown);
    draw_figures();
  }
  view_->go_to_heading(place.section);
}

void HelpWindow::follow(const QUrl& link) {
  if (link.scheme() == QStringLiteral("topic")) show_topic(link.path());
}

// --- contents and search

void HelpWindow::fill_contents() {
  const QSignalBlocker quiet(contents_);
  contents_->clear();
  for (std::size_t page = 0; page < book_.pages.size(); ++page) {
    QTreeWidgetItem* top = nullptr;
    const auto& sections = book_.pages[page].sections;
    for (std::size_t section = 0; section < sections.size(); ++section) {
      auto* item = section == 0 ? new QTreeWidgetItem(contents_) : new QTreeWidgetItem(top);
      if (section == 0) top = item;
      item->setText(0, sections[section].title);
      item->setToolTip(0, sections[section].title);
      item->setData(0, kPage, static_cast<qulonglong>(page));
      item->setData(0, kSection, static_cast<qulonglong>(section));
    }
  }
  search(wanted_->text());
}

void HelpWindow::search(const QString& words) {
  const QString wanted = words.trimmed();
  for (int i = 0; i < contents_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* const top = contents_->topLevelItem(i);
    const auto& sections = book_.pages[static_cast<std::size_t>(i)].sections;
    bool any = false;
    const auto fits = [&](const HelpSection& section) {
      return section.title.contains(wanted, Qt::CaseInsensitive) ||
             section.text.contains(wanted, Qt::CaseInsensitive) ||
             section.topics.contains(wanted, Qt::CaseInsensitive);
    };
    for (int child = 0; child < top->childCount(); ++child) {
      const HelpSection& section = sections[static_cast<std::size_t>(child + 1)];
      const bool shown = wanted.isEmpty() ? section.level <= kDeepestInContents : fits(section);
      top->child(child)->setHidden(!shown);
      any = any || (shown && !wanted.isEmpty());
    }
    top->setHidden(!wanted.isEmpty() && !any && !fits(sections.front()));
    top->setExpanded(any);
  }
}

void HelpWindow::go_to_first_found() {
  const QString wanted = wanted_->text().trimmed();
  std::optional<HelpPlace> place = book_.place_of(wanted);
  for (int i = 0; i < contents_->topLevelItemCount() && !place; ++i) {
    const QTreeWidgetItem* const top = contents_->topLevelItem(i);
    if (top->isHidden()) continue;
    place = HelpPlace{static_cast<std::size_t>(i), 0};
    for (int child = top->childCount() - 1; child >= 0; --child)
      if (!top->child(child)->isHidden()) place->section = static_cast<std::size_t>(child + 1);
  }
  if (!place) return;
  go_to(*place);
  // The word itself, if it stands there; else the heading stays.
  const QTextCursor heading = view_->textCursor();
  if (!view_->find(wanted)) view_->setTextCursor(heading);
}

// --- figures

void HelpWindow::draw_figures() {
  static const QRegularExpression kImage(QStringLiteral("\\(figure:([^)]*)\\)"));
  std::map<QString, Figure> missing;
  auto found = kImage.globalMatch(book_.pages[*shown_page_].markdown);
  while (found.hasNext()) {
    const QString name = found.next().captured(1);
    const auto figure = book_.figures.find(name);
    if (!view_->has_figure(name) && figure != book_.figures.end()) missing.insert(*figure);
  }
  if (missing.empty()) return;
  const int letter = fontMetrics().horizontalAdvance(u'0');
  DrawingStyle large = figure_style(colours(), letter * kFigureLetters);
  large.letters_height = fontMetrics().height() * 0.8;
  DrawingStyle small = large;
  small.size = letter * kFormLetters;
  small.aspect = kAspect;
  background_.ask(
      [this, missing, large, small, ratio = devicePixelRatioF()]() -> Background::Outcome {
        std::map<QString, QImage> drawn;
        for (const auto& [name, figure] : missing) {
          const bool is_form = name.startsWith(QStringLiteral("form:"));
          drawn.emplace(name, draw_figure(figure, is_form ? small : large, ratio));
        }
        return [this, drawn] {
          view_->set_figures(drawn);
          view_->go_to_heading(history_[at_].section);
        };
      });
}

// --- the window

void HelpWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    close();
  } else if (event->matches(QKeySequence::Find)) {
    wanted_->setFocus();
    wanted_->selectAll();
  } else if (event->matches(QKeySequence::Back) && at_ > 0) {
    step(-1);
  } else if (event->matches(QKeySequence::Forward) && at_ + 1 < history_.size()) {
    step(1);
  } else {
    QWidget::keyPressEvent(event);
  }
}

void HelpWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void HelpWindow::retranslate() {
  book_ = help_book(message_language());
  setWindowTitle(tr("DGT Studio: help"));
  wanted_->setPlaceholderText(tr("Search"));
  wanted_->setToolTip(tr("A word, a form (L=PC), the code of a message (DGT0203); Ctrl+F"));
  back_->setToolTip(tr("Back (Alt+Left)"));
  forward_->setToolTip(tr("Forward (Alt+Right)"));
  fill_contents();
  shown_page_.reset();
  show_place();
}

}  // namespace dgt::studio
