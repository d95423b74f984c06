// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "lang/dxf/drawing.h"
#include "lang/dxf/groups.h"

namespace dgt {

/// An entity of a file: the pair that names it, and those behind it.
struct DxfRecord {
  Range name;
  std::vector<DxfGroup> groups;
  std::vector<DxfRecord> vertices;  ///< of an old polyline

  /// The last of that code; null: none.
  [[nodiscard]] const DxfGroup* find(int code) const;
};

/// Angles nearer to a quarter turn than this are one: what 16 digits of degrees or radians leave.
/// Unit: degrees.
[[nodiscard]] const Rational& dxf_angle_rounding();

/// The entity that a record says. Numbers that are none, and needed ones that are not there, are
/// told; what else cannot be cut becomes DxfFaulty.
[[nodiscard]] DxfEntity dxf_entity(const DxfRecord& record, DxfGroups& groups, DiagnosticBag& bag);

}  // namespace dgt
