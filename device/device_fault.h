// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <tl/expected.hpp>

namespace dgt {

/// A device that failed, as far as the computer can tell.
struct DeviceFault {
  enum class Kind : std::uint8_t {
    CannotOpen,   ///< `error` says why
    CannotSetUp,  ///< opened, but the line does not take its speed or handshake
    Failed,       ///< the system reports `error`
    Gone,         ///< the line is dead: power cut, cable out
    Stalled,      ///< the punch takes no rows
    NoRows,       ///< the reader has not sent one row
    Silent,       ///< the reader stopped where no tape ends
    Slow,         ///< `rate` rows a second, a small part of what is set
    Torn,         ///< the reader sees light in all tracks, without end
    TooLong,      ///< more rows than any reel holds
    Cancelled     ///< by the person
  };
  Kind kind = Kind::Failed;
  std::string device;
  int error = 0;        ///< errno, where the system says something
  std::size_t row = 0;  ///< so many rows were done
  double rate = 0;      ///< rows a second
};
template <typename T>
using DeviceResult = tl::expected<T, DeviceFault>;

}  // namespace dgt
