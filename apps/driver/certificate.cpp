// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/certificate.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

namespace dgt {
namespace {

using Kind = VerifyFault::Kind;

/// With six decimals, never below `value`: a bound stays one.
std::string above(double value) {
  constexpr double kSteps = 1e6;
  if (!std::isfinite(value)) return "∞";
  return fmt::format("{:.6f}", std::ceil(value * kSteps) / kSteps);
}

struct Words {
  const char* proved;
  const char* failed;
  const char* against;
  const char* deviation;
  const char* position;
  const char* drift;
  const char* moves;
  const char* by_control;
  const char* meets;
  const char* beside;
  const char* moved;
  const char* both;
  const char* closure;
  const char* gouges;
  const char* no_gouges;
  const char* arcs;
  const char* incomplete;
  const char* line;
  const char* lines;
  const char* nowhere;
  const char* meant;
};

constexpr Words kEnglish = {
    "PROVED: {} runs the path of {}\n",
    "NOT PROVED: {} does not run the path of {}\n",
    "  control    {}, unit {} mm\n",
    "  distance   at most {} mm between the two curves, both ways (allowed {}), line {}\n",
    "  position   at most X {} (line {}), Y {} (line {}) mm at every stop (allowed {})\n",
    "  drift      at most X {}, Y {} mm at the end\n",
    "  moves      {} compared, {} of them too small to be written\n",
    "  offset     {} contours by the control, which goes {}; at most {} mm off at every stop (line "
    "{}, "
    "allowed {})\n",
    "to where the offsets of lead and contour meet",
    "beside the beginning of the contour",
    "where the contour begins when all of it is moved",
    "to where the offsets of lead and contour meet, or beside the beginning",
    "  closed     {} contours, {} of them open as written\n",
    "  gouges     {} contours with an offset, {} gouges; beyond the distance above none is "
    "possible\n",
    "  gouges     no contour has an offset\n",
    "  arcs       {} read, their two radii differ by at most {} mm (allowed {}){}\n",
    "  what follows the first fault was not all compared\n",
    "line {}: ",
    "lines {} to {}: ",
    "",
    " (written for {}:{}:{})"};
constexpr Words kRussian = {
    "ДОКАЗАНО: {} проходит траекторию {}\n",
    "НЕ ДОКАЗАНО: {} не проходит траекторию {}\n",
    "  станок      {}, дискрета {} мм\n",
    "  расстояние  не больше {} мм между кривыми в обе стороны (допустимо {}), строка {}\n",
    "  положение   не больше X {} (строка {}), Y {} (строка {}) мм в каждой точке (допустимо {})\n",
    "  накопление  не больше X {}, Y {} мм в конце\n",
    "  перемещения сравнено {}, из них слишком малы для записи {}\n",
    "  коррекция   контуров {}, станок выходит {}; отклонение не больше {} мм в каждой точке "
    "(строка "
    "{}, допустимо {})\n",
    "туда, где сходятся эквидистанты подхода и контура",
    "на нормаль к началу контура",
    "в начало контура, сдвинутого целиком",
    "туда, где сходятся эквидистанты подхода и контура, или на нормаль к началу",
    "  замкнутые   контуров {}, из них не замкнуты в записи {}\n",
    "  подрезы     контуров с эквидистантой {}, подрезов {}; сверх расстояния выше невозможны\n",
    "  подрезы     эквидистант нет\n",
    "  дуги        прочитано {}, радиусы концов расходятся не больше чем на {} мм (допустимо "
    "{}){}\n",
    "  после первой ошибки сравнено не всё\n",
    "строка {}: ",
    "строки {}–{}: ",
    "",
    " (записано для {}:{}:{})"};

/// What a fault says; {0} dx, {1} dy, {2} measure in mm, {3} the allowed value, {4} the contour.
const char* sentence(Kind kind, bool russian) {
  switch (kind) {
    case Kind::Start:
      return russian ? "начинается в стороне от траектории на X {0} Y {1} мм; допустимо ±{3}"
                     : "begins beside the path by X {0} Y {1} mm; ±{3} is allowed on each axis";
    case Kind::Displaced:
      return russian ? "точка смещена от траектории на X {0} Y {1} мм; допустимо ±{3} по каждой оси"
                     : "stops beside the path by X {0} Y {1} mm; ±{3} is allowed on each axis";
    case Kind::Deviates:
      return russian ? "отходит от траектории до {2} мм; допустимо {3}"
                     : "runs beside the path by up to {2} mm; {3} is allowed";
    case Kind::WrongKind:
      return russian ? "режет там, где траектория идёт вхолостую, или наоборот"
                     : "cuts where the path is rapid, or the other way about";
    case Kind::Lost:
      return russian ? "дальше программа не похожа на траекторию"
                     : "from here on the program does not resemble the path";
    case Kind::Ended:
      return russian ? "программа кончается раньше траектории" : "the program ends before the path";
    case Kind::Surplus:
      return russian ? "программа продолжается после конца траектории"
                     : "the program goes on behind the end of the path";
    case Kind::Height:
      return russian ? "высота отличается на Z {0} мм; допустимо ±{3}"
                     : "the height is off by Z {0} mm; ±{3} is allowed";
    case Kind::Open:
      return russian ? "контур {4} не замкнут: конец от начала на X {0} Y {1} мм"
                     : "contour {4} does not close: its end lies X {0} Y {1} mm from its beginning";
    case Kind::Gouge:
      return russian ? "инструмент подрезает контур уже на точной траектории"
                     : "the tool cuts into its contour on the exact path already";
    case Kind::RadiusMismatch:
      return russian ? "радиусы концов дуги расходятся на {2} мм; станок принимает до {3}"
                     : "the two radii of the arc differ by {2} mm; the control takes up to {3}";
    case Kind::EndOpen:
      break;
  }
  return russian
             ? "разные станки закончат этот кадр в точках до {2} мм друг от друга; допустимо {3}"
             : "controls end this block up to {2} mm apart; {3} is allowed";
}

std::string allowed(const Certificate& proof, Kind kind) {
  const VerifyLimits& limits = proof.limits;
  if (kind == Kind::Deviates) return to_short_decimal(limits.deviation);
  if (kind == Kind::RadiusMismatch) return to_short_decimal(limits.radius_mismatch);
  if (kind == Kind::EndOpen) return to_short_decimal(limits.unit);
  return to_short_decimal(Rational(limits.unit / 2));
}

std::string file_of(const Certificate& proof, const SourcePlace& place) {
  return place.file < proof.files.size() ? proof.files[place.file] : proof.against;
}

std::size_t count(const Certificate& proof, Kind kind) {
  std::size_t found = 0;
  for (const VerifyFault& fault : proof.faults)
    if (fault.kind == kind) ++found;
  return found;
}

class Page {
 public:
  Page(const Certificate& proof, Language language)
      : proof_(proof),
        is_russian_(language == Language::Russian),
        words_(is_russian_ ? kRussian : kEnglish) {}

  std::string run() {
    append(proof_.holds() ? words_.proved : words_.failed, proof_.program, proof_.against);
    for (const VerifyFault& fault : proof_.faults) {
      out_ += "  ! ";
      add(fault);
      out_ += '\n';
    }
    if (!proof_.is_complete) append(words_.incomplete);
    add_figures();
    return std::move(out_);
  }
  std::string run(const VerifyFault& fault) {
    add(fault);
    return std::move(out_);
  }

 private:
  template <class... Values>
  void append(const char* format, const Values&... values) {
    fmt::format_to(std::back_inserter(out_), fmt::runtime(format), values...);
  }

  void add(const VerifyFault& fault) {
    if (fault.first_line != fault.last_line) {
      append(words_.lines, fault.first_line, fault.last_line);
    } else if (fault.first_line != 0) {
      append(words_.line, fault.first_line);
    }
    append(sentence(fault.kind, is_russian_), signed_length(fault.dx), signed_length(fault.dy),
           above(fault.measure), allowed(proof_, fault.kind), fault.contour);
    const SourcePlace& source = fault.source;
    if (source.line != 0) append(words_.meant, file_of(proof_, source), source.line, source.column);
  }

  static std::string signed_length(double millimetres) {
    return fmt::format("{:+.6f}", millimetres);
  }

  void add_figures() {
    const VerifyLimits& limits = proof_.limits;
    append(words_.against, proof_.dialect, to_short_decimal(limits.unit));
    append(words_.deviation, above(proof_.deviation.value), to_short_decimal(limits.deviation),
           proof_.deviation.line);
    append(words_.position, above(proof_.error_x.value), proof_.error_x.line,
           above(proof_.error_y.value), proof_.error_y.line,
           to_short_decimal(Rational(limits.unit / 2)));
    append(words_.drift, above(proof_.drift_x), above(proof_.drift_y));
    append(words_.moves, proof_.moves, proof_.omitted);
    if (proof_.by_control > 0)
      append(words_.by_control, proof_.by_control, way(), above(proof_.control_error.value),
             proof_.control_error.line, to_short_decimal(limits.deviation));
    append(words_.closure, proof_.closed, count(proof_, Kind::Open));
    if (proof_.guarded > 0) {
      append(words_.gouges, proof_.guarded, count(proof_, Kind::Gouge));
    } else {
      append(words_.no_gouges);
    }
    std::string at;
    if (proof_.mismatch.line != 0)
      at = fmt::format(fmt::runtime(is_russian_ ? ", строка {}" : ", line {}"),
                       proof_.mismatch.line);
    append(words_.arcs, proof_.arcs, above(proof_.mismatch.value),
           to_short_decimal(limits.radius_mismatch), at);
  }

  const char* way() const {
    if (proof_.leads.size() > 1) return words_.both;
    switch (proof_.leads.front()) {
      case KerfLead::Meets:
        return words_.meets;
      case KerfLead::Beside:
        return words_.beside;
      case KerfLead::Moved:
        break;
    }
    return words_.moved;
  }

  const Certificate& proof_;
  const bool is_russian_;
  const Words& words_;
  std::string out_;
};

// --- JSON

using Json = nlohmann::ordered_json;

Json bound(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json lines(std::uint32_t first, std::uint32_t last) {
  return first == 0 ? Json(nullptr) : Json({first, last});
}

Json place(const Certificate& proof, const SourcePlace& source) {
  if (source.line == 0) return nullptr;
  return {{"file", file_of(proof, source)}, {"line", source.line}, {"column", source.column}};
}

Json leads(const Certificate& proof) {
  Json all = Json::array();
  for (const KerfLead lead : proof.leads)
    all.push_back(lead == KerfLead::Meets    ? "meets"
                  : lead == KerfLead::Beside ? "beside"
                                             : "moved");
  return all;
}

Json faults(const Certificate& proof) {
  Json all = Json::array();
  for (const VerifyFault& fault : proof.faults) {
    all.push_back({{"kind", name_of(fault.kind)},
                   {"lines", lines(fault.first_line, fault.last_line)},
                   {"source", place(proof, fault.source)},
                   {"dx", fault.dx},
                   {"dy", fault.dy},
                   {"measure", bound(fault.measure)}});
  }
  return all;
}

/// One line a block; a tree of a million of them would take gigabytes.
void append_blocks(std::string& out, const Certificate& proof) {
  const char* separator = "\n";
  for (const Certificate::Row& row : proof.rows) {
    const Json json = {{"lines", lines(row.first_line, row.last_line)},
                       {"source", place(proof, row.source)},
                       {"deviation", bound(row.deviation)},
                       {"error", {bound(row.error_x), bound(row.error_y)}}};
    out += separator;
    out += "    " + json.dump();
    separator = ",\n";
  }
}

}  // namespace

std::string to_text(const Certificate& proof, Language language) {
  return Page(proof, language).run();
}

std::string to_text(const VerifyFault& fault, const Certificate& proof, Language language) {
  return Page(proof, language).run(fault);
}

std::string to_json(const Certificate& proof) {
  const VerifyLimits& limits = proof.limits;
  const double half = nearest_double(Rational(limits.unit / 2));
  const Json json = {
      {"schema", "dgt-verify/1"},
      {"units", "mm"},
      {"verified", proof.holds()},
      {"program", proof.program},
      {"against", proof.against},
      {"dialect", proof.dialect},
      {"unit", nearest_double(limits.unit)},
      {"complete", proof.is_complete},
      {"moves", proof.moves},
      {"omitted", proof.omitted},
      {"deviation",
       {{"bound", bound(proof.deviation.value)},
        {"limit", nearest_double(limits.deviation)},
        {"line", proof.deviation.line}}},
      {"position",
       {{"x", bound(proof.error_x.value)},
        {"y", bound(proof.error_y.value)},
        {"limit", half},
        {"line_x", proof.error_x.line},
        {"line_y", proof.error_y.line}}},
      {"drift", {bound(proof.drift_x), bound(proof.drift_y)}},
      {"control",
       {{"contours", proof.by_control},
        {"leads", leads(proof)},
        {"stops", bound(proof.control_error.value)},
        {"limit", nearest_double(limits.deviation)},
        {"line", proof.control_error.line}}},
      {"closure", {{"contours", proof.closed}, {"open", count(proof, Kind::Open)}}},
      {"gouges", {{"contours", proof.guarded}, {"found", count(proof, Kind::Gouge)}}},
      {"arcs",
       {{"count", proof.arcs},
        {"mismatch", bound(proof.mismatch.value)},
        {"limit", nearest_double(limits.radius_mismatch)},
        {"line", proof.mismatch.line}}},
      {"faults", faults(proof)}};
  std::string out = json.dump(2);
  out.resize(out.rfind('\n'));
  out += ",\n  \"blocks\": [";
  append_blocks(out, proof);
  out += "\n  ]\n}\n";
  return out;
}

}  // namespace dgt
