// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "apps/cli/console.h"
#include "kernel/progress.h"

namespace dgt::cli {

/// One line that says what is being done and how far it is, where standard error is a terminal and
/// shows messages: a million blocks take seconds. Gone when the stage is.
class Stage {
 public:
  /// Of a file; nothing is said of standard input, into which somebody may type.
  Stage(const Console& console, Text what, const std::string& file);
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  ~Stage();

  /// Shows the percentage; empty where nothing is shown. Not to be called when the stage is gone.
  [[nodiscard]] OnProgress on_progress();

 private:
  void show(std::size_t percent);

  bool shown_;
  std::string line_;
  std::size_t percent_ = 0;  ///< shown; 0: none
  std::chrono::steady_clock::time_point last_;
};

}  // namespace dgt::cli
