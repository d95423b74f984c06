// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "apps/cli/session.h"
#include "apps/driver/device_messages.h"

namespace dgt::cli {

/// Tells of a device that failed.
[[nodiscard]] ExitCode report(const DeviceFault& fault, const DeviceLimits& limits,
                              const Console& console);

}  // namespace dgt::cli
