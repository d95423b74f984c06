// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/dxf/reader.h"

#include <memory>
#include <utility>

#include "lang/dxf/chaining.h"
#include "lang/dxf/nesting.h"
#include "lang/nc/kerf_messages.h"
#include "lang/nc/path_builder.h"

namespace dgt {
namespace {

SourcePlace place_of(const Range& range) {
  const Place place = range.place();
  return {0, place.line, place.column};
}

std::vector<Move> moves_along(const DxfContour& contour) {
  std::vector<Move> moves;
  for (const DxfPiece& piece : contour.pieces) {
    Move move;
    move.from = moves.empty() ? Point(piece.from) : moves.back().to;
    move.to = Point(piece.to);
    if (piece.circle) {
      move.kind = MoveKind::Arc;
      move.full_circle = piece.is_whole_circle();
      move.carrier.base = ElementPtr(*piece.circle);
    }
    move.source = place_of(piece.place);
    moves.push_back(std::move(move));
  }
  if (contour.closed) moves.back().to = moves.front().from;
  return moves;
}

class DxfPath {
 public:
  DxfPath(const SourceFile& file, std::vector<DxfContour> contours, const DxfOptions& options,
          const ContourOptions& contour_options, DiagnosticBag& bag)
      : file_(file),
        contours_(std::move(contours)),
        options_(options),
        contour_options_(contour_options),
        bag_(bag) {
    path_.files = {file.name()};
  }

  Toolpath as_drawn() {
    for (const DxfContour& contour : contours_) {
      std::vector<Move> moves = moves_along(contour);
      const bool closed = mark_leads(moves);
      append(moves, moves, closed, {});
    }
    return std::move(path_);
  }

  Toolpath from_inside() {
    const Nesting nesting = nesting_of(contours_);
    const bool offsets = options_.apply_kerf && sgn(options_.kerf_width) > 0;
    if (offsets) tell_kerf(nesting);
    for (const std::size_t i : inside_out(contours_, nesting)) {
      const bool turns = runs_the_other_way(contours_[i], nesting.depth[i]);
      const DxfContour contour = turns ? turned_round(contours_[i]) : contours_[i];
      const std::vector<Move> moves = moves_along(contour);
      if (offsets && contour.closed)
        append_offset(moves, contour, nesting.depth[i]);
      else
        append(moves, moves, contour.closed, {});
    }
    return std::move(path_);
  }

 private:
  struct Offset {
    Rational distance;
    Side side = Side::None;
  };

  /// Against the direction that is wanted; a contour of no area has none.
  [[nodiscard]] bool runs_the_other_way(const DxfContour& contour, std::size_t depth) const {
    if (options_.direction == DxfDirection::Drawn || !contour.closed) return false;
    const double area = doubled_area(contour);
    const bool part_left = (area > 0) == (depth % 2 == 0);
    return area != 0 && part_left != (options_.direction == DxfDirection::PartLeft);
  }

  /// The other way from the same place.
  static DxfContour turned_round(const DxfContour& contour) {
    DxfContour turned;
    turned.closed = contour.closed;
    for (auto piece = contour.pieces.rbegin(); piece != contour.pieces.rend(); ++piece)
      turned.pieces.push_back(reversed(*piece));
    return turned;
  }

  void tell_kerf(const Nesting& nesting) {
    std::size_t outer = 0;
    std::size_t holes = 0;
    std::size_t open = 0;
    const DxfContour* first_open = nullptr;
    for (std::size_t i = 0; i < contours_.size(); ++i) {
      if (!contours_[i].closed) {
        if (open++ == 0) first_open = &contours_[i];
      } else {
        ++(nesting.depth[i] % 2 == 0 ? outer : holes);
      }
    }
    bag_.add({Message::DxfKerf,
              contours_.front().pieces.front().place,
              {to_short_decimal(options_.kerf_width / 2), std::to_string(outer),
               std::to_string(holes)}});
    if (first_open != nullptr)
      bag_.add({Message::DxfKerfOpen, first_open->pieces.front().place, {std::to_string(open)}});
  }

  void append_offset(const std::vector<Move>& programmed, const DxfContour& contour,
                     std::size_t depth) {
    const double area = doubled_area(contour);
    const Range& place = contour.pieces.front().place;
    if (area == 0) {
      bag_.add({Message::DxfNoInside, place, {}});
      return;
    }
    const bool outside = depth % 2 == 0;
    const Side side = (area > 0) == outside ? Side::Right : Side::Left;
    const Rational distance = options_.kerf_width / 2;
    const BuiltContour built = build_equidistant(programmed, distance, side, contour_options_);
    NcProgram program;  // where the messages look for the lines of moves
    program.path.moves = programmed;
    KerfMessages(file_, program, bag_).report(built, 0);
    if (!built.faults.empty() || built.moves.empty()) return;
    append(programmed, built.moves, true, {distance, side});
  }

  void append(const std::vector<Move>& programmed, const std::vector<Move>& moves, bool closed,
              const Offset& offset) {
    Contour contour;
    contour.id = static_cast<unsigned>(path_.contours.size() + 1);
    contour.closed = closed;
    if (offset.side != Side::None) contour.programmed = programmed;
    contour.offset = offset.distance;
    contour.side = offset.side;
    const Move& first = moves.front();
    if (path_.contours.empty()) {
      // Where the drawing begins; an equidistant mostly begins at no rational point.
      at_ = programmed.front().from;
      const ExactPoint start = at_.exact();
      path_.start = {start.x.a, start.y.a};
    }
    if (!(first.from == at_)) add_rapid(first);
    contour.first = path_.moves.size();
    path_.moves.insert(path_.moves.end(), moves.begin(), moves.end());
    contour.last = path_.moves.size();
    at_ = path_.moves.back().to;
    path_.contours.push_back(std::move(contour));
  }

  void add_rapid(const Move& to) {
    Move rapid;
    rapid.kind = MoveKind::Rapid;
    rapid.role = Role::Position;
    rapid.from = at_;
    rapid.to = to.from;
    rapid.source = to.source;
    path_.moves.push_back(std::move(rapid));
  }

  const SourceFile& file_;
  std::vector<DxfContour> contours_;
  const DxfOptions& options_;
  const ContourOptions& contour_options_;
  DiagnosticBag& bag_;
  Toolpath path_;
  Point at_;
};

}  // namespace

Toolpath read_dxf(const SourceFile& file, const DxfOptions& options, const ContourOptions& contour,
                  DiagnosticBag& bag) {
  const DxfDrawing drawing = read_dxf_drawing(file, bag);
  if (bag.has_errors()) return {};
  std::vector<DxfStrand> strands = strands_of(drawing, file, options, bag);
  if (bag.has_errors()) return {};
  const DxfOrder order =
      options.order.value_or(drawing.is_of_dgt ? DxfOrder::File : DxfOrder::InsideOut);
  const bool as_drawn = order == DxfOrder::File;
  std::vector<DxfContour> contours = as_drawn ? in_drawn_order(std::move(strands), options, bag)
                                              : chained(std::move(strands), options, bag);
  if (contours.empty()) return {};
  DxfPath path(file, std::move(contours), options, contour, bag);
  return as_drawn ? path.as_drawn() : path.from_inside();
}

}  // namespace dgt
