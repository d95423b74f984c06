// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "apps/cli/options.h"

/// The steps that verbs are made of. Each tells the person what went wrong and returns the exit
/// code for it.
namespace dgt::cli {

template <typename T>
using Step = tl::expected<T, ExitCode>;

/// Reads and executes a program and shows its diagnostics; it has a tool path then.
[[nodiscard]] Step<Compilation> load(const std::string& file, const SourceOptions& options,
                                     const Console& console);

/// The tool path of a program.
[[nodiscard]] Step<Toolpath> load_path(const std::string& file, const SourceOptions& options,
                                       const Console& console);

/// Writes a finished result whole or not at all.
[[nodiscard]] ExitCode write_result(const std::string& output, std::string_view bytes,
                                    const Console& console);

}  // namespace dgt::cli
