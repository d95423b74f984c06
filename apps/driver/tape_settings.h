// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <tl/expected.hpp>

#include "device/settings.h"
#include "device/tape.h"
#include "post/machine.h"

/// How a shop lays out its tapes, and its punch and reader. The keys stand in post/README.md.
namespace dgt {

struct TapeSettings {
  TapeFormat format;
  bool header_is_name = false;  ///< the name of the program in holes
  PunchSettings punch;
  ReaderSettings reader;
};

[[nodiscard]] std::span<const SettingKey> tape_settings();

/// The settings with one changed. A key that is none of tape_settings() is told without a nearest.
[[nodiscard]] tl::expected<TapeSettings, SettingFault> with_setting(TapeSettings settings,
                                                                    const Setting& setting);

}  // namespace dgt
