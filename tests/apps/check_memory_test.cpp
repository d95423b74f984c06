// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program is executed as it is read, so checking it takes little more than its text.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "tests/support/command.h"

#if defined(__SANITIZE_ADDRESS__)
#define DGT_MEMORY_IS_INFLATED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define DGT_MEMORY_IS_INFLATED 1
#endif
#endif

namespace dgt {
namespace {

#ifndef DGT_MEMORY_IS_INFLATED
constexpr std::size_t kBytes = 2'000'000;
constexpr long kTimesTheSource = 10;

/// Peak of `dgt check` on a source made of `piece(0)`, `piece(1)`, …, in KiB, over that on an empty
/// one.
long peak_over_empty(const std::function<std::string(int)>& piece) {
  const support::TemporaryFolder folder;
  const std::string empty = folder.write("empty.bgt", "");
  std::string text;
  for (int i = 0; text.size() < kBytes; ++i) text += piece(i);
  const std::string large = folder.write("large.bgt", text);
  text = {};
  const long base = support::run_dgt({"check", empty}).peak_kib;
  const support::Outcome outcome = support::run_dgt({"check", large});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err.substr(0, 1000);
  return outcome.peak_kib - base;
}
#endif

void expect_small(const std::function<std::string(int)>& piece) {
#ifdef DGT_MEMORY_IS_INFLATED
  (void)piece;
  GTEST_SKIP() << "the sanitizer takes memory of its own";
#else
  EXPECT_LT(peak_over_empty(piece), kTimesTheSource * static_cast<long>(kBytes) / 1024);
#endif
}

TEST(CheckMemory, OfDefinitions) {
  expect_small([](int i) {
    return fmt::format("P{}=X{}.{:03} Y{}.125\n", i % 9999, i % 997, i % 1000, i % 811);
  });
}

TEST(CheckMemory, OfContours) {
  expect_small([](int i) {
    const int n = i * 4 % 9996;
    const int x = i % 100 * 30;
    return fmt::format(
        "L{0}=Y0.125\nL{1}=X{4} Y0 X{4} Y1\nL{2}=Y20.5\nL{3}=X{5} Y0 X{5} Y1\nG54 X{6} Y5\n"
        "K1 W0.15 L-{3} L{0} R2.5 L{1} L-{2} R2.5 L-{3} L{0}\n",
        n, n + 1, n + 2, n + 3, x + 20, x, x + 5);
  });
}

TEST(CheckMemory, OfVariablesAndLoops) {
  expect_small([](int i) {
    return fmt::format("FOR 2\nN{0}=N{1}*0.5+{2}.125\nK1 XN{0} Y{2} X0 YN{1},\nNEXT\n", i % 30 + 1,
                       i % 29 + 1, i % 997);
  });
}

}  // namespace
}  // namespace dgt
