// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "kernel/number.h"
#include "lang/text/diagnostic.h"

namespace dgt::language {

/// How the program came to a line: the macro call, the round of a loop or the use of a text that is
/// being executed, and what that stands in itself. Shared by all items that came the same way.
struct Expansion {
  Message message;  ///< of its note
  Range range;      ///< the call, the FOR, the line that uses the text
  std::string argument;
  std::size_t depth = 1;
  std::shared_ptr<const Expansion> outer;
};
using ExpansionPtr = std::shared_ptr<const Expansion>;

/// The calls, loops and texts under way.
class ExpansionStack {
 public:
  /// `argument`: of the message, empty when it takes none.
  void push(Message message, const Range& range, std::string argument = {});
  /// A loop in its first round, of which nothing is told: what is wrong there is wrong in any.
  void push_loop(const Range& range);
  /// The loop on top goes into its next round.
  void next_round();
  void pop() { steps_.pop_back(); }

  /// The stack as it is now; null when there is nothing to tell. Made when first asked for, since
  /// most rounds of most loops go by without anybody asking.
  [[nodiscard]] const ExpansionPtr& current();

 private:
  struct Step {
    Message message;
    Range range;
    std::string argument;
    Integer round;  // of a loop; 0: no loop
    bool made = false;
    ExpansionPtr expansion;
  };
  std::vector<Step> steps_;
};

/// The notes that tell of `expansion`, innermost first. A text is not told of when `range`, the
/// place of the fault, lies in the line that uses it; of deep stacks both ends are told.
[[nodiscard]] std::vector<Note> notes_of(const ExpansionPtr& expansion, const Range& range);

/// Adds those notes to an error or warning.
void add_expansion(Diagnostic& diagnostic, const ExpansionPtr& expansion);

}  // namespace dgt::language
