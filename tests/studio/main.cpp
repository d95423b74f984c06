// SPDX-License-Identifier: GPL-3.0-or-later
// The studio's windows on the offscreen platform, driven by real events.
#include <gmock/gmock.h>

#include <QApplication>
#include <QDir>
#include <QTemporaryDir>

#include "tests/studio/doomed_window.h"

namespace {

/// No test finds what another has saved.
class FreshHome : public testing::EmptyTestEventListener {
 public:
  explicit FreshHome(const QString& path) : path_(path) {}

 private:
  void OnTestStart(const testing::TestInfo&) override {
    QDir(path_).removeRecursively();
    QDir().mkpath(path_);
  }
  QString path_;
};

}  // namespace

// Fontconfig never gives back what threads that are gone had asked it for. Nothing of ours is in
// these leaks.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  // Nothing of the person who runs this is read or changed; a parent process may say where else.
  const QTemporaryDir home;
  for (const char* const name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"}) {
    if (!qEnvironmentVariableIsSet("DGT_STUDIO_DOOMED")) qputenv(name, home.path().toUtf8());
  }
  QApplication application(argc, argv);
  QApplication::setApplicationName(QStringLiteral("dgt-studio"));
  if (qEnvironmentVariableIsSet("DGT_STUDIO_DOOMED")) return dgt::studio::live_until_killed();
  testing::InitGoogleMock(&argc, argv);
  testing::UnitTest::GetInstance()->listeners().Append(new FreshHome(home.path()));  // theirs now
  return RUN_ALL_TESTS();
}
