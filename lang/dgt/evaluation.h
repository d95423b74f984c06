// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lang/dgt/compile.h"
#include "lang/dgt/definition_places.h"
#include "lang/dgt/elements.h"
#include "lang/dgt/expansion.h"
#include "lang/dgt/syntax.h"
#include "lang/dgt/variables.h"

namespace dgt::language {

/// An element as a word names it: `L-2` is {'L', 2, true}.
struct ElementName {
  char letter = 0;
  int number = 0;
  bool reversed = false;
};
[[nodiscard]] std::string to_text(const ElementName& name);

/// A length for a message, in mm: at most nine significant digits.
[[nodiscard]] std::string millimetres(double value);

/// What all parts of the evaluator share: the names of the program and where faults go. Every
/// look-up reports its own fault; a result that is missing without a report rests on an earlier
/// fault.
class Evaluation {
 public:
  Evaluation(const EvaluateOptions& options_, DiagnosticBag& bag_) : options(options_), bag(bag_) {}

  const EvaluateOptions& options;
  DiagnosticBag& bag;
  Variables variables;
  ElementTable elements;
  /// A macro or definition file could not be run: what it was to define is not missed again.
  bool names_missing = false;
  /// The files being executed, the program first; definition files it has read stand for it.
  std::vector<const SourceFile*> call_stack;
  std::vector<const SourceFile*> definition_files;
  /// What is being executed inside what.
  ExpansionStack expansion;

  /// Adds a diagnostic with the notes that say how the program came to its place.
  void report(Diagnostic diagnostic) {
    add_expansion(diagnostic, expansion.current());
    bag.add(std::move(diagnostic));
  }

  [[nodiscard]] std::optional<Rational> value(const Item& item) const {
    return variables.value(item.number);
  }
  /// The name that a word with a number or variable means now.
  [[nodiscard]] std::optional<ElementName> name_of(const Item& item);
  /// What is defined under the name of an L, C, P or O.
  [[nodiscard]] const ElementEntry* look_up(const Item& item, const ElementName& name);
  /// Warns of an element that a loop without rounds would miss. Precondition: its number is
  /// written.
  void warn_if_undefined(const Item& item);
  /// A line or circle in the direction of its name.
  [[nodiscard]] ElementPtr element(const Item& item, const ElementName& name);
  /// A point, by number or inline.
  [[nodiscard]] std::optional<KnownPoint> point(const Item& item);
  /// I1…I6.
  [[nodiscard]] std::optional<Selector> selector(const Item& item);

  /// Whether what was last set for `owner` belongs to a caller of the macro being executed.
  [[nodiscard]] bool is_caller(const SourceFile* owner) const;

 private:
  void report_undefined(Message message, const Item& item, const ElementName& name);
  [[nodiscard]] std::optional<Note> defined_later(const Item& item, const ElementName& name);
  [[nodiscard]] std::optional<ElementName> similar_name(const ElementName& name) const;

  std::map<const SourceFile*, DefinitionPlaces> definition_places_;
};

/// Executes a definition: the element, or the fault with its message.
void define(const Definition& definition, bool broken, Evaluation& evaluation);

/// Why a construction over `names` has no result, as a diagnostic at `range`.
[[nodiscard]] Diagnostic explain(const Impossible& impossible, Range range,
                                 const std::vector<std::string>& names);

}  // namespace dgt::language
