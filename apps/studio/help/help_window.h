// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "apps/studio/background.h"
#include "apps/studio/help/pages.h"

class QLineEdit;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;
class QUrl;

namespace dgt::studio {

class HelpView;

/// The reference of the language, the keys, the dialects, tape and messages; in the language of the
/// program.
class HelpWindow : public QWidget {
  Q_OBJECT

 public:
  explicit HelpWindow(QWidget* parent = nullptr);
  ~HelpWindow() override;

  /// The topic of a word of the language (`FOR`, `L`, `G54`), a form (`L=PC`) or a message
  /// (`DGT0203`); the contents for anything else.
  void show_topic(const QString& word);
  [[nodiscard]] const HelpBook& book() const { return book_; }
  [[nodiscard]] HelpPlace place() const { return history_[at_]; }

 protected:
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void go_to(const HelpPlace& place);
  void show_place();
  void step(int by);
  void fill_contents();
  void search(const QString& words);
  void go_to_first_found();
  void follow(const QUrl& link);
  void draw_figures();
  void retranslate();

  HelpBook book_;
  std::vector<HelpPlace> history_{HelpPlace{}};
  std::size_t at_ = 0;
  std::optional<std::size_t> shown_page_;
  QLineEdit* wanted_ = nullptr;
  QTreeWidget* contents_ = nullptr;
  QToolButton* back_ = nullptr;
  QToolButton* forward_ = nullptr;
  HelpView* view_ = nullptr;
  Background background_{this};
};

}  // namespace dgt::studio
