// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/settings_store.h"

#include <QLocale>
#include <QStandardPaths>
#include <algorithm>

namespace dgt::studio {
namespace {

constexpr int kStandardFontSize = 11;
constexpr int kSmallestFont = 6;
constexpr int kLargestFont = 48;

/// Empty: the user's.
QString& other_file() {
  static QString file;
  return file;
}

QString file_name() {
  if (!other_file().isEmpty()) return other_file();
  return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) +
         QStringLiteral("/studio.ini");
}

QString theme_name(Theme theme) {
  return theme == Theme::Dark ? QStringLiteral("dark") : QStringLiteral("light");
}

QString colour_key(Theme theme, const ColourRow& row) {
  return QStringLiteral("colours-%1/%2").arg(theme_name(theme), QString::fromLatin1(row.key));
}

}  // namespace

SettingsStore::SettingsStore() : file_(file_name(), QSettings::IniFormat) {}

void SettingsStore::keep_in(const QString& file) { other_file() = file; }

int SettingsStore::standard_font_size() { return kStandardFontSize; }

Language SettingsStore::language() const {
  const QString saved = file_.value(QStringLiteral("language")).toString();
  if (saved == QStringLiteral("ru")) return Language::Russian;
  if (saved == QStringLiteral("en")) return Language::English;
  return QLocale::system().language() == QLocale::Russian ? Language::Russian : Language::English;
}

void SettingsStore::set_language(Language language) {
  file_.setValue(QStringLiteral("language"),
                 language == Language::Russian ? QStringLiteral("ru") : QStringLiteral("en"));
}

Theme SettingsStore::theme() const {
  const QString saved = file_.value(QStringLiteral("theme")).toString();
  return saved == theme_name(Theme::Dark) ? Theme::Dark : Theme::Light;
}

void SettingsStore::set_theme(Theme theme) {
  file_.setValue(QStringLiteral("theme"), theme_name(theme));
}

Colours SettingsStore::colours(Theme theme) const {
  Colours colours = standard_colours(theme);
  for (const ColourRow& row : colour_rows()) {
    const QColor saved(file_.value(colour_key(theme, row)).toString());
    if (saved.isValid()) colours.*row.colour = saved;
  }
  return colours;
}

void SettingsStore::set_colours(Theme theme, const Colours& colours) {
  const Colours standard = standard_colours(theme);
  for (const ColourRow& row : colour_rows()) {
    const QColor& colour = colours.*row.colour;
    if (colour == standard.*row.colour) {
      file_.remove(colour_key(theme, row));
    } else {
      file_.setValue(colour_key(theme, row), colour.name());
    }
  }
}

int SettingsStore::font_size() const {
  const int saved = file_.value(QStringLiteral("font_size"), kStandardFontSize).toInt();
  return std::clamp(saved, kSmallestFont, kLargestFont);
}

void SettingsStore::set_font_size(int points) {
  file_.setValue(QStringLiteral("font_size"), std::clamp(points, kSmallestFont, kLargestFont));
}

QStringList SettingsStore::recent_files() const {
  return file_.value(QStringLiteral("recent")).toStringList().mid(0, kRecentFiles);
}

void SettingsStore::add_recent_file(const QString& name) {
  QStringList files = recent_files();
  files.removeAll(name);
  files.prepend(name);
  file_.setValue(QStringLiteral("recent"), files.mid(0, kRecentFiles));
}

void SettingsStore::remove_recent_file(const QString& name) {
  QStringList files = recent_files();
  files.removeAll(name);
  file_.setValue(QStringLiteral("recent"), files);
}

QString SettingsStore::machine_file() const {
  return file_.value(QStringLiteral("machine_file")).toString();
}

void SettingsStore::set_machine_file(const QString& name) {
  file_.setValue(QStringLiteral("machine_file"), name);
}

bool SettingsStore::draws_live() const {
  return file_.value(QStringLiteral("draws_live"), true).toBool();
}

void SettingsStore::set_draws_live(bool live) {
  file_.setValue(QStringLiteral("draws_live"), live);
}

QByteArray SettingsStore::geometry() const {
  return file_.value(QStringLiteral("window/geometry")).toByteArray();
}

QByteArray SettingsStore::layout() const {
  return file_.value(QStringLiteral("window/layout")).toByteArray();
}

void SettingsStore::set_window(const QByteArray& geometry, const QByteArray& layout) {
  file_.setValue(QStringLiteral("window/geometry"), geometry);
  file_.setValue(QStringLiteral("window/layout"), layout);
}

QVariant SettingsStore::panel(const QString& key, const QVariant& otherwise) const {
  return file_.value(QStringLiteral("panels/") + key, otherwise);
}

void SettingsStore::set_panel(const QString& key, const QVariant& value) {
  file_.setValue(QStringLiteral("panels/") + key, value);
}

}  // namespace dgt::studio
