// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "kernel/toolpath.h"
#include "post/svg_names.h"

namespace dgt {

/// How a drawing looks: colours as CSS writes them, widths in pixels.
struct DrawingStyle {
  std::string background = "#11151c";
  std::string programmed = "#2ea043";   ///< the contour as programmed, W = 0
  std::string equidistant = "#ffd33d";  ///< what is cut
  std::string rapid = "#8b98a9";        ///< dashed
  std::string start = "#f0f6fc";
  std::string named = "#7390b0";  ///< elements by name
  std::string letters = "#c9d7e6";
  double programmed_width = 3;  ///< wider, to be seen under the equidistant where both run
  double equidistant_width = 1.25;
  double rapid_width = 1;
  double rapid_dash = 5;
  double start_width = 7;
  double named_width = 0.75;
  double arrow_width = 1.5;
  double dot_width = 5;
  double letters_height = 15;
  double margin = 0.05;        ///< on each side, of the longer side of the box
  double margin_named = 0.12;  ///< the same where elements are named
  double size = 1000;          ///< of the longer side, in pixels
  double aspect = 0;           ///< width by height of the sheet; 0: as the drawing needs
};

/// The tool path as an SVG 1.1 drawing, y up.
///  (1) Arcs are arcs: `A` commands with the doubles of the path, a full circle as two halves.
///  (2) Coordinates are the path's own millimetres, in shortest form: the file can be measured.
///  (3) Strokes keep their width when the drawing is scaled, where the viewer can do that.
///  (4) The same path gives the same bytes.
/// `named` elements lie thin beneath the path, with their names and arrows in their directions, and
/// arrows stand on the path; those that are lit have the colour and width of a programmed contour.
/// Without a path the elements have the sheet to themselves.
[[nodiscard]] std::string draw_svg(const Toolpath& path, const DrawingStyle& style = {},
                                   std::span<const NamedShape> named = {});

}  // namespace dgt
