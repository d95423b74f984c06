// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>

#include "apps/studio/compiler.h"

namespace dgt::studio {

/// The main window of the guide: menus, tools, the editor and the panels around it.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);

 private:
  Compiler compiler_;
};

}  // namespace dgt::studio
