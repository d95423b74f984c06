// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "device/descriptor.h"
#include "device/devices.h"

struct termios;

namespace dgt {

enum class PortUse : std::uint8_t { Punch, Reader };

/// A character device of the system that never keeps anybody waiting. Serial lines are set up while
/// it is open and get their settings back.
class Port {
 public:
  [[nodiscard]] static DeviceResult<Port> open(const std::string& name, PortUse use,
                                               const LineSettings& line);
  Port(Port&& other) noexcept;
  Port& operator=(Port&&) = delete;
  ~Port();

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool is_line() const { return before_ != nullptr; }

  /// How many bytes were taken within `wait`.
  [[nodiscard]] DeviceResult<std::size_t> write(std::span<const std::uint8_t> bytes, Wait wait);
  /// How many came within `wait`; `ended` when there will be no more.
  struct Got {
    std::size_t count = 0;
    bool ended = false;
  };
  [[nodiscard]] DeviceResult<Got> read(std::span<std::uint8_t> into, Wait wait);
  /// Whether all that was written has left the computer; waits for it.
  [[nodiscard]] DeviceResult<bool> is_drained(Wait wait);
  /// From now on closing need not throw away what was written.
  void keep_output() { keeps_output_ = true; }
  /// Raises or drops RTS; without effect where there is none.
  void set_rts(bool raised);

 private:
  Port(std::string name, Descriptor descriptor);
  [[nodiscard]] bool set_up(PortUse use, const LineSettings& line);
  /// Whether the device is ready for `events` (of poll()) within `wait`.
  [[nodiscard]] DeviceResult<bool> is_ready(short events, Wait wait);
  [[nodiscard]] tl::unexpected<DeviceFault> failed(int error) const;

  std::string name_;
  Descriptor descriptor_;
  std::unique_ptr<termios> before_;  // of a serial line
  bool keeps_output_ = false;
};

}  // namespace dgt
