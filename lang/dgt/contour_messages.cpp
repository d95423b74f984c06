// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the kernel says about a contour, in the user's words: its items become the words they came
// from.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "kernel/piece.h"
#include "lang/dgt/contour_writer.h"

namespace dgt::language {
namespace {

using Fault = ContourFault::Kind;
using Notice = ContourNotice::Kind;

// In radians, counter-clockwise positive.
double sweep_of(const Piece& arc) {
  const double turn = arc.radius > 0 ? 2 * std::numbers::pi : -2 * std::numbers::pi;
  if (arc.full_circle) return turn;
  const double sweep =
      std::atan2(arc.y1 - arc.cy, arc.x1 - arc.cx) - std::atan2(arc.y0 - arc.cy, arc.x0 - arc.cx);
  return sweep * turn < 0 ? sweep + turn : sweep;
}

// Twice the area that the cut goes round, positive when it goes counter-clockwise; 0 when nobody
// could say. Plain floating point: the sign is told to a person and decides nothing.
double signed_area(const std::vector<Move>& moves) {
  double area = 0;
  double length = 0;
  const Move* first = nullptr;
  for (const Move& move : moves) {
    if (!is_part(move)) continue;
    if (first == nullptr) first = &move;
    const double x0 = move.from.x() - first->from.x();
    const double y0 = move.from.y() - first->from.y();
    const double x1 = move.to.x() - first->from.x();
    const double y1 = move.to.y() - first->from.y();
    area += x0 * y1 - x1 * y0;
    length += std::hypot(x1 - x0, y1 - y0);
    if (move.kind != MoveKind::Arc) continue;
    const Piece arc = piece_of(move);
    const double radius = arc.radius;
    const double sweep = sweep_of(arc);
    area += radius * radius * (sweep - std::sin(sweep));
    length += std::fabs(radius * sweep);
  }
  return std::fabs(area) > 1e-6 * length * length ? area : 0;
}

class ContourReporter {
 public:
  ContourReporter(const OpenContour& contour, DiagnosticBag& bag) : contour_(contour), bag_(bag) {}

  void report(const ContourFault& fault) {
    if (is_mirrored(fault)) return;
    Diagnostic diagnostic = describe(fault);
    diagnostic.notes = largest_offset(fault.largest_offset);
    add(std::move(diagnostic), fault.item);
  }

  void report(const ContourNotice& notice, const BuiltContour& built) {
    const ItemOrigin& origin = contour_.origins[notice.item];
    switch (notice.kind) {
      case Notice::SideChosen:
        add({message_of_side(notice.side, built), origin.range, {origin.text()}}, notice.item);
        return;
      case Notice::JoinedGap:
        add({Message::GapJoined,
             origin.range,
             {origin.text(), name(notice.other), millimetres(notice.measure)}},
            notice.item);
        return;
      case Notice::Gouge:
        add({Message::GougeAllowed, origin.range, gouge_arguments(notice),
             largest_offset(notice.largest_offset)},
            notice.item);
        return;
      case Notice::AgainstDirection:
        break;
    }
    const std::string turned = reversed_word(origin);
    add({Message::AgainstDirection,
         origin.range,
         {origin.text(), turned},
         {},
         FixIt{origin.range, turned, Certainty::Guess}},
        notice.item);
  }

  /// A contour with an offset that does not close: often a side was forgotten, now and then it is
  /// meant.
  void report_open_end(const BuiltContour& built) {
    const Move* first = nullptr;
    const Move* last = nullptr;
    for (const Move& move : built.programmed) {
      if (!is_part(move)) continue;
      if (first == nullptr) first = &move;
      last = &move;
    }
    if (first == nullptr) return;
    const double gap = std::hypot(last->to.x() - first->from.x(), last->to.y() - first->from.y());
    bag_.add({Message::ContourOpen,
              contour_.range,
              {std::string(contour_.range.text()), millimetres(gap)}});
  }

 private:
  void add(Diagnostic diagnostic, std::size_t item) {
    add_expansion(diagnostic, contour_.origins[item].expansion);
    bag_.add(std::move(diagnostic));
  }

  // What misses on the way in misses by as much on the way out.
  [[nodiscard]] bool is_mirrored(const ContourFault& fault) {
    if (fault.kind != Fault::NoMeeting) return false;
    const std::string there = name(fault.item) + " " + name(fault.other);
    const std::string back = name(fault.other) + " " + name(fault.item);
    const std::string gap = " " + millimetres(fault.measure);
    const bool known = missed_.count(back + gap) > 0;
    missed_.insert(there + gap);
    return known && there != back;
  }

  // Of a closed contour inside and outside say more than left and right.
  static Message message_of_side(Side side, const BuiltContour& built) {
    const bool left = side == Side::Left;
    const double area = built.closed ? signed_area(built.programmed) : 0;
    if (area == 0) return left ? Message::OffsetOnLeft : Message::OffsetOnRight;
    return left == (area > 0) ? Message::OffsetInside : Message::OffsetOutside;
  }

  [[nodiscard]] std::string name(std::size_t item) const { return contour_.origins[item].text(); }

  // Of a fault or notice about a gouge.
  template <class Told>
  [[nodiscard]] std::vector<std::string> gouge_arguments(const Told& told) const {
    return {name(told.item), name(told.other), millimetres(told.measure), millimetres(told.x),
            millimetres(told.y)};
  }

  [[nodiscard]] std::vector<Note> largest_offset(const std::optional<Rational>& largest) const {
    if (!largest || sgn(*largest) == 0) return {};
    return {{Message::LargestOffset, range_of_offset(), {to_short_decimal(*largest)}}};
  }

  // The W, or the K of a contour with U alone.
  [[nodiscard]] Range range_of_offset() const {
    for (std::size_t i = 0; i < contour_.items.size(); ++i) {
      const auto* const offset = std::get_if<OffsetItem>(&contour_.items[i].what);
      if (offset != nullptr && offset->whole_contour) return contour_.origins[i].range;
    }
    return contour_.range;
  }

  // The word with its minus put in or taken away, its number as written.
  static std::string reversed_word(const ItemOrigin& origin) {
    const std::string_view written = origin.range.text();
    const std::size_t number = std::min(written.find_first_of("0123456789.Nn"), written.size());
    const bool minus = written.substr(0, number).find('-') != std::string_view::npos;
    return origin.name.letter + std::string(minus ? "" : "-").append(written.substr(number));
  }

  // V between lines is a chamfer or, without a number, misplaced.
  [[nodiscard]] bool is_chamfer(const ContourFault& fault) const {
    for (std::size_t i = fault.item; i < fault.other && i < contour_.items.size(); ++i) {
      const auto* const bevel = std::get_if<BevelItem>(&contour_.items[i].what);
      if (bevel != nullptr) return bevel->leg.has_value();
    }
    return true;
  }

  [[nodiscard]] Diagnostic describe(const ContourFault& fault) const {
    const Range range = contour_.origins[fault.item].range;
    const auto one = [&](Message m) { return Diagnostic{m, range, {name(fault.item)}}; };
    const auto one_measured = [&](Message m) {
      return Diagnostic{m, range, {name(fault.item), millimetres(fault.measure)}};
    };
    const auto two = [&](Message m) {
      return Diagnostic{m, range, {name(fault.item), name(fault.other)}};
    };
    const auto plain = [&](Message m) { return Diagnostic{m, range, {}}; };
    switch (fault.kind) {
      case Fault::NoMeeting: {
        const Message m = fault.on_equidistant ? Message::OffsetsDoNotMeet : Message::NoMeeting;
        const std::size_t other = fault.other == fault.item ? axis_beside(fault.item) : fault.other;
        return {m, range, {name(fault.item), name(other), millimetres(fault.measure)}};
      }
      case Fault::SameElement:
        return two(Message::SameElement);
      case Fault::Impossible:
        return explain(*fault.impossible, range, {name(fault.item), name(fault.other)});
      case Fault::NoChoice:
        return two(Message::NoChoice);
      case Fault::EqualCandidates:
        return two(Message::EqualCandidates);
      case Fault::UnusedSelector:
        return plain(Message::UnusedSelector);
      case Fault::NothingToJoin:
        return one(Message::NothingToJoin);
      case Fault::BevelKinds:
        return two(is_chamfer(fault) ? Message::ChamferAtCircle : Message::TangentAtLine);
      case Fault::TravelOnCircle:
        return one(Message::TravelOnCircle);
      case Fault::CentreApproach:
        return one(Message::CentreApproach);
      case Fault::OffsetTwice:
        return plain(Message::MisplacedOffset);
      case Fault::OffsetAtTangent:
        return one(Message::OffsetAtTangent);
      case Fault::SideUnknown:
        return one(Message::SideUnknown);
      case Fault::SideOfNegative:
        return plain(Message::SideOfNegative);
      case Fault::Eaten:
        return fault.measure > 0 ? one_measured(Message::Eaten) : one(Message::EatenToNothing);
      case Fault::ArcEaten:
        return one(Message::ArcEaten);
      case Fault::BlendsOverlap:
        return one_measured(Message::BlendsOverlap);
      case Fault::ZeroArc:
        return one(Message::ZeroArc);
      case Fault::RapidArc:
        return one(Message::RapidArc);
      case Fault::OffElement:
        return one_measured(Message::OffElement);
      case Fault::Overrun:
        return one(Message::Overrun);
      case Fault::Gouge:
        return {Message::Gouge, range, gouge_arguments(fault)};
      case Fault::ZeroValue:
        break;
    }
    const std::size_t blend = blend_of(fault);
    return {Message::ZeroValue, contour_.origins[blend].range, {name(blend)}};
  }

  // The fillet or chamfer between the elements of a fault.
  [[nodiscard]] std::size_t blend_of(const ContourFault& fault) const {
    for (std::size_t i = fault.item; i < contour_.items.size(); ++i) {
      const auto& what = contour_.items[i].what;
      if (std::holds_alternative<FilletItem>(what) || std::holds_alternative<BevelItem>(what)) {
        return i;
      }
    }
    return fault.item;
  }

  // An element that misses the line X or Y beside it is reported with itself.
  [[nodiscard]] std::size_t axis_beside(std::size_t item) const {
    const auto is_axis = [&](std::size_t i) {
      return i < contour_.items.size() && std::holds_alternative<AxisItem>(contour_.items[i].what);
    };
    for (std::size_t away = 1; away < contour_.items.size(); ++away) {
      if (is_axis(item + away)) return item + away;
      if (away <= item && is_axis(item - away)) return item - away;
    }
    return item;
  }

  const OpenContour& contour_;
  DiagnosticBag& bag_;
  std::set<std::string, std::less<>> missed_;
};

}  // namespace

void report(const BuiltContour& built, const OpenContour& contour, DiagnosticBag& bag) {
  ContourReporter reporter(contour, bag);
  for (const ContourFault& fault : built.faults) reporter.report(fault);
  for (const ContourNotice& notice : built.notices) reporter.report(notice, built);
  const bool cut_to_size = built.side != Side::None && built.faults.empty();
  if (cut_to_size && !built.closed) reporter.report_open_end(built);
}

}  // namespace dgt::language
