// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <map>
#include <string>
#include <vector>

#include "apps/studio/window/theme.h"
#include "post/svg.h"

/// Small drawings of small programs, for the wizard and the help: all made by the plotter of the
/// project, none by hand.
namespace dgt::studio {

/// A word in a drawing.
struct FigureNote {
  std::string text;
  double x = 0, y = 0;  ///< mm
};

/// A program to be drawn.
struct Figure {
  std::string program;
  /// What is drawn so that it stands out: `L1`; empty: nothing.
  std::string lit = {};
  /// The axes of coordinates are shown.
  bool axes = false;
  /// Elements that are called otherwise in the drawing; empty: not at all.
  std::map<std::string, std::string> called = {};
  std::vector<FigureNote> notes = {};
  /// Macros and definition files by their names.
  std::map<std::string, std::string> files = {};
};

/// The drawing's colours and strokes; `pixels` are those of the longer side.
[[nodiscard]] DrawingStyle figure_style(const Colours& colours, double pixels);

/// Draws the elements of the program with their names, and its contours; `ratio` pixels for one of
/// the style. Null when the program has errors. Takes some milliseconds.
[[nodiscard]] QImage draw_figure(const Figure& figure, const DrawingStyle& style, double ratio = 1);

}  // namespace dgt::studio
