// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/language.h"

#include <QCoreApplication>

namespace dgt::studio {

// Each translation says which language it is.
Language message_language() {
  const QString name = QCoreApplication::translate("dgt::studio::Language", "en");
  return name == QStringLiteral("ru") ? Language::Russian : Language::English;
}

}  // namespace dgt::studio
