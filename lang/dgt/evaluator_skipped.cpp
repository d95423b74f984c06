// SPDX-License-Identifier: GPL-3.0-or-later
//
// The body of a loop that runs 0 times. Its syntax has been checked with the rest of the program;
// of its names those are told that no round could find. Its geometry is nobody's fault yet: the
// numbers it is to be worked out with are not known.
#include <algorithm>
#include <set>
#include <utility>

#include "lang/dgt/evaluator.h"

namespace dgt::language {
namespace {

using Name = std::pair<char, int>;

// By a number, not by a variable or inline.
bool is_plain_name(const Item& item) {
  const bool is_element = std::string_view("LCPO").find(item.letter) != std::string_view::npos;
  return is_element && item.letter != 0 && !item.is_inline_point &&
         item.number.form == NumberForm::Decimal;
}

// Lines that define what cannot be told from them.
bool may_define_anything(const Statement& statement) {
  const auto* const definition = std::get_if<Definition>(&statement.body);
  return (definition != nullptr && !is_plain_name(definition->target)) ||
         std::holds_alternative<MacroCall>(statement.body) ||
         std::holds_alternative<DefinitionFile>(statement.body) ||
         std::holds_alternative<SplicedLine>(statement.body);
}

const std::vector<Item>& items_of(const Statement& statement) {
  static const std::vector<Item> kNone;
  if (const auto* const d = std::get_if<Definition>(&statement.body)) return d->operands;
  if (const auto* const s = std::get_if<ContourStart>(&statement.body)) return s->items;
  if (const auto* const l = std::get_if<ItemLine>(&statement.body)) return l->items;
  return kNone;
}

}  // namespace

// In a macro or in a loop the next call or round may find more defined, so nothing is said there.
void Evaluator::check_skipped(std::span<const Statement> body) {
  const bool comes_again = loop_depth_ > 0 || shared_.call_stack.size() > 1;
  if (comes_again || shared_.names_missing || std::ranges::any_of(body, may_define_anything)) {
    return;
  }
  std::set<Name> own;
  for (const Statement& statement : body) {
    const auto* const definition = std::get_if<Definition>(&statement.body);
    if (definition != nullptr) {
      own.emplace(definition->target.letter, definition->target.number.whole);
    }
  }
  for (const Statement& statement : body) {
    for (const Item& item : items_of(statement)) {
      const bool is_world = item.letter == 'O' && item.number.whole == 0;
      if (!is_plain_name(item) || is_world) continue;
      if (!own.contains({item.letter, item.number.whole})) shared_.warn_if_undefined(item);
    }
  }
}

}  // namespace dgt::language
