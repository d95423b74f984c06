// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "apps/studio/window/invocation.h"

namespace dgt::studio {

/// Opens the window as the invocation says, waits until everything in it is calculated, and saves a
/// picture. The exit code; what failed has been said on standard error.
[[nodiscard]] int take_picture(const Invocation& invocation);

}  // namespace dgt::studio
