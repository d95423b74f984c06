// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/nc/nc_panel.h"

namespace dgt::studio {

NcPanel::NcPanel(QWidget* parent) : QWidget(parent) {}
NcPanel::~NcPanel() = default;

void NcPanel::set_machine(const QString&) {}
void NcPanel::show_part(PartPtr) {}
bool NcPanel::choose_dialect() { return false; }
void NcPanel::set_dialect(const QString&) {}
QString NcPanel::dialect() const { return {}; }

}  // namespace dgt::studio
