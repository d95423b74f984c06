// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <random>
#include <string>

namespace dgt::support {

/// How a comment is written.
enum class Writing : std::uint8_t { Sentence, Small, Capitals };

/// Russian comments as programmers in a shop type them, put together at random from phrases that
/// are not those of shop_notes.txt.
class CommentSamples {
 public:
  explicit CommentSamples(std::uint32_t seed) : random_(seed) {}

  /// A comment in UTF-8 of at least `letters` Russian letters.
  [[nodiscard]] std::string next(std::size_t letters, Writing writing);
  /// A program of a few lines, some of which carry such comments.
  [[nodiscard]] std::string program(std::size_t letters);
  [[nodiscard]] std::uint32_t below(std::uint32_t bound);

 private:
  std::mt19937 random_;
};

}  // namespace dgt::support
