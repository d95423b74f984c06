// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/toolpath.h"

#include <mpfr.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "kernel/check.h"
#include "kernel/mpfr_float.h"
#include "kernel/place_order.h"

namespace dgt {
namespace {

constexpr mpfr_prec_t kMeasureBits = 128;

/// out = the angle from `from` to `to` about the circle's centre, in radians, signed by its sense.
void sweep_radians(mpfr_ptr out, const Circle& circle, const Point& from, const Point& to) {
  const double cx = nearest_double(circle.centre().x);
  const double cy = nearest_double(circle.centre().y);
  const auto off = [](mpfr_ptr result, double at, double centre) {
    mpfr_set_d(result, at, MPFR_RNDN);
    mpfr_sub_d(result, result, centre, MPFR_RNDN);
  };
  MpfrFloat ux(kMeasureBits);
  MpfrFloat uy(kMeasureBits);
  MpfrFloat vx(kMeasureBits);
  MpfrFloat vy(kMeasureBits);
  off(ux, from.x(), cx);
  off(uy, from.y(), cy);
  off(vx, to.x(), cx);
  off(vy, to.y(), cy);
  MpfrFloat across(kMeasureBits);
  MpfrFloat along(kMeasureBits);
  mpfr_fmms(across, ux, vy, uy, vx, MPFR_RNDN);
  mpfr_fmma(along, ux, vx, uy, vy, MPFR_RNDN);
  mpfr_atan2(out, across, along, MPFR_RNDN);
  const bool ccw = circle.counter_clockwise();
  if ((ccw && mpfr_sgn(out) < 0) || (!ccw && mpfr_sgn(out) > 0)) {
    mpfr_const_pi(along, MPFR_RNDN);
    mpfr_mul_ui(along, along, 2, MPFR_RNDN);
    if (ccw)
      mpfr_add(out, out, along, MPFR_RNDN);
    else
      mpfr_sub(out, out, along, MPFR_RNDN);
  }
}

void arc_radians(mpfr_ptr out, const Move& arc) {
  if (!arc.full_circle) {
    sweep_radians(out, arc.circle(), arc.from, arc.to);
    return;
  }
  mpfr_const_pi(out, MPFR_RNDN);
  mpfr_mul_si(out, out, arc.circle().counter_clockwise() ? 2 : -2, MPFR_RNDN);
}

void length_of(mpfr_ptr out, const Move& move) {
  if (!move.travels()) {
    mpfr_set_zero(out, 1);
    return;
  }
  MpfrFloat other(kMeasureBits);
  if (move.kind == MoveKind::Arc) {
    arc_radians(out, move);
    mpfr_set_q(other, move.circle().radius().get_mpq_t(), MPFR_RNDN);
    mpfr_mul(out, out, other, MPFR_RNDN);
    mpfr_abs(out, out, MPFR_RNDN);
    return;
  }
  mpfr_set_d(out, move.to.x(), MPFR_RNDN);
  mpfr_sub_d(out, out, move.from.x(), MPFR_RNDN);
  mpfr_set_d(other, move.to.y(), MPFR_RNDN);
  mpfr_sub_d(other, other, move.from.y(), MPFR_RNDN);
  mpfr_hypot(out, out, other, MPFR_RNDN);
}

/// A way that also rises: on a helix, too, the two are square to each other all along.
void lengthen(mpfr_ptr length, const Rational& rise) {
  MpfrFloat up(kMeasureBits);
  mpfr_set_q(up, rise.get_mpq_t(), MPFR_RNDN);
  mpfr_hypot(length, length, up, MPFR_RNDN);
}

// --- the printed form ---------------------------------------------------------------------------

std::string fixed(double value) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.6f", value);
  std::string text = buffer.data();
  return text == "-0.000000" ? "0.000000" : text;
}

std::string place_text(const Point& p) { return "X" + fixed(p.x()) + " Y" + fixed(p.y()); }

std::string move_text(const Move& move) {
  std::string text = name_of(move.kind);
  if (move.kind == MoveKind::Code) return text + " " + move.code;
  if (move.kind == MoveKind::Dwell) return text + " " + to_short_decimal(*move.seconds) + " s";
  text += " " + place_text(move.to);
  if (move.kind == MoveKind::Arc) {
    const Circle circle = move.circle();
    text += " centre " + place_text(Point(circle.centre())) + " radius " +
            fixed(std::fabs(nearest_double(circle.radius()))) + " sweep " +
            fixed(sweep_degrees(move));
  }
  if (move.z) text += " Z" + to_short_decimal(*move.z);
  if (move.feed && move.kind != MoveKind::Rapid) text += " F" + to_short_decimal(*move.feed);
  return text + " " + name_of(move.role);
}

std::string source_text(const Toolpath& path, const SourcePlace& place) {
  if (place.line == 0) return "";
  std::string text = "  ; ";
  if (place.file < path.files.size()) text += path.files[place.file] + ":";
  return text + std::to_string(place.line) + ":" + std::to_string(place.column);
}

std::string contour_text(const Contour& contour) {
  return "contour " + std::to_string(contour.id) + " offset " + to_short_decimal(contour.offset) +
         " side " + name_of(contour.side) + (contour.closed ? " closed" : " open") + "\n";
}

}  // namespace

std::span<const Move> moves_of(const Toolpath& path, const Contour& contour) {
  return std::span(path.moves).subspan(contour.first, contour.last - contour.first);
}

std::span<const Move> programmed_moves(const Toolpath& path, const Contour& contour) {
  if (contour.programmed) return *contour.programmed;
  return moves_of(path, contour);
}

bool is_part(const Move& move) {
  if (!move.cuts()) return false;
  return move.role == Role::Contour || move.role == Role::Fillet || move.role == Role::Chamfer ||
         move.role == Role::Tangent || move.role == Role::Corner;
}

int half_turn_order(const Move& arc) {
  if (arc.full_circle) return 1;
  const Circle circle = arc.circle();
  const int sense = circle.counter_clockwise() ? 1 : -1;
  return -sense * turn_about(circle.centre(), arc.from, arc.to);
}

double sweep_degrees(const Move& arc) {
  DGT_CHECK(arc.kind == MoveKind::Arc);
  if (arc.full_circle) return arc.circle().counter_clockwise() ? 360 : -360;
  MpfrFloat sweep(kMeasureBits);
  MpfrFloat pi(kMeasureBits);
  arc_radians(sweep, arc);
  mpfr_const_pi(pi, MPFR_RNDN);
  mpfr_mul_ui(sweep, sweep, 180, MPFR_RNDN);
  mpfr_div(sweep, sweep, pi, MPFR_RNDN);
  return mpfr_get_d(sweep, MPFR_RNDN);
}

double length(const Move& move) {
  MpfrFloat length(kMeasureBits);
  length_of(length, move);
  return mpfr_get_d(length, MPFR_RNDN);
}

Lengths lengths(std::span<const Move> moves) {
  MpfrFloat cut(kMeasureBits);
  MpfrFloat rapid(kMeasureBits);
  MpfrFloat one(kMeasureBits);
  mpfr_set_zero(cut, 1);
  mpfr_set_zero(rapid, 1);
  Rational height;
  for (const Move& move : moves) {
    length_of(one, move);
    if (move.z && *move.z != height) {
      lengthen(one, *move.z - height);
      height = *move.z;
    }
    if (move.kind == MoveKind::Rapid)
      mpfr_add(rapid, rapid, one, MPFR_RNDN);
    else
      mpfr_add(cut, cut, one, MPFR_RNDN);
  }
  return {mpfr_get_d(cut, MPFR_RNDN), mpfr_get_d(rapid, MPFR_RNDN)};
}

std::string to_text(const Toolpath& path) {
  std::string text = "start " + place_text(Point(path.start)) + "\n";
  std::size_t contour = 0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    while (contour < path.contours.size() && path.contours[contour].first == i)
      text += contour_text(path.contours[contour++]);
    text += std::to_string(i + 1) + " " + move_text(path.moves[i]) +
            source_text(path, path.moves[i].source) + "\n";
  }
  while (contour < path.contours.size()) text += contour_text(path.contours[contour++]);
  return text;
}

const char* name_of(MoveKind kind) {
  switch (kind) {
    case MoveKind::Line:
      return "line";
    case MoveKind::Arc:
      return "arc";
    case MoveKind::Rapid:
      return "rapid";
    case MoveKind::Dwell:
      return "dwell";
    case MoveKind::Code:
      return "code";
  }
  return "";
}

const char* name_of(Role role) {
  switch (role) {
    case Role::LeadIn:
      return "lead-in";
    case Role::Contour:
      return "contour";
    case Role::Fillet:
      return "fillet";
    case Role::Chamfer:
      return "chamfer";
    case Role::Tangent:
      return "tangent";
    case Role::LeadOut:
      return "lead-out";
    case Role::Position:
      return "position";
    case Role::Thread:
      return "thread";
    case Role::Corner:
      return "corner";
  }
  return "";
}

const char* name_of(Side side) {
  switch (side) {
    case Side::Left:
      return "left";
    case Side::Right:
      return "right";
    case Side::None:
      return "none";
  }
  return "";
}

}  // namespace dgt
