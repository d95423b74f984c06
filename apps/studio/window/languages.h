// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lang/text/diagnostic.h"

namespace dgt::studio {

/// Puts the whole program into a language, at once: every `_ru.qm` of its folders and the dialogs
/// of Qt. Widgets get a LanguageChange.
void use_language(Language language);

}  // namespace dgt::studio
