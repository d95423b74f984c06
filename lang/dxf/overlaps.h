// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lang/dxf/strand.h"

namespace dgt {

/// Keeps of strands that are drawn twice, in either direction, within 10⁻⁶ mm, the first; tells how
/// many were.
void remove_duplicates(std::vector<DxfStrand>& strands, DiagnosticBag& bag);

/// Tells of pieces that run along each other for more than 10⁻⁶ mm: on one line or one circle,
/// exactly. They are cut twice there.
void report_overlaps(const std::vector<DxfStrand>& strands, DiagnosticBag& bag);

}  // namespace dgt
