// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/main_window.h"

namespace dgt::studio {

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent) {
  setWindowTitle(QStringLiteral("DGT Studio"));
}

}  // namespace dgt::studio
