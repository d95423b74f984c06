// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the kernel says about a contour, in the user's words: its items become the words they came
// from.
#include <algorithm>

#include "lang/dgt/contour_writer.h"

namespace dgt::language {
namespace {

using Fault = ContourFault::Kind;
using Notice = ContourNotice::Kind;

class ContourReporter {
 public:
  ContourReporter(const OpenContour& contour, DiagnosticBag& bag) : contour_(contour), bag_(bag) {}

  void report(const ContourFault& fault) {
    Diagnostic diagnostic = describe(fault);
    diagnostic.notes = largest_offset(fault.largest_offset);
    bag_.add(std::move(diagnostic));
  }

  void report(const ContourNotice& notice) {
    const ItemOrigin& origin = contour_.origins[notice.item];
    switch (notice.kind) {
      case Notice::SideChosen:
        bag_.add({notice.side == Side::Left ? Message::OffsetOnLeft : Message::OffsetOnRight,
                  origin.range,
                  {origin.text()}});
        return;
      case Notice::JoinedGap:
        bag_.add({Message::GapJoined,
                  origin.range,
                  {origin.text(), name(notice.other), millimetres(notice.measure)}});
        return;
      case Notice::Gouge:
        bag_.add({Message::GougeAllowed, origin.range, gouge_arguments(notice),
                  largest_offset(notice.largest_offset)});
        return;
      case Notice::AgainstDirection:
        break;
    }
    const std::string turned = reversed_word(origin);
    bag_.add({Message::AgainstDirection,
              origin.range,
              {origin.text(), turned},
              {},
              FixIt{origin.range, turned, Certainty::Guess}});
  }

 private:
  [[nodiscard]] std::string name(std::size_t item) const { return contour_.origins[item].text(); }

  // Of a fault or notice about a gouge.
  template <class Told>
  [[nodiscard]] std::vector<std::string> gouge_arguments(const Told& told) const {
    return {name(told.item), name(told.other), millimetres(told.measure), millimetres(told.x),
            millimetres(told.y)};
  }

  [[nodiscard]] std::vector<Note> largest_offset(const std::optional<Rational>& largest) const {
    if (!largest || sgn(*largest) == 0) return {};
    return {{Message::LargestOffset, contour_.range, {to_short_decimal(*largest)}}};
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
        return fault.measure > 0 ? one_measured(Message::Eaten) : one(Message::ArcEaten);
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
    return one(Message::ZeroValue);
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
};

}  // namespace

void report(const BuiltContour& built, const OpenContour& contour, DiagnosticBag& bag) {
  ContourReporter reporter(contour, bag);
  for (const ContourFault& fault : built.faults) reporter.report(fault);
  for (const ContourNotice& notice : built.notices) reporter.report(notice);
}

}  // namespace dgt::language
