// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "apps/cli/session.h"
#include "apps/driver/settings.h"

namespace dgt::cli {

/// --machine and --set.
void add_machine_options(CLI::App& verb, MachineOptions& options);

/// What the machine file, --set and the other options come to; tells what is wrong with them.
/// `post` is the dialect chosen by name; empty: the settings choose it, or nobody.
[[nodiscard]] Step<Settings> settle(const SourceOptions& options, const Console& console,
                                    const std::string& post = {});

/// A line for each dialect: its name, and what it is.
[[nodiscard]] std::string list_of_dialects(Language language);

/// `essi`, `plasmatic` and so on.
[[nodiscard]] std::string names_of_dialects(std::string_view separator);

}  // namespace dgt::cli
