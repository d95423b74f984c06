// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "apps/studio/figure.h"

namespace dgt::studio {

/// A whole small program of the tab K.
struct ContourExample {
  QString name;  ///< in the language of the program
  Figure figure;
  /// What goes into the editor: the program, before it the text of its macro as comments.
  [[nodiscard]] std::string text() const;
};

/// From the simplest to loops and macros.
[[nodiscard]] std::vector<ContourExample> contour_examples();

}  // namespace dgt::studio
