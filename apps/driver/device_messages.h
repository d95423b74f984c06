// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "device/device_fault.h"
#include "device/settings.h"
#include "lang/text/diagnostic.h"

namespace dgt {

/// What a device that failed was set to.
struct DeviceLimits {
  std::uint32_t speed = 0;  ///< rows a second
  std::chrono::milliseconds timeout{};
};
[[nodiscard]] inline DeviceLimits limits_of(const PunchSettings& punch) {
  return {punch.speed, punch.timeout};
}
[[nodiscard]] inline DeviceLimits limits_of(const ReaderSettings& reader) {
  return {reader.speed, reader.timeout};
}

/// What has failed, where, and what to look after, in one sentence.
[[nodiscard]] std::string sentence_of(const DeviceFault& fault, const DeviceLimits& limits,
                                      Language language);

}  // namespace dgt
