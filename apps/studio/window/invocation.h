// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <QString>
#include <cstdint>
#include <optional>

#include "apps/studio/window/theme.h"
#include "lang/text/diagnostic.h"

namespace dgt::studio {

/// What a picture shows.
enum class View : std::uint8_t { Draw, Nc, Points, Wizard, Tape };

/// A picture of the window, instead of the window.
struct Picture {
  QString file;
  View view = View::Draw;
  QSize size;
};

/// The command line.
struct Invocation {
  QString file;  ///< empty: none
  std::optional<Language> language;
  std::optional<Theme> theme;
  QString machine_file;
  std::optional<Picture> picture;
};

/// What a command line ends with when the window does not come up: as `dgt` does.
inline constexpr int kWrongUsage = 2;
inline constexpr int kFailure = 3;

/// Reads the command line. When it asks for help or the version, or is wrong, that is printed and
/// nothing comes back but the exit code.
struct Parsed {
  std::optional<Invocation> invocation;
  int exit_code = 0;
};
[[nodiscard]] Parsed parse(int argc, const char* const* argv);

}  // namespace dgt::studio
