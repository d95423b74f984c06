// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lang/nc/program.h"

namespace dgt {

/// Two languages are called ESSI; a program may be legal in both and mean different things.
enum class EssiDialect : std::uint8_t {
  Guide,  ///< arcs by radius, subprograms from 101 to 30000
  Iso     ///< arcs by centre, modes and speeds by codes (ISO 6582 and its kin)
};
enum class RotationSense : std::uint8_t { CounterClockwise, Clockwise };

struct EssiOptions {
  NcOptions nc;
  EssiDialect dialect = EssiDialect::Guide;
  /// What increments count, in mm.
  Rational unit = Rational(1, 10);
  /// Where a positive angle of a call turns.
  RotationSense rotation = RotationSense::CounterClockwise;
  /// What the scale of a call counts.
  Rational scale_unit = Rational(1, 100);
  /// Where the + of an Iso arc turns.
  RotationSense iso_plus = RotationSense::CounterClockwise;
};

/// Reads ESSI: what lang/README.md lists, and an error at everything else. The program starts at
/// X0 Y0. Moves with the torch off are rapids, unless the torch never comes on. Faults go to
/// `bag`, and reading goes on behind them; with an error the program is not to be used.
[[nodiscard]] NcProgram read_essi(const SourceFile& file, const EssiOptions& options,
                                  DiagnosticBag& bag);

}  // namespace dgt
