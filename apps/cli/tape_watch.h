// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <string>

#include "apps/cli/console.h"
#include "device/run.h"

namespace dgt::cli {

/// While it lives, Ctrl-C and a request to end stop the devices instead of the program.
class Interrupts {
 public:
  Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;
  ~Interrupts();

  [[nodiscard]] static bool arrived();

 private:
  struct sigaction interrupt_ {};
  struct sigaction terminate_ {};
};

/// One line that says how far it is, where standard error is a terminal and shows messages.
class Progress {
 public:
  /// `total` rows; 0 when nobody knows.
  Progress(std::string what, std::size_t total, const Console& console);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();  ///< takes the line away

  /// For punch_tape() and read_tape(): shows progress, stops at an interrupt.
  [[nodiscard]] Watch watch();

 private:
  void show(std::size_t rows);

  std::string what_;
  std::size_t total_;
  bool shown_;
  bool has_line_ = false;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace dgt::cli
