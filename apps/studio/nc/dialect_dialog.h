// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace dgt::studio {

/// Asks for whose control the NC program is: all dialects with what they are, and the shop's own
/// files.
class DialectDialog : public QDialog {
  Q_OBJECT

 public:
  /// `chosen` is marked; `own` are the dialect files that were used before.
  DialectDialog(const QString& chosen, const QStringList& own, QWidget* parent = nullptr);

  /// A name or the path of a file.
  [[nodiscard]] QString dialect() const;
  [[nodiscard]] QStringList own_files() const;

 private:
  QTreeWidgetItem* add(const QString& dialect, const QString& name, const QString& about);
  QTreeWidgetItem* add_file(const QString& file);
  void ask_for_file();
  void mark(const QString& dialect);

  QTreeWidget* list_;
  QPushButton* ok_;
};

}  // namespace dgt::studio
