// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/points_panel.h"

#include <utility>

namespace dgt::studio {

PointsPanel::PointsPanel(QWidget* parent) : QWidget(parent) {}

void PointsPanel::show_part(PartPtr part) { part_ = std::move(part); }

}  // namespace dgt::studio
