// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace dgt::studio {

/// The numbers that a program has given to elements, contours and variables.
class UsedNumbers {
 public:
  UsedNumbers() = default;
  /// Of a program, UTF-8; lines with faults count as far as they can be read.
  explicit UsedNumbers(std::string_view program);

  /// Whether `kind` (`L C P O K N B`) has the number anywhere in the program.
  [[nodiscard]] bool has(char kind, int number) const;
  /// Whether an element of that number is defined.
  [[nodiscard]] bool defines(char kind, int number) const;
  /// The least number from 1 that nothing has; 0: all are taken.
  [[nodiscard]] int next_free(char kind) const;
  void add(char kind, int number);
  void add(const UsedNumbers& others);

 private:
  std::map<char, std::set<int>> mentioned_;
  std::map<char, std::set<int>> defined_;
};

/// A program with numbers that are taken by another replaced by free ones, wherever they stand in
/// it; nothing else is changed.
[[nodiscard]] std::string with_free_numbers(std::string_view program, UsedNumbers used);

}  // namespace dgt::studio
