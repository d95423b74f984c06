// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QObject>
#include <cstdint>
#include <span>

/// How everything looks: two themes, and the colours of drawing and text, which a person may
/// change.
namespace dgt::studio {

enum class Theme : std::uint8_t { Light, Dark };

/// Every colour that the style does not know.
struct Colours {
  // The drawing.
  QColor sheet;        ///< behind everything
  QColor grid;         ///< lines of the grid
  QColor axes;         ///< the axes of coordinates, the frame of measures
  QColor programmed;   ///< the contour as programmed; green in the guide
  QColor equidistant;  ///< what the tool does; yellow in the guide
  QColor rapid;        ///< moves without cutting
  QColor tool;         ///< the disc that is stepped along
  QColor lit;          ///< moves of the line with the cursor
  QColor points;       ///< control points and their numbers
  QColor measure;      ///< measuring, snapped places
  // Texts of programs.
  QColor paper;         ///< behind the text
  QColor text;          ///< what is nothing of the below
  QColor element;       ///< `L1`, `C-2`, `P3`
  QColor number;        ///< numbers, and letters that are quantities: `X5`, `R10`
  QColor keyword;       ///< FOR, NEXT, MAC, OPR, G, M, F, S, T
  QColor variable;      ///< `N1`, `B2` and texts in quotes
  QColor comment;       ///< what is not executed
  QColor error;         ///< under faults
  QColor warning;       ///< under doubts
  QColor note;          ///< under remarks
  QColor current_line;  ///< behind the line with the cursor
  QColor found;         ///< behind what was searched for
  QColor line_numbers;  ///< at the left of the text

  friend bool operator==(const Colours&, const Colours&) = default;
};

/// One colour as a person chooses it.
struct ColourRow {
  const char* key;    ///< in the settings file
  const char* label;  ///< English, to be translated in the context `Colours`
  QColor Colours::*colour;
};
/// All of them, in the order of `Colours`.
[[nodiscard]] std::span<const ColourRow> colour_rows();

/// The colours that a theme comes with.
[[nodiscard]] Colours standard_colours(Theme theme);

/// The look of the whole program. Widgets repaint at `changed`.
class Appearance : public QObject {
  Q_OBJECT

 public:
  [[nodiscard]] static Appearance& of_program();

  [[nodiscard]] Theme theme() const { return theme_; }
  [[nodiscard]] const Colours& colours() const { return colours_; }
  /// Sets the style, its palette and the colours of the program.
  void set(Theme theme, const Colours& colours);

 signals:
  void changed();

 private:
  Appearance();

  Theme theme_ = Theme::Light;
  Colours colours_;
};

/// The colours in force.
[[nodiscard]] inline const Colours& colours() { return Appearance::of_program().colours(); }

}  // namespace dgt::studio
