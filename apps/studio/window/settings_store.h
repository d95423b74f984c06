// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QSettings>
#include <QString>
#include <QStringList>
#include <QVariant>

#include "apps/studio/window/theme.h"
#include "lang/text/diagnostic.h"

namespace dgt::studio {

/// The guide's menu has room for four recent files.
inline constexpr int kRecentFiles = 4;

/// What the program remembers from day to day, in `studio.ini` of the user's configuration folder.
/// Panels keep theirs in groups of their own, through `panel`.
class SettingsStore {
 public:
  SettingsStore();
  /// From now on this process keeps its settings in another file than the user's: pictures and
  /// tests are the same for everybody.
  static void keep_in(const QString& file);

  /// As the system asks until a person has chosen.
  [[nodiscard]] Language language() const;
  void set_language(Language language);
  [[nodiscard]] Theme theme() const;
  void set_theme(Theme theme);
  /// The colours of a theme: its own, with what a person has changed.
  [[nodiscard]] Colours colours(Theme theme) const;
  void set_colours(Theme theme, const Colours& colours);
  [[nodiscard]] int font_size() const;  ///< of programs, in points
  void set_font_size(int points);
  [[nodiscard]] static int standard_font_size();
  [[nodiscard]] QStringList recent_files() const;  ///< newest first
  void add_recent_file(const QString& name);
  void remove_recent_file(const QString& name);
  [[nodiscard]] QString machine_file() const;  ///< empty: none
  void set_machine_file(const QString& name);
  [[nodiscard]] bool draws_live() const;  ///< or at F5 alone
  void set_draws_live(bool live);
  [[nodiscard]] QByteArray geometry() const;
  [[nodiscard]] QByteArray layout() const;
  void set_window(const QByteArray& geometry, const QByteArray& layout);

  /// What a panel remembers under a key of its own, `nc/dialect`.
  [[nodiscard]] QVariant panel(const QString& key, const QVariant& otherwise) const;
  void set_panel(const QString& key, const QVariant& value);

 private:
  QSettings file_;
};

}  // namespace dgt::studio
