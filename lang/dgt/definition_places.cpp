// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/definition_places.h"

#include <algorithm>
#include <utility>

#include "lang/dgt/parser.h"

namespace dgt::language {

DefinitionPlaces::DefinitionPlaces(const SourceFile& file) : file_(&file) {
  DiagnosticBag known;
  ProgramReader reader(file, known);
  for (Program piece; reader.next(piece);) {
    for (const Statement& statement : piece.statements) {
      const auto* const definition = std::get_if<language::Definition>(&statement.body);
      if (definition == nullptr) continue;
      const Item& target = definition->target;
      if (target.number.is_absent() || target.number.is_variable()) continue;
      definitions_.push_back({target.letter, static_cast<std::int16_t>(target.number.whole),
                              target.range.begin, target.range.end, statement.range.end});
    }
  }
  std::ranges::stable_sort(definitions_, {},
                           [](const Definition& d) { return std::pair(d.letter, d.number); });
}

std::optional<Range> DefinitionPlaces::first_outside(const Range& use, char letter,
                                                     int number) const {
  const auto same = std::ranges::equal_range(
      definitions_, std::pair(letter, static_cast<std::int16_t>(number)), {},
      [](const Definition& d) { return std::pair(d.letter, d.number); });
  for (const Definition& d : same) {
    if (!lies_in(use, {file_, d.begin, d.end})) return Range{file_, d.begin, d.target_end};
  }
  return std::nullopt;
}

}  // namespace dgt::language
