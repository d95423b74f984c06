// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

#include "apps/studio/window/theme.h"

/// Icons drawn for both themes: pictures of `window/icons`, whose signal colours stand for those of
/// the theme. #000 is the text, #00f an accent, #0a0 the programmed contour, #fb0 the equidistant,
/// #f00 the tool. They are coloured when they are painted, so a change of theme needs nothing.
namespace dgt::studio {

/// The icon `window/icons/NAME.svg`.
[[nodiscard]] QIcon icon(const QString& name);
/// The same in one colour of the theme instead of the text's.
[[nodiscard]] QIcon sign_icon(const QString& name, QColor Colours::*colour);

}  // namespace dgt::studio
