// SPDX-License-Identifier: GPL-3.0-or-later
// The studio's windows on the offscreen platform, driven by real events.
#include <gmock/gmock.h>

#include <QApplication>
#include <QStandardPaths>

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  testing::InitGoogleMock(&argc, argv);
  QStandardPaths::setTestModeEnabled(true);  // no settings of the person who runs this
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
