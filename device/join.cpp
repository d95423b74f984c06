// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/join.h"

#include <algorithm>
#include <optional>

namespace dgt {
namespace {

/// How many rows of `again` come before the end of `kept`, by where its last rows are found.
/// Blank rows at the very end of `kept` fit anywhere in blank tape: what is searched for ends with
/// the last row that is punched, and begins far enough before.
struct Overlap {
  std::span<const Row> rows;
  std::size_t behind = 0;  // rows of `kept` behind it
};

std::optional<Overlap> last_punched(std::span<const Row> kept) {
  std::size_t end = kept.size();
  while (end > 0 && kept[end - 1] == kBlankRow) --end;
  if (end < kLeastOverlap) return std::nullopt;
  return Overlap{kept.subspan(end - kLeastOverlap, kLeastOverlap), kept.size() - end};
}

/// What lies before the place found must agree with `kept` too, as far as both go.
bool agrees(std::span<const Row> kept, std::span<const Row> again) {
  const std::size_t common = std::min(kept.size(), again.size());
  return std::ranges::equal(kept.last(common), again.last(common), [](Row a, Row b) {
    return a == b || !has_even_parity(a) || !has_even_parity(b);
  });
}

}  // namespace

tl::expected<Tape, JoinFault> join_readings(const Tape& kept, const Tape& again) {
  const std::size_t end = kept.gaps.empty() ? kept.rows.size() : kept.gaps.back().row;
  const auto before = std::span<const Row>(kept.rows).first(end);
  const auto overlap = last_punched(before);
  if (!overlap) return tl::unexpected(JoinFault::NoOverlap);
  std::optional<std::size_t> rest;
  for (auto from = again.rows.begin();; ++from) {
    from = std::search(from, again.rows.end(), overlap->rows.begin(), overlap->rows.end());
    if (from == again.rows.end()) break;
    const auto behind = static_cast<std::size_t>(from - again.rows.begin()) + kLeastOverlap;
    const std::span<const Row> seen(again.rows.data(), behind);
    if (!agrees(before.first(end - overlap->behind), seen)) continue;
    if (rest) return tl::unexpected(JoinFault::Ambiguous);
    rest = behind;
  }
  if (!rest) return tl::unexpected(JoinFault::NoOverlap);
  Tape joined{{before.begin(), before.end() - static_cast<std::ptrdiff_t>(overlap->behind)}, {}};
  for (const Gap& gap : kept.gaps) {
    if (gap.row < end) joined.gaps.push_back(gap);
  }
  for (const Gap& gap : again.gaps) {
    if (gap.row > *rest) joined.gaps.push_back({gap.row - *rest + joined.rows.size(), gap.reason});
  }
  joined.rows.insert(joined.rows.end(), again.rows.begin() + static_cast<std::ptrdiff_t>(*rest),
                     again.rows.end());
  return joined;
}

}  // namespace dgt
