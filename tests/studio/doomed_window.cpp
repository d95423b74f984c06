// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/studio/doomed_window.h"

#include <QApplication>
#include <QDir>
#include <QTest>
#include <cstdio>

#include "apps/studio/window/main_window.h"

namespace dgt::studio {

int live_until_killed() {
  MainWindow window({});
  window.show();
  const QString file = qEnvironmentVariable("DGT_STUDIO_FILE");
  if (!file.isEmpty()) window.open_file(file);
  QTest::keyClicks(&window.editor(), qEnvironmentVariable("DGT_STUDIO_DOOMED"));
  const QDir kept(Recovery::standard_folder());
  while (kept.entryList({QStringLiteral("*.text")}, QDir::Files).isEmpty()) QTest::qWait(50);
  std::puts("kept");
  std::fflush(stdout);
  return QApplication::exec();
}

}  // namespace dgt::studio
