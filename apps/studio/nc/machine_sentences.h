// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "apps/driver/machine_choice.h"
#include "apps/studio/editor/faults.h"

namespace dgt::studio {

/// Why a machine cannot be used, in a sentence of the program's language; empty: its messages say
/// it.
[[nodiscard]] QString sentence_of(const MachineFault& fault);

/// What is to be said about the files of a machine.
[[nodiscard]] std::vector<Fault> messages_of(const SettledMachine& machine, Language language);

}  // namespace dgt::studio
