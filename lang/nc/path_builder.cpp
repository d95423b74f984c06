// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/nc/path_builder.h"

#include <cmath>
#include <memory>
#include <utility>

namespace dgt {
namespace {

/// What lies nearer together is one place: far above what stand-ins of turned subprograms leave,
/// far below the unit of any control. Unit: mm.
constexpr double kOnePlace = 1e-9;

bool is_one_place(const Point& a, const Point& b) {
  return std::fabs(a.x() - b.x()) <= kOnePlace && std::fabs(a.y() - b.y()) <= kOnePlace;
}

}  // namespace

PathBuilder::PathBuilder(const SourceFile& file, std::size_t expected) {
  program_.path.files = {file.name()};
  program_.path.moves.reserve(expected);
}

void PathBuilder::start_at(const Spot& start) {
  at_ = start;
  point_ = start.point();
  program_.path.start = start.exact();
  for (Move& move : program_.path.moves) move.from = move.to = point_;
}

void PathBuilder::rapid(const Spot& to, RationalPtr height, const SourcePlace& place) {
  travel(MoveKind::Rapid, to, std::move(height), place).role = Role::Position;
}

void PathBuilder::line(const Spot& to, RationalPtr height, const SourcePlace& place) {
  travel(MoveKind::Line, to, std::move(height), place);
}

void PathBuilder::arc(const Spot& to, const Circle& circle, RationalPtr height,
                      const SourcePlace& place) {
  const bool full_circle = to == at_;
  Move& move = travel(MoveKind::Arc, to, std::move(height), place);
  move.full_circle = full_circle;
  move.carrier.base = std::make_shared<const Element>(circle);
}

void PathBuilder::dwell(RationalPtr seconds, const SourcePlace& place) {
  Move& move = add(MoveKind::Dwell, place);
  move.to = point_;
  move.seconds = std::move(seconds);
}

void PathBuilder::code(std::string code, const SourcePlace& place) {
  Move& move = add(MoveKind::Code, place);
  move.to = point_;
  move.code = std::move(code);
}

void PathBuilder::switch_kerf(Side side, const Rational& offset, const Range& block) {
  program_.kerf.push_back({size(), side, offset, block});
}

NcProgram PathBuilder::finish() { return std::move(program_); }

Move& PathBuilder::add(MoveKind kind, const SourcePlace& place) {
  Move& move = program_.path.moves.emplace_back();
  move.kind = kind;
  move.from = point_;
  move.source = place;
  return move;
}

Move& PathBuilder::travel(MoveKind kind, const Spot& to, RationalPtr height,
                          const SourcePlace& place) {
  Move& move = add(kind, place);
  if (height) height_ = height;
  move.z = std::move(height);
  move.feed = feed_;
  at_ = to;
  point_ = to.point();
  move.to = point_;
  return move;
}

std::vector<Contour> contours_of(const std::vector<Move>& moves) {
  std::vector<Contour> contours;
  std::size_t i = 0;
  while (i < moves.size()) {
    if (!moves[i].cuts()) {
      ++i;
      continue;
    }
    Contour contour;
    contour.id = static_cast<unsigned>(contours.size() + 1);
    contour.first = i;
    // Dwells and codes inside belong to the contour, those behind it do not.
    for (; i < moves.size() && moves[i].kind != MoveKind::Rapid; ++i)
      if (moves[i].cuts()) contour.last = i + 1;
    const Move& first = moves[contour.first];
    contour.closed = is_one_place(first.from, moves[contour.last - 1].to);
    const auto begin = moves.begin();
    contour.programmed.assign(begin + static_cast<std::ptrdiff_t>(contour.first),
                              begin + static_cast<std::ptrdiff_t>(contour.last));
    contours.push_back(std::move(contour));
  }
  return contours;
}

}  // namespace dgt
