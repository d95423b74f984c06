// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/tape.h"

namespace dgt {

std::string millimetres_to(std::size_t index) {
  const std::uint64_t hundredths = index * kRowPitch;
  const std::uint64_t rest = hundredths % 100;
  return std::to_string(hundredths / 100) + (rest < 10 ? ".0" : ".") + std::to_string(rest);
}

}  // namespace dgt
