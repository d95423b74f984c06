// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dgt/expansion.h"

#include <iterator>

namespace dgt::language {
namespace {

// Of a stack deeper than kMaxTold steps, this many at its inner end and one at its outer are told.
constexpr std::size_t kMaxTold = 6;
constexpr std::size_t kToldInside = 3;

Note note_of(const Expansion& step) {
  if (step.argument.empty()) return {step.message, step.range, {}};
  return {step.message, step.range, {step.argument}};
}

}  // namespace

void ExpansionStack::push(Message message, const Range& range, std::string argument) {
  steps_.push_back({message, range, std::move(argument), 0, false, nullptr});
}

void ExpansionStack::push_loop(const Range& range) {
  steps_.push_back({Message::InRound, range, {}, 1, false, nullptr});
}

void ExpansionStack::next_round() {
  Step& loop = steps_.back();
  ++loop.round;
  loop.made = false;
}

const ExpansionPtr& ExpansionStack::current() {
  static const ExpansionPtr kNothing;
  const ExpansionPtr* outer = &kNothing;
  for (Step& step : steps_) {
    if (!step.made) {
      step.made = true;
      step.expansion = *outer;
      if (step.round != 1) {
        if (step.round > 1) step.argument = step.round.get_str();
        const std::size_t depth = *outer ? (*outer)->depth + 1 : 1;
        step.expansion = std::make_shared<const Expansion>(
            Expansion{step.message, step.range, step.argument, depth, *outer});
      }
    }
    outer = &step.expansion;
  }
  return *outer;
}

std::vector<Note> notes_of(const ExpansionPtr& expansion, const Range& range) {
  std::vector<Note> notes;
  const std::size_t depth = expansion ? expansion->depth : 0;
  for (const Expansion* step = expansion.get(); step != nullptr; step = step->outer.get()) {
    const bool is_outermost = step->outer == nullptr;
    const std::size_t inside = depth - step->depth;
    if (depth > kMaxTold && inside >= kToldInside && !is_outermost) {
      if (inside == kToldInside) {
        notes.push_back(
            {Message::StepsOmitted, step->range, {std::to_string(depth - kToldInside - 1)}});
      }
      continue;
    }
    if (step->message == Message::TextUsedHere && lies_in(range, step->range)) continue;
    notes.push_back(note_of(*step));
  }
  return notes;
}

void add_expansion(Diagnostic& diagnostic, const ExpansionPtr& expansion) {
  if (diagnostic.severity() == Severity::Note) return;
  std::vector<Note> notes = notes_of(expansion, diagnostic.range);
  diagnostic.notes.insert(diagnostic.notes.end(), std::make_move_iterator(notes.begin()),
                          std::make_move_iterator(notes.end()));
}

}  // namespace dgt::language
