// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "apps/driver/pipeline.h"

namespace dgt {

/// A fix-it that was put in place.
struct Repair {
  Message message;
  Place place;  ///< in the text as it stood then
  std::string before;
  std::string after;
};

/// A program after its fix-its.
struct Fixing {
  std::vector<Repair> repairs;  ///< in the order made
  std::string bytes;            ///< the file as it should be; as it is, without repairs
  Compilation made;             ///< of these bytes
};

/// Fix-its bring others to light; so many times a program is read again.
inline constexpr int kMaxFixRounds = 100;

/// Puts the sure fix-its of a program in place and reads it again until nothing changes. Encoding
/// and marks of the file stay, line ends become its commonest. A file with bytes that are no text
/// is left as it is. Nothing is written.
[[nodiscard]] FileResult<Fixing> fix_file(const std::string& name, const SourceSettings& settings);

}  // namespace dgt
