// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "kernel/construct.h"
#include "lang/dgt/forms.h"
#include "lang/text/source_file.h"

namespace dgt::language {

/// A coordinate system as defined: where its origin lies and how far it is turned.
struct FrameDefinition {
  RationalPoint origin;
  Rational degrees;
};

/// What stands under a number of an element.
struct ElementEntry {
  enum class State : std::uint8_t {
    Undefined,
    Defined,
    Unknown  ///< its definition failed, or its absence has been reported
  };
  State state = State::Undefined;
  ElementPtr element;                            ///< of L and C
  ElementPtr reversed;                           ///< made when first asked for
  std::shared_ptr<const KnownPoint> point;       ///< of P
  std::shared_ptr<const FrameDefinition> frame;  ///< of O
  double bound = 0;  ///< how far it may lie from its ideal, mm; see Constructed
  double turn = 0;   ///< radians
  Range place;       ///< its definition
};

/// All elements of a program by kind and number, 0…9999. A macro shares it with its program.
class ElementTable {
 public:
  [[nodiscard]] ElementEntry& at(ElementKind kind, int number);
  /// Whether something is under the number, or a fault there has been told.
  [[nodiscard]] bool is_known(char letter, int number) const {
    const ElementEntry* const entry = find(static_cast<ElementKind>(letter), number);
    return entry != nullptr && entry->state != ElementEntry::State::Undefined;
  }
  /// Null when nothing was ever under the number.
  [[nodiscard]] const ElementEntry* find(ElementKind kind, int number) const;
  [[nodiscard]] const std::vector<ElementEntry>& all(ElementKind kind) const;

 private:
  std::array<std::vector<ElementEntry>, 4> entries_;  // L, C, P, O
};

/// One line per defined element in the order L, C, P, O: `C2: centre (14, 0) radius -5`, with the
/// certified bound where the element is not exact.
[[nodiscard]] std::string print_elements(const ElementTable& elements);

}  // namespace dgt::language
