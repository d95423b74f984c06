// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/summary.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

namespace dgt {
namespace {

constexpr std::array<MoveKind, kMoveKinds> kKinds = {MoveKind::Line, MoveKind::Arc, MoveKind::Rapid,
                                                     MoveKind::Dwell, MoveKind::Code};

std::size_t index(MoveKind kind) { return static_cast<std::size_t>(kind); }

/// The words of the text form in one language.
struct Words {
  std::array<const char*, kMoveKinds> kinds;
  const char* moves;
  const char* contours;
  const char* pierces;
  const char* cut;
  const char* rapid;
  const char* dwell;
  const char* box;
  const char* nothing;
  const char* time;
};

const Words& words(Language language) {
  static constexpr Words kEnglish = {
      {"lines", "arcs", "rapids", "dwells", "codes"},
      "moves: ",
      "contours: ",
      "pierces: ",
      "cut: {:.3f} mm\n",
      "rapid: {:.3f} mm\n",
      "dwell: {:.3f} s\n",
      "box: X {:.3f} … {:.3f}, Y {:.3f} … {:.3f} ({:.3f} × {:.3f}) mm\n",
      "box: nothing moves\n",
      "time: {} (cut {:.1f} s, rapid {:.1f} s, pierce {:.1f} s, dwell {:.1f} s)\n"};
  static constexpr Words kRussian = {
      {"отрезки", "дуги", "холостые ходы", "выдержки", "команды"},
      "перемещения: ",
      "контуры: ",
      "врезки: ",
      "резание: {:.3f} мм\n",
      "холостой ход: {:.3f} мм\n",
      "выдержки: {:.3f} с\n",
      "габарит: X {:.3f} … {:.3f}, Y {:.3f} … {:.3f} ({:.3f} × {:.3f}) мм\n",
      "габарит: движения нет\n",
      "время: {} (резание {:.1f} с, холостой ход {:.1f} с, врезки {:.1f} с, выдержки {:.1f} с)\n"};
  return language == Language::Russian ? kRussian : kEnglish;
}

/// Three decimals are shown; what is below them is not to print as "-0.000".
double shown(double value) { return std::abs(value) < 0.0005 ? 0.0 : value; }

/// `1:02:03.4`: hours, minutes, seconds.
std::string clock(double seconds) {
  const auto tenths = std::llround(seconds * 10);
  return fmt::format("{}:{:02}:{:02}.{}", tenths / 36000, tenths / 600 % 60, tenths / 10 % 60,
                     tenths % 10);
}

}  // namespace

Summary summarise(const Toolpath& path, const MotionSettings& motion) {
  Summary sum;
  bool cutting = false;
  for (const Move& move : path.moves) {
    ++sum.moves.at(index(move.kind));
    if (move.travels()) {
      if (move.cuts() && !cutting) ++sum.pierces;
      cutting = move.cuts();
    }
    if (move.seconds) sum.dwell += nearest_double(*move.seconds);
  }
  sum.contours = path.contours.size();
  sum.length = lengths(path.moves);
  sum.box = box_of(path.moves);
  sum.times = time_of(path, motion);
  return sum;
}

WayLengths way_lengths(const Toolpath& path) {
  WayLengths sum;
  for (const Contour& contour : path.contours)
    sum.programmed += lengths(programmed_moves(path, contour)).cut;
  const Lengths tool = lengths(path.moves);
  sum.cut = tool.cut;
  sum.rapid = tool.rapid;
  return sum;
}

std::string to_text(const Summary& sum, Language language) {
  const Words& w = words(language);
  std::string out = w.moves;
  const auto append = [&out](const char* format, const auto&... values) {
    fmt::format_to(std::back_inserter(out), fmt::runtime(format), values...);
  };
  for (const MoveKind kind : kKinds) {
    append(kind == kKinds.front() ? "{} {}" : ", {} {}", w.kinds.at(index(kind)),
           sum.moves.at(index(kind)));
  }
  append("\n{}{}\n{}{}\n", w.contours, sum.contours, w.pierces, sum.pierces);
  append(w.cut, sum.length.cut);
  append(w.rapid, sum.length.rapid);
  if (sum.dwell > 0) append(w.dwell, sum.dwell);
  const Times& times = sum.times;
  append(w.time, clock(times.total()), times.cut, times.rapid, times.pierce, times.dwell);
  const Box& box = sum.box;
  if (box.empty()) return out + w.nothing;
  append(w.box, shown(box.left), shown(box.right), shown(box.bottom), shown(box.top), box.width(),
         box.height());
  return out;
}

std::string to_json(const Summary& sum) {
  using Json = nlohmann::ordered_json;
  Json json = {{"schema", "dgt-info/1"}, {"units", "mm"}, {"moves", Json::object()}};
  for (const MoveKind kind : kKinds) json["moves"][name_of(kind)] = sum.moves.at(index(kind));
  json["contours"] = sum.contours;
  json["pierces"] = sum.pierces;
  json["length"] = {{"cut", sum.length.cut}, {"rapid", sum.length.rapid}};
  json["dwell"] = sum.dwell;
  const Times& times = sum.times;
  json["time"] = {{"total", times.total()},
                  {"cut", times.cut},
                  {"rapid", times.rapid},
                  {"pierce", times.pierce},
                  {"dwell", times.dwell}};
  json["box"] = nullptr;
  if (!sum.box.empty()) {
    json["box"] = {{"min", {sum.box.left, sum.box.bottom}}, {"max", {sum.box.right, sum.box.top}}};
  }
  return json.dump(2) + "\n";
}

}  // namespace dgt
