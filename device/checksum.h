// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "device/iso7.h"

namespace dgt {

/// What the checksum line of a tape says: over the rows that mean something, in their order.
struct TapeSum {
  std::uint32_t crc = 0;    ///< CRC-32 of IEEE 802.3, of the rows with their track 8
  std::uint64_t count = 0;  ///< so many rows

  friend bool operator==(const TapeSum&, const TapeSum&) = default;
};

/// Of all rows but blank ones and rub-outs.
///  (1) Two flipped holes anywhere change it, and so do rows lost, doubled or exchanged, but for
///      one case in 2³².
[[nodiscard]] TapeSum sum_of(std::span<const Row> rows);

/// `CRC32 9A8B7C6D 1234`, and back. Nothing when the text is no such line.
[[nodiscard]] std::string to_line(const TapeSum& sum);
[[nodiscard]] std::optional<TapeSum> sum_in_line(std::string_view line);

}  // namespace dgt
