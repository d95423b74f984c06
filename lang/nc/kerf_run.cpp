// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/nc/kerf_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dgt {
namespace {

/// Leads have one cut, or a straight one and an arc.
constexpr std::size_t kMostLeads = 2;

/// A gouge as deep as the tool is wide, but for the digits of doubles: its centre goes across.
constexpr double kWhole = 0.999999;

Side opposite(Side side) { return side == Side::Left ? Side::Right : Side::Left; }

Side side_of(const KerfSwitch& kerf) {
  return sgn(kerf.offset) < 0 ? opposite(kerf.side) : kerf.side;
}

BuiltContour equidistant_of(const std::vector<Move>& cuts, const KerfSwitch& kerf,
                            const ContourOptions& options) {
  return build_equidistant(cuts, abs(kerf.offset), side_of(kerf), options);
}

bool goes_on(const Move& move) {
  return move.cuts() && (move.full_circle || !(move.from == move.to));
}

double distance(const Point& a, const Point& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

/// Whether a place lies to the left of a cut.
bool is_left_of(const Move& cut, double x, double y) {
  if (cut.kind == MoveKind::Line) {
    return (cut.to.x() - cut.from.x()) * (y - cut.from.y()) >
           (cut.to.y() - cut.from.y()) * (x - cut.from.x());
  }
  const Circle circle = cut.circle();
  const double from_centre =
      std::hypot(x - nearest_double(circle.centre().x), y - nearest_double(circle.centre().y));
  return (from_centre < std::fabs(nearest_double(circle.radius()))) == circle.counter_clockwise();
}

/// Marks the leads that the gouges of an open run tell of; false when one of them is no lead.
bool mark_gouged_leads(const std::vector<ContourFault>& faults, const KerfSwitch& kerf,
                       std::vector<Move>& programmed) {
  std::vector<std::size_t> cuts;
  for (std::size_t i = 0; i < programmed.size(); ++i)
    if (goes_on(programmed[i])) cuts.push_back(i);
  for (const ContourFault& fault : faults) {
    if (fault.kind != ContourFault::Kind::Gouge) return false;
    const auto at = static_cast<std::size_t>(std::ranges::find(cuts, fault.other) - cuts.begin());
    const bool leads_in = at < kMostLeads;
    if (!leads_in && at + kMostLeads < cuts.size()) return false;
    const bool crosses = fault.measure >= kWhole * std::fabs(nearest_double(kerf.offset));
    const bool is_left = is_left_of(programmed[fault.other], fault.x, fault.y);
    if (!crosses && is_left == (side_of(kerf) == Side::Left)) return false;
    const auto begin = leads_in ? cuts.begin() : cuts.begin() + static_cast<std::ptrdiff_t>(at);
    const auto end = leads_in ? cuts.begin() + static_cast<std::ptrdiff_t>(at + 1) : cuts.end();
    for (auto cut = begin; cut != end; ++cut)
      programmed[*cut].role = leads_in ? Role::LeadIn : Role::LeadOut;
  }
  return std::ranges::any_of(cuts, [&](std::size_t i) { return is_part(programmed[i]); });
}

/// Where the equidistant begins, as a place of the programmed element.
Point foot_of(const Point& at, const Move& cut) {
  const RationalPoint p{Rational(at.x()), Rational(at.y())};
  if (cut.kind == MoveKind::Line) {
    const ExactPoint from = cut.from.exact();
    const ExactPoint to = cut.to.exact();
    const RationalPoint begin{from.x.a, from.y.a};
    const Vector along = RationalPoint{to.x.a, to.y.a} - begin;
    return Point(begin + dot(p - begin, along) / squared_length(along) * along);
  }
  const Circle circle = cut.circle();
  const double x = at.x() - nearest_double(circle.centre().x);
  const double y = at.y() - nearest_double(circle.centre().y);
  const Rational scale = abs(circle.radius()) / Rational(std::hypot(x, y));
  return Point(circle.centre() + scale * (p - circle.centre()));
}

}  // namespace

/// How the tool comes to the contour, and where that begins.
struct KerfEquidistant::Begun {
  std::vector<Move> moves;  ///< the lead, and what goes round a corner behind it
  Point begin;              ///< on the first element, as programmed
};

std::optional<BuiltContour> KerfEquidistant::told(const BuiltContour& built, std::size_t first) {
  messages_.report(built, first);
  if (!built.faults.empty() || built.moves.empty()) return std::nullopt;
  return built;
}

std::optional<BuiltContour> KerfEquidistant::moved(KerfRun& run) {
  ContourOptions strict = options_;
  if (strict.gouge == GougePolicy::Trim) strict.gouge = GougePolicy::Error;
  BuiltContour built = equidistant_of(run.programmed, *run.kerf, strict);
  if (built.faults.empty()) return told(built, run.first);
  std::vector<Move> with_leads = run.programmed;
  while (!built.closed && mark_gouged_leads(built.faults, *run.kerf, with_leads)) {
    BuiltContour tried = equidistant_of(with_leads, *run.kerf, strict);
    if (!tried.faults.empty()) {
      built.faults = std::move(tried.faults);
      continue;
    }
    for (std::size_t i = 0; i < with_leads.size(); ++i) {
      if (with_leads[i].role == run.programmed[i].role) continue;
      messages_.report(Message::KerfLeadTaken, run.first + i, {messages_.text_of(run.first + i)});
    }
    run.programmed = std::move(with_leads);
    return told(tried, run.first);
  }
  return told(equidistant_of(run.programmed, *run.kerf, options_), run.first);
}

std::optional<BuiltContour> KerfEquidistant::led(KerfRun& run, KerfLead way) {
  std::vector<Move>& programmed = run.programmed;
  std::size_t place = 0;
  if (!run.rapid)
    while (!programmed[place].cuts()) ++place;
  const std::size_t behind = run.rapid ? 0 : place + 1;
  std::size_t next = behind;
  while (next < programmed.size() && !goes_on(programmed[next])) ++next;
  Move lead = run.rapid ? *run.rapid : programmed[place];
  if (!check_lead(run, lead, place, next)) return std::nullopt;
  lead.kind = MoveKind::Line;
  lead.role = Role::LeadIn;
  if (!run.rapid) programmed[place].role = Role::LeadIn;

  Begun begun{{}, programmed[next].from};
  if (way == KerfLead::Meets) {
    auto met = meeting(run, lead, place, next);
    if (!met) return std::nullopt;
    begun = *std::move(met);
  }
  std::vector<Move> cuts(programmed.begin() + static_cast<std::ptrdiff_t>(behind),
                         programmed.end());
  cuts[next - behind].from = begun.begin;
  if (!(begun.begin == programmed[next].from)) cuts[next - behind].full_circle = false;
  auto built = told(equidistant_of(cuts, *run.kerf, options_), run.first + behind);
  if (!built) return built;

  std::vector<Move> moves(programmed.begin(),
                          programmed.begin() + static_cast<std::ptrdiff_t>(run.rapid ? 0 : place));
  for (Move& stop : moves) stop.from = stop.to = run.at;
  if (begun.moves.empty()) begun.moves = {lead};
  begun.moves.front().from = run.at;
  begun.moves.front().carrier = {};
  begun.moves.back().to = built->moves.front().from;
  if (run.rapid && begun.moves.size() == 1) begun.moves.clear();
  moves.insert(moves.end(), begun.moves.begin(), begun.moves.end());
  moves.insert(moves.end(), built->moves.begin(), built->moves.end());
  built->moves = std::move(moves);
  return built;
}

bool KerfEquidistant::check_lead(const KerfRun& run, const Move& lead, std::size_t place,
                                 std::size_t next) {
  const double length = distance(run.at, lead.to);
  const double offset = std::fabs(nearest_double(run.kerf->offset));
  if (next == run.programmed.size()) {
    messages_.report(Message::KerfLeadAlone, run.first + place);
  } else if (lead.kind == MoveKind::Arc) {
    messages_.report(Message::KerfLeadArc, run.first + place);
  } else if (!(length > offset)) {
    messages_.report(Message::KerfLeadShort, run.first + place,
                     {fmt::format("{:.6g}", length), fmt::format("{:.6g}", offset)});
  } else {
    return true;
  }
  return false;
}

/// From the lead and the first element alone.
std::optional<KerfEquidistant::Begun> KerfEquidistant::meeting(const KerfRun& run, const Move& lead,
                                                               std::size_t place,
                                                               std::size_t next) {
  const Move& first = run.programmed[next];
  BuiltContour pair = equidistant_of({lead, first}, *run.kerf, options_);
  for (ContourFault& fault : pair.faults) {
    fault.item = fault.item == 0 ? place : next;
    fault.other = fault.other == 0 ? place : next;
    fault.largest_offset.reset();
  }
  pair.notices.clear();
  if (!told(pair, run.first)) return std::nullopt;
  Begun begun;
  std::size_t i = 0;
  for (; i < pair.moves.size() && (i == 0 || pair.moves[i].role == Role::Corner); ++i)
    begun.moves.push_back(pair.moves[i]);
  const Point& at = begun.moves.back().to;
  const Point foot = foot_of(at, first);
  constexpr double kOnePlace = 1e-9;  // mm
  begun.begin = distance(foot, first.from) <= kOnePlace ? first.from : foot;
  return begun;
}

}  // namespace dgt
