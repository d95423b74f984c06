// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/cli/tape_faults.h"

namespace dgt::cli {

ExitCode report(const DeviceFault& fault, const DeviceLimits& limits, const Console& console) {
  console.error(Text::FileFailed, {sentence_of(fault, limits, console.language())});
  return ExitCode::Failure;
}

}  // namespace dgt::cli
