// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "kernel/toolpath.h"
#include "post/write.h"

/// A tool path as a program in the DGT language: points, lines and circles by dimensions, then the
/// contours along them.
namespace dgt {

/// How a contour is said, from what a person would write to what always works.
enum class DgtStyle : std::uint8_t {
  Offset,       ///< the programmed contour with W, by Elements, leads along the normals
  FromMeeting,  ///< likewise, from where the last element of a closed contour meets the first
  Elements,     ///< lines and circles, tangents and fillets; each met with the next
  Through,      ///< the same, circles through three places of their arcs
  Points,       ///< from point to point, circles between them through three places
};

[[nodiscard]] constexpr bool is_with_width(DgtStyle style) {
  return style == DgtStyle::Offset || style == DgtStyle::FromMeeting;
}

/// What says a contour: lines of the text, from 1, and the style, plainer than the one asked for
/// where that has no words for it.
struct DgtLines {
  std::size_t first = 0;
  std::size_t last = 0;
  DgtStyle style = DgtStyle::Points;
};

struct DgtText {
  std::string text;
  std::vector<DgtLines> contours;  ///< one for each of the path
  std::vector<WriteFault> faults;  ///< codes that the language lacks; then no text
};

/// Numbers are rounded to this many decimals, or to fewer where that is as near as rounding of
/// doubles brings them.
inline constexpr int kDgtDecimals = 12;

/// The largest number of an element, hence how many circles a contour has at most.
inline constexpr std::size_t kMaxDgtNumber = 9999;

/// The path as a program. What a style means is for the compiler to say: in any but Points the
/// elements may meet elsewhere, or not at all. `styles`: one for each contour.
[[nodiscard]] DgtText to_dgt(const Toolpath& path, const std::vector<DgtStyle>& styles,
                             const std::string& title);

/// A code as the language has it: torch and stop of ESSI become M7, M8, M0. Empty: it has none.
[[nodiscard]] std::string dgt_code(const std::string& code);

}  // namespace dgt
