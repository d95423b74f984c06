// SPDX-License-Identifier: GPL-3.0-or-later
//
// Executes definitions: operands by the form, the kernel's construction, the entry in the table.
#include <fmt/format.h>

#include <utility>

#include "kernel/check.h"
#include "lang/dgt/dump.h"
#include "lang/dgt/evaluation.h"

namespace dgt::language {
namespace {

using State = ElementEntry::State;

// What became of a definition: an entry to be, a fault of geometry, or silence about a value that
// rests on an earlier fault.
using Made = std::variant<std::monostate, ElementEntry, Impossible>;

// The operands of a definition in the order of its form, each resolved when asked for.
class Operands {
 public:
  Operands(const Definition& definition, Evaluation& evaluation)
      : definition_(definition), evaluation_(evaluation) {}

  // Resolves all of them; false when one rests on a fault.
  bool resolve() {
    bool complete = true;
    for (const std::uint8_t index : definition_.match.order) {
      complete = resolve(definition_.operands[index]) && complete;
    }
    if (!definition_.selector.empty()) {
      const auto chosen = evaluation_.selector(definition_.selector.front());
      complete = complete && chosen.has_value();
      selector_ = chosen.value_or(Selector::Default);
    }
    return complete;
  }

  const KnownPoint& point(std::size_t i) const { return std::get<KnownPoint>(operands_[i]); }
  const Element& element(std::size_t i) const { return *std::get<ElementPtr>(operands_[i]); }
  const Line& line(std::size_t i) const { return std::get<Line>(element(i)); }
  const Circle& circle(std::size_t i) const { return std::get<Circle>(element(i)); }
  const Rational& number(std::size_t i) const { return std::get<Rational>(operands_[i]); }
  Selector selector() const { return selector_; }
  /// Of the elements and points, in the order of the form.
  const std::vector<std::string>& names() const { return names_; }

 private:
  bool resolve(const Item& item) {
    if (item.letter == 'P') {
      std::optional<KnownPoint> point = evaluation_.point(item);
      names_.push_back(to_text(item));
      if (point) operands_.emplace_back(*std::move(point));
      return point.has_value();
    }
    if (item.letter == 'L' || item.letter == 'C') {
      const std::optional<ElementName> name = evaluation_.name_of(item);
      ElementPtr element = name ? evaluation_.element(item, *name) : nullptr;
      if (!element) return false;
      names_.push_back(to_text(*name));
      operands_.emplace_back(std::move(element));
      return true;
    }
    std::optional<Rational> number = evaluation_.value(item);
    if (number) operands_.emplace_back(*std::move(number));
    return number.has_value();
  }

  const Definition& definition_;
  Evaluation& evaluation_;
  std::vector<std::variant<KnownPoint, ElementPtr, Rational>> operands_;
  std::vector<std::string> names_;
  Selector selector_ = Selector::Default;
};

ElementEntry entry_of(Line line) {
  ElementEntry entry;
  entry.element = ElementPtr(std::move(line));
  return entry;
}
ElementEntry entry_of(Circle circle) {
  ElementEntry entry;
  entry.element = ElementPtr(std::move(circle));
  return entry;
}
ElementEntry entry_of(KnownPoint point) {
  ElementEntry entry;
  entry.point = std::make_shared<const KnownPoint>(std::move(point));
  return entry;
}

template <class T>
Made made(Constructed<T> constructed) {
  ElementEntry entry = entry_of(std::move(constructed.value));
  entry.bound = constructed.bound;
  entry.turn = constructed.turn;
  return entry;
}
template <class T>
Made made(Construction<T> construction) {
  if (auto* impossible = std::get_if<Impossible>(&construction)) return *impossible;
  return made(std::get<Constructed<T>>(std::move(construction)));
}

Made make_line(Recipe recipe, const Operands& o) {
  switch (recipe) {
    case Recipe::LineAtX:
      return entry_of(vertical_line(o.number(0)));
    case Recipe::LineAtY:
      return entry_of(horizontal_line(o.number(0)));
    case Recipe::LineThroughPoints:
      return made(line_through(o.point(0), o.point(1)));
    case Recipe::LineParallelThroughPoint:
      return made(parallel_through(o.point(0), o.line(1)));
    case Recipe::LineParallelAtDistance:
      return made(parallel_at(o.line(0), o.number(1)));
    case Recipe::LineFromPointToCircle:
      return made(tangent_from(o.point(0), o.circle(1)));
    case Recipe::LineThroughPointAtAngle:
      return made(line_at_angle(o.point(0), o.number(1)));
    case Recipe::LineTangentAtAngle:
      return made(tangent_at_angle(o.circle(0), o.number(1)));
    case Recipe::LineTangentToCircles:
      return made(common_tangent(o.circle(0), o.circle(1)));
    default:
      DGT_CHECK(recipe == Recipe::LineTurnedThroughPoint);
      return made(line_turned(o.line(0), o.number(1), o.point(2)));
  }
}

Made make_circle(Recipe recipe, const Operands& o) {
  switch (recipe) {
    case Recipe::CircleAtCentre:
      return made(circle_about(o.point(0), o.number(1)));
    case Recipe::CircleThroughPoints:
      return made(circle_through(o.point(0), o.point(1), o.point(2)));
    case Recipe::CircleTouchingLines:
      return made(touching(o.line(0), o.line(1), o.number(2)));
    case Recipe::CircleTouchingLineAndCircle:
      return made(touching(o.line(0), o.circle(2), o.number(1), o.selector()));
    case Recipe::CircleTouchingCircles:
      return made(touching(o.circle(0), o.circle(2), o.number(1), o.selector()));
    default:
      DGT_CHECK(recipe == Recipe::CircleAtPolarCentre);
      return made(circle_polar(o.point(0), o.number(1), o.number(2), o.number(3)));
  }
}

Made make_point(Recipe recipe, const Operands& o) {
  switch (recipe) {
    case Recipe::PointAtCoordinates:
      return entry_of(o.point(0));
    case Recipe::PointAtCentre:
      return entry_of(known_point(o.circle(0).centre()));
    case Recipe::PointOfLines:
    case Recipe::PointOfLineAndCircle:
    case Recipe::PointOfCircles:
      return made(meeting_point(o.element(0), o.element(1), o.selector()));
    default:
      DGT_CHECK(recipe == Recipe::PointAtPolar);
      return made(point_polar(o.point(2), o.number(0), o.number(1)));
  }
}

Made make_frame(const Operands& o) {
  ElementEntry entry;
  entry.frame =
      std::make_shared<const FrameDefinition>(FrameDefinition{o.point(0).stand_in, o.number(1)});
  entry.bound = o.point(0).bound;
  return entry;
}

Made make(const Definition& definition, const Operands& operands) {
  const Recipe recipe = definition.match.form->recipe;
  switch (definition.kind) {
    case ElementKind::Line:
      return make_line(recipe, operands);
    case ElementKind::Circle:
      return make_circle(recipe, operands);
    case ElementKind::Point:
      return make_point(recipe, operands);
    case ElementKind::Frame:
      break;
  }
  return make_frame(operands);
}

// The operands at fault.
Range range_of(const Impossible& impossible, const Definition& definition) {
  if (impossible.why == Impossible::Why::ZeroRadius) {
    for (const Item& item : definition.operands) {
      if (item.letter == 'R') return item.range;
    }
  }
  return join(definition.operands.front().range, definition.operands.back().range);
}

Made evaluate(const Definition& definition, Evaluation& evaluation) {
  Operands operands(definition, evaluation);
  if (!operands.resolve()) return {};
  Made result = make(definition, operands);
  if (const auto* impossible = std::get_if<Impossible>(&result)) {
    evaluation.report(explain(*impossible, range_of(*impossible, definition), operands.names()));
  }
  return result;
}

void warn_of_clash(const ElementEntry& old, const Item& target, const ElementName& name,
                   Evaluation& evaluation) {
  if (old.state == State::Undefined || !evaluation.is_caller(old.place.file)) return;
  evaluation.report({Message::ElementClash,
                     target.range,
                     {to_text(name)},
                     {{Message::SetHereBefore, old.place, {to_text(name)}}}});
}

}  // namespace

void define(const Definition& definition, bool broken, Evaluation& evaluation) {
  if (definition.target.letter == 0) return;  // nobody knows what it was to define
  const std::optional<ElementName> name = evaluation.name_of(definition.target);
  if (!name) return;
  if (name->reversed) {
    evaluation.report(
        {Message::NegativeTarget, definition.target.range, {std::string(1, name->letter)}});
    return;
  }
  if (definition.kind == ElementKind::Frame && name->number == 0) {
    evaluation.report({Message::WorldFrame, definition.target.range, {}});
    return;
  }
  Made result = broken ? Made{} : evaluate(definition, evaluation);
  ElementEntry& entry = evaluation.elements.at(definition.kind, name->number);
  warn_of_clash(entry, definition.target, *name, evaluation);
  entry = {};
  if (auto* made = std::get_if<ElementEntry>(&result)) {
    entry = std::move(*made);
    entry.state = State::Defined;
  } else {
    entry.state = State::Unknown;
  }
  entry.place = definition.target.range;
}

Diagnostic explain(const Impossible& impossible, Range range,
                   const std::vector<std::string>& names) {
  using Why = Impossible::Why;
  const auto name = [&](std::size_t i) { return i < names.size() ? names[i] : std::string(); };
  const std::string measure = millimetres(impossible.measure);
  const auto with_two = [&](Message message) {
    return Diagnostic{message, range, {name(0), name(1), measure}};
  };
  switch (impossible.why) {
    case Why::CoincidentPoints:
      return with_two(Message::PointsCoincide);
    case Why::CollinearPoints:
      return {Message::PointsOnOneLine, range, {name(0), name(1), name(2), measure}};
    case Why::ParallelLines:
      return with_two(Message::LinesParallel);
    case Why::PointInside:
      return with_two(Message::PointInsideCircle);
    case Why::ConcentricCircles:
      return with_two(Message::CirclesConcentric);
    case Why::CircleInside:
      return with_two(Message::NoCommonTangent);
    case Why::NoTouchingCircle:
      return with_two(Message::NoTouchingCircle);
    case Why::AlwaysTouching:
      return {Message::EveryCircleTouches, range, {name(0), name(1)}};
    case Why::ZeroRadius:
      return {Message::ZeroRadius, range, {}};
    case Why::NoMeeting:
      return with_two(Message::NoMeeting);
    case Why::SameElement:
      return {Message::SameElement, range, {name(0), name(1)}};
    case Why::NoChoice:
      return {Message::NoChoice, range, {name(0), name(1)}};
    case Why::EqualCandidates:
      break;
  }
  return {Message::EqualCandidates, range, {name(0), name(1)}};
}

}  // namespace dgt::language
