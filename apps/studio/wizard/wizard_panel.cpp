// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/wizard/wizard_panel.h"

#include <QEvent>
#include <QFontDatabase>
#include <QKeyEvent>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

#include "apps/studio/wizard/form_list.h"
#include "apps/studio/wizard/template_bar.h"

namespace dgt::studio {
namespace {

constexpr int kExampleLines = 7;     // of an example that are seen
constexpr double kAspect = 4.0 / 3;  // of a picture

QFont fixed_font() { return QFontDatabase::systemFont(QFontDatabase::FixedFont); }

}  // namespace

WizardPanel::WizardPanel(QWidget* parent) : QWidget(parent) {
  tabs_ = new QTabBar(this);
  tabs_->setExpanding(true);
  for (const char kind : {'L', 'C', 'P', 'K'}) tabs_->addTab(QString(QChar::fromLatin1(kind)));
  template_ = new TemplateBar(this);
  description_ = new QLabel(this);
  description_->setWordWrap(true);
  stack_ = new QStackedWidget(this);
  add_page("L");
  add_page("C");
  add_page("PO");  // the guide has no tab for coordinate systems
  add_examples();
  auto* column = new QVBoxLayout(this);
  column->addWidget(tabs_);
  column->addWidget(template_);
  column->addWidget(description_);
  column->addWidget(stack_, 1);
  connect(tabs_, &QTabBar::currentChanged, this, [this](int tab) {
    template_->end();
    description_->clear();
    stack_->setCurrentIndex(tab);
  });
  connect(template_, &TemplateBar::finished, this, &WizardPanel::take_definition);
  connect(template_, &TemplateBar::left, this, [this] {
    description_->clear();
    pages_[static_cast<std::size_t>(tabs_->currentIndex())].list->setFocus();
    emit left();
  });
  connect(&Appearance::of_program(), &Appearance::changed, this, [this] {
    if (is_drawn_) draw_pictures();
  });
  retranslate();
}

WizardPanel::~WizardPanel() = default;

void WizardPanel::add_page(std::string_view kinds) {
  Page page;
  page.list = new FormList(this);
  for (DefinitionForm& form : definition_forms()) {
    if (kinds.find(form.kind()) == std::string_view::npos) continue;
    page.list->add(QString::fromStdString(form.example()));
    page.figures.push_back(form.figure);
    page.forms.push_back(std::move(form));
  }
  const std::size_t index = pages_.size();
  const auto choose = [this, index](int row) { choose_form(index, row); };
  connect(page.list, &FormList::chosen, this, choose);
  connect(page.list, &FormList::confirmed, this, choose);
  stack_->addWidget(page.list);
  pages_.push_back(std::move(page));
}

void WizardPanel::add_examples() {
  Page page;
  page.list = new FormList(this);
  examples_ = contour_examples();
  for (const ContourExample& example : examples_) {
    page.list->add(example.name);
    page.figures.push_back(example.figure);
  }
  connect(page.list, &FormList::confirmed, this, &WizardPanel::insert_example);
  connect(page.list, &QListWidget::currentRowChanged, this, &WizardPanel::show_example);
  connect(page.list, &QListWidget::itemDoubleClicked, this, &WizardPanel::insert_example);
  pages_.push_back(std::move(page));
  stack_->addWidget(examples_page());
}

QWidget* WizardPanel::examples_page() {
  auto* split = new QSplitter(Qt::Vertical, this);
  split->addWidget(pages_.back().list);
  auto* below = new QWidget(split);
  auto* column = new QVBoxLayout(below);
  column->setContentsMargins(0, 0, 0, 0);
  example_text_ = new QPlainTextEdit(below);
  example_text_->setObjectName(QStringLiteral("example"));
  example_text_->setReadOnly(true);
  example_text_->setFont(fixed_font());
  example_text_->setMinimumHeight(example_text_->fontMetrics().lineSpacing() * kExampleLines);
  insert_ = new QPushButton(below);
  insert_->setObjectName(QStringLiteral("insert"));
  insert_->setEnabled(false);
  connect(insert_, &QPushButton::clicked, this, &WizardPanel::insert_example);
  column->addWidget(example_text_);
  column->addWidget(insert_);
  split->setStretchFactor(0, 3);
  split->setStretchFactor(1, 1);
  split->setChildrenCollapsible(false);
  return split;
}

void WizardPanel::show_source(const QString& text) {
  used_ = UsedNumbers(text.toStdString());
  template_->set_program(used_);
}

void WizardPanel::choose_form(std::size_t page, int row) {
  const DefinitionForm& form = pages_[page].forms.at(static_cast<std::size_t>(row));
  description_->setText(form.description);
  template_->begin(form.pattern, used_.next_free(form.kind()));
}

// The editor may show the new line to us only later.
void WizardPanel::take_definition(const QString& line, int number) {
  const std::string pattern = template_->pattern();
  used_.add(pattern.front(), number);
  template_->set_program(used_);
  emit line_finished(line);
  template_->begin(pattern, used_.next_free(pattern.front()));
}

void WizardPanel::show_example(int row) {
  insert_->setEnabled(row >= 0);
  if (row < 0) return;
  const std::string text = examples_.at(static_cast<std::size_t>(row)).text();
  example_text_->setPlainText(QString::fromStdString(with_free_numbers(text, used_)));
}

void WizardPanel::insert_example() {
  const int row = pages_.back().list->currentRow();
  if (row < 0) return;
  show_example(row);  // the program may have taken numbers meanwhile
  const QString text = example_text_->toPlainText().trimmed();
  used_.add(UsedNumbers(text.toStdString()));
  emit line_finished(text);
}

void WizardPanel::draw_pictures() {
  is_drawn_ = true;
  std::vector<std::vector<Figure>> figures;
  for (const Page& page : pages_) figures.push_back(page.figures);
  DrawingStyle style = figure_style(colours(), pages_.front().list->picture_size().width());
  style.aspect = kAspect;
  style.letters_height = fontMetrics().height() * 0.7;
  const double ratio = devicePixelRatioF();
  background_.ask([this, figures, style, ratio]() -> Background::Outcome {
    std::vector<std::vector<QImage>> pictures;
    for (const auto& page : figures) {
      pictures.emplace_back();
      for (const Figure& figure : page) {
        pictures.back().push_back(draw_figure(figure, style, ratio));
      }
    }
    return [this, pictures] { place_pictures(pictures); };
  });
}

void WizardPanel::place_pictures(const std::vector<std::vector<QImage>>& pictures) {
  for (std::size_t page = 0; page < pages_.size(); ++page) {
    for (std::size_t row = 0; row < pictures[page].size(); ++row)
      pages_[page].list->set_picture(static_cast<int>(row), pictures[page][row]);
  }
}

void WizardPanel::showEvent(QShowEvent* event) {
  if (!is_drawn_) draw_pictures();
  QWidget::showEvent(event);
}

void WizardPanel::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) {
    QWidget::keyPressEvent(event);
    return;
  }
  emit left();
}

void WizardPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void WizardPanel::retranslate() {
  const QStringList tips = {tr("Lines"), tr("Circles"), tr("Points and coordinate systems"),
                            tr("Examples of contours")};
  for (int tab = 0; tab < tips.size(); ++tab) tabs_->setTabToolTip(tab, tips[tab]);
  const std::vector<DefinitionForm> forms = definition_forms();
  for (Page& page : pages_) {
    for (std::size_t row = 0; row < page.forms.size(); ++row) {
      for (const DefinitionForm& form : forms) {
        if (form.pattern == page.forms[row].pattern) page.forms[row].description = form.description;
      }
      const QString pattern = QString::fromStdString(page.forms[row].pattern);
      page.list->set_tip(static_cast<int>(row),
                         pattern + QStringLiteral("\n") + page.forms[row].description);
    }
  }
  examples_ = contour_examples();
  for (std::size_t row = 0; row < examples_.size(); ++row)
    pages_.back().list->item(static_cast<int>(row))->setText(examples_[row].name);
  insert_->setText(tr("&Insert into the program"));
  insert_->setToolTip(tr("Numbers that the program has already are replaced by free ones."));
  description_->clear();
}

}  // namespace dgt::studio
