// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "kernel/contour.h"

/// A contour's items in one line of a test: contour({along(l1), fillet("2"), along(l2)}).
namespace dgt::notation {

inline Rational number(const std::string& text) { return parse_decimal(text).value(); }

inline ElementPtr element(Element e) { return ElementPtr(std::move(e)); }
inline ElementPtr horizontal(const std::string& y) { return element(horizontal_line(number(y))); }
inline ElementPtr vertical(const std::string& x) { return element(vertical_line(number(x))); }
inline ElementPtr circle(const std::string& x, const std::string& y, const std::string& r) {
  return element(Circle({number(x), number(y)}, number(r)));
}
inline ElementPtr minus(const ElementPtr& e) { return element(reversed(*e)); }
inline ElementPtr turned(const ElementPtr& e, const std::string& degrees) {
  return element(placed(*e, Frame{{0, 0}, direction_of(number(degrees)).unit}));
}
inline Point at(const std::string& x, const std::string& y) {
  return Point(RationalPoint{number(x), number(y)});
}

using What = decltype(ContourItem::what);
inline What along(ElementPtr e) { return AlongItem{std::move(e)}; }
inline What to(const std::string& x, const std::string& y) { return PointItem{at(x, y)}; }
inline What axis(ElementPtr line) { return AxisItem{std::move(line)}; }
inline What fillet(const std::string& r) { return FilletItem{number(r)}; }
inline What chamfer(const std::string& v) { return BevelItem{number(v)}; }
inline What tangent() { return BevelItem{}; }
inline What travel(const std::string& d) { return TravelItem{number(d)}; }
inline What w(const std::string& v) { return OffsetItem{number(v), true}; }
inline What u(const std::string& v) { return OffsetItem{number(v), false}; }
inline What select(Selector s) { return SelectItem{s}; }
inline What feed(const std::string& f) { return FeedItem{number(f)}; }
inline What height(const std::string& z) { return HeightItem{number(z)}; }
inline What code(const std::string& c) { return CodeItem{c}; }
inline What dwell(const std::string& s) { return DwellItem{number(s)}; }
inline What rapid() { return RapidItem{}; }

/// Items placed in line 1, their columns counting from 1.
inline std::vector<ContourItem> items(std::vector<What> whats) {
  std::vector<ContourItem> result;
  for (What& what : whats)
    result.push_back({std::move(what), {0, 1, static_cast<std::uint32_t>(result.size() + 1)}});
  return result;
}

inline BuiltContour build(std::vector<What> whats, const Point& tool = Point(),
                          const ContourOptions& options = {}) {
  ToolState state;
  state.at = tool;
  return build_contour(items(std::move(whats)), state, options);
}

/// The moves in one line: `line(0,0 10,0) arc(10,0 0,10 r5 +180)`; coordinates to 4 digits.
std::string text(const std::vector<Move>& moves);
/// Faults as `NoMeeting#3/4 0.5000`.
std::string text(const std::vector<ContourFault>& faults);

}  // namespace dgt::notation
