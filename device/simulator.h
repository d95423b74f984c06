// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "device/device_fault.h"
#include "device/iso7.h"

/// A punch and a reader that are not there, each on a pseudo-terminal, with XON/XOFF.
namespace dgt {

/// A fault at a row, counted from 0; it happens on the first tape (of the punch) or the first
/// reading, not again.
struct SimulatedFault {
  enum class Kind : std::uint8_t {
    Flip,     ///< one hole of the row too many or too few, in `track`
    Drop,     ///< the row is lost
    Double,   ///< the row comes twice
    Break,    ///< the tape tears: the reader sees light in all tracks, the punch stops the computer
    Slow,     ///< from this row on at kSlowedDown of the speed
    Hang,     ///< from this row on nothing moves
    PowerCut  ///< the line is dead
  };
  Kind kind = Kind::Flip;
  std::size_t row = 0;
  unsigned track = 1;  ///< 1 to 8
};
inline constexpr double kSlowedDown = 1.0 / 20;

/// `flip@120`, `flip@120:3`, `drop@7`, `double@7`, `break@…`, `slow@…`, `hang@…`, `power@…`; rows
/// count from 1 here, as everywhere where a person reads them.
[[nodiscard]] std::optional<SimulatedFault> parse_simulated_fault(std::string_view text);

struct SimulatorSettings {
  std::vector<Row> tape;              ///< lies in the reader
  std::uint32_t reader_speed = 1500;  ///< rows a second
  std::uint32_t punch_speed = 150;
  std::vector<SimulatedFault> reader_faults;
  std::vector<SimulatedFault> punch_faults;
  bool loop = false;  ///< what has been punched lies in the reader next
  /// Gets each punched tape when the computer has closed the line.
  std::function<void(const std::vector<Row>&)> on_punched = [](const std::vector<Row>&) {};
};

class Simulator {
 public:
  [[nodiscard]] static DeviceResult<std::unique_ptr<Simulator>> open(SimulatorSettings settings);
  virtual ~Simulator() = default;

  /// The names under which they are opened.
  [[nodiscard]] virtual const std::string& punch_name() const = 0;
  [[nodiscard]] virtual const std::string& reader_name() const = 0;
  /// Works until `stopped` says so; asked a hundred times a second at least.
  virtual void run(const std::function<bool()>& stopped) = 0;

 protected:
  Simulator() = default;
};

}  // namespace dgt
