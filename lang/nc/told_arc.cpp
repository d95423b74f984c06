// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/nc/told_arc.h"

#include "lang/nc/arc.h"
#include "lang/nc/grid_arc.h"

namespace dgt {
namespace {

enum class Told : std::uint8_t { Centre, MinorRadius, MajorRadius, HalfTurn };

/// What a block says of its arc, in steps.
struct ArcWords {
  grid::Vector from;
  grid::Vector chord;
  grid::Vector more;  ///< the centre seen from `from`, or the radius in x
  Told told = Told::Centre;
  bool counter_clockwise = true;
};

Spot spot(const grid::Vector& v) { return {Length::of_steps(v.x), Length::of_steps(v.y)}; }

Circle circle_of(const ArcWords& arc) {
  const Spot from = spot(arc.from);
  const Spot chord = spot(arc.chord);
  switch (arc.told) {
    case Told::Centre:
      return circle_by_centre(from, chord, spot(arc.more), arc.counter_clockwise);
    case Told::HalfTurn:
      return half_turn(from, chord, arc.counter_clockwise);
    case Told::MinorRadius:
    case Told::MajorRadius:
      break;
  }
  return circle_by_radius(from, chord, Length::of_steps(arc.more.x), arc.told == Told::MajorRadius,
                          arc.counter_clockwise);
}

class ToldArc final : public ElementOnDemand {
 public:
  explicit ToldArc(const ArcWords& arc) : arc_(arc) {}

 private:
  [[nodiscard]] Element make() const override { return circle_of(arc_); }

  ArcWords arc_;
};

ElementPtr told(const ArcWords& arc) { return ElementPtr(std::make_shared<const ToldArc>(arc)); }

}  // namespace

ElementPtr told_by_centre(const Spot& from, const Spot& chord, const Spot& centre,
                          bool counter_clockwise) {
  if (!from.on_grid() || !chord.on_grid() || !centre.on_grid())
    return ElementPtr(circle_by_centre(from, chord, centre, counter_clockwise));
  return told({grid::steps_of(from), grid::steps_of(chord), grid::steps_of(centre), Told::Centre,
               counter_clockwise});
}

ElementPtr told_by_radius(const Spot& from, const Spot& chord, const Length& radius, bool major,
                          bool counter_clockwise) {
  if (!from.on_grid() || !chord.on_grid() || !radius.on_grid())
    return ElementPtr(circle_by_radius(from, chord, radius, major, counter_clockwise));
  return told({grid::steps_of(from),
               grid::steps_of(chord),
               {radius.steps(), 0},
               major ? Told::MajorRadius : Told::MinorRadius,
               counter_clockwise});
}

ElementPtr told_half_turn(const Spot& from, const Spot& chord, bool counter_clockwise) {
  if (!from.on_grid() || !chord.on_grid())
    return ElementPtr(half_turn(from, chord, counter_clockwise));
  return told({grid::steps_of(from), grid::steps_of(chord), {}, Told::HalfTurn, counter_clockwise});
}

}  // namespace dgt
