// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <rapidcheck.h>

#include <string>
#include <vector>

/// Programs without syntax errors for property tests: rectangles with fillets and chamfers, which
/// compile, beside definitions and contours put together at random, which mostly do not. A skeleton
/// says what a program says; a spelling of it is one way to type it.
namespace dgt::support {

enum class PieceKind {
  Letter,    ///< `L`, in either case or as a Cyrillic letter of its shape
  Number,    ///< unsigned
  Minus,     ///< before a number
  Plus,      ///< nothing, or a plus before a number
  Mark,      ///< `=`, `*`, `,` where one must stand
  Quote,     ///< `"`
  Keyword,   ///< `FOR`
  Name,      ///< of a file, a blank behind it
  Separator  ///< nothing, or a comma between items
};
struct Piece {
  PieceKind kind;
  std::string text;
};
struct SkeletonLine {
  std::vector<Piece> pieces;
  bool goes_on = false;  ///< with a contour: one of its separators must be a comma
  std::string comment;   ///< from its mark, empty: none
  bool blank_before = false;
};
using Skeleton = std::vector<SkeletonLine>;

/// A macro SLOT with five arguments, which the programs call.
extern const std::string kMacro;

[[nodiscard]] rc::Gen<Skeleton> any_skeleton();
/// The spelling that `seed` stands for: free blanks, letters of either case and alphabet, numbers
/// with idle zeros and points, line ends.
[[nodiscard]] std::string spelling(const Skeleton& skeleton, unsigned seed);
[[nodiscard]] rc::Gen<std::string> any_spelling(const Skeleton& skeleton);
/// Some spelling of some skeleton.
[[nodiscard]] rc::Gen<std::string> any_program();

}  // namespace dgt::support

namespace dgt::support {
inline void showValue(const SkeletonLine& line, std::ostream& out) {
  out << spelling({line}, 0);  // shown by RapidCheck when a property fails
}
}  // namespace dgt::support
