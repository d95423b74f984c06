// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/poly.h"

#include <array>
#include <charconv>

#include "kernel/chain.h"
#include "kernel/check.h"

namespace dgt {
namespace {

/// The coordinate itself, or something this near: far below what a double of it can show.
constexpr int kBulgeBits = 160;

RationalPoint near_to(const Point& p) {
  const ExactPoint exact = p.exact();
  return {rational_within(exact.x, -kBulgeBits), rational_within(exact.y, -kBulgeBits)};
}

double bulge_of(const Move& move) {
  if (move.kind != MoveKind::Arc) return 0;
  if (move.full_circle) return move.circle().counter_clockwise() ? 1 : -1;
  return nearest_double(bulge_of(move.circle(), near_to(move.from), near_to(move.to)));
}

/// No double takes more than 1 + 309 digits before the point, or 1 + 1 + 1 + 1074 behind it.
using Digits = std::array<char, 1100>;

void append_plain(std::string& out, double value) {
  Digits digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(),
                                 value == 0 ? 0.0 : value, std::chars_format::fixed);
  DGT_CHECK(end.ec == std::errc());
  out.append(digits.data(), end.ptr);
}

void append_vertex(std::string& out, double x, double y, double bulge) {
  append_plain(out, x);
  out += ' ';
  append_plain(out, y);
  out += ' ';
  append_plain(out, bulge);
  out += '\n';
}

void append_edge(std::string& out, const Move& move) {
  const double bulge = bulge_of(move);
  append_vertex(out, move.from.x(), move.from.y(), bulge);
  if (!move.full_circle) return;
  const RationalPoint from = near_to(move.from);
  const RationalPoint centre = move.circle().centre();
  const Point across(2 * centre - from);
  append_vertex(out, across.x(), across.y(), bulge);
}

}  // namespace

void append_poly(std::string& out, std::span<const Move> moves) {
  DGT_CHECK(!moves.empty());
  const Point& first = moves.front().from;
  const Point& last = moves.back().to;
  const bool closed = first == last;
  if (!out.empty()) out += '\n';
  if (!closed) out += "open\n";
  for (const Move& move : moves) append_edge(out, move);
  if (!closed) append_vertex(out, last.x(), last.y(), 0);
}

}  // namespace dgt
