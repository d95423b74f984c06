// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lang/text/diagnostic.h"

namespace dgt::studio {

/// The language of messages: that of the translators which are installed.
[[nodiscard]] Language message_language();

}  // namespace dgt::studio
