// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "kernel/toolpath.h"

namespace dgt {

/// The tool path as JSON of the schema `dgt-path/1` (apps/README.md), one move a line.
///  (1) Every number is the shortest decimal that reads back as the double nearest to the exact
///      value; coordinates within 2^kZeroExponent of 0 are 0.
///  (2) The same path gives the same bytes.
[[nodiscard]] std::string to_json(const Toolpath& path);

}  // namespace dgt
