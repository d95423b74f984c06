// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <map>

#include "apps/studio/figure.h"
#include "lang/text/diagnostic.h"

/// Pages of the help that tables of the project say.
namespace dgt::studio {

/// Every form of definition with its example; adds their figures.
[[nodiscard]] QString page_of_definitions(std::map<QString, Figure>& figures);
/// Every message with its code.
[[nodiscard]] QString page_of_messages(Language language);
[[nodiscard]] QString table_of_dialects();
/// Between a macro and the program of a sample.
[[nodiscard]] QString bridge_to_program();

}  // namespace dgt::studio
