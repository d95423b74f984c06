// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <tl/expected.hpp>

#include "device/tape.h"

namespace dgt {

enum class JoinFault : std::uint8_t {
  NoOverlap,  ///< what was read again does not hold the end of what was kept
  Ambiguous   ///< it fits in several places; more has to be read again
};

/// So many rows at the end of what was kept must be read again, of them so many punched.
inline constexpr std::size_t kLeastOverlap = 20;

/// Goes on where a reading stopped. `again` is a reading of the same tape that began anywhere
/// before the last gap of `kept`: the rows of `kept` up to that gap, then what `again` holds behind
/// them. Damaged rows agree with nothing.
///  (1) Of a tape read in two parts in this way the result is the tape.
///  (2) Nothing is joined where the overlap fits in more than one way.
[[nodiscard]] tl::expected<Tape, JoinFault> join_readings(const Tape& kept, const Tape& again);

}  // namespace dgt
