// SPDX-License-Identifier: GPL-3.0-or-later
// The production engine against the reference on thousands of contours. DGT_DIFFERENTIAL=n tries n
// of each family.
#include "kernel/offset.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "kernel/loop_fault.h"
#include "tests/differential/contours.h"

namespace dgt::differential {
namespace {

/// Vertices and radii; loops begin at their lowest vertex and follow each other by these.
struct Corner {
  double y, x, radius;

  auto operator<=>(const Corner&) const = default;
};
using Corners = std::vector<Corner>;

std::vector<Corners> corners(const std::vector<OffsetLoop>& loops) {
  std::vector<Corners> result;
  for (const OffsetLoop& loop : loops) {
    Corners& corners = result.emplace_back();
    for (const OffsetPiece& p : loop.pieces)
      corners.push_back({p.from.y(), p.from.x(), p.is_line ? 0 : nearest_double(p.radius)});
    std::ranges::rotate(corners, std::ranges::min_element(corners));
  }
  std::ranges::sort(result);
  return result;
}

std::string to_text(const std::vector<Corners>& loops) {
  std::string text;
  for (const Corners& loop : loops) {
    for (const Corner& c : loop) text += fmt::format("  {} {} r {}\n", c.x, c.y, c.radius);
    text += "\n";
  }
  return text;
}

bool near(const Corner& a, const Corner& b) {
  return std::hypot(a.x - b.x, a.y - b.y) <= kOffsetResolution &&
         std::fabs(a.radius - b.radius) <= kOffsetResolution;
}

/// Nothing, or how the engines differ.
std::optional<std::string> difference(const Case& c, const OffsetOptions& options,
                                      bool& by_reference) {
  OffsetCounts counts;
  const auto fast = corners(production_offset(c.chains(), c.distance, options, &counts));
  const auto slow = corners(reference_offset(c.chains(), c.distance, options));
  by_reference = counts.exact > 0;
  EXPECT_EQ(counts.torn, 0) << c.to_text();
  const bool same = std::ranges::equal(fast, slow, [](const Corners& a, const Corners& b) {
    return std::ranges::equal(a, b, near);
  });
  if (same) return std::nullopt;
  return fmt::format("{}production\n{}reference\n{}", c.to_text(), to_text(fast), to_text(slow));
}

std::uint32_t tries() {
  if (const char* asked = std::getenv("DGT_DIFFERENTIAL"))
    return static_cast<std::uint32_t>(std::atoi(asked));
#if defined(__SANITIZE_ADDRESS__) || defined(DGT_SANITIZED)
  return 100;
#else
  return 1500;
#endif
}

class Differential : public testing::TestWithParam<Family> {};

TEST_P(Differential, EnginesGiveTheSameLoops) {
  const std::uint32_t count = tries();
  std::uint32_t slow = 0;
  std::uint32_t wrong = 0;
  for (std::uint32_t seed = 1; seed <= count; ++seed) {
    bool by_reference = false;
    OffsetOptions options;
    options.corner = static_cast<OffsetCorner>(seed % 5 < 3 ? 0 : seed % 5 - 2);
    const auto differs = difference(make(GetParam(), seed), options, by_reference);
    slow += by_reference ? 1 : 0;
    if (!differs) continue;
    if (++wrong <= 3) ADD_FAILURE() << "seed " << seed << "\n" << *differs;
  }
  EXPECT_EQ(wrong, 0U) << "of " << count;
  RecordProperty("by_reference", static_cast<int>(slow));
  std::printf("%u of %u by the reference\n", slow, count);
}

TEST_P(Differential, TheContoursBoundARegionAndOneOfThemReversedBoundsNone) {
  for (std::uint32_t seed = 1; seed <= tries() / 5; ++seed) {
    std::vector<Chain> loops = make(GetParam(), seed).chains();
    EXPECT_FALSE(find_loop_fault(loops)) << "seed " << seed;
    std::vector<Chain> backwards;
    for (const Chain& loop : loops) backwards.push_back(reversed(loop));
    EXPECT_FALSE(find_loop_fault(backwards)) << "seed " << seed;
    if (loops.size() < 2) continue;
    const std::size_t one = seed % loops.size();
    loops[one] = backwards[one];
    EXPECT_TRUE(find_loop_fault(loops)) << "seed " << seed;
  }
}

std::string name_of(const testing::TestParamInfo<Family>& family) {
  switch (family.param) {
    case Family::Star:
      return "Star";
    case Family::Grid:
      return "Grid";
    case Family::Rounded:
      return "Rounded";
    case Family::Slots:
      return "Slots";
    case Family::Islands:
      return "Islands";
    case Family::Minute:
      return "Minute";
    case Family::Offset:
      return "Offset";
    case Family::Touching:
      return "Touching";
  }
  return {};
}

INSTANTIATE_TEST_SUITE_P(Families, Differential,
                         testing::Values(Family::Star, Family::Grid, Family::Rounded, Family::Slots,
                                         Family::Islands, Family::Minute, Family::Offset,
                                         Family::Touching),
                         name_of);

}  // namespace
}  // namespace dgt::differential
