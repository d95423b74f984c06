// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lang/nc/program.h"

namespace dgt {

struct GcodeOptions {
  NcOptions nc;
  /// Before the first G90 or G91.
  bool begins_incremental = false;
  /// What G04 counts.
  Rational dwell_unit = 1;  ///< seconds
};

/// Reads G-code: what lang/README.md lists, and an error at everything else. The first rapid to an
/// absolute place tells where the program starts; without one that is X0 Y0. Faults go to `bag`,
/// and reading goes on behind them; with an error the program is not to be used.
[[nodiscard]] NcProgram read_gcode(const SourceFile& file, const GcodeOptions& options,
                                   DiagnosticBag& bag);

}  // namespace dgt
