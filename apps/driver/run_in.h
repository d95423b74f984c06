// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/toolpath.h"

namespace dgt {

/// The exact path as a control runs it whose program is `written`.
///  (1) Where it comes to its offset before the beginning of a closed contour, the lead goes there
///      and the first element begins there: if the contour runs by that place to its end anyway,
///      or if the tool keeps off all parts on the way from there. Else that is not the path.
///  (2) A closed contour that begins in an outer corner ends before it: the tool touches the corner
///      at both its ends, and between them there is nothing to cut.
/// `unit`, of the program, in mm: no place that is as near is another.
[[nodiscard]] Toolpath with_run_ins(const Toolpath& exact, const Toolpath& written,
                                    const Rational& unit);

}  // namespace dgt
