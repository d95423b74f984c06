// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "apps/cli/options.h"

namespace dgt::cli {

/// Reads a program in any language and writes it in a dialect, the machine file's when
/// `dialect_name` is empty. A note tells the certificate.
[[nodiscard]] ExitCode write_for(const Request& request, const std::string& dialect_name,
                                 const Console& console);

}  // namespace dgt::cli
