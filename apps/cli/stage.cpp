// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/stage.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "apps/driver/file_io.h"

namespace dgt::cli {
namespace {

constexpr const char* kClearLine = "\r\x1b[K";
/// Nobody reads faster.
constexpr auto kBetween = std::chrono::milliseconds(100);

void print(const std::string& line) {
  std::fputs((kClearLine + line).c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace

Stage::Stage(const Console& console, Text what, const std::string& file)
    : shown_(!console.is_quiet() && file != kStream && ::isatty(STDERR_FILENO) == 1) {
  if (!shown_) return;
  line_ = console.sentence(what, {std::filesystem::path(file).filename().string()});
  print(line_);
}

Stage::~Stage() {
  if (shown_) std::fputs(kClearLine, stderr);
}

OnProgress Stage::on_progress() {
  if (!shown_) return {};
  return [this](std::size_t done, std::size_t all) {
    const std::size_t percent = all == 0 ? 0 : done * 100 / all;
    if (percent != percent_) show(percent);
  };
}

void Stage::show(std::size_t percent) {
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < kBetween) return;
  last_ = now;
  percent_ = percent;
  print(fmt::format("{} {} %", line_, percent));
}

}  // namespace dgt::cli
