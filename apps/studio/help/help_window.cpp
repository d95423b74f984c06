// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/help/help_window.h"

namespace dgt::studio {

HelpWindow::HelpWindow(QWidget* parent) : QWidget(parent) {}
HelpWindow::~HelpWindow() = default;

void HelpWindow::show_topic(const QString&) {}

}  // namespace dgt::studio
