// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any bytes as a drawing. The first byte chooses order and kerf; the rest is read within small
// bounds, told of in both languages, and what comes out is held against the laws of a tool path.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "kernel/check.h"
#include "lang/dxf/reader.h"
#include "lang/text/render.h"

namespace {

using namespace dgt;

DxfOptions options_of(std::uint8_t choice) {
  DxfOptions options;
  options.max_moves = 300;
  if ((choice & 1) != 0) options.order = DxfOrder::File;
  if ((choice & 2) != 0) options.kerf_width = Rational(3, 10);
  if ((choice & 4) != 0) options.join_tolerance = 1;
  if ((choice & 8) != 0) options.curve_tolerance = Rational(1, 10);
  return options;
}

// Moves meet, and arcs have circles.
void check_path(const Toolpath& path) {
  Point at(path.start);
  for (const Move& move : path.moves) {
    DGT_CHECK(move.from == at);
    DGT_CHECK(move.kind != MoveKind::Arc || move.carrier.base != nullptr);
    DGT_CHECK(move.full_circle || !(move.from == move.to));
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
  const SourceFile file("f.dxf", text);
  DiagnosticBag bag;
  const Toolpath path = read_dxf(file, options_of(*data), ContourOptions{}, bag);
  if (!bag.has_errors()) {
    check_path(path);
    (void)to_text(path);
  }
  for (const Diagnostic& diagnostic : bag.all()) {
    DGT_CHECK(diagnostic.range.file == &file);
    DGT_CHECK(diagnostic.range.begin <= diagnostic.range.end);
    DGT_CHECK(diagnostic.range.end <= file.text().size());
  }
  bag.sort();
  (void)render(bag, {Language::English, Colour::Plain});
  (void)render(bag, {Language::Russian, Colour::Ansi});
  return 0;
}
