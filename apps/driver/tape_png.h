// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "device/drawing.h"

namespace dgt {

/// The drawing as PNG; nothing when a side has more than 32767 pixels, Cairo's limit.
[[nodiscard]] std::optional<std::string> to_png(const TapeDrawing& drawing, double pixels_per_mm);

}  // namespace dgt
