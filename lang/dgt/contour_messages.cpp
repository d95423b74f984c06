// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the kernel says about a contour, in the user's words: its items become the words they came
// from.
#include <algorithm>
#include <cmath>
#include <map>
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
  ContourReporter(const OpenContour& contour, const Rational& offset, DiagnosticBag& bag)
      : contour_(contour), offset_(offset), bag_(bag) {}

  void report(const ContourFault& fault) {
    if (is_mirrored(fault)) return;
    Diagnostic diagnostic = describe(fault);
    if (names_two(fault)) mark_other(diagnostic, other_of(fault));
    for (Note& note : largest_offset(fault.largest_offset)) {
      diagnostic.notes.push_back(std::move(note));
    }
    if (fault.round_works) {
      diagnostic.notes.push_back({Message::CornerChoice, diagnostic.range, {}});
    }
    add(std::move(diagnostic), fault.item);
  }

  void report(const ContourNotice& notice, const BuiltContour& built) {
    const ItemOrigin& origin = contour_.origins[notice.item];
    switch (notice.kind) {
      case Notice::SideChosen:
        add({message_of_side(notice.side, built), origin.range, {origin.text()}}, notice.item);
        return;
      case Notice::JoinedGap: {
        Diagnostic joined{Message::GapJoined,
                          origin.range,
                          {origin.text(), name(notice.other), millimetres(notice.measure)}};
        mark_other(joined, notice.other);
        add(std::move(joined), notice.item);
        return;
      }
      case Notice::LongCorner: {
        Diagnostic spike{Message::LongCorner,
                         origin.range,
                         {origin.text(), name(notice.other), millimetres(notice.measure),
                          millimetres(notice.x), millimetres(notice.y)}};
        mark_other(spike, notice.other);
        spike.notes.push_back({Message::CornerChoice, origin.range, {}});
        add(std::move(spike), notice.item);
        return;
      }
      case Notice::Trimmed: {
        Diagnostic trimmed{
            Message::Trimmed,
            origin.range,
            {origin.text(), name(notice.other), millimetres(notice.x), millimetres(notice.y)}};
        mark_other(trimmed, notice.other);
        add(std::move(trimmed), notice.item);
        return;
      }
      case Notice::Gouge:
        return;  // told together
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

  /// One slip makes gouges all along a contour. With the element known that has to be turned round
  /// there is one fault to tell; else one for each element that takes part in several.
  void report_gouges(const BuiltContour& built, const std::optional<Turn>& turn) {
    std::vector<GougeTold> gouges = gouges_of(built);
    while (!gouges.empty()) {
      const std::size_t culprit = turn ? turn->item : most_frequent(gouges);
      const auto takes_part = [&](const GougeTold& g) {
        return turn || contour_.first_of_word(g.item) == culprit ||
               contour_.first_of_word(g.other) == culprit;
      };
      const GougeTold first = *std::ranges::find_if(gouges, takes_part);
      const bool several = std::ranges::count_if(gouges, takes_part) > 1;
      std::erase_if(gouges, takes_part);
      Diagnostic told{first.message,
                      contour_.origins[first.item].range,
                      {name(first.item), name(first.other), millimetres(first.measure),
                       millimetres(first.x), millimetres(first.y)}};
      if (!turn || turn->item != first.other) mark_other(told, first.other);
      if (turn) {
        add_turn(told, *turn);
      } else {
        for (Note& note : largest_offset(first.largest)) told.notes.push_back(std::move(note));
        if (several) {
          told.notes.push_back(
              {Message::MoreGouges, contour_.origins[culprit].range, {name(culprit)}});
        }
      }
      add(std::move(told), first.item);
    }
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
  // A gouge, be it a fault or, when gouges are allowed, a notice.
  struct GougeTold {
    Message message;
    std::size_t item = 0;
    std::size_t other = 0;
    double measure = 0, x = 0, y = 0;
    std::optional<Rational> largest;
  };

  static std::vector<GougeTold> gouges_of(const BuiltContour& built) {
    std::vector<GougeTold> gouges;
    const auto take = [&](Message message, const auto& g) {
      gouges.push_back({message, g.item, g.other, g.measure, g.x, g.y, g.largest_offset});
    };
    for (const ContourFault& f : built.faults) {
      if (f.kind == Fault::Gouge) take(Message::Gouge, f);
    }
    for (const ContourNotice& n : built.notices) {
      if (n.kind == Notice::Gouge) take(Message::GougeAllowed, n);
    }
    return gouges;
  }

  // The word that takes part in most of them, the first of several; by its first item.
  [[nodiscard]] std::size_t most_frequent(const std::vector<GougeTold>& gouges) const {
    std::map<std::size_t, int> counts;
    for (const GougeTold& g : gouges) {
      ++counts[contour_.first_of_word(g.item)];
      ++counts[contour_.first_of_word(g.other)];
    }
    return std::ranges::max_element(counts, {}, [](const auto& c) { return c.second; })->first;
  }

  void add_turn(Diagnostic& told, const Turn& turn) const {
    const ItemOrigin& origin = contour_.origins[turn.item];
    const std::string turned = reversed_word(origin);
    told.notes.push_back({Message::CutWhenTurned, origin.range, {turned}});
    told.fix_it = FixIt{origin.range, turned, Certainty::Guess};
  }

  void add(Diagnostic diagnostic, std::size_t item) {
    add_expansion(diagnostic, contour_.origins[item].expansion);
    bag_.add(std::move(diagnostic));
  }

  // Faults of two elements, both of which the message names.
  static bool names_two(const ContourFault& fault) {
    switch (fault.kind) {
      case Fault::NoMeeting:
      case Fault::SameElement:
      case Fault::Impossible:
      case Fault::NoChoice:
      case Fault::EqualCandidates:
      case Fault::BevelKinds:
        return true;
      default:
        return false;
    }
  }

  // An element that misses the line X or Y beside it is reported with itself.
  [[nodiscard]] std::size_t other_of(const ContourFault& fault) const {
    const bool itself = fault.kind == Fault::NoMeeting && fault.other == fault.item;
    return itself ? axis_beside(fault.item) : fault.other;
  }

  // Underlined in the same line, else with a note of its own.
  void mark_other(Diagnostic& diagnostic, std::size_t other) const {
    const Range& range = contour_.origins[other].range;
    if (range == diagnostic.range) return;
    if (range.file == diagnostic.range.file &&
        range.place().line == diagnostic.range.place().line) {
      diagnostic.other = range;
    } else {
      diagnostic.notes.push_back({Message::OtherElement, range, {name(other)}});
    }
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

  [[nodiscard]] std::vector<Note> largest_offset(const std::optional<Rational>& largest) const {
    if (!largest || sgn(*largest) == 0 || *largest == offset_) return {};
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
    const auto placed = [&](Message m) {
      return Diagnostic{m, range, {name(fault.item), millimetres(fault.x), millimetres(fault.y)}};
    };
    switch (fault.kind) {
      case Fault::NoMeeting: {
        const Message m = fault.on_equidistant ? Message::OffsetsDoNotMeet : Message::NoMeeting;
        return {m, range, {name(fault.item), name(other_of(fault)), millimetres(fault.measure)}};
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
      case Fault::TrimStart:
        return placed(Message::TrimStart);
      case Fault::TrimBroken:
        return placed(Message::TrimBroken);
      case Fault::TrimSplits:
        return placed(Message::TrimSplits);
      case Fault::TrimNothing:
        return {Message::TrimNothing, contour_.range, {}};
      case Fault::Gouge:  // told together
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
  const Rational& offset_;  // W
  DiagnosticBag& bag_;
  std::set<std::string, std::less<>> missed_;
};

}  // namespace

void report(const BuiltContour& built, const OpenContour& contour, const std::optional<Turn>& turn,
            DiagnosticBag& bag) {
  ContourReporter reporter(contour, built.offset, bag);
  for (const ContourFault& fault : built.faults) {
    if (fault.kind != Fault::Gouge) reporter.report(fault);
  }
  reporter.report_gouges(built, turn);
  // Of a contour with a cure, what is left to say with it.
  for (const ContourNotice& notice : (turn ? turn->built : built).notices) {
    reporter.report(notice, turn ? turn->built : built);
  }
  const bool cut_to_size = built.side != Side::None && built.faults.empty();
  if (cut_to_size && !built.closed) reporter.report_open_end(built);
}

}  // namespace dgt::language
