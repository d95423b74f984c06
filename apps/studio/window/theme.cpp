// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/window/theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyle>
#include <QStyleFactory>
#include <QToolTip>
#include <array>

namespace dgt::studio {
namespace {

constexpr std::array kRows = {
    ColourRow{"sheet", QT_TRANSLATE_NOOP("Colours", "Drawing: background"), &Colours::sheet},
    ColourRow{"grid", QT_TRANSLATE_NOOP("Colours", "Drawing: grid"), &Colours::grid},
    ColourRow{"axes", QT_TRANSLATE_NOOP("Colours", "Drawing: axes"), &Colours::axes},
    ColourRow{"programmed", QT_TRANSLATE_NOOP("Colours", "Programmed contour"),
              &Colours::programmed},
    ColourRow{"equidistant", QT_TRANSLATE_NOOP("Colours", "Equidistant"), &Colours::equidistant},
    ColourRow{"rapid", QT_TRANSLATE_NOOP("Colours", "Rapid moves"), &Colours::rapid},
    ColourRow{"tool", QT_TRANSLATE_NOOP("Colours", "Tool"), &Colours::tool},
    ColourRow{"lit", QT_TRANSLATE_NOOP("Colours", "Moves of the current line"), &Colours::lit},
    ColourRow{"points", QT_TRANSLATE_NOOP("Colours", "Control points"), &Colours::points},
    ColourRow{"measure", QT_TRANSLATE_NOOP("Colours", "Measuring"), &Colours::measure},
    ColourRow{"paper", QT_TRANSLATE_NOOP("Colours", "Text: background"), &Colours::paper},
    ColourRow{"text", QT_TRANSLATE_NOOP("Colours", "Text"), &Colours::text},
    ColourRow{"element", QT_TRANSLATE_NOOP("Colours", "Elements L C P O"), &Colours::element},
    ColourRow{"number", QT_TRANSLATE_NOOP("Colours", "Quantities and numbers"), &Colours::number},
    ColourRow{"keyword", QT_TRANSLATE_NOOP("Colours", "Operators and commands"), &Colours::keyword},
    ColourRow{"variable", QT_TRANSLATE_NOOP("Colours", "Variables"), &Colours::variable},
    ColourRow{"comment", QT_TRANSLATE_NOOP("Colours", "Comments"), &Colours::comment},
    ColourRow{"error", QT_TRANSLATE_NOOP("Colours", "Errors"), &Colours::error},
    ColourRow{"warning", QT_TRANSLATE_NOOP("Colours", "Warnings"), &Colours::warning},
    ColourRow{"note", QT_TRANSLATE_NOOP("Colours", "Remarks"), &Colours::note},
    ColourRow{"current_line", QT_TRANSLATE_NOOP("Colours", "Line with the cursor"),
              &Colours::current_line},
    ColourRow{"found", QT_TRANSLATE_NOOP("Colours", "Places found"), &Colours::found},
    ColourRow{"line_numbers", QT_TRANSLATE_NOOP("Colours", "Line numbers"), &Colours::line_numbers},
};

QColor rgb(std::uint32_t value) { return QColor::fromRgb(0xFF000000U | value); }

Colours light_colours() {
  return {.sheet = rgb(0xFCFCFA),
          .grid = rgb(0xE4E4DE),
          .axes = rgb(0x9A9A92),
          .programmed = rgb(0x1E8E3E),
          .equidistant = rgb(0xB07800),
          .rapid = rgb(0x6A7480),
          .tool = rgb(0xC0392B),
          .lit = rgb(0xD0107A),
          .points = rgb(0x0B57A4),
          .measure = rgb(0x7A1FA2),
          .paper = rgb(0xFFFFFF),
          .text = rgb(0x202124),
          .element = rgb(0x0B57A4),
          .number = rgb(0x8A3B00),
          .keyword = rgb(0x7A1FA2),
          .variable = rgb(0x00696B),
          .comment = rgb(0x5F6B5F),
          .error = rgb(0xC5221F),
          .warning = rgb(0xB26A00),
          .note = rgb(0x1A73E8),
          .current_line = rgb(0xF1F4FA),
          .found = rgb(0xFFE58A),
          .line_numbers = rgb(0x7C8087)};
}

Colours dark_colours() {
  return {.sheet = rgb(0x14171A),
          .grid = rgb(0x2A2F35),
          .axes = rgb(0x6C757F),
          .programmed = rgb(0x35C759),
          .equidistant = rgb(0xFFD60A),
          .rapid = rgb(0x8E99A6),
          .tool = rgb(0xFF6B5E),
          .lit = rgb(0xFF5FB0),
          .points = rgb(0x6CB6FF),
          .measure = rgb(0xD79BFF),
          .paper = rgb(0x1B1E22),
          .text = rgb(0xE6E8EA),
          .element = rgb(0x6CB6FF),
          .number = rgb(0xF0B072),
          .keyword = rgb(0xD79BFF),
          .variable = rgb(0x5FD7D0),
          .comment = rgb(0x8FA08F),
          .error = rgb(0xFF6B6B),
          .warning = rgb(0xFFB340),
          .note = rgb(0x6CB6FF),
          .current_line = rgb(0x262B31),
          .found = rgb(0x6B5A10),
          .line_numbers = rgb(0x7D858E)};
}

/// What differs between the themes in the style's palette.
struct Shades {
  QColor window, base, alternate, text, dim, button, light, dark, highlight, highlighted, link;
};

QPalette palette_of(const Shades& s) {
  QPalette palette(s.text, s.button, s.light, s.dark, s.dark, s.text, s.highlighted, s.base,
                   s.window);
  palette.setColor(QPalette::AlternateBase, s.alternate);
  palette.setColor(QPalette::ToolTipBase, s.alternate);
  palette.setColor(QPalette::ToolTipText, s.text);
  palette.setColor(QPalette::PlaceholderText, s.dim);
  palette.setColor(QPalette::Midlight, s.light);
  palette.setColor(QPalette::Shadow, s.dark.darker());
  palette.setColor(QPalette::Highlight, s.highlight);
  palette.setColor(QPalette::HighlightedText, s.highlighted);
  palette.setColor(QPalette::Link, s.link);
  palette.setColor(QPalette::LinkVisited, s.link);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, s.dim);
  }
  palette.setColor(QPalette::Disabled, QPalette::Highlight, s.dark);
  return palette;
}

QPalette palette_of(Theme theme) {
  if (theme == Theme::Dark) {
    return palette_of({rgb(0x24282D), rgb(0x1B1E22), rgb(0x2B3036), rgb(0xE6E8EA), rgb(0x7D858E),
                       rgb(0x2F343A), rgb(0x454C54), rgb(0x15181B), rgb(0x2F6FBF), rgb(0xFFFFFF),
                       rgb(0x6CB6FF)});
  }
  return palette_of({rgb(0xF0F0EE), rgb(0xFFFFFF), rgb(0xF7F7F5), rgb(0x202124), rgb(0x8A8D92),
                     rgb(0xF0F0EE), rgb(0xFFFFFF), rgb(0xB4B4B0), rgb(0x1A66C2), rgb(0xFFFFFF),
                     rgb(0x0B57A4)});
}

}  // namespace

std::span<const ColourRow> colour_rows() { return kRows; }

Colours standard_colours(Theme theme) {
  return theme == Theme::Dark ? dark_colours() : light_colours();
}

Appearance::Appearance() : colours_(light_colours()) {}

Appearance& Appearance::of_program() {
  static Appearance appearance;
  return appearance;
}

// Fusion is the one style that every platform has and that takes any palette.
void Appearance::set(Theme theme, const Colours& colours) {
  theme_ = theme;
  colours_ = colours;
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("fusion")));
  QApplication::setPalette(palette_of(theme));
  QToolTip::setPalette(palette_of(theme));
  emit changed();
}

}  // namespace dgt::studio
