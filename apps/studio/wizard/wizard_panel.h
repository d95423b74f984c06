// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "apps/studio/background.h"
#include "apps/studio/wizard/contour_examples.h"
#include "apps/studio/wizard/definition_forms.h"
#include "apps/studio/wizard/used_numbers.h"

class QLabel;
class QPlainTextEdit;
class QPushButton;
class QStackedWidget;
class QTabBar;

namespace dgt::studio {

class FormList;
class TemplateBar;

/// The wizard at the right of the editor: pictures of all forms of definition; a form that is
/// clicked becomes a template, its values are typed, the space bar goes on to the next.
class WizardPanel : public QWidget {
  Q_OBJECT

 public:
  explicit WizardPanel(QWidget* parent = nullptr);
  ~WizardPanel() override;

  /// The program as it stands, so that new elements get numbers that are free.
  void show_source(const QString& text);

 signals:
  /// A definition is complete, without a line end: `L1=X72`. An example has several lines.
  void line_finished(QString line);
  /// The person is done: the editor should have the focus.
  void left();

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  /// A list of pictures and what its rows stand for.
  struct Page {
    FormList* list = nullptr;
    std::vector<DefinitionForm> forms;
    std::vector<Figure> figures;
  };

  void add_page(std::string_view kinds);
  void add_examples();
  QWidget* examples_page();
  void choose_form(std::size_t page, int row);
  void take_definition(const QString& line, int number);
  void show_example(int row);
  void insert_example();
  void draw_pictures();
  void place_pictures(const std::vector<std::vector<QImage>>& pictures);
  void retranslate();

  UsedNumbers used_;
  std::vector<Page> pages_;  // of the tabs, the examples last
  std::vector<ContourExample> examples_;
  QTabBar* tabs_ = nullptr;
  TemplateBar* template_ = nullptr;
  QStackedWidget* stack_ = nullptr;
  QLabel* description_ = nullptr;
  QPlainTextEdit* example_text_ = nullptr;
  QPushButton* insert_ = nullptr;
  bool is_drawn_ = false;
  Background background_{this};
};

}  // namespace dgt::studio
