// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "apps/driver/certificate.h"
#include "apps/driver/machine_choice.h"
#include "apps/studio/part.h"
#include "post/write.h"

/// What the NC panel does in the background: the same calls as the command's.
namespace dgt::studio {

/// An NC program that is wanted.
struct NcWish {
  PartPtr part;  ///< with a path
  MachineChoice machine;
  std::optional<Compensation> compensation;  ///< unset: as the machine's settings say
};

/// An NC program as it was written, or why it was not.
struct NcProgramText {
  NcWish wish;
  SettledMachine machine;
  WriteResult written;
  DiagnosticBag said;  ///< points into the part's sources

  [[nodiscard]] bool exists() const { return machine.settings && written.faults.empty(); }
  [[nodiscard]] const Settings& settings() const { return *machine.settings; }
};
using NcProgramTextPtr = std::shared_ptr<const NcProgramText>;

/// Settles the machine and writes: `dgt compile`.
[[nodiscard]] NcProgramTextPtr write_nc(const NcWish& wish);

/// A text as a control would read it.
[[nodiscard]] PartPtr read_nc(const NcProgramText& base, const std::string& name,
                              const std::string& bytes);

/// `dgt verify`: a text that was read back against the exact path. Precondition: both have one.
[[nodiscard]] Certificate prove_nc(const Part& read, const Part& exact, const Settings& settings);

}  // namespace dgt::studio
