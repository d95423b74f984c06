// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "apps/cli/session.h"
#include "post/dialect.h"

namespace dgt::cli {

/// The control that is written for.
struct MachineOptions {
  std::string dialect;
  std::vector<std::string> settings;  ///< `key=value`, the later one wins

  /// The dialect with its settings; says what is wrong with them.
  [[nodiscard]] Step<Dialect> chosen(const Console& console) const;
};
void add_machine_options(CLI::App& verb, MachineOptions& options);

/// `essi`, `plasmatic` and so on.
[[nodiscard]] std::string names_of_dialects(std::string_view separator);

}  // namespace dgt::cli
