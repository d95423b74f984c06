// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>

#include "apps/studio/window/main_window.h"

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QApplication::setApplicationName(QStringLiteral("dgt-studio"));
  QApplication::setApplicationVersion(QStringLiteral(DGT_VERSION));
  dgt::studio::MainWindow window;
  window.show();
  return QApplication::exec();
}
