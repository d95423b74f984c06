// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "apps/driver/verify.h"
#include "lang/text/diagnostic.h"

namespace dgt {

/// The certificate as a page for a person.
[[nodiscard]] std::string to_text(const Certificate& proof, Language language);

/// One of its faults, with the lines to blame: `line 7: stops beside the path by …`.
[[nodiscard]] std::string to_text(const VerifyFault& fault, const Certificate& proof,
                                  Language language);

/// `dgt-verify/1`, lengths in mm, lines of the program from 1:
///  {"schema", "units", "verified", "program", "against", "dialect", "unit", "complete",
///   "moves": of the exact path that were compared, "omitted": those too small to be written,
///   "deviation": {"bound", "limit", "line"}, "position": {"x", "y", "limit", "line_x", "line_y"},
///   "drift": [x, y], "closure": {"contours", "open"}, "gouges": {"contours", "found"},
///   "arcs": {"count", "mismatch", "limit", "line"},
///   "faults": [{"kind", "lines": [first, last] or null, "source": {"file", "line", "column"} or
///               null, "dx", "dy", "measure"}],
///   "blocks": [{"lines", "source", "deviation", "error": [x, y]}], one a move of the exact path}.
/// Bounds are upper bounds; one that could not be given is null.
[[nodiscard]] std::string to_json(const Certificate& proof);

}  // namespace dgt
