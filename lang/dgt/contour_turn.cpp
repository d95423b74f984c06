// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/contour_turn.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "lang/dgt/contour_writer.h"

namespace dgt::language {
namespace {

using Fault = ContourFault::Kind;
using Notice = ContourNotice::Kind;

constexpr std::size_t kMaxTried = 4;

bool is_gouge(const ContourFault& fault) { return fault.kind == Fault::Gouge; }
bool is_against(const ContourNotice& notice) { return notice.kind == Notice::AgainstDirection; }

// Lines cut against their direction first, then what takes part in most gouges; each by the first
// item of its word.
std::vector<std::size_t> suspects(const OpenContour& contour, const BuiltContour& built) {
  std::vector<std::size_t> items;
  for (const ContourNotice& notice : built.notices) {
    if (is_against(notice)) items.push_back(contour.first_of_word(notice.item));
  }
  std::map<std::size_t, int> gouges;
  for (const ContourFault& fault : built.faults) {
    ++gouges[contour.first_of_word(fault.item)];
    ++gouges[contour.first_of_word(fault.other)];
  }
  std::vector<std::pair<std::size_t, int>> by_count(gouges.begin(), gouges.end());
  std::ranges::stable_sort(by_count, std::greater{}, [](const auto& g) { return g.second; });
  for (const auto& [item, count] : by_count) items.push_back(item);
  std::vector<std::size_t> distinct;
  for (const std::size_t item : items) {
    const bool is_new = std::ranges::find(distinct, item) == distinct.end();
    if (is_new && distinct.size() < kMaxTried) distinct.push_back(item);
  }
  return distinct;
}

std::vector<ContourItem> turned_at(const OpenContour& contour, std::size_t item) {
  std::vector<ContourItem> items = contour.items;
  for (std::size_t i = item; i < items.size(); ++i) {
    if (contour.origins[i].range != contour.origins[item].range) continue;
    if (auto* const along = std::get_if<AlongItem>(&items[i].what)) {
      along->element = ElementPtr(reversed(*along->element));
    }
  }
  return items;
}

}  // namespace

std::optional<Turn> find_turn(const OpenContour& contour, const BuiltContour& built,
                              const ToolState& before, const ContourOptions& options) {
  if (built.faults.empty() || !std::ranges::all_of(built.faults, is_gouge)) return std::nullopt;
  const auto against = std::ranges::count_if(built.notices, is_against);
  for (const std::size_t item : suspects(contour, built)) {
    if (!std::holds_alternative<AlongItem>(contour.items[item].what)) continue;
    ToolState state = before;
    Turn turn{item, build_contour(turned_at(contour, item), state, options)};
    if (!turn.built.faults.empty()) continue;
    if (std::ranges::count_if(turn.built.notices, is_against) <= against) return turn;
  }
  return std::nullopt;
}

}  // namespace dgt::language
