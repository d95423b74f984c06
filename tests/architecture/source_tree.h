// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace dgt::architecture {

/// One text file of the repository.
struct SourceFile {
  std::string path;  ///< relative to the root, with `/`
  std::vector<std::string> lines;

  /// The top-level folder the file lives in, "" for a top-level file.
  [[nodiscard]] std::string_view room() const;
  [[nodiscard]] bool is_header() const;
  /// C++: a header, a source or a table meant for inclusion (*.def).
  [[nodiscard]] bool is_cpp() const;
  /// "path:line: ", with the first line (index 0) called 1.
  [[nodiscard]] std::string place(std::size_t index) const;
};

/// A file from its path and text; a stand-in for a file on disk in the tests of the rules.
[[nodiscard]] SourceFile source_file(std::string path, std::string_view text);

/// Every text file below `root`, by path; build trees (build/), version control and files with a
/// zero byte (images, tapes) are left out.
[[nodiscard]] std::vector<SourceFile> read_source_tree(const std::filesystem::path& root);

}  // namespace dgt::architecture
