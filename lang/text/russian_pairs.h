// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace dgt {

/// A letter of the Russian alphabet without regard to case, ё being е, numbered from а; or what
/// stands around words.
inline constexpr std::uint32_t kRussianLetters = 32;
inline constexpr std::uint32_t kWordBoundary = kRussianLetters;

/// A Russian letter by its number and case.
struct RussianLetter {
  std::uint32_t number = 0;
  bool capital = false;
};
[[nodiscard]] std::optional<RussianLetter> russian_letter(char32_t value);

/// How surprising `next` is behind `letter` in a Russian text about this trade, in bits: the
/// rounded −log2 of its probability, at most kMostSurprising. Both are numbers of letters or
/// kWordBoundary.
inline constexpr std::uint32_t kMostSurprising = 15;
[[nodiscard]] std::uint32_t surprise(std::uint32_t letter, std::uint32_t next);

}  // namespace dgt
