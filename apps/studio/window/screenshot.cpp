// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/screenshot.h"

#include <QApplication>
#include <QBuffer>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <cstdio>

#include "apps/driver/file_io.h"
#include "apps/studio/background.h"
#include "apps/studio/tape/tape_dialog.h"
#include "apps/studio/window/main_window.h"

namespace dgt::studio {
namespace {

/// Windows are laid out and painted in steps; after this long without work they stand still.
constexpr int kStill = 150;  // ms
/// No program of a picture takes as long.
constexpr int kLongestWait = 600'000;  // ms

/// A panel behind another is never painted, and the drawing settles when it is.
template <typename Panel>
bool is_unsettled(const Panel* panel) {
  return !panel->visibleRegion().isEmpty() && !panel->is_settled();
}

bool has_work(const QWidget* window) {
  return std::ranges::any_of(window->findChildren<Background*>(), &Background::is_busy);
}

bool is_at_work(MainWindow& window) {
  const Panels& panels = window.panels();
  return !window.compiler().current() || is_unsettled(panels.drawing) ||
         is_unsettled(panels.points) || is_unsettled(panels.internal_form) ||
         std::ranges::any_of(QApplication::topLevelWidgets(), has_work);
}

void wait_until_still(MainWindow& window) {
  QElapsedTimer waited;
  waited.start();
  QElapsedTimer still;
  still.start();
  while (still.elapsed() < kStill && waited.elapsed() < kLongestWait) {
    QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 20);
    QTimer::singleShot(10, qApp, [] {});
    if (is_at_work(window)) still.restart();
  }
}

FileResult<void> save(const QPixmap& picture, const QString& file) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  picture.save(&buffer, "PNG");
  return write_file(file.toStdString(), {bytes.data(), static_cast<std::size_t>(bytes.size())});
}

void say(const FileError& error) {
  std::fprintf(stderr, "dgt-studio: error: %s\n", error.text().c_str());
}

/// Without a machine for the guide's first control.
void show_nc(MainWindow& window) {
  const std::string& dialect = window.machine().dialect.name;
  window.panels().nc->set_dialect(dialect.empty() ? QStringLiteral("essi")
                                                  : QString::fromStdString(dialect));
  window.panels().show(Panels::Panel::Nc);
}

QPixmap picture_of_tape(MainWindow& window, const QSize& size) {
  show_nc(window);
  wait_until_still(window);
  TapeDialog dialog(TapeJob::Punch, window.machine(), &window);
  dialog.set_program(window.documents().document().name(), window.panels().nc->program());
  dialog.resize(size);
  dialog.show();
  wait_until_still(window);
  return dialog.grab();
}

QPixmap picture_of(MainWindow& window, const Picture& picture) {
  switch (picture.view) {
    case View::Draw:
      window.draw();
      break;
    case View::Nc:
      show_nc(window);
      break;
    case View::Points:
      window.panels().show(Panels::Panel::Points);
      break;
    case View::Wizard:
      window.panels().hide(Panels::Panel::Drawing);  // all forms are in view
      window.panels().show(Panels::Panel::Wizard);
      break;
    case View::Tape:
      return picture_of_tape(window, picture.size);
  }
  wait_until_still(window);
  return window.grab();
}

}  // namespace

int take_picture(const Invocation& invocation) {
  for (const QString& file : {invocation.file, invocation.machine_file}) {
    if (file.isEmpty()) continue;
    if (const auto readable = read_file(file.toStdString()); !readable) {
      say(readable.error());
      return kFailure;
    }
  }
  const QTemporaryDir settings;  // nobody's, so that the picture is the same for everybody
  SettingsStore::keep_in(settings.filePath(QStringLiteral("studio.ini")));
  MainWindow window(
      {invocation.language, invocation.theme.value_or(Theme::Light), invocation.machine_file});
  window.resize(invocation.picture->size);
  if (!invocation.file.isEmpty() && !window.open_file(invocation.file)) return kFailure;
  window.show();
  wait_until_still(window);
  const auto saved = save(picture_of(window, *invocation.picture), invocation.picture->file);
  if (saved) return 0;
  say(saved.error());
  return kFailure;
}

}  // namespace dgt::studio
