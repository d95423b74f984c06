// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "apps/driver/settings.h"

/// What each setting says and does, but those of tapes and dialects. Internal to the driver.
namespace dgt {

inline constexpr std::string_view kDialectKey = "dialect";
inline constexpr std::string_view kMacroPathKey = "macro_path";

struct SettingRule {
  SettingKey key;
  /// False, and nothing changed that counts, when the text is no value of the setting.
  bool (*apply)(Settings&, std::string_view);
};

[[nodiscard]] std::span<const SettingRule> setting_rules();

}  // namespace dgt
