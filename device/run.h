// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "device/devices.h"
#include "device/tape.h"

/// Punching and reading whole tapes, at the device's pace and never without end.
namespace dgt {

/// What a person sees of it and may do about it; asked several times a second.
struct Watch {
  std::function<void(std::size_t rows)> progress = [](std::size_t) {};
  std::function<bool()> cancelled = [] { return false; };
};

/// A tape that was not punched to its end.
struct PunchFailure {
  DeviceFault fault;
  std::size_t punched = 0;  ///< rows that are surely on the tape; some more may be
};

/// Hands over the rows in portions of a fiftieth of a second, never further ahead of the punch.
///  (1) It ends at the latest one timeout after the last row was taken.
///  (2) Of a punch that takes less than a fifth of its speed for kSlowWindows windows
///      (of kWindowRows rows and kWindowSeconds, whichever takes longer), it says so.
[[nodiscard]] tl::expected<void, PunchFailure> punch_tape(Punch& punch, std::span<const Row> rows,
                                                          const PunchSettings& settings,
                                                          const Watch& watch = {});

/// What was read; with a fault it is what came before.
struct TapeReading {
  Tape tape;
  std::optional<DeviceFault> fault;
};

/// Reads until the reader falls silent behind blank tape, or the end of a file.
///  (1) It ends at the latest one timeout after the last row, or after kMostRows.
///  (2) Silence without the end of a tape before it is a fault: less than kEndRows blank rows, or
///      less than the trailer has.
///  (3) Bad framing and breaks of the line are gaps.
[[nodiscard]] TapeReading read_tape(Reader& reader, const ReaderSettings& settings,
                                    const TapeFormat& format, const Watch& watch = {});

inline constexpr std::size_t kWindowRows = 50;
inline constexpr double kWindowSeconds = 0.25;
inline constexpr int kSlowWindows = 3;
inline constexpr double kSlowShare = 0.2;  ///< of the speed that is set
inline constexpr std::size_t kEndRows = 10;
inline constexpr std::size_t kTornRows = 1000;  ///< rub-outs in a row, 2.5 m: no tape has so many
inline constexpr std::size_t kMostRows = 1'000'000;  ///< 2.5 km; a reel holds 300 m

}  // namespace dgt
