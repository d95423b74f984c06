// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "kernel/element.h"
#include "lang/nc/length.h"
#include "lang/nc/program.h"

namespace dgt {

/// The tool path of an NC program as it grows, block by block.
class PathBuilder {
 public:
  /// `expected`: about how many moves there will be.
  PathBuilder(const SourceFile& file, std::size_t expected);

  [[nodiscard]] const Spot& at() const { return at_; }
  [[nodiscard]] std::size_t size() const { return program_.path.moves.size(); }
  [[nodiscard]] ArcSummary& arcs() { return program_.arcs; }
  [[nodiscard]] RationalPtr height() const { return height_; }

  /// Where the program begins; what came before only waited, switched or rose there.
  void start_at(const Spot& start, const SourcePlace& place);
  /// Modal: mm/min, of all moves from here on.
  void set_feed(RationalPtr feed) { feed_ = std::move(feed); }

  /// `height`, of all that travels: the Z reached at the end, in mm; null: unchanged.
  void rapid(const Spot& to, RationalPtr height, const SourcePlace& place);
  void line(const Spot& to, RationalPtr height, const SourcePlace& place);
  /// An arc to `to`; once round when that is where the tool stands.
  void arc(const Spot& to, ElementPtr circle, RationalPtr height, const SourcePlace& place);
  void dwell(RationalPtr seconds, const SourcePlace& place);
  void code(std::string code, const SourcePlace& place);
  /// Acts on the moves to come.
  void switch_kerf(Side side, const Rational& offset, const Range& block);

  [[nodiscard]] NcProgram finish();

 private:
  Move& add(MoveKind kind, const SourcePlace& place);
  Move& travel(MoveKind kind, const Spot& to, RationalPtr height, const SourcePlace& place);

  NcProgram program_;
  Spot at_;
  Point point_;  ///< at_
  RationalPtr height_;
  RationalPtr feed_;
};

/// Gives the first and the last cuts of a run, at most two each, their roles as leads: those before
/// and behind a loop that closes on itself. True when there is such a loop; that is the whole run
/// when it ends where it began.
bool mark_leads(std::span<Move> run);

/// The runs of cuts between rapids as contours without an offset, with their leads marked, in the
/// moves too.
[[nodiscard]] std::vector<Contour> contours_of(std::vector<Move>& moves);

}  // namespace dgt
