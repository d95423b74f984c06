// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "post/dialect.h"
#include "post/machine.h"
#include "post/machine_file.h"

/// A dialect file: TOML that says how a control wants its programs. All keys stand in README.md.
namespace dgt {

struct DialectFileFault {
  enum class Kind : std::uint8_t {
    Syntax,      ///< the text is no TOML from `span` on
    KeyTwice,    ///< `span` is the second one
    UnknownKey,  ///< `nearest` is the known key most like it
    BadValue,    ///< `expected` says what would be right
    KeyLacking   ///< `key` has to be there; no span
  };
  Kind kind;
  TextSpan span;
  std::string key;
  std::string nearest;
  std::string expected;
};

struct DialectFile {
  Dialect dialect;
  std::vector<DialectFileFault> faults;  ///< not empty: the dialect is not to be used
};

/// The keys of a dialect file in the order of README.md; `codes.translate.*` is any code.
[[nodiscard]] std::span<const SettingKey> dialect_keys();

/// Reads the text of a dialect file, UTF-8. `base` in it is looked up in `known`.
[[nodiscard]] DialectFile read_dialect(std::string name, std::string_view text,
                                       std::span<const Dialect> known);
[[nodiscard]] DialectFile read_dialect(std::string name, std::string_view text);

/// A file of post/dialects/, as it was when the library was built.
struct ShippedDialect {
  std::string_view name;
  std::string_view text;
};
[[nodiscard]] std::span<const ShippedDialect> shipped_dialects();

}  // namespace dgt
