// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/tape/tape_dialog.h"

namespace dgt::studio {

TapeDialog::TapeDialog(TapeJob, const Settings&, QWidget* parent) : QDialog(parent) {}
TapeDialog::~TapeDialog() = default;

void TapeDialog::set_program(const QString&, const QByteArray&) {}

}  // namespace dgt::studio
