// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "apps/driver/settings.h"

/// From the names that a person says to the settings of a machine: what the command and the studio
/// share.
namespace dgt {

/// Which machine a program is written for.
struct MachineChoice {
  std::string file;          ///< a machine file; empty: none
  std::vector<Setting> set;  ///< `key=value`, whatever the file says; the later win
  std::string dialect;       ///< a name or a dialect file; empty: as the settings say
};

/// There is no dialect of that name.
struct UnknownDialect {
  std::string name;
};
/// A file was read and is wrong; its messages say how.
struct FaultyMachine {};
using MachineFault = std::variant<FileError, SettingFault, UnknownDialect, FaultyMachine>;

/// What is to be said about a machine or dialect file.
struct MachineMessages {
  std::shared_ptr<const SourceFile> file;
  DiagnosticBag bag;  ///< points into `file`
};

struct SettledMachine {
  std::vector<MachineMessages> messages;
  tl::expected<Settings, MachineFault> settings;
};

/// Reads the files that the choice names and settles all settings. The dialect has no name when
/// nothing chooses one.
[[nodiscard]] SettledMachine settle(const MachineChoice& choice);

}  // namespace dgt
