// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/tape_watch.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

#include "device/tape.h"

namespace dgt::cli {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void note_interrupt(int) { interrupted = 1; }

constexpr std::chrono::milliseconds kBetween{100};  // what an eye can follow
constexpr const char* kClearLine = "\r\x1b[K";

}  // namespace

Interrupts::Interrupts() {
  interrupted = 0;
  struct sigaction noting {};
  noting.sa_handler = note_interrupt;
  sigemptyset(&noting.sa_mask);  // and no SA_RESTART: what waits comes back
  ::sigaction(SIGINT, &noting, &interrupt_);
  ::sigaction(SIGTERM, &noting, &terminate_);
}

Interrupts::~Interrupts() {
  ::sigaction(SIGINT, &interrupt_, nullptr);
  ::sigaction(SIGTERM, &terminate_, nullptr);
}

bool Interrupts::arrived() { return interrupted != 0; }

Progress::Progress(std::string what, std::size_t total, const Console& console)
    : what_(std::move(what)),
      total_(total),
      shown_(!console.is_quiet() && ::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (has_line_) std::fputs(kClearLine, stderr);
}

Watch Progress::watch() {
  return {[this](std::size_t rows) { show(rows); }, [] { return Interrupts::arrived(); }};
}

void Progress::show(std::size_t rows) {
  const auto now = std::chrono::steady_clock::now();
  if (!shown_ || (has_line_ && now - last_ < kBetween)) return;
  last_ = now;
  has_line_ = true;
  const std::string percent =
      total_ == 0 ? "" : fmt::format(" / {} ({} %)", total_, rows * 100 / total_);
  const std::string line =
      fmt::format("{}{}: {}{}, {} mm", kClearLine, what_, rows, percent, millimetres_to(rows));
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace dgt::cli
