// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "apps/cli/options.h"
#include "post/dialect.h"

namespace dgt::cli {

/// How a program is written.
struct PostOptions {
  std::string dialect;                       ///< empty: as the settings have it
  std::optional<Compensation> compensation;  ///< likewise
};
/// --compensation.
void add_compensation(CLI::App& verb, PostOptions& options);

/// Reads a program in any language and writes it in a dialect. A note tells the certificate.
[[nodiscard]] ExitCode write_for(const Request& request, const PostOptions& post,
                                 const Console& console);

}  // namespace dgt::cli
