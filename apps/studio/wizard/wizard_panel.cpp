// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/wizard/wizard_panel.h"

namespace dgt::studio {

WizardPanel::WizardPanel(QWidget* parent) : QWidget(parent) {}
WizardPanel::~WizardPanel() = default;

void WizardPanel::show_source(const QString&) {}

}  // namespace dgt::studio
