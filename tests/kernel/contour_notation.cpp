// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kernel/contour_notation.h"

#include <fmt/format.h>

namespace dgt::notation {
namespace {

std::string digits(double value) {
  std::string s = fmt::format("{:.4f}", value);
  s.erase(s.find_last_not_of('0') + 1);
  if (s.back() == '.') s.pop_back();
  return s == "-0" ? "0" : s;
}

std::string pair(const Point& p) { return digits(p.x()) + "," + digits(p.y()); }

}  // namespace

std::string text(const std::vector<Move>& moves) {
  std::string all;
  for (const Move& move : moves) {
    if (!all.empty()) all += " ";
    if (move.kind == MoveKind::Code) {
      all += move.code;
    } else if (move.kind == MoveKind::Dwell) {
      all += "dwell(" + to_short_decimal(*move.seconds) + ")";
    } else {
      all += fmt::format("{}({} {}", name_of(move.kind), pair(move.from), pair(move.to));
      if (move.kind == MoveKind::Arc) {
        all += fmt::format(" r{} {}", digits(nearest_double(abs(move.circle().radius()))),
                           digits(sweep_degrees(move)));
      }
      if (move.z) all += " z" + to_short_decimal(*move.z);
      all += ")";
    }
  }
  return all;
}

std::string text(const std::vector<ContourFault>& faults) {
  std::string all;
  for (const ContourFault& f : faults) {
    if (!all.empty()) all += " ";
    all += fmt::format("{}#{}/{} {:.4f}", static_cast<int>(f.kind), f.item, f.other, f.measure);
  }
  return all;
}

}  // namespace dgt::notation
