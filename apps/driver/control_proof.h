// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "apps/driver/settings.h"
#include "apps/driver/verify.h"

namespace dgt {

/// A source with the settings it was compiled with.
struct Compiled {
  std::string name;
  const Compilation& made;
  const SourceSettings& settings;
};

/// verify(), the way the control runs the program.
///  (1) `program` was read with the settings of as_its_control().
///  (2) When the control offsets contours and goes round corners, so does the exact path: `against`
///      is compiled so once more. The part stays what it is.
///  (3) When nobody has said how the control comes to its offset, the program is proved both ways;
///      a program that no control could come to its offset in is proved as it was read.
[[nodiscard]] Certificate prove(const Compiled& program, const Compiled& against,
                                const Dialect& dialect, const VerifyLimits& limits,
                                const OnProgress& on_progress = {});

}  // namespace dgt
