// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "apps/cli/console.h"

namespace dgt::cli {

/// One line that says what is being done, where standard error is a terminal and shows messages:
/// a million blocks take seconds. Gone when the stage is.
class Stage {
 public:
  /// Of a file; nothing is said of standard input, into which somebody may type.
  Stage(const Console& console, Text what, const std::string& file);
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  ~Stage();

 private:
  bool shown_;
};

}  // namespace dgt::cli
