// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/nc/path_builder.h"

#include <algorithm>
#include <array>
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

/// Of a run of cuts, those at either end may be leads.
constexpr std::size_t kMaxLead = 2;

/// The cuts of a run, by their number. Those at its ends are kept, as far as anybody asks for them:
/// the leads, and what they lead to.
class Cuts {
 public:
  explicit Cuts(std::span<Move> run) {
    for (Move& move : run) {
      if (!move.cuts()) continue;
      if (count_ < kKept) first_.at(count_) = &move;
      last_.at(count_++ % kKept) = &move;
    }
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] Move& operator[](std::size_t k) const {
    return k < kKept ? *first_.at(k) : *last_.at(k % kKept);
  }

 private:
  static constexpr std::size_t kKept = kMaxLead + 2;

  std::array<Move*, kKept> first_{};
  std::array<Move*, kKept> last_{};  ///< number k at k % kKept
  std::size_t count_ = 0;
};

}  // namespace

PathBuilder::PathBuilder(const SourceFile& file, std::size_t expected) {
  program_.path.files = {file.name()};
  program_.path.moves.reserve(expected);
}

void PathBuilder::start_at(const Spot& start, const SourcePlace& place) {
  program_.placed_by = place;
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

void PathBuilder::arc(const Spot& to, ElementPtr circle, RationalPtr height,
                      const SourcePlace& place) {
  const bool full_circle = to == at_;
  Move& move = travel(MoveKind::Arc, to, std::move(height), place);
  move.full_circle = full_circle;
  move.carrier.base = std::move(circle);
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

bool mark_leads(std::span<Move> run) {
  const Cuts cuts(run);
  const std::size_t count = cuts.count();
  const auto point = [&](std::size_t k) { return k < count ? cuts[k].from : cuts[count - 1].to; };
  for (std::size_t leads = 0; leads <= 2 * kMaxLead; ++leads) {
    for (std::size_t in = 0; in <= std::min(leads, kMaxLead); ++in) {
      const std::size_t out = leads - in;
      if (out > kMaxLead || leads >= count) continue;
      const std::size_t end = count - out;
      const bool is_loop = end - in > 1 || cuts[in].full_circle;
      if (!is_loop || !is_one_place(point(in), point(end))) continue;
      // Out by the way it came in: that is a lead however it ends.
      if (end - in > 2 && is_one_place(point(in + 1), point(end - 1))) continue;
      for (std::size_t k = 0; k < in; ++k) cuts[k].role = Role::LeadIn;
      for (std::size_t k = end; k < count; ++k) cuts[k].role = Role::LeadOut;
      return true;
    }
  }
  return false;
}

std::vector<Contour> contours_of(std::vector<Move>& moves) {
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
    const std::span<Move> run(moves.data() + contour.first, contour.last - contour.first);
    contour.closed = mark_leads(run);
    contours.push_back(std::move(contour));
  }
  return contours;
}

}  // namespace dgt
