// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "post/dialect.h"

/// Settings of a machine that change its dialect: `key=value`. All keys stand in README.md.
namespace dgt {

struct Setting {
  std::string key;
  std::string value;
};

struct SettingFault {
  enum class Kind : std::uint8_t {
    NoValue,     ///< not of the form `key=value`
    UnknownKey,  ///< `nearest` is the known key most like it
    BadValue     ///< `expected` says what would be right
  };
  Kind kind;
  std::string key;
  std::string value;
  std::string nearest;
  std::string expected;  ///< `0.0001…100 mm`, `auto|program|none`
};

/// One key. `expected` is what its values look like, in no language in particular: for messages,
/// for help and for README.md.
struct SettingKey {
  std::string_view key;
  std::string_view expected;
};
/// The keys of a dialect.
[[nodiscard]] std::span<const SettingKey> dialect_settings();

/// Codes and ranges of them between blanks or commas: `M21 M100-M199`.
[[nodiscard]] std::optional<std::vector<CodeRange>> code_ranges(std::string_view text, Form form);

/// Splits `key=value` at the first `=`.
[[nodiscard]] tl::expected<Setting, SettingFault> parse_setting(std::string_view text);

/// The dialect with one setting changed.
[[nodiscard]] tl::expected<Dialect, SettingFault> with_setting(Dialect dialect,
                                                               const Setting& setting);

/// The fault of a value that `key` does not take.
[[nodiscard]] SettingFault bad_value(const SettingKey& key, std::string_view value);
/// The fault of a key that is none of `known`.
[[nodiscard]] SettingFault unknown_key(const Setting& setting,
                                       std::span<const std::string_view> known);

/// The known key with the least edit distance from `key`; of equals the one that begins
/// most like it, then the first. Empty for no keys.
[[nodiscard]] std::string_view nearest_key(std::string_view key,
                                           std::span<const std::string_view> known);

}  // namespace dgt
