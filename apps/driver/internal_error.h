// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apps/driver/file_io.h"

namespace dgt {

/// A mistake of the program's own, with what it takes to see it again.
struct FailedRun {
  std::string what;
  std::vector<std::string> command_line;  ///< without the name of the program
};

/// Files on the command line that are larger are named only.
inline constexpr std::uintmax_t kMostSavedBytes = 16u << 20;

/// Saves the version, the error, the command line and every file that the command line names, as
/// `dgt-internal-error-<pid>.txt` in `folder`; returns the full name. Standard input is among them
/// when it is a file. For the user's eyes only (mode 0600); nothing that exists is written over.
[[nodiscard]] FileResult<std::string> save_internal_error(const FailedRun& error,
                                                          const std::filesystem::path& folder);

}  // namespace dgt
