// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "post/dgt.h"
#include "post/dgt_elements.h"

namespace dgt {

/// The items of a contour that runs along `moves`, which follow each other; `closed`: it ends where
/// it begins and may be met there. What has to be defined goes to `names`. Nothing when the style
/// has no words for it: dwells, codes and rapids want Points.
[[nodiscard]] std::optional<std::vector<std::string>> dgt_items(std::span<const Move> moves,
                                                                bool closed, DgtStyle style,
                                                                DgtNames& names);

/// The same along elements, in the style Offset or FromMeeting, with the straight leads at both
/// ends as approach and departure.
[[nodiscard]] std::optional<std::vector<std::string>> dgt_items_with_leads(
    std::span<const Move> moves, bool closed, DgtStyle style, DgtNames& names);

}  // namespace dgt
