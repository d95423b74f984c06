// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "device/devices.h"

namespace dgt {

/// Undoes what a terminal makes of a serial line's bytes with PARMRK (POSIX termios): the byte 0xFF
/// comes twice, a break as 0xFF 0 0, a byte x that came badly framed as 0xFF 0 x. Marks may be
/// divided between calls.
class LineMarks {
 public:
  void read(std::span<const std::uint8_t> bytes, Reading& reading);

 private:
  enum class State : std::uint8_t { Plain, Mark, Bad };
  State state_ = State::Plain;
};

}  // namespace dgt
