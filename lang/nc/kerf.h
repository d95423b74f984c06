// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/contour.h"
#include "lang/nc/program.h"

namespace dgt {

/// The tool path of a program with its kerf applied.
///  (1) Each run of cuts between rapids is a contour. Where the kerf is compensated, its moves are
///      the equidistant of the run as a whole (kernel/contour.h), and its programmed path is what
///      the program says.
///  (2) Rapids lead to and from the moved ends. A straight cut without compensation beside a run
///      with it leads there, too. A program that begins with a compensated cut begins with a rapid.
///  (3) With another KerfLead than Moved, the first cut of a compensated run is straight, longer
///  than
///      the kerf moves the tool, begins where the tool stands and is no part of the contour. Else
///      it is an error at its block.
///  (4) The tool may come nearer to the contour by twice the step of the program's numbers: what
///      they were rounded by.
///  (5) A kerf that nothing is cut with, a run that it eats or in which it changes its side, is an
///      error at its block; a kerf of no width a warning.
[[nodiscard]] Toolpath with_kerf(const SourceFile& file, NcProgram program,
                                 const ContourOptions& options, DiagnosticBag& bag,
                                 KerfLead lead = KerfLead::Moved);

}  // namespace dgt
