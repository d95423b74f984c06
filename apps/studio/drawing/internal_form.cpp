// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/internal_form.h"

#include <utility>

namespace dgt::studio {

InternalForm::InternalForm(QWidget* parent) : QWidget(parent) {}

void InternalForm::show_part(PartPtr part) { part_ = std::move(part); }

void InternalForm::light_line(int /*file*/, int /*line*/) {}

}  // namespace dgt::studio
