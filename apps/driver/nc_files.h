// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "apps/driver/settings.h"

/// NC programs as files: what they are called, and how their own control reads them.
namespace dgt {

/// What a control's programs are called by: `.ess`, `.3b`, `.cnc`, `.ngc`.
[[nodiscard]] const char* extension_of(const Dialect& dialect);

/// In which language the programs of a dialect are read back.
[[nodiscard]] InputLanguage language_of(const Dialect& dialect);

/// The settings with which a program of `settings.dialect` is read: it counts in the units of its
/// control, which comes to its offset and goes round corners in its own way, where that is known.
/// The language stays as it is set.
[[nodiscard]] SourceSettings as_its_control(const Settings& settings);

/// For programs in every language.
void set_kerf_lead(SourceSettings& source, KerfLead lead);

}  // namespace dgt
