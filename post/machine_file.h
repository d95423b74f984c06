// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

/// A machine file: the settings of a machine as TOML, each with its place.
namespace dgt {

/// Bytes `begin` to `end` of the file's text.
struct TextSpan {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

struct MachineEntry {
  enum class Kind : std::uint8_t {
    Number,
    Text,
    List,  ///< of texts
    Other  ///< what no setting takes: true, dates, empty tables, other lists
  };
  std::string key;  ///< of a table's entry with the table before it: `essi.rotation`
  Kind kind = Kind::Other;
  /// One; of a list any number. A number is the decimal that the file spells, digit for digit: no
  /// double lies between, so 0.05 is 1/20. Exponents and `_` are resolved, hexadecimals converted.
  /// Of Other the text as it stands.
  std::vector<std::string> values;
  TextSpan key_span;
  TextSpan value_span;
};

/// The text is no TOML.
struct MachineSyntaxFault {
  enum class Kind : std::uint8_t {
    Unreadable,  ///< from `span` on; never empty unless the text is
    KeyTwice     ///< `span` is the second one
  };
  Kind kind;
  TextSpan span;
};

/// The entries in the order of the text. `text` is UTF-8 without a byte order mark, of less than
/// 4 GiB. Reading stops at the first fault of syntax; what the entries mean is not judged here.
[[nodiscard]] tl::expected<std::vector<MachineEntry>, MachineSyntaxFault> read_machine_text(
    std::string_view text);

}  // namespace dgt
