// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <memory>

namespace dgt::cli {

/// Help like a manual page: what a verb does before its options, lines of at most 80 columns.
[[nodiscard]] std::shared_ptr<CLI::Formatter> manual_formatter();

}  // namespace dgt::cli
