// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace dgt::studio {

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
};

}  // namespace dgt::studio
