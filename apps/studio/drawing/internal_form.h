// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "apps/studio/part.h"

namespace dgt::studio {

/// The program in its internal form (F7), as `dgt dump` prints it.
class InternalForm : public QWidget {
  Q_OBJECT

 public:
  explicit InternalForm(QWidget* parent = nullptr);

  void show_part(PartPtr part);
  /// Lights the lines of the moves that were asked for there; see DrawingPanel.
  void light_line(int file, int line);

 signals:
  /// The cursor went to a move: where it was asked for.
  void place_chosen(int file, int line, int column);

 private:
  PartPtr part_;
};

}  // namespace dgt::studio
