// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace dgt::studio {

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
};

}  // namespace dgt::studio
