// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/control_offset.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "post/control_entry.h"

namespace dgt {
namespace {

using FaultKind = WriteFault::Kind;

/// Of travel, where a cut begins.
struct Direction {
  double x = 0;
  double y = 0;
};
Direction direction_of(const Move& m) {
  if (m.kind == MoveKind::Line) {
    const double dx = m.to.x() - m.from.x();
    const double dy = m.to.y() - m.from.y();
    const double length = std::hypot(dx, dy);
    return length > 0 ? Direction{dx / length, dy / length} : Direction{};
  }
  const Circle circle = m.circle();
  const double x = m.from.x() - nearest_double(circle.centre().x);
  const double y = m.from.y() - nearest_double(circle.centre().y);
  const double radius = std::hypot(x, y);
  const double sense = circle.counter_clockwise() ? 1 : -1;
  return {-sense * y / radius, sense * x / radius};
}

/// Of the contour's own cuts: those along its elements.
bool is_along(const Move& move) { return move.cuts() && is_part(move) && move.carrier.base; }

/// The cuts of one contour that matter, as places in its moves.
struct Parts {
  std::optional<std::size_t> lead;   ///< the last move before the contour
  std::optional<std::size_t> first;  ///< of the contour itself
  std::size_t last = 0;
};
Parts parts_of(std::span<const Move> moves) {
  Parts parts;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (is_along(moves[i])) {
      if (!parts.first) parts.first = i;
      parts.last = i;
    } else if (moves[i].travels() && !parts.first) {
      parts.lead = i;
    }
  }
  return parts;
}

/// The elements a path runs along, one after the other.
std::vector<const Element*> elements_of(std::span<const Move> moves) {
  std::vector<const Element*> elements;
  for (const Move& move : moves)
    if (is_along(move) && move.role != Role::Corner) elements.push_back(move.carrier.base.get());
  return elements;
}

/// Whether the contour runs along some lines and against others: the offset of an element lies on
/// one side of it, and that of a control on one side of the travel.
bool changes_side(std::span<const Move> moves) {
  bool along = false;
  bool against = false;
  for (const Move& move : moves) {
    if (!is_along(move)) continue;
    const auto* const line = std::get_if<Line>(move.carrier.base.get());
    const Direction way = direction_of(move);
    const bool backwards =
        line != nullptr && way.x * nearest_double(line->direction().x()) +
                                   way.y * nearest_double(line->direction().y()) <
                               0;
    (backwards ? against : along) = true;
  }
  return along && against;
}

/// Whether a straight cut from point to point, which no offset moves, stands within the contour.
bool has_points_within(std::span<const Move> moves, const Parts& parts) {
  return std::any_of(moves.begin() + static_cast<std::ptrdiff_t>(*parts.first),
                     moves.begin() + static_cast<std::ptrdiff_t>(parts.last),
                     [](const Move& m) { return m.travels() && !is_along(m); });
}

/// Whether all elements are offset by the contour's own offset.
bool is_offset_evenly(const Contour& contour, const std::vector<Move>& moves) {
  const Rational offset = abs(contour.offset);
  return std::all_of(moves.begin() + static_cast<std::ptrdiff_t>(contour.first),
                     moves.begin() + static_cast<std::ptrdiff_t>(contour.last), [&](const Move& m) {
                       if (!m.cuts() || m.role != Role::Contour || !m.carrier.base) return true;
                       return m.carrier.shift && abs(*m.carrier.shift) == offset;
                     });
}

void replace(std::string& text, std::string_view what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what))
    text.replace(at, what.size(), by);
}

class Controller {
 public:
  Controller(const Toolpath& path, const Dialect& dialect) : path_(path), dialect_(dialect) {
    made_.path.files = path.files;
    made_.path.start = path.start;
  }

  ControlledPath run() {
    std::size_t next = 0;
    for (const Contour& contour : path_.contours) {
      for (; next < contour.first; ++next) add(path_.moves[next]);
      if (contour.side == Side::None || sgn(contour.offset) == 0) continue;
      if (!add_contour(contour)) break;  // the control has no words for any
      next = contour.last;
    }
    for (; next < path_.moves.size(); ++next) add(path_.moves[next]);
    return std::move(made_);
  }

 private:
  void add(const Move& move) {
    Move& m = made_.path.moves.emplace_back(move);
    // A contour ends elsewhere than its equidistant.
    if (m.kind != MoveKind::Arc && made_.path.moves.size() > 1)
      m.from = made_.path.moves[made_.path.moves.size() - 2].to;
    if (!m.travels()) m.to = m.from;
  }

  void fault(FaultKind kind, const Contour& contour, double measure = 0, double limit = 0) {
    WriteFault fault;
    fault.kind = kind;
    fault.move = contour.first;
    fault.place = path_.moves[contour.first].source;
    fault.measure = measure;
    fault.limit = limit;
    made_.faults.push_back(std::move(fault));
  }

  bool add_contour(const Contour& contour) {
    if (!dialect_.kerf.exist()) {
      fault(FaultKind::KerfImpossible, contour);
      return false;
    }
    const auto programmed = programmed_moves(path_, contour);
    const auto moved = moves_of(path_, contour);
    if (!check(contour, programmed, moved)) return true;
    const Parts parts = parts_of(programmed);
    const Parts moved_parts = parts_of(moved);
    const Move& first = programmed[*parts.first];
    const Move& beside = moved[*moved_parts.first];
    const Move& last = moved[moved_parts.last];
    const bool left = is_left(first, beside);
    const bool goes_round =
        last.role == Role::Corner ||
        (dialect_.kerf.rounds_corners && programmed[parts.last].to == first.from &&
         begins_out(programmed[parts.last], first, beside));
    const auto entry = control_entry(
        {path_, contour, programmed[*parts.lead].from,
         goes_round ? beside_beginning(first, contour, left) : beside.from, first, last, left},
        dialect_);
    if (!entry) {
      fault(entry.error().kind, contour, entry.error().measure, entry.error().limit);
      return true;
    }
    for (std::size_t i = 0; i < programmed.size(); ++i) {
      if (i == *parts.lead) say(left ? dialect_.kerf.left : dialect_.kerf.right, contour);
      Move move = programmed[i];
      if (i == *parts.lead) move.to = *entry;
      // Round an outer corner where the contour begins there is nothing to cut: the tool touches it
      // at both its ends.
      if (i == parts.last && !goes_round) move.to = foot_on(move, last.to, move.to);
      if (i == *parts.first) {
        add_first(std::move(move), *entry);
      } else {
        add(move);
      }
      if (i != parts.last) continue;
      say(dialect_.kerf.off, contour);
    }
    return true;
  }

  /// Whether the control would offset the contour at all as it was offset here.
  bool check(const Contour& contour, std::span<const Move> programmed,
             std::span<const Move> moved) {
    const Parts parts = parts_of(programmed);
    const auto refuse = [&](FaultKind kind) {
      fault(kind, contour);
      return false;
    };
    if (!is_offset_evenly(contour, path_.moves)) return refuse(FaultKind::OffsetsDiffer);
    if (!parts.first || !parts.lead || programmed[*parts.lead].kind == MoveKind::Arc)
      return refuse(FaultKind::LeadLacking);
    if (has_points_within(programmed, parts)) return refuse(FaultKind::PointsInContour);
    if (elements_of(programmed) != elements_of(moved)) return refuse(FaultKind::ContourTrimmed);
    if (changes_side(programmed)) return refuse(FaultKind::SideChanges);
    if (takes_offset_from_settings() && offset_ != nullptr && *offset_ != abs(contour.offset))
      return refuse(FaultKind::OffsetsVary);
    offset_ = shared(abs(contour.offset));
    return true;
  }

  /// Seen along the travel, which may run against the elements.
  static bool is_left(const Move& first, const Move& beside) {
    const Direction along = direction_of(first);
    return along.x * (beside.from.y() - first.from.y()) -
               along.y * (beside.from.x() - first.from.x()) >
           0;
  }

  /// Whether the equidistant begins at an outer corner, where it is prolonged.
  static bool begins_out(const Move& last, const Move& first, const Move& beside) {
    if (last.carrier.base == first.carrier.base) return false;
    const Point foot = foot_on(first, beside.from, first.from);
    const Direction along = direction_of(first);
    return along.x * (first.from.x() - foot.x()) + along.y * (first.from.y() - foot.y()) > 0;
  }
  static Point beside_beginning(const Move& first, const Contour& contour, bool left) {
    const Direction along = direction_of(first);
    const double offset = std::fabs(nearest_double(contour.offset)) * (left ? 1 : -1);
    return Point(RationalPoint{Rational(first.from.x() - along.y * offset),
                               Rational(first.from.y() + along.x * offset)});
  }

  /// The first element from where the lead ends, which may lie before its beginning. An arc that
  /// has come near to a full turn is told in two, or it might pass one.
  void add_first(Move move, const Point& from) {
    constexpr double kLongSweep = 180;  // and what comes in before is a quarter turn at most
    const Point began = move.from;
    move.from = from;
    if (move.kind == MoveKind::Line || from == began ||
        (!move.full_circle && at_most(move, began, kLongSweep)))
      return add(move);
    const Point to = move.to;
    const RationalPoint centre = move.circle().centre();
    const RationalPoint opposite =
        2 * centre - RationalPoint{Rational(began.x()), Rational(began.y())};
    move.full_circle = false;
    move.to = Point(opposite);
    add(move);
    move.from = move.to;
    move.to = to;
    add(move);
  }
  static bool at_most(Move arc, const Point& from, double degrees) {
    arc.from = from;
    return std::fabs(sweep_degrees(arc)) <= degrees;
  }

  void say(const std::vector<std::string>& words, const Contour& contour) {
    const Rational offset = abs(contour.offset);
    constexpr int kDecimals = 6;
    for (std::string line : words) {
      replace(line, "{offset}", to_short_decimal(offset, kDecimals));
      replace(line, "{width}", to_short_decimal(Rational(2 * offset), kDecimals));
      replace(line, "{units}", nearest_integer(Rational(2 * offset / dialect_.unit)).get_str());
      made_.words[made_.path.moves.size()].push_back(line);
    }
  }

  /// No word of the program says how wide the kerf is.
  bool takes_offset_from_settings() const {
    return std::none_of(dialect_.kerf.left.begin(), dialect_.kerf.left.end(),
                        [](const std::string& line) { return line.find('{') != line.npos; });
  }

  const Toolpath& path_;
  const Dialect& dialect_;
  RationalPtr offset_;  ///< of the contours so far
  ControlledPath made_;
};

}  // namespace

ControlledPath offset_by_control(const Toolpath& path, const Dialect& dialect) {
  return Controller(path, dialect).run();
}

}  // namespace dgt
