// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/control_offset.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dgt {
namespace {

using FaultKind = WriteFault::Kind;

/// A corner of less, in radians, costs the part under a millionth of the offset.
constexpr double kSmoothAngle = 1e-3;

struct Direction {
  double x = 0;
  double y = 0;

  [[nodiscard]] double angle_to(const Direction& other) const {
    return std::atan2(x * other.y - y * other.x, x * other.x + y * other.y);
  }
};

/// Of travel, at the beginning or the end of a cut.
Direction direction_of(const Move& m, bool at_end) {
  if (m.kind == MoveKind::Line) {
    const double dx = m.to.x() - m.from.x();
    const double dy = m.to.y() - m.from.y();
    const double length = std::hypot(dx, dy);
    return length > 0 ? Direction{dx / length, dy / length} : Direction{};
  }
  const Circle circle = m.circle();
  const Point& at = at_end ? m.to : m.from;
  const double x = at.x() - nearest_double(circle.centre().x);
  const double y = at.y() - nearest_double(circle.centre().y);
  const double radius = std::hypot(x, y);
  const double sense = circle.counter_clockwise() ? 1 : -1;
  return {-sense * y / radius, sense * x / radius};
}

/// The cuts of one contour that matter, as places in its moves.
struct Parts {
  std::optional<std::size_t> lead;   ///< the last cut before the contour
  std::optional<std::size_t> first;  ///< of the contour itself
  std::size_t last = 0;
};
Parts parts_of(std::span<const Move> moves) {
  Parts parts;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (!moves[i].cuts()) continue;
    if (is_part(moves[i])) {
      if (!parts.first) parts.first = i;
      parts.last = i;
    } else if (!parts.first) {
      parts.lead = i;
    }
  }
  return parts;
}

/// Whether all elements are offset by the contour's own offset.
bool is_offset_evenly(const Contour& contour, const std::vector<Move>& moves) {
  const Rational offset = abs(contour.offset);
  return std::all_of(moves.begin() + static_cast<std::ptrdiff_t>(contour.first),
                     moves.begin() + static_cast<std::ptrdiff_t>(contour.last), [&](const Move& m) {
                       if (!m.cuts() || m.role != Role::Contour || !m.carrier.base) return true;
                       return m.carrier.shift && abs(*m.carrier.shift) == offset;
                     });
}

void replace(std::string& text, std::string_view what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what))
    text.replace(at, what.size(), by);
}

class Controller {
 public:
  Controller(const Toolpath& path, const Dialect& dialect) : path_(path), dialect_(dialect) {
    made_.path.files = path.files;
    made_.path.start = path.start;
  }

  ControlledPath run() {
    std::size_t next = 0;
    for (const Contour& contour : path_.contours) {
      for (; next < contour.first; ++next) add(path_.moves[next]);
      if (contour.side == Side::None || sgn(contour.offset) == 0) continue;
      if (!add_contour(contour)) break;  // the control has no words for any
      next = contour.last;
    }
    for (; next < path_.moves.size(); ++next) add(path_.moves[next]);
    return std::move(made_);
  }

 private:
  void add(const Move& move) {
    Move& m = made_.path.moves.emplace_back(move);
    // A contour ends elsewhere than its equidistant.
    if (m.kind != MoveKind::Arc && made_.path.moves.size() > 1)
      m.from = made_.path.moves[made_.path.moves.size() - 2].to;
    if (!m.travels()) m.to = m.from;
  }

  void fault(FaultKind kind, const Contour& contour, double measure = 0, double limit = 0) {
    WriteFault fault;
    fault.kind = kind;
    fault.move = contour.first;
    fault.place = path_.moves[contour.first].source;
    fault.measure = measure;
    fault.limit = limit;
    made_.faults.push_back(std::move(fault));
  }

  bool add_contour(const Contour& contour) {
    if (!dialect_.kerf.exist()) {
      fault(FaultKind::KerfImpossible, contour);
      return false;
    }
    const auto moves = programmed_moves(path_, contour);
    const Parts parts = parts_of(moves);
    const auto overlap = judge(contour, parts);
    if (!overlap) return true;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      if (i == *parts.lead)
        say(is_left(contour) ? dialect_.kerf.left : dialect_.kerf.right, contour);
      add(moves[i]);
      if (i != parts.last) continue;
      if (*overlap > 0) add_overlap(moves[*parts.first], moves[parts.last], *overlap);
      say(dialect_.kerf.off, contour);
    }
    return true;
  }

  /// How far to cut on behind the end; nothing when the control cannot do the contour.
  std::optional<double> judge(const Contour& contour, const Parts& parts) {
    const auto moves = programmed_moves(path_, contour);
    const double offset = std::fabs(nearest_double(contour.offset));
    const auto refuse = [&](FaultKind kind, double measure = 0, double limit = 0) {
      fault(kind, contour, measure, limit);
      return std::nullopt;
    };
    if (!is_offset_evenly(contour, path_.moves)) return refuse(FaultKind::OffsetsDiffer);
    if (!parts.first || !parts.lead || moves[*parts.lead].kind != MoveKind::Line)
      return refuse(FaultKind::LeadLacking);
    const Move& lead = moves[*parts.lead];
    const double length = std::hypot(lead.to.x() - lead.from.x(), lead.to.y() - lead.from.y());
    // One unit more, for both are rounded.
    const double needed = offset + nearest_double(dialect_.unit);
    if (!(length > needed)) return refuse(FaultKind::LeadTooShort, length, offset);
    const Move& first = moves[*parts.first];
    const double towards_tool = is_left(contour) ? 1 : -1;
    const Direction begin = direction_of(first, false);
    const double corner = towards_tool * direction_of(moves[parts.last], true).angle_to(begin);
    if (contour.closed && corner > kSmoothAngle) return refuse(FaultKind::BeginsInCorner);
    const double turn = towards_tool * direction_of(lead, true).angle_to(begin);
    if (turn < kSmoothAngle) return 0;
    const double missed = offset * std::tan(turn / 2) + nearest_double(dialect_.unit);
    const double room = std::hypot(first.to.x() - first.from.x(), first.to.y() - first.from.y());
    if (!contour.closed || first.kind != MoveKind::Line || !(missed < room))
      return refuse(FaultKind::OverlapLacking, missed);
    return missed;
  }

  /// Seen along the travel, which may run against the elements.
  bool is_left(const Contour& contour) const {
    const auto programmed = programmed_moves(path_, contour);
    const Parts parts = parts_of(programmed);
    const auto moved = moves_of(path_, contour);
    const Parts moved_parts = parts_of(moved);
    if (!parts.first || !moved_parts.first) return contour.side == Side::Left;
    const Move& first = programmed[*parts.first];
    const Move& beside = moved[*moved_parts.first];
    const Direction along = direction_of(first, false);
    return along.x * (beside.from.y() - first.from.y()) -
               along.y * (beside.from.x() - first.from.x()) >
           0;
  }

  void add_overlap(const Move& first, const Move& last, double length) {
    const Direction along = direction_of(first, false);
    Move m = last;
    m.kind = MoveKind::Line;
    m.full_circle = false;
    m.carrier = {};
    m.z = nullptr;
    m.from = last.to;
    m.to = Point(RationalPoint{Rational(last.to.x() + along.x * length),
                               Rational(last.to.y() + along.y * length)});
    add(m);
  }

  void say(const std::vector<std::string>& words, const Contour& contour) {
    const Rational offset = abs(contour.offset);
    constexpr int kDecimals = 6;
    for (std::string line : words) {
      replace(line, "{offset}", to_short_decimal(offset, kDecimals));
      replace(line, "{width}", to_short_decimal(Rational(2 * offset), kDecimals));
      replace(line, "{units}", nearest_integer(Rational(2 * offset / dialect_.unit)).get_str());
      made_.words[made_.path.moves.size()].push_back(line);
    }
  }

  const Toolpath& path_;
  const Dialect& dialect_;
  ControlledPath made_;
};

}  // namespace

ControlledPath offset_by_control(const Toolpath& path, const Dialect& dialect) {
  return Controller(path, dialect).run();
}

}  // namespace dgt
