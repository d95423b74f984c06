// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QLocale>
#include <cstdio>
#include <optional>

#include "apps/studio/window/invocation.h"
#include "apps/studio/window/main_window.h"
#include "apps/studio/window/screenshot.h"

namespace {

/// Whether Qt has somewhere to put a window. Without it Qt ends the program with a signal.
bool has_screen() {
  return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
         qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
}

void tell_no_screen(std::optional<dgt::Language> chosen) {
  const bool russian =
      chosen ? *chosen == dgt::Language::Russian : QLocale::system().language() == QLocale::Russian;
  std::fputs(russian ? "dgt-studio: ошибка: нет экрана: не заданы ни DISPLAY, ни WAYLAND_DISPLAY; "
                       "картинку без экрана сохраняет --screenshot OUT.png\n"
                     : "dgt-studio: error: there is no screen: neither DISPLAY nor "
                       "WAYLAND_DISPLAY is set; --screenshot OUT.png saves a picture without one\n",
             stderr);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace dgt::studio;
  const Parsed parsed = parse(argc, argv);
  if (!parsed.invocation) return parsed.exit_code;
  const Invocation& invocation = *parsed.invocation;
  if (!has_screen()) {
    if (!invocation.picture) {
      tell_no_screen(invocation.language);
      return kFailure;
    }
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
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
