// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/line_marks.h"

namespace dgt {

namespace {
constexpr std::uint8_t kMark = 0xFF;
}  // namespace

void LineMarks::read(std::span<const std::uint8_t> bytes, Reading& reading) {
  for (const std::uint8_t byte : bytes) {
    switch (state_) {
      case State::Plain:
        if (byte == kMark) {
          state_ = State::Mark;
        } else {
          reading.rows.push_back(byte);
        }
        break;
      case State::Mark:
        state_ = byte == 0 ? State::Bad : State::Plain;
        if (byte != 0) reading.rows.push_back(byte);
        break;
      case State::Bad:
        // A break carries no row; a badly framed byte may be right or wrong.
        reading.noise.push_back(reading.rows.size());
        if (byte != 0) reading.rows.push_back(byte);
        state_ = State::Plain;
        break;
    }
  }
}

}  // namespace dgt
