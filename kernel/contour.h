// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "kernel/construct.h"
#include "kernel/toolpath.h"

/// From a contour's items to its programmed path and its equidistant.
///
/// Nouns. An *item* is one word of the contour with its elements and numbers resolved. A *leg* is a
/// stretch of travel: along an element, or straight. A *joint* is where one leg ends and the next
/// begins; it is kept as a rule (the crossing of these two elements, the foot of that normal), so
/// that the programmed contour and the equidistant are the same legs and joints, evaluated with
/// offset 0 and with the offset. What is chosen (which crossing, which fillet) is chosen once, on
/// the programmed contour.
namespace dgt {

// --- items ------------------------------------------------------------------------------------

/// Go along this element from the joint with what came before.
struct AlongItem {
  ElementPtr element;
};
/// Go straight to a point; beside an element, along its normal there.
struct PointItem {
  Point at;
};
/// Begin or end at the crossing with this line, which is not offset.
struct AxisItem {
  ElementPtr line;
};
struct FilletItem {
  Rational radius;  ///< negative: clockwise only
};
/// With a leg: a chamfer between lines. Without: the common tangent of circles.
struct BevelItem {
  std::optional<Rational> leg;
};
/// Go along the line so far.
struct TravelItem {
  Rational distance;
};
/// W (for the whole contour) or U (from the next element on).
struct OffsetItem {
  Rational distance;
  bool whole_contour = false;
};
struct SelectItem {
  Selector selector;
};
/// G0: the next move not along an element is rapid.
struct RapidItem {};
/// F: working feed in mm/min; 0 makes straight moves rapid until the next F.
struct FeedItem {
  Rational feed;
};
struct HeightItem {
  Rational z;
};
struct DwellItem {
  Rational seconds;
};
/// Passed through in place.
struct CodeItem {
  std::string code;
};
/// G54: the point the work starts or goes on from.
struct ThreadItem {
  RationalPoint at;
};

struct ContourItem {
  std::variant<AlongItem, PointItem, AxisItem, FilletItem, BevelItem, TravelItem, OffsetItem,
               SelectItem, RapidItem, FeedItem, HeightItem, DwellItem, CodeItem, ThreadItem>
      what;
  SourcePlace place;
};

// --- options and state ------------------------------------------------------------------------

enum class OffsetSide : std::uint8_t { Auto, Left, Right };
/// What a tool that cuts into the contour is.
enum class GougePolicy : std::uint8_t {
  Error,
  Warn,
  Trim  ///< the loops that gouge are taken out, with a notice each; an error where that is no
        ///< answer
};

/// How the equidistant goes round a corner on whose outer side the tool runs.
enum class CornerStyle : std::uint8_t {
  Extend,  ///< the offset elements are prolonged until they meet
  Round,   ///< an arc about the programmed corner
  Chamfer  ///< as Extend, but cut across at the limit
};

struct ContourOptions {
  /// Where W > 0 lies; Auto: on the side of the first element where the tool stands before the
  /// first contact.
  OffsetSide offset_side = OffsetSide::Auto;
  /// Offset elements that miss each other by at most this, in mm, are joined at the closest points
  /// with a notice. Default 0.001: a tenth of what a wire machine can show.
  Rational join_tolerance = Rational(1, 1000);
  GougePolicy gouge = GougePolicy::Error;
  /// A gouge of at most this, in mm, is none. Default 0; programs that were rounded gouge by that.
  Rational gouge_tolerance = 0;
  CornerStyle corner = CornerStyle::Extend;
  /// How far from a programmed corner an extended one may lie, in multiples of the offset: beyond
  /// it Extend gives a notice and Chamfer cuts across. ≥ 1. 4 is a corner of 29°, and as far as
  /// drawing programs let a mitre go.
  Rational corner_limit = 4;
};

/// What the machine carries from one contour to the next.
struct ToolState {
  RationalPoint start;  ///< where the program begins: the last G54 before anything moved
  Point at;
  bool moved = false;           ///< G54 sets the start until the first move, then it travels
  RationalPtr feed;             ///< null: never set
  bool straight_rapid = false;  ///< F0 in force
};

/// Offsets that would work are given in whole multiples of this, rounded down: finer than a kerf is
/// ever known. Unit: mm.
inline constexpr int kOffsetStepsPerMillimetre = 1000;

// --- results ----------------------------------------------------------------------------------

/// What is wrong with a contour; `item` and `other` count into the items and name the elements.
struct ContourFault {
  enum class Kind : std::uint8_t {
    NoMeeting,        ///< item and other do not meet; measure: their gap
    SameElement,      ///< item and other are one element: no corner
    Impossible,       ///< a construction failed; see `impossible`
    NoChoice,         ///< a selector that selects nothing
    EqualCandidates,  ///< X> and the like between equal coordinates
    UnusedSelector,   ///< nothing follows that it could select on
    NothingToJoin,    ///< R, V or D without the element before or after it
    BevelKinds,       ///< V with a value at a circle, without one at a line
    TravelOnCircle,   ///< D along a circle
    CentreApproach,   ///< the normal from the centre of a circle is not defined
    OffsetTwice,      ///< W again or after the first element
    OffsetAtTangent,  ///< U where a fillet or tangent joins
    SideUnknown,      ///< W with the tool exactly on the first element
    SideOfNegative,   ///< W < 0 with the side left to the program
    Eaten,            ///< the offset eats the element; measure: what is missing
    ArcEaten,         ///< the offset makes the ends of the arc pass each other
    BlendsOverlap,    ///< the element is too short for the blends at its ends; measure: by how much
    ZeroArc,          ///< an arc that begins and ends at one point
    RapidArc,         ///< an arc while straight moves are rapid (F0)
    OffElement,       ///< D from a point that is not on the line; measure: distance
    ZeroValue,        ///< a fillet or chamfer of 0
    Overrun,  ///< the ends of the arc pass each other: the tool does not fit between its neighbours
    Gouge,    ///< beside item the tool cuts into other; measure: how deep; at x, y
    TrimStart,   ///< nothing to trim to: beside item, at x, y, the tool cuts in where it begins
    TrimBroken,  ///< trimmed, the path along item has no way on at x, y
    TrimSplits,  ///< trimmed, a part of the work is not reached any more: beside item, at x, y
    TrimNothing  ///< trimmed, nothing is left
  };
  Kind kind;
  std::size_t item = 0;
  std::size_t other = 0;
  double measure = 0;           ///< mm
  bool on_equidistant = false;  ///< fine as programmed; the offset does it
  std::optional<Impossible> impossible;
  /// When the offset does it: the largest W, a multiple of 1/kOffsetStepsPerMillimetre, and scaled
  /// down together with any U, with which this stretch still works.
  std::optional<Rational> largest_offset;
  double x = 0, y = 0;  ///< of a gouge: where the tool stands, mm
  /// Of elements that miss each other beyond an outer corner: CornerStyle::Round makes the contour.
  bool round_works = false;
};

/// What the programmer should know although it works.
struct ContourNotice {
  enum class Kind : std::uint8_t {
    SideChosen,        ///< by the position of the tool relative to the element `item`
    JoinedGap,         ///< item and other miss each other by `measure` and were joined
    AgainstDirection,  ///< the line `item` is cut against its direction while W ≠ 0
    LongCorner,        ///< extended, the corner of item and other lies beyond the limit; measure:
                       ///< how far from the programmed one; at x, y
    Gouge,             ///< as the fault, when gouges only warn
    Trimmed            ///< what lies between item and other is left out; at x, y they meet
  };
  Kind kind;
  std::size_t item = 0;
  std::size_t other = 0;
  double measure = 0;  ///< mm
  Side side = Side::None;
  bool on_equidistant = false;
  std::optional<Rational> largest_offset{};
  double x = 0, y = 0;
};

struct BuiltContour {
  Rational offset;
  Side side = Side::None;
  bool closed = false;
  std::vector<Move> programmed;
  std::vector<Move> moves;
  std::vector<ContourNotice> notices;
  std::vector<ContourFault> faults;  ///< not empty: the moves are not to be used
};

/// Builds the programmed contour first, then the equidistant from the same legs; `state` goes on to
/// where the tool ends. All independent faults are reported.
[[nodiscard]] BuiltContour build_contour(const std::vector<ContourItem>& items, ToolState& state,
                                         const ContourOptions& options);

/// The equidistant of cuts that are known already, as a program for a control has them: lines, arcs
/// and full circles that follow each other, with rational ends, and dwells and codes among them.
///  (1) Each cut keeps its element, `distance` mm to `side` of its direction of travel, and the
///      joints between them become what they are in a contour of elements: crossings, corners by
///      the options, and beside their places where one goes on in the direction of the other.
///  (2) The ends move along the normals there; cuts that end where they began are joined there as
///      anywhere else, unless they end in the direction they came from.
///  (3) `item` and `other` of faults and notices count into `cuts`.
/// Precondition: something travels, distance > 0 and side is not None.
[[nodiscard]] BuiltContour build_equidistant(const std::vector<Move>& cuts,
                                             const Rational& distance, Side side,
                                             const ContourOptions& options);

}  // namespace dgt
