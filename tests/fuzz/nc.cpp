// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any bytes as an NC program. The first byte chooses ESSI, its Iso kin, G-code or 3B, and whether
// arcs are repaired; the rest is read within small bounds, its kerf applied, told of in both
// languages, and what comes out is held against the laws of a tool path.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "kernel/check.h"
#include "lang/essi/reader.h"
#include "lang/gcode/reader.h"
#include "lang/nc/kerf.h"
#include "lang/text/fixes.h"
#include "lang/text/render.h"
#include "lang/three_b/reader.h"

namespace {

using namespace dgt;

NcOptions small_bounds(std::uint8_t choice) {
  NcOptions options;
  options.repair = (choice & 4) != 0;
  options.kerf_width = (choice & 8) != 0 ? Rational(3, 10) : Rational(0);
  options.max_moves = 300;
  options.max_blocks = 300;
  return options;
}

NcProgram read(const SourceFile& file, std::uint8_t choice, DiagnosticBag& bag) {
  if ((choice & 16) != 0) {
    ThreeBOptions options;
    options.nc = small_bounds(choice);
    if ((choice & 1) != 0) options.pause = ThreeBPause::Stop;
    if ((choice & 2) != 0) options.unit = Rational(1, 3);
    if ((choice & 4) != 0) options.end_tolerance = 10;
    return read_three_b(file, options, bag);
  }
  if ((choice & 1) != 0) {
    GcodeOptions options;
    options.nc = small_bounds(choice);
    options.begins_incremental = (choice & 2) != 0;
    return read_gcode(file, options, bag);
  }
  EssiOptions options;
  options.nc = small_bounds(choice);
  if ((choice & 2) != 0) options.dialect = EssiDialect::Iso;
  return read_essi(file, options, bag);
}

void check_places(const DiagnosticBag& bag) {
  const auto is_inside = [](const Range& range) {
    return range.file != nullptr && range.begin <= range.end &&
           range.end <= range.file->text().size();
  };
  for (const Diagnostic& diagnostic : bag.all()) {
    DGT_CHECK(is_inside(diagnostic.range));
    for (const Note& note : diagnostic.notes) DGT_CHECK(is_inside(note.range));
    if (diagnostic.fix_it) DGT_CHECK(is_inside(diagnostic.fix_it->range));
  }
}

// Moves meet, and arcs have the circles that their ends lie on.
void check_path(const Toolpath& path) {
  Point at(path.start);
  for (const Move& move : path.moves) {
    DGT_CHECK(move.from == at);
    DGT_CHECK(move.kind != MoveKind::Arc || move.carrier.base.get() != nullptr);
    at = move.to;
  }
  for (const Contour& contour : path.contours) {
    DGT_CHECK(contour.first < contour.last && contour.last <= path.moves.size());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const SourceFile file("f.nc", text);
  DiagnosticBag bag;
  NcProgram program = read(file, *data, bag);
  if (!bag.has_errors()) {
    const Toolpath path = with_kerf(file, std::move(program), ContourOptions{}, bag);
    if (!bag.has_errors()) {
      check_path(path);
      (void)to_text(path);
    }
  }
  check_places(bag);
  bag.sort();
  (void)render(bag, {Language::English, Colour::Plain});
  (void)render(bag, {Language::Russian, Colour::Ansi});
  (void)apply_fixes(file, bag);
  return 0;
}
