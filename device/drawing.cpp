// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/drawing.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace dgt {
namespace {

constexpr double kMargin = 5;   // mm around the strips
constexpr double kBetween = 6;  // mm between them; their labels stand there

DrawnStrip strip_of(const Tape& tape, std::size_t first, std::size_t last, double y) {
  DrawnStrip strip{first, kMargin, y, static_cast<double>(last - first) * kPitch, {}, {}};
  for (std::size_t row = first; row < last; ++row) {
    const double x = strip.x + (static_cast<double>(row - first) + 0.5) * kPitch;
    strip.feed.push_back({x, y + kTapeWidth - kFeedFromEdge});
    for (std::size_t track = 0; track < kTracks; ++track) {
      if ((tape.rows[row] >> track & 1) != 0)
        strip.code.push_back({x, y + kTapeWidth - track_from_edge(track)});
    }
  }
  return strip;
}

/// Thousandths of a mm are plenty; the shortest form of the rounded number.
std::string number(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::fixed, 3)
                       .ptr;
  std::string text(buffer.data(), end);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string attribute(std::string_view name, double value) {
  return " " + std::string(name) + "=\"" + number(value) + "\"";
}

void append_holes(std::string& svg, const std::vector<DrawnHole>& holes, double diameter) {
  for (const DrawnHole& hole : holes) {
    svg += "<circle" + attribute("cx", hole.x) + attribute("cy", hole.y) +
           attribute("r", diameter / 2) + "/>\n";
  }
}

}  // namespace

TapeDrawing draw_tape(const Tape& tape, RowRange rows) {
  const std::size_t last = std::min(rows.last, tape.rows.size());
  TapeDrawing drawing;
  double y = kMargin + kBetween;
  double longest = 0;
  for (std::size_t first = rows.first; first < last; first += kRowsPerStrip) {
    drawing.strips.push_back(strip_of(tape, first, std::min(last, first + kRowsPerStrip), y));
    longest = std::max(longest, drawing.strips.back().length);
    y += kTapeWidth + kBetween;
  }
  drawing.width = longest + 2 * kMargin;
  drawing.height = y - kBetween + kMargin;
  return drawing;
}

std::string to_svg(const TapeDrawing& drawing) {
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(drawing.width) +
                    "mm\" height=\"" + number(drawing.height) + "mm\" viewBox=\"0 0 " +
                    number(drawing.width) + " " + number(drawing.height) + "\">\n";
  for (const DrawnStrip& strip : drawing.strips) {
    svg += "<text" + attribute("x", strip.x) + attribute("y", strip.y - 1.5) +
           " font-family=\"sans-serif\" font-size=\"3\">" + std::to_string(strip.first_row + 1) +
           " · " + millimetres_to(strip.first_row) + " mm</text>\n<rect" + attribute("x", strip.x) +
           attribute("y", strip.y) + attribute("width", strip.length) +
           attribute("height", kTapeWidth) + " fill=\"#e9dfc0\"/>\n<g class=\"feed\">\n";
    append_holes(svg, strip.feed, kFeedHole);
    svg += "</g>\n<g class=\"code\">\n";
    append_holes(svg, strip.code, kCodeHole);
    svg += "</g>\n";
  }
  return svg + "</svg>\n";
}

}  // namespace dgt
