// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeWidget>
#include <vector>

#include "apps/studio/editor/faults.h"

namespace dgt::studio {

/// What the compiler says, as a list: a click, or Enter, goes to the place. Notes and cures stand
/// below their fault.
class FaultList : public QTreeWidget {
  Q_OBJECT

 public:
  explicit FaultList(QWidget* parent = nullptr);

  void show_faults(const std::vector<Fault>& faults);
  void choose(int fault);

 signals:
  /// A fault of the program itself; it may have moved since.
  void fault_chosen(int fault);
  /// Another place: of a note, or of another file.
  void place_chosen(QString file, int line, int column);
  void cure_chosen(int fault);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();
  void add(const Fault& fault, int index);
  void go_to(const QTreeWidgetItem* item);
};

}  // namespace dgt::studio
