// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace dgt {

/// A file, stream or folder that failed, with what the system says.
struct FileError {
  std::string name;
  int error = 0;  ///< errno

  [[nodiscard]] std::string text() const;  ///< `part.bgt: No such file or directory`
};
template <typename T>
using FileResult = tl::expected<T, FileError>;

/// Stands for standard input or output where a file name is asked for.
inline constexpr std::string_view kStream = "-";

/// The whole content of a file, or of standard input for `-`. Names are UTF-8.
[[nodiscard]] FileResult<std::string> read_file(const std::string& name);

/// Writes a file whole or not at all: to a new file beside it, synced, then renamed over it, so
/// that neither a full disk nor a power cut leaves half a program under the name. What the name
/// links to is written, the permissions of an existing file stay, a read-only one is refused.
/// Devices and pipes, and standard output for `-`, are written straight through.
[[nodiscard]] FileResult<void> write_file(const std::string& name, std::string_view bytes);

}  // namespace dgt
