// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>

#include "apps/studio/window/invocation.h"
#include "apps/studio/window/main_window.h"
#include "apps/studio/window/screenshot.h"

namespace {

/// Pictures need no screen.
void do_without_screen() {
  const bool has_screen =
      qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY");
  if (!has_screen && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
}

}  // namespace

int main(int argc, char** argv) {
  using namespace dgt::studio;
  const Parsed parsed = parse(argc, argv);
  if (!parsed.invocation) return parsed.exit_code;
  const Invocation& invocation = *parsed.invocation;
  if (invocation.picture) do_without_screen();
  int qt_arguments = 1;  // the others are ours
  QApplication application(qt_arguments, argv);
  QApplication::setApplicationName(QStringLiteral("dgt-studio"));
  QApplication::setApplicationVersion(QStringLiteral(DGT_VERSION));
  QApplication::setDesktopFileName(QStringLiteral("dgt-studio"));
  QApplication::setWindowIcon(QIcon(QStringLiteral(":/studio/window/icons/dgt-studio.svg")));
  if (invocation.picture) return take_picture(invocation);
  MainWindow window({invocation.language, invocation.theme, invocation.machine_file});
  window.show();
  if (!invocation.file.isEmpty()) window.open_file(invocation.file);
  window.offer_recovery();
  return QApplication::exec();
}
