// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "kernel/contour.h"

/// Legs and joints of a contour, between its items and its moves. Internal to the kernel.
namespace dgt {

/// An element as a leg uses it: with the offset step in force and the item it came from.
struct UsedElement {
  ElementPtr element;
  std::size_t step = 0;  ///< counts into ContourLegs::steps
  std::size_t item = 0;
};

/// A place that no offset moves.
struct FixedJoint {
  Point at;
};
/// The foot of the normal from `from` on the offset element.
struct FootJoint {
  Point from;
  UsedElement on;
};
/// The crossing of two offset elements.
struct CrossJoint {
  UsedElement a, b;
  Which which = Which::Entry;
};
/// The contact of two elements that touch by construction; they share one step.
struct TangentJoint {
  UsedElement a, b;
};
/// The crossing of the offset element with a line that is not offset.
struct AxisJoint {
  UsedElement on;
  ElementPtr axis;
  Which which = Which::Entry;
};
/// The point of the offset line beside the programmed point `at`.
struct BesideJoint {
  Point at;
  UsedElement on;
};

/// How the programmed contour turns where a leg along an element ends and the next one begins.
struct Turn {
  int sense = 0;  ///< +1 to the left of the travel, −1 to the right, 0: no corner
  int way = 1;    ///< of travel: −1 where both elements are lines run against their direction
  /// The corner in which a closed contour begins: the tool comes there by a lead and leaves as from
  /// the corner in which it ends.
  bool begins = false;
};

struct Joint {
  std::variant<FixedJoint, FootJoint, CrossJoint, TangentJoint, AxisJoint, BesideJoint> rule;
  Point programmed;
  Turn turn{};
};

struct Leg {
  enum class Travel : std::uint8_t { Along, Straight, Stop };
  Travel travel = Travel::Straight;
  Role role = Role::Contour;
  bool rapid = false;
  bool full_circle = false;
  UsedElement element;   ///< of Along
  std::size_t from = 0;  ///< joints
  std::size_t to = 0;
  RationalPtr z, feed, seconds;
  std::string code;
  SourcePlace place;
};

struct ContourLegs {
  std::vector<Joint> joints;  ///< the first is where the tool stood
  std::vector<Leg> legs;
  std::vector<Rational> steps{Rational(0)};  ///< W and each U, as programmed
  bool offset_given = false;                 ///< a W was among the items

  /// The first element and where the tool stood before it: they decide the side.
  std::optional<UsedElement> first_element;
  Point tool_before;

  std::vector<ContourNotice> notices;
  std::vector<ContourFault> faults;
};

/// Items to legs; everything is decided on the programmed contour.
[[nodiscard]] ContourLegs lay_out(const std::vector<ContourItem>& items, ToolState& state,
                                  const ContourOptions& options);

/// Finds the corners between legs, exactly.
void mark_corners(ContourLegs& legs);

/// How far each step moves an element to the left; null for 0.
using Shifts = std::vector<RationalPtr>;

/// The place of a joint with its elements offset by `shifts`, or the fault that there is none.
/// Near misses within the tolerance are reported as notices.
struct PlacedJoint {
  std::optional<Point> at;
  std::optional<ContourFault> fault;
  std::optional<ContourNotice> notice;
};
[[nodiscard]] PlacedJoint place_joint(const Joint& joint, const Shifts& shifts,
                                      const ContourOptions& options);

/// The way round a corner: on `carrier` from `begin`, which lies on the first offset element, to
/// `end` on the second. Both lie on the carrier exactly.
struct CornerPath {
  Point begin;
  Point end;
  Carrier carrier;
};
/// Whether the joint is a corner with the tool on its outer side.
[[nodiscard]] bool is_outer_corner(const Joint& joint, const Shifts& shifts);
/// Nothing where the offset elements themselves go round, extended to `extended`, if they meet.
/// Precondition: is_outer_corner.
[[nodiscard]] std::optional<CornerPath> path_round(const Joint& corner, const Shifts& shifts,
                                                   const std::optional<Point>& extended,
                                                   const ContourOptions& options);
/// Whether the extended corner lies beyond the limit. Precondition: a corner that is offset.
[[nodiscard]] bool is_long_corner(const Joint& corner, const Shifts& shifts, const Point& extended,
                                  const ContourOptions& options);
/// A rational point within 2⁻¹⁶⁰ mm of `p`.
[[nodiscard]] RationalPoint rational_near(const Point& p);

/// The foot of the normal from `from` on `element`: on a circle, on the ray from its centre through
/// `from`. Precondition: `from` is not the centre.
[[nodiscard]] ExactPoint foot_of_normal(const Element& element, const Point& from);
/// Whether `p` lies on the element within the contact resolution.
[[nodiscard]] bool lies_on(const Element& element, const Point& p);
/// Nothing to see between the two, by the resolution below which legs are left out.
[[nodiscard]] bool indistinct(const Point& a, const Point& b);
/// Sweep in degrees, signed, from plain floating point: for choices between values far apart.
[[nodiscard]] double coarse_sweep(const Circle& circle, const Point& from, const Point& to);

/// One fillet or bevel between two elements, and how the legs join it.
struct Blend {
  ElementPtr element;
  bool tangent = true;  ///< joints are contacts, else crossings
};
/// The fillet arc the rules choose: of the candidates the smallest sweep, then the shortest travel
/// on `a` from `start` (unknown in a first pair); `next` takes the one after.
[[nodiscard]] std::variant<Blend, ContourFault> fillet_between(const Element& a, const Element& b,
                                                               const Rational& radius,
                                                               const std::optional<Point>& start,
                                                               bool next);
[[nodiscard]] std::variant<Blend, ContourFault> chamfer_between(const Element& a, const Element& b,
                                                                const Rational& leg);
[[nodiscard]] std::variant<Blend, ContourFault> tangent_between(const Element& a, const Element& b);

/// Legs shorter than this in both coordinates are left out: what lies between an ideal point and
/// its rational stand-ins is 10⁻²⁰ mm and less, what a person means is 10⁻⁶ mm and more. Unit: mm.
inline constexpr double kLegResolution = 1e-9;

}  // namespace dgt
