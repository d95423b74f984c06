// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dgt::support {

/// What a finished command left behind.
struct Outcome {
  int exit_code = -1;  ///< 128 + signal when killed by one
  std::string out;
  std::string err;
  long peak_kib = 0;  ///< memory at its peak; what the calling process held at the least
};

struct CommandOptions {
  std::string input = {};                     ///< standard input
  std::vector<std::string> environment = {};  ///< `NAME=value`, besides PATH and LC_ALL=C.UTF-8
  std::filesystem::path folder = ".";         ///< where it runs
  std::string output_to = {};                 ///< standard output goes to this file instead
  bool on_terminal = false;                   ///< standard error is a terminal
};

/// Runs the `dgt` that was just built with these arguments.
[[nodiscard]] Outcome run_dgt(const std::vector<std::string>& arguments,
                              const CommandOptions& options = {});

/// An empty folder that is gone at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// The full name of a file in it.
  [[nodiscard]] std::string name(const std::string& file) const { return path_ / file; }
  /// Writes a file into it and returns its full name.
  std::string write(const std::string& file, const std::string& text) const;
  /// The names in it, hidden ones too, in order.
  [[nodiscard]] std::vector<std::string> entries() const;

 private:
  std::filesystem::path path_;
};

[[nodiscard]] std::string read_text(const std::filesystem::path& file);
/// The full name of a program of the corpus.
[[nodiscard]] std::string corpus(const std::string& file);

}  // namespace dgt::support
