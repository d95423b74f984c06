// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "device/device_fault.h"
#include "device/iso7.h"
#include "device/settings.h"

/// A punch and a reader, whatever stands behind them. No call lasts much longer than its `wait`.
/// SIGPIPE must be ignored by the program.
namespace dgt {

using Wait = std::chrono::milliseconds;

class Punch {
 public:
  virtual ~Punch() = default;
  /// Hands over as many of the rows as are taken within `wait`, maybe none.
  [[nodiscard]] virtual DeviceResult<std::size_t> put(std::span<const Row> rows, Wait wait) = 0;
  /// Whether everything handed over has left the computer; waits for it.
  [[nodiscard]] virtual DeviceResult<bool> finish(Wait wait) = 0;
  /// Whether it works at a speed of its own, so that rows are handed over at that speed.
  [[nodiscard]] virtual bool has_pace() const = 0;
};

/// Rows as they came.
struct Reading {
  std::vector<Row> rows;
  std::vector<std::size_t> noise;  ///< so many of `rows` had come when the line failed
  bool ended = false;              ///< there will be no more
};

class Reader {
 public:
  virtual ~Reader() = default;
  /// Sets the tape in motion.
  [[nodiscard]] virtual DeviceResult<void> start() = 0;
  /// What comes within `wait`: at least one row, or nothing.
  [[nodiscard]] virtual DeviceResult<Reading> take(Wait wait) = 0;
  virtual void stop() = 0;
  /// Whether it works at a speed of its own, so that it can be too slow.
  [[nodiscard]] virtual bool has_pace() const = 0;
};

/// By what stands under the name: a terminal is a serial line, other character devices and named
/// pipes are taken as they are (parallel ports), and everything else is a file. A file to punch to
/// is written whole when it is finished, or not at all.
[[nodiscard]] DeviceResult<std::unique_ptr<Punch>> open_punch(const PunchSettings& settings);
[[nodiscard]] DeviceResult<std::unique_ptr<Reader>> open_reader(const ReaderSettings& settings);

}  // namespace dgt
