// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lang/text/source_file.h"

namespace dgt::language {

/// Where a source file defines which elements: for the messages about those that are not defined
/// yet. Definitions of elements with a variable for their number are not among them.
class DefinitionPlaces {
 public:
  explicit DefinitionPlaces(const SourceFile& file);

  /// The target of the first definition of `letter` `number` that does not hold `use`.
  [[nodiscard]] std::optional<Range> first_outside(const Range& use, char letter, int number) const;

 private:
  struct Definition {
    char letter = 0;
    std::int16_t number = 0;
    std::uint32_t begin = 0;
    std::uint32_t target_end = 0;
    std::uint32_t end = 0;
  };

  const SourceFile* file_;
  std::vector<Definition> definitions_;  // by letter and number, then by place
};

}  // namespace dgt::language
