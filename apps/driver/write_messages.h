// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "apps/driver/pipeline.h"
#include "post/write.h"

namespace dgt {

/// What the writer has to say, as diagnostics at the places in the source that asked for it.
/// Precondition: `program` has a tool path, and `written` was made from it.
[[nodiscard]] DiagnosticBag explain(const WriteResult& written, const Dialect& dialect,
                                    const Compilation& program);

/// A certified deviation as it is told: mm with four decimals, never below `deviation`.
[[nodiscard]] std::string told(double deviation);

}  // namespace dgt
