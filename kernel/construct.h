// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <variant>

#include "kernel/angle.h"
#include "kernel/element.h"
#include "kernel/meet.h"

/// The catalogue of constructions. Where the ideal element is irrational, the result is a rational
/// element beside it, chosen so that the incidence that matters to a tool path stays exact:
///
/// | construction | exact | within the bound |
/// | --- | --- | --- |
/// | through two points | through the first | the second |
/// | parallel, shifted, tangent at an angle | all | the angle alone |
/// | tangent from a point | contact with the circle | the point |
/// | common tangent | contact with the first circle | contact with the second |
/// | circle through three points | through the first | the other two |
/// | circle touching two lines | all | – |
/// | circle touching a line and a circle, two circles | both contacts | the radius |
///
/// Contact is oriented: both elements run the same way where they touch. For the left unit normal n
/// of a line n·x = p, a centre c and a signed radius r it is n·c − p = r; for two circles
/// |c1 − c2|² = (r1 − r2)². Both are rational conditions, and offsetting both elements by the same
/// distance keeps them.
namespace dgt {

/// Rational coordinates longer than this many bits are rounded onto a dyadic grid, so that programs
/// that build on their own results do not blow up; the bound says so.
inline constexpr std::size_t kMaxHeight = 1024;

/// A point as an operand: its exact form decides incidences; further constructions start from the
/// rational stand-in, which is at most `bound` mm away.
struct KnownPoint {
  ExactPoint exact;
  RationalPoint stand_in;
  double bound = 0;
};
[[nodiscard]] KnownPoint known_point(const RationalPoint& p);
[[nodiscard]] KnownPoint known_point(const ExactPoint& p);

/// A constructed element and how far it may lie from the ideal one over the same operands (of a
/// point: over its stand-in). Operands within the contact resolution of a contact are taken to be
/// in contact; the ideal is then the one of the exact contact.
template <class T>
struct Constructed {
  T value;
  double bound = 0;  ///< mm at the element's anchor (the incidence kept exact; a circle: centre and
                     ///< radius together); 0 when exact
  double turn = 0;   ///< largest angle between a line and its ideal, in radians
};

/// Why a construction has no result, and by how much it fails.
struct Impossible {
  enum class Why : std::uint8_t {
    CoincidentPoints,   ///< measure: their distance
    CollinearPoints,    ///< measure: distance of the middle one from the line of the others
    ParallelLines,      ///< measure: distance of the lines, or of the loci of the centre
    PointInside,        ///< measure: depth inside the circle
    ConcentricCircles,  ///< measure: difference of the radii
    CircleInside,       ///< no common tangent: depth by which one lies inside the other
    NoTouchingCircle,   ///< measure: gap between the loci of the centre
    AlwaysTouching,  ///< the loci of the centre coincide: as wide a channel or ring as the circle
    ZeroRadius,
    NoMeeting,       ///< measure: gap between the elements
    SameElement,     ///< the elements coincide
    NoChoice,        ///< a selector where there is one point
    EqualCandidates  ///< a selector that compares equal coordinates
  };
  Why why;
  double measure = 0;  ///< mm, correctly rounded or nearly so
};

template <class T>
using Construction = std::variant<Constructed<T>, Impossible>;

/// Which of two solutions: I1 is the first by the rule of entry, I2 the other; the rest compare
/// coordinates.
enum class Selector : std::uint8_t { Default, I1, I2, GreaterX, GreaterY, SmallerX, SmallerY };

// --- lines ------------------------------------------------------------------------------------

[[nodiscard]] Line vertical_line(const Rational& x);    ///< runs towards −Y
[[nodiscard]] Line horizontal_line(const Rational& y);  ///< runs towards +X
[[nodiscard]] Construction<Line> line_through(const KnownPoint& from, const KnownPoint& to,
                                              int bits = kStandInBits);
[[nodiscard]] Constructed<Line> parallel_through(const KnownPoint& point, const Line& line);
[[nodiscard]] Constructed<Line> parallel_at(const Line& line, const Rational& distance);
[[nodiscard]] Constructed<Line> line_at_angle(const KnownPoint& point, const Rational& degrees,
                                              int bits = kStandInBits);
/// Through `point`, the direction of `line` turned by `degrees`.
[[nodiscard]] Constructed<Line> line_turned(const Line& line, const Rational& degrees,
                                            const KnownPoint& point, int bits = kStandInBits);
[[nodiscard]] Constructed<Line> tangent_at_angle(const Circle& circle, const Rational& degrees,
                                                 int bits = kStandInBits);
/// From the point towards the contact; a point on the circle gives the tangent there, in the
/// circle's direction.
[[nodiscard]] Construction<Line> tangent_from(const KnownPoint& point, const Circle& circle,
                                              int bits = kStandInBits);
/// From the contact on `a` to that on `b`.
[[nodiscard]] Construction<Line> common_tangent(const Circle& a, const Circle& b,
                                                int bits = kStandInBits);

// --- circles ----------------------------------------------------------------------------------

[[nodiscard]] Construction<Circle> circle_about(const KnownPoint& centre, const Rational& radius);
/// Counter-clockwise.
[[nodiscard]] Construction<Circle> circle_through(const KnownPoint& p, const KnownPoint& q,
                                                  const KnownPoint& r, int bits = kStandInBits);
[[nodiscard]] Construction<Circle> touching(const Line& a, const Line& b, const Rational& radius);
/// The loci of the centre are the line shifted by the radius and a circle about the given centre;
/// the selector works on their crossings. When the two elements are already in contact the one
/// circle that touches both at their contact is the result.
[[nodiscard]] Construction<Circle> touching(const Line& line, const Circle& circle,
                                            const Rational& radius, Selector selector,
                                            int bits = kStandInBits);
[[nodiscard]] Construction<Circle> touching(const Circle& a, const Circle& b,
                                            const Rational& radius, Selector selector,
                                            int bits = kStandInBits);
/// For elements of any kind, in the order given.
[[nodiscard]] Construction<Circle> touching(const Element& a, const Element& b,
                                            const Rational& radius, Selector selector,
                                            int bits = kStandInBits);
/// The circle with its centre `distance` away from `point` at `degrees`.
[[nodiscard]] Construction<Circle> circle_polar(const KnownPoint& point, const Rational& distance,
                                                const Rational& degrees, const Rational& radius,
                                                int bits = kStandInBits);

// --- points -----------------------------------------------------------------------------------

[[nodiscard]] Constructed<KnownPoint> point_polar(const KnownPoint& point, const Rational& distance,
                                                  const Rational& degrees, int bits = kStandInBits);
/// Where `a` meets `b`, by the rule of the selector; both orders of a line and a circle mean the
/// line entering the circle.
[[nodiscard]] Construction<KnownPoint> meeting_point(const Element& a, const Element& b,
                                                     Selector selector);

/// The crossing that `selector` means when one goes along `a` to `b` in a contour, where a circle
/// met by a line is left by it: `first` is I1. EqualCandidates when the coordinates agree.
[[nodiscard]] std::variant<Which, Impossible> choose(const TwoPoints& crossings, Which first,
                                                     Selector selector);

// --- contacts ---------------------------------------------------------------------------------

/// The point where two elements in oriented contact touch, on `a` exactly; rational. Precondition:
/// at least one is a circle.
[[nodiscard]] RationalPoint contact(const Element& a, const Element& b);

// --- frames -----------------------------------------------------------------------------------

/// A coordinate system: what is given in it lies at origin + rotation·x in the world.
struct Frame {
  RationalPoint origin;
  UnitVector rotation;
  [[nodiscard]] bool is_identity() const {
    return sgn(origin.x) == 0 && sgn(origin.y) == 0 && rotation.x() == 1;
  }
};
[[nodiscard]] Element placed(const Element& e, const Frame& frame);
[[nodiscard]] RationalPoint placed(const RationalPoint& p, const Frame& frame);
[[nodiscard]] ExactPoint placed(const ExactPoint& p, const Frame& frame);

}  // namespace dgt
