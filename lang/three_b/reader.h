// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lang/nc/program.h"

namespace dgt {

/// What the D of a program is.
enum class ThreeBPause : std::uint8_t {
  Rapid,  ///< takes the wire out, and the next one threads it again; two in a row are a stop
  Stop    ///< stops the machine, and nothing else
};

struct ThreeBOptions {
  NcOptions nc;
  /// What numbers count, in mm.
  Rational unit = Rational(1, 1000);
  ThreeBPause pause = ThreeBPause::Rapid;
  /// How far apart controls may end a block, in mm (lang/three_b/counting.h).
  Rational end_tolerance = Rational(1, 100);
};

/// Reads 3B: what lang/README.md lists, and an error at everything else. The program starts at X0
/// Y0, or where its title says. What it moves with the wire out are rapids. Faults go to `bag`, and
/// reading goes on behind them; with an error the program is not to be used.
[[nodiscard]] NcProgram read_three_b(const SourceFile& file, const ThreeBOptions& options,
                                     DiagnosticBag& bag);

}  // namespace dgt
