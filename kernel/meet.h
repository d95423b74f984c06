// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <variant>

#include "kernel/element.h"

/// Where oriented elements meet, as named cases.
///
/// Two stages decide. Balls over long double settle almost every question at about the price of
/// floating point; what they leave open is settled in rationals and, for the crossings themselves,
/// by CGAL's exact circular kernel. Both stages give the same answer wherever the first gives one.
namespace dgt {

/// Which of two crossings of `a` with `b`: where `a` enters the disc of the circle, or where it
/// leaves it. Of a circle `a` and a line `b` it is the line that enters and leaves the disc of `a`.
enum class Which : std::uint8_t { Entry, Exit };

[[nodiscard]] constexpr Which other(Which w) {
  return w == Which::Entry ? Which::Exit : Which::Entry;
}

/// A point of a tool path: doubles correctly rounded from the exact coordinates, and these when
/// asked for. Copying shares the exact form.
class Point {
 public:
  Point() = default;  ///< the origin
  explicit Point(const RationalPoint& p);
  explicit Point(const ExactPoint& p);
  /// The crossing of two carriers that are known to cross. `x`, `y`: its coordinates when the
  /// filter has them already.
  static Point crossing(const Carrier& a, const Carrier& b, Which which);

  /// A point whose coordinates are known correctly rounded, and whose exact form is worked out by
  /// `exact` when somebody asks for it.
  static Point on_demand(double x, double y, std::function<ExactPoint()> exact);

  /// The point of two decimals, in steps of 10⁻⁹ mm: as exact as any and without a form of its
  /// own, since its doubles tell which steps they are nearest to. Programs of a control have
  /// millions. Precondition (checked): both are within ±kMaxDecimalSteps.
  static constexpr std::int64_t kDecimalStepsPerMillimetre = 1'000'000'000;
  static constexpr std::int64_t kMaxDecimalSteps = std::int64_t{1} << 50;  // 1126 m
  static Point decimal(std::int64_t x, std::int64_t y);

  /// Millimetres, the double nearest to the exact coordinate (0 within 2⁻⁶⁴ mm of it).
  [[nodiscard]] double x() const { return x_; }
  [[nodiscard]] double y() const { return y_; }
  [[nodiscard]] ExactPoint exact() const;

  /// Whether both lie at one place, exactly. Different doubles prove that they do not.
  friend bool operator==(const Point& a, const Point& b);

 private:
  struct Crossing {
    Carrier a;
    Carrier b;
    Which which;
  };
  struct Decimal {};
  using Form = std::variant<RationalPoint, Crossing, std::unique_ptr<const ExactPoint>,
                            std::function<ExactPoint()>, Decimal>;

  double x_ = 0;
  double y_ = 0;
  std::shared_ptr<const Form> form_;  // null: the origin
};

/// No common point; lines that are parallel, circles apart or one inside the other.
struct Apart {
  OneRoot gap;  ///< the least distance between the two, in mm, exactly
  ExactPoint on_a,
      on_b;  ///< where they come nearest (parallel lines, concentric circles: anywhere)
  bool anywhere = false;  ///< the gap is the same everywhere
};
/// The same points: one line or one circle, in either direction.
struct Coincident {};
/// One common point: two lines that cross, or a contact.
struct OnePoint {
  Point at;
  bool contact = false;
};
/// A line and a circle, or two circles, that cross.
struct TwoPoints {
  Carrier a;
  Carrier b;
  [[nodiscard]] Point at(Which which) const { return Point::crossing(a, b, which); }
};
using Meeting = std::variant<Apart, Coincident, OnePoint, TwoPoints>;

/// Where `a` and `b` meet.
///  (1) Every crossing returned lies on both, exactly; a contact lies on both within 2⁻⁷⁰ mm, and
///  on
///      the circle exactly when the contact is exact.
///  (2) meet(b, a) returns the same points; of two circles that turn the same way Entry and Exit
///      change places: where the first enters the second, the second leaves the first.
///  (3) Reversing the element whose motion counts exchanges Entry and Exit and changes nothing
///  else.
[[nodiscard]] Meeting meet(const Carrier& a, const Carrier& b);
[[nodiscard]] Meeting meet(const Element& a, const Element& b);

/// The carrier of an element that is not offset.
[[nodiscard]] Carrier carrier(const Element& e);

/// Unfiltered stages, for the tests that hold one against the other.
namespace stages {
enum class Verdict : std::uint8_t { Apart, Contact, Crossing, Unknown };
[[nodiscard]] Verdict filtered(const Carrier& a, const Carrier& b);
[[nodiscard]] Verdict exact(const Element& a, const Element& b);
/// The crossing by the exact stage alone. Precondition: a line and a circle or two circles that
/// cross.
[[nodiscard]] ExactPoint exact_crossing(const Element& a, const Element& b, Which which);
}  // namespace stages

}  // namespace dgt
