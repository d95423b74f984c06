// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dgt::language {

/// What a definition can define; the value is its letter in the source.
enum class ElementKind : char { Line = 'L', Circle = 'C', Point = 'P', Frame = 'O' };

/// The construction that a form of definition calls, with its operands in the order of the form.
enum class Recipe : std::uint8_t {
  LineAtX,
  LineAtY,
  LineThroughPoints,
  LineParallelThroughPoint,
  LineParallelAtDistance,
  LineFromPointToCircle,
  LineThroughPointAtAngle,
  LineTangentAtAngle,
  LineTangentToCircles,
  LineTurnedThroughPoint,
  CircleAtCentre,
  CircleThroughPoints,
  CircleTouchingLines,
  CircleTouchingLineAndCircle,
  CircleTouchingCircles,
  CircleAtPolarCentre,
  PointAtCoordinates,
  PointAtCentre,
  PointOfLines,
  PointOfLineAndCircle,
  PointOfCircles,
  PointAtPolar,
  FrameAtPoint
};

/// One row of the guide's tables of definitions.
struct Form {
  ElementKind result;
  std::string_view operands;  ///< a letter each, in the order the construction takes them; P is a
                              ///< point, by number or as X Y
  std::string_view pattern;   ///< as the guide writes it
  bool takes_selector;        ///< oriented geometry leaves two solutions
  Recipe recipe;
};

/// All rows, in the order of the guide.
[[nodiscard]] std::span<const Form> all_forms();

/// How the operands of a definition fill a form: `order[i]` is the index, among the operands as
/// written, of the form's operand i. Operands of unlike kinds may be written in any order, like
/// kinds are taken as written.
struct FormMatch {
  const Form* form = nullptr;
  std::vector<std::uint8_t> order;
};

/// The form of `result` that takes exactly `operands` (letters as written).
[[nodiscard]] std::optional<FormMatch> match_form(ElementKind result, std::string_view operands);

/// Why no form takes the operands: the forms that come nearest.
struct FormMismatch {
  struct Candidate {
    const Form* form = nullptr;
    std::string missing;               ///< letters the form needs besides
    std::vector<std::size_t> surplus;  ///< indices of operands that it has no use for
  };
  std::vector<Candidate> nearest;  ///< with the fewest missing and surplus operands; never empty
};
/// Precondition: match_form(result, operands) finds nothing.
[[nodiscard]] FormMismatch explain_mismatch(ElementKind result, std::string_view operands);

/// Whether some form of `result` has an operand of this letter.
[[nodiscard]] bool is_operand_of(ElementKind result, char letter);

}  // namespace dgt::language
