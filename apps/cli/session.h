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

/// The files that a program's diagnostics point into.
[[nodiscard]] Sources sources_of(const Compilation& made);

/// Reads and executes a program and shows its diagnostics, errors among them.
[[nodiscard]] Step<Compilation> examine(const std::string& file, const SourceOptions& options,
                                        const SourceSettings& settings, const Console& console);

/// Wrong usage when `file` is in no known language.
[[nodiscard]] Step<void> expect_source(const std::string& file, const SourceOptions& options,
                                       const Console& console);

/// By --from or the extension; DGT when neither says anything.
[[nodiscard]] InputLanguage language_for(const std::string& file, const SourceOptions& options);

/// Tells of a file that failed.
[[nodiscard]] ExitCode report(const FileError& error, const Console& console);

/// Reads and executes a program and shows its diagnostics; it has a tool path then.
[[nodiscard]] Step<Compilation> load(const std::string& file, const SourceOptions& options,
                                     const SourceSettings& settings, const Console& console);
/// Settles the settings first.
[[nodiscard]] Step<Compilation> load(const std::string& file, const SourceOptions& options,
                                     const Console& console);

/// The tool path of a program.
[[nodiscard]] Step<Toolpath> load_path(const std::string& file, const SourceOptions& options,
                                       const Console& console);

/// Writes a finished result whole or not at all.
[[nodiscard]] ExitCode write_result(const std::string& output, std::string_view bytes,
                                    const Console& console);

}  // namespace dgt::cli
