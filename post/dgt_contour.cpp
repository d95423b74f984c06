// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/dgt_contour.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dgt {
namespace {

/// Directions that differ by less are one: rounding leaves far less, and no corner is so flat.
/// Unit: radians.
constexpr double kTangent = 1e-6;

struct Heading {
  double x = 0;
  double y = 0;
};

Heading heading(const Move& move, const Point& at) {
  double x = move.to.x() - move.from.x();
  double y = move.to.y() - move.from.y();
  if (move.kind == MoveKind::Arc) {
    const Circle circle = move.circle();
    const double turn = circle.counter_clockwise() ? 1 : -1;
    x = -turn * (at.y() - nearest_double(circle.centre().y));
    y = turn * (at.x() - nearest_double(circle.centre().x));
  }
  const double length = std::hypot(x, y);
  return {x / length, y / length};
}

/// Whether the second goes on in the direction of the first.
bool is_smooth(const Move& first, const Move& second) {
  const Heading a = heading(first, first.to);
  const Heading b = heading(second, first.to);
  return std::fabs(a.x * b.y - a.y * b.x) <= kTangent && a.x * b.x + a.y * b.y > 0;
}

RationalPoint place_along(const Move& arc, double part) {
  const Circle circle = arc.circle();
  const double cx = nearest_double(circle.centre().x);
  const double cy = nearest_double(circle.centre().y);
  const double degrees = sweep_degrees(arc) * part;
  const double angle =
      std::atan2(arc.from.y() - cy, arc.from.x() - cx) + degrees * std::acos(-1.0) / 180;
  const double radius = std::fabs(nearest_double(circle.radius()));
  return {dgt_number(Rational(cx + radius * std::cos(angle))),
          dgt_number(Rational(cy + radius * std::sin(angle)))};
}

RationalPoint circumcentre(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  const Vector u = b - a;
  const Vector v = c - a;
  const Rational turn = 2 * cross(u, v);
  const Rational uu = squared_length(u);
  const Rational vv = squared_length(v);
  return {a.x + (v.y * uu - u.y * vv) / turn, a.y + (u.x * vv - v.x * uu) / turn};
}

std::string feed_of(const Move& move) { return "F" + to_short_decimal(*move.feed, kDgtDecimals); }

/// A code or a dwell.
std::string word_of(const Move& move) {
  if (move.kind == MoveKind::Code) return dgt_code(move.code);
  return "T" + to_short_decimal(*move.seconds, kDgtDecimals);
}

/// A cut of the contour as it is written.
struct Leg {
  const Move* move = nullptr;
  RationalPoint from;
  RationalPoint to;
  std::string name;      ///< of its element; empty for a fillet
  RationalPoint centre;  ///< of a circle, as it is defined
  bool fillet = false;   ///< said as R between its neighbours
  /// What happens before it is cut; in the language it stands behind the element.
  std::vector<std::string> words;

  [[nodiscard]] bool is_line() const { return move->kind == MoveKind::Line; }
  [[nodiscard]] bool ccw() const { return move->circle().counter_clockwise(); }
};

class ContourItems {
 public:
  ContourItems(std::span<const Move> moves, bool closed, DgtStyle style, DgtNames& names)
      : closed_(closed), style_(style), names_(names) {
    std::vector<std::string> words;
    const Rational* feed = nullptr;
    for (const Move& move : moves) {
      if (!move.travels()) {
        words.push_back(word_of(move));
        continue;
      }
      can_be_said_ = can_be_said_ && move.cuts() && !move.z;
      if (move.feed && feed != nullptr && *feed != *move.feed) words.push_back(feed_of(move));
      feed = move.feed.get();
      legs_.push_back({&move,
                       dgt_place(move.from),
                       dgt_place(move.to),
                       "",
                       {},
                       false,
                       std::exchange(words, {})});
    }
  }

  /// `approached`, `departed`: by leads that say where it begins and ends.
  std::optional<std::vector<std::string>> run(bool approached = false, bool departed = false) {
    if (!can_be_said_ || legs_.empty() || !can_be_named()) return std::nullopt;
    if (style_ != DgtStyle::Through) find_fillets();
    for (std::size_t i = 0; i < legs_.size(); ++i)
      if (!legs_[i].is_line()) name_circle(legs_[i]);
    for (std::size_t i = 0; i < legs_.size(); ++i)
      if (legs_[i].is_line()) name_line(i);
    return in_order(approached, departed);
  }

  /// The first element as the one that bounds the last.
  [[nodiscard]] std::string back_to_first() const {
    return selector(legs_.back(), legs_.front()) + legs_.front().name;
  }
  [[nodiscard]] bool ends_in_line() const { return !legs_.empty() && legs_.back().is_line(); }
  /// How far the last one goes along its line.
  [[nodiscard]] std::string last_length() const {
    const Leg& last = legs_.back();
    const Rational length = sqrt_within(squared_length(last.to - last.from), kLengthExponent);
    return "D" + to_short_decimal(dgt_number(length), kDgtDecimals);
  }

 private:
  /// Finer than the last digit that is written.
  static constexpr int kLengthExponent = -80;

  [[nodiscard]] bool can_be_named() const {
    return std::ranges::none_of(legs_, [](const Leg& leg) {
      return leg.from == leg.to && !leg.move->full_circle;  // rounded to nothing
    });
  }

  /// The leg before, or behind; null at the ends of an open contour.
  [[nodiscard]] const Leg* before(std::size_t i) const {
    if (i > 0) return &legs_[i - 1];
    return closed_ && legs_.size() > 1 ? &legs_.back() : nullptr;
  }
  [[nodiscard]] const Leg* behind(std::size_t i) const {
    if (i + 1 < legs_.size()) return &legs_[i + 1];
    return closed_ && legs_.size() > 1 ? &legs_.front() : nullptr;
  }
  [[nodiscard]] bool is_tangent_before(std::size_t i) const {
    const Leg* const other = before(i);
    return other != nullptr && is_smooth(*other->move, *legs_[i].move);
  }
  [[nodiscard]] bool is_tangent_behind(std::size_t i) const {
    const Leg* const other = behind(i);
    return other != nullptr && is_smooth(*legs_[i].move, *other->move);
  }

  /// Arcs of less than half a turn that touch both neighbours, which are lines or larger circles.
  /// Where a contour begins or ends none is: it is met there.
  void find_fillets() {
    for (std::size_t i = 1; i + 1 < legs_.size(); ++i) {
      Leg& leg = legs_[i];
      if (leg.is_line() || leg.move->full_circle || !leg.words.empty()) continue;
      leg.fillet = is_wider(legs_[i - 1], leg) && is_wider(legs_[i + 1], leg) &&
                   is_tangent_before(i) && is_tangent_behind(i) && half_turn_order(*leg.move) < 0;
    }
  }
  static bool is_wider(const Leg& neighbour, const Leg& arc) {
    if (neighbour.fillet) return false;
    if (neighbour.is_line()) return true;
    return abs(neighbour.move->circle().radius()) > abs(arc.move->circle().radius());
  }

  void name_circle(Leg& leg) {
    if (leg.fillet) return;
    const Circle circle = leg.move->circle();
    leg.centre = {dgt_number(circle.centre().x), dgt_number(circle.centre().y)};
    const Rational radius = dgt_number(abs(circle.radius()));
    const bool is_exact = squared_length(leg.from - leg.centre) == radius * radius;
    if (leg.move->full_circle ? is_exact : style_ != DgtStyle::Through) {
      leg.name = names_.circle(leg.centre, radius, leg.ccw());
      return;
    }
    const bool whole = leg.move->full_circle;
    const RationalPoint middle = place_along(*leg.move, whole ? 1.0 / 3 : 0.5);
    const RationalPoint last = whole ? place_along(*leg.move, 2.0 / 3) : leg.to;
    leg.name = names_.circle_through(leg.from, middle, last, leg.ccw());
    leg.centre = circumcentre(leg.from, middle, last);
  }

  /// The name of the circle that the line touches on that side, by which it may be defined.
  [[nodiscard]] const std::string* touched(const Leg* other, bool is_tangent) const {
    if (style_ == DgtStyle::Through || !is_tangent || other == nullptr || other->is_line() ||
        other->fillet)
      return nullptr;
    return &other->name;
  }

  static std::string turned(const std::string& name) {
    return name[1] == '-' ? name[0] + name.substr(2) : name[0] + ("-" + name.substr(1));
  }

  void name_line(std::size_t i) {
    Leg& leg = legs_[i];
    const std::string* const first = touched(before(i), is_tangent_before(i));
    const std::string* const last = touched(behind(i), is_tangent_behind(i));
    const bool is_level = leg.from.x == leg.to.x || leg.from.y == leg.to.y;
    if (is_level || (first == nullptr && last == nullptr)) {
      leg.name = names_.line(leg.from, leg.to);
    } else if (first != nullptr && last != nullptr) {
      leg.name = names_.by_form('L', *first + " " + *last);
    } else if (last != nullptr) {
      leg.name = names_.by_form('L', dgt_coordinates(leg.from) + " " + *last);
    } else {  // from the point to its contact, then the other way
      leg.name = turned(names_.by_form('L', dgt_coordinates(leg.to) + " " + turned(*first)));
    }
  }

  // --- joints

  /// The direction in which the leg passes one of its ends.
  static Vector direction_at(const Leg& leg, const RationalPoint& at) {
    if (leg.is_line()) return leg.to - leg.from;
    const Vector out = at - leg.centre;
    return leg.ccw() ? turned_left(out) : turned_right(out);
  }

  /// `I2 ` where the first crossing of the language is not the one meant (lang/README.md, section
  /// 2); nothing where both are one.
  [[nodiscard]] std::string selector(const Leg& first, const Leg& second) const {
    if (share_element(first, second) || (first.is_line() && second.is_line())) return "";
    if (style_ != DgtStyle::Through && is_smooth(*first.move, *second.move)) return "";
    const RationalPoint& at = second.from;
    // A circle and a line: where the line leaves is I1. Otherwise where the first enters.
    const bool by_second = !first.is_line() && second.is_line();
    const Leg& passing = by_second ? second : first;
    const Leg& disc = by_second ? first : second;
    const int out = sgn(dot(direction_at(passing, at), at - disc.centre));
    if (out == 0) return "";
    return (out > 0) == by_second ? "" : "I2 ";
  }

  /// Whether two legs run on one element, so that only the point between them tells where.
  static bool share_element(const Leg& first, const Leg& second) {
    const auto number = [](const Leg& leg) {
      const std::size_t begin = leg.name.find_first_of("0123456789");
      return begin == std::string::npos ? std::string() : leg.name[0] + leg.name.substr(begin);
    };
    return !first.name.empty() && number(first) == number(second);
  }

  void add_joint(std::vector<std::string>& items, const Leg& first, const Leg& second) {
    if (second.fillet) {
      items.push_back(
          "R" + to_short_decimal(dgt_number(abs(second.move->circle().radius())), kDgtDecimals));
      return;
    }
    if (!first.fillet && share_element(first, second)) items.push_back(names_.point(second.from));
    items.push_back((first.fillet ? "" : selector(first, second)) + second.name);
    items.insert(items.end(), second.words.begin(), second.words.end());
  }

  std::vector<std::string> in_order(bool approached, bool departed) {
    std::vector<std::string> items;
    const bool meets = closed_ && legs_.size() > 1 && !share_element(legs_.back(), legs_.front());
    if (meets) {
      items.push_back(legs_.back().name);
      add_joint(items, legs_.back(), legs_.front());
    } else {
      const Leg& first = legs_.front();
      if (!approached) items.push_back(names_.point(first.from));
      items.push_back(first.name);
      items.insert(items.end(), first.words.begin(), first.words.end());
    }
    for (std::size_t i = 1; i < legs_.size(); ++i) add_joint(items, legs_[i - 1], legs_[i]);
    if (meets)
      items.push_back(selector(legs_.back(), legs_.front()) + legs_.front().name);
    else if (!departed)
      items.push_back(names_.point(legs_.back().to));
    return items;
  }

  bool closed_;
  DgtStyle style_;
  DgtNames& names_;
  bool can_be_said_ = true;
  std::vector<Leg> legs_;
};

/// From point to point, with everything that happens between.
std::vector<std::string> by_points(std::span<const Move> moves, DgtNames& names) {
  // Names run out before coordinates do.
  const bool has_names = moves.size() < kMaxDgtNumber;
  const auto point = [&](const RationalPoint& p) {
    return has_names ? names.point(p) : dgt_coordinates(p);
  };
  std::vector<std::string> items;
  if (!moves.empty()) items.push_back(point(dgt_place(moves.front().from)));
  const Rational* feed = moves.empty() ? nullptr : moves.front().feed.get();
  for (const Move& move : moves) {
    if (!move.travels()) {
      items.push_back(word_of(move));
      continue;
    }
    if (move.feed && (feed == nullptr || *feed != *move.feed)) items.push_back(feed_of(move));
    feed = move.feed.get();
    const RationalPoint from = dgt_place(move.from);
    const RationalPoint to = dgt_place(move.to);
    const std::string height = move.z ? "Z" + to_short_decimal(*move.z, kDgtDecimals) : "";
    if (move.z && move.kind != MoveKind::Arc) items.push_back(height);
    if (move.kind == MoveKind::Rapid) items.emplace_back("G0");
    if (move.kind == MoveKind::Arc) {
      const bool whole = move.full_circle;
      const RationalPoint middle = place_along(move, whole ? 1.0 / 3 : 0.5);
      const RationalPoint last = whole ? place_along(move, 2.0 / 3) : to;
      items.push_back(names.circle_through(from, middle, last, move.circle().counter_clockwise()));
    }
    items.push_back(point(to));
  }
  return items;
}

}  // namespace

std::optional<std::vector<std::string>> dgt_items(std::span<const Move> moves, bool closed,
                                                  DgtStyle style, DgtNames& names) {
  if (style == DgtStyle::Points) return by_points(moves, names);
  return ContourItems(moves, closed, style, names).run();
}

std::optional<std::vector<std::string>> dgt_items_with_leads(std::span<const Move> moves,
                                                             bool closed, DgtStyle style,
                                                             DgtNames& names) {
  const auto is_lead = [](const Move& move) {
    return (move.kind == MoveKind::Line || move.kind == MoveKind::Rapid) && !is_part(move);
  };
  std::size_t first = 0;
  while (first < moves.size() && is_lead(moves[first])) ++first;
  std::size_t last = moves.size();
  while (last > first && is_lead(moves[last - 1])) --last;
  const bool departs = last < moves.size();
  const bool meets = style == DgtStyle::FromMeeting;
  if (first == last || (meets && (!closed || departs))) return std::nullopt;
  ContourItems part(moves.subspan(first, last - first),
                    closed && (meets || (first == 0 && !departs)), style, names);
  if (meets) return part.run();  // the first pair leads there
  // The contact of an approach or departure is no point of its own.
  const bool approached = first > 0;
  const bool bounded = approached && !departs && (closed || part.ends_in_line());
  auto along = part.run(approached, departs || bounded);
  if (!along) return std::nullopt;
  if (bounded) along->push_back(closed ? part.back_to_first() : part.last_length());
  std::vector<std::string> items;
  for (std::size_t i = 0; i < first; ++i) {
    // From where the tool stands a straight way to the next point needs no word.
    if (i > 0 || first == 1) items.push_back(names.point(dgt_place(moves[i].from)));
    if (moves[i].kind == MoveKind::Rapid) items.emplace_back("G0");
  }
  items.insert(items.end(), along->begin(), along->end());
  for (const Move& lead : moves.subspan(last)) {
    if (lead.kind == MoveKind::Rapid) items.emplace_back("G0");
    items.push_back(names.point(dgt_place(lead.to)));
  }
  return items;
}

}  // namespace dgt
