// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/stage.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "apps/driver/file_io.h"

namespace dgt::cli {
namespace {

constexpr const char* kClearLine = "\r\x1b[K";

}  // namespace

Stage::Stage(const Console& console, Text what, const std::string& file)
    : shown_(!console.is_quiet() && file != kStream && ::isatty(STDERR_FILENO) == 1) {
  if (!shown_) return;
  const std::string name = std::filesystem::path(file).filename();
  std::fputs((kClearLine + console.sentence(what, {name})).c_str(), stderr);
  std::fflush(stderr);
}

Stage::~Stage() {
  if (shown_) std::fputs(kClearLine, stderr);
}

}  // namespace dgt::cli
