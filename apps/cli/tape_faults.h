// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "apps/cli/session.h"
#include "apps/driver/tape_settings.h"
#include "device/run.h"

namespace dgt::cli {

/// What a device that failed is told as. `speed` and `timeout` are those it was set to.
struct DeviceLimits {
  std::uint32_t speed = 0;
  std::chrono::milliseconds timeout{};
};
[[nodiscard]] std::string sentence_of(const DeviceFault& fault, const DeviceLimits& limits,
                                      const Console& console);
[[nodiscard]] ExitCode report(const DeviceFault& fault, const DeviceLimits& limits,
                              const Console& console);

[[nodiscard]] inline DeviceLimits limits_of(const PunchSettings& punch) {
  return {punch.speed, punch.timeout};
}
[[nodiscard]] inline DeviceLimits limits_of(const ReaderSettings& reader) {
  return {reader.speed, reader.timeout};
}

}  // namespace dgt::cli
