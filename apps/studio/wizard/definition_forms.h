// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "apps/studio/figure.h"

namespace dgt::studio {

/// One way to define an element, as the guide's tables spell it: `L=PC`.
struct DefinitionForm {
  std::string pattern;
  QString description;  ///< in the language of the program
  Figure figure;        ///< an example; its last line is such a definition

  [[nodiscard]] char kind() const { return pattern.front(); }  ///< `L`, `C`, `P`, `O`
  /// The letters of the values, in order: `PC`.
  [[nodiscard]] std::string_view letters() const { return std::string_view(pattern).substr(2); }
  /// The last line of the example: `L1=P1 C1`.
  [[nodiscard]] std::string example() const;
};

/// Every spelling of every form of the language, in the order of the guide.
[[nodiscard]] std::vector<DefinitionForm> definition_forms();

/// The letters that are followed by the number of an element, not by a measure.
[[nodiscard]] bool names_an_element(char letter);

}  // namespace dgt::studio
