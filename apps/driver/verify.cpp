// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/driver/verify.h"

#include <algorithm>
#include <cmath>

#include "apps/driver/run_in.h"

namespace dgt {
namespace {

using Kind = VerifyFault::Kind;

/// The readers tell the difference of two radii in doubles: 10⁻¹² mm is a thousand times what that
/// leaves open for radii of a metre.
const Rational& radii_rounding() {
  static const Rational kRounding(1, 1'000'000'000'000);
  return kRounding;
}

Kind kind_of(MatchFault::Kind kind) {
  switch (kind) {
    case MatchFault::Kind::Start:
      return Kind::Start;
    case MatchFault::Kind::Displaced:
      return Kind::Displaced;
    case MatchFault::Kind::Deviates:
      return Kind::Deviates;
    case MatchFault::Kind::WrongKind:
      return Kind::WrongKind;
    case MatchFault::Kind::Lost:
      return Kind::Lost;
    case MatchFault::Kind::Ended:
      return Kind::Ended;
    case MatchFault::Kind::Surplus:
      break;
  }
  return Kind::Surplus;
}

/// The height in force before each move and, at the end, behind the last; null: never said.
std::vector<RationalPtr> heights_before(const std::vector<Move>& moves) {
  std::vector<RationalPtr> heights;
  heights.reserve(moves.size() + 1);
  heights.push_back(nullptr);
  for (const Move& move : moves) heights.push_back(move.z ? move.z : heights.back());
  return heights;
}

class Verifier {
 public:
  Verifier(const Compilation& program, const Compilation& against, const std::string& dialect,
           const VerifyLimits& limits, KerfLead lead)
      : program_(program),
        against_(against),
        written_(*program.result.path),
        begun_(program.has_kerf
                   ? with_run_ins(*against.result.path, *program.result.path, limits.unit)
                   : Toolpath{}),
        exact_(program.has_kerf ? begun_ : *against.result.path) {
    proof_.program = program.file->name();
    proof_.against = against.file->name();
    proof_.dialect = dialect;
    proof_.limits = limits;
    proof_.files = exact_.files;
    if (!program.has_kerf) return;
    proof_.leads = {lead};
    offset_by_control_.resize(exact_.moves.size());
    for (const Contour& contour : exact_.contours) {
      if (contour.side == Side::None) continue;
      for (std::size_t i = contour.first; i < contour.last; ++i) offset_by_control_[i] = true;
    }
  }

  Certificate run(const OnProgress& on_progress) {
    match_ = match(written_, exact_,
                   {proof_.limits.unit, proof_.limits.deviation, tells_cuts(), on_progress,
                    offset_by_control_});
    proof_.is_complete = match_.is_complete;
    take_faults();
    take_rows();
    check_heights();
    check_contours();
    take_gouges();
    check_radii();
    check_ends();
    const auto by_line = [](const VerifyFault& a, const VerifyFault& b) {
      return a.first_line < b.first_line;
    };
    std::stable_sort(proof_.faults.begin(), proof_.faults.end(), by_line);
    return std::move(proof_);
  }

 private:
  bool tells_cuts() const {
    const auto& told = program_.bag.all();
    return std::none_of(told.begin(), told.end(), [](const Diagnostic& diagnostic) {
      return diagnostic.message == Message::TorchNeverOn;
    });
  }

  std::uint32_t line_of(std::size_t move) const {
    return move < written_.moves.size() ? written_.moves[move].source.line : 0;
  }

  void add(Kind kind, std::size_t exact, std::uint32_t first_line, std::uint32_t last_line,
           double measure) {
    VerifyFault fault{};
    fault.kind = kind;
    fault.first_line = first_line;
    fault.last_line = last_line;
    if (exact < exact_.moves.size()) fault.source = exact_.moves[exact].source;
    fault.measure = measure;
    proof_.faults.push_back(fault);
  }

  // --- what the match says

  void take_faults() {
    for (const MatchFault& fault : match_.faults) {
      add(kind_of(fault.kind), fault.exact, line_of(fault.first), line_of(fault.last),
          fault.measure);
      VerifyFault& told = proof_.faults.back();
      told.dx = fault.dx;
      told.dy = fault.dy;
      if (fault.kind == MatchFault::Kind::Start)
        told.first_line = told.last_line = program_.placed_by.line;
    }
  }

  void take_rows() {
    proof_.moves = match_.moves.size();
    proof_.rows.reserve(match_.moves.size());
    for (const MatchedMove& move : match_.moves) {
      Certificate::Row row{
          exact_.moves[move.exact].source, 0, 0, move.deviation, move.error_x, move.error_y};
      if (move.last > move.first) {
        row.first_line = line_of(move.first);
        row.last_line = line_of(move.last - 1);
      } else {
        ++proof_.omitted;
      }
      raise(proof_.deviation, row.deviation, row.last_line);
      if (is_by_control(move.exact)) {
        raise(proof_.control_error, std::max(row.error_x, row.error_y), row.last_line);
      } else {
        raise(proof_.error_x, row.error_x, row.last_line);
        raise(proof_.error_y, row.error_y, row.last_line);
      }
      proof_.drift_x = row.error_x;
      proof_.drift_y = row.error_y;
      proof_.rows.push_back(row);
    }
  }

  bool is_by_control(std::size_t exact) const {
    return !offset_by_control_.empty() && offset_by_control_[exact];
  }

  static void raise(Peak& peak, double value, std::uint32_t line) {
    if (value > peak.value) peak = {value, line};
  }

  // --- heights

  void check_heights() {
    const std::vector<RationalPtr> meant = heights_before(exact_.moves);
    const std::vector<RationalPtr> written = heights_before(written_.moves);
    if (!written.back()) return;  // the control has no Z, or the path
    for (const MatchedMove& move : match_.moves) {
      if (move.first == move.last) continue;
      check_height(meant[move.exact + 1], written[move.last], move);
    }
  }

  void check_height(const RationalPtr& meant, const RationalPtr& written, const MatchedMove& move) {
    if (!meant || !written) return;
    const Rational off = *written - *meant;
    if (abs(off) * 2 <= proof_.limits.unit) return;
    add(Kind::Height, move.exact, line_of(move.first), line_of(move.last - 1), 0);
    proof_.faults.back().dx = nearest_double(off);
  }

  // --- contours

  /// The match of the exact moves [first, last).
  std::vector<const MatchedMove*> matched(const Contour& contour) const {
    const auto before = [](const MatchedMove& move, std::size_t exact) {
      return move.exact < exact;
    };
    std::vector<const MatchedMove*> found;
    auto at = std::lower_bound(match_.moves.begin(), match_.moves.end(), contour.first, before);
    for (; at != match_.moves.end() && at->exact < contour.last; ++at) {
      if (is_part(exact_.moves[at->exact])) found.push_back(&*at);
    }
    return found;
  }

  void check_contours() {
    for (const Contour& contour : exact_.contours) {
      const auto moves = matched(contour);
      if (moves.empty()) continue;
      check_closed(contour, moves);
      if (contour.side == Side::None) continue;
      ++proof_.guarded;
      if (program_.has_kerf) ++proof_.by_control;
    }
  }

  /// Where the program stands before and behind a move of the exact path.
  Point begin_of(const MatchedMove& move) const {
    if (move.first < written_.moves.size()) return written_.moves[move.first].from;
    return written_.moves.empty() ? Point(written_.start) : written_.moves.back().to;
  }
  Point end_of(const MatchedMove& move) const {
    return move.last > move.first ? written_.moves[move.last - 1].to : begin_of(move);
  }

  void check_closed(const Contour& contour, const std::vector<const MatchedMove*>& moves) {
    const MatchedMove& first = *moves.front();
    const MatchedMove& last = *moves.back();
    if (!(exact_.moves[first.exact].from == exact_.moves[last.exact].to)) return;
    ++proof_.closed;
    const Point begin = begin_of(first);
    const Point end = end_of(last);
    if (begin == end) return;
    // The control's own arithmetic ends there: within the deviation is all that can be asked.
    const double gap = nearest_double(proof_.limits.deviation);
    if (is_by_control(first.exact) && std::hypot(end.x() - begin.x(), end.y() - begin.y()) <= gap)
      return;
    const std::uint32_t line = last.last > 0 ? line_of(last.last - 1) : 0;
    add(Kind::Open, last.exact, line, line, 0);
    VerifyFault& fault = proof_.faults.back();
    fault.contour = contour.id;
    fault.dx = end.x() - begin.x();
    fault.dy = end.y() - begin.y();
  }

  /// That the exact tool keeps off the contour was decided exactly when the path was built; what
  /// cuts into it all the same was let through by a setting and told. The program lies within its
  /// deviation of the exact path, so the tool of the program comes no nearer by more than that.
  void take_gouges() {
    for (const Diagnostic& diagnostic : against_.bag.all()) {
      if (diagnostic.message != Message::GougeAllowed) continue;
      add(Kind::Gouge, exact_.moves.size(), 0, 0, 0);
      const Place place = diagnostic.range.place();
      proof_.faults.back().source = {0, place.line, place.column};
    }
  }

  // --- arcs

  void check_radii() {
    proof_.arcs = program_.arcs.arcs;
    const Rational most = proof_.limits.radius_mismatch + radii_rounding();
    std::size_t told = 0;
    for (const auto& [block, difference] : program_.arcs.mismatches) {
      const std::uint32_t line = block.file->line_at(block.begin);
      raise(proof_.mismatch, difference, line);
      if (Rational(difference) > most && told++ < kMaxMatchFaults)
        add(Kind::RadiusMismatch, exact_.moves.size(), line_before(line), line, difference);
    }
  }

  /// That the program ends its blocks where it was read to end them, whatever control runs it.
  void check_ends() {
    std::size_t told = 0;
    for (const auto& [block, distance] : program_.arcs.apart) {
      const std::uint32_t line = block.file->line_at(block.begin);
      if (told++ == kMaxMatchFaults) break;
      add(Kind::EndOpen, exact_.moves.size(), line, line, distance);
    }
  }

  /// Where an arc begins inside a divided one, the stop before may be to blame as well: nothing
  /// else says where it should be.
  std::uint32_t line_before(std::uint32_t line) const {
    const auto inside = [line](const Certificate::Row& row) {
      return row.first_line < line && line <= row.last_line;
    };
    if (std::none_of(proof_.rows.begin(), proof_.rows.end(), inside)) return line;
    std::uint32_t before = line;
    for (const Move& move : written_.moves) {
      if (move.source.line == line) break;
      if (move.travels()) before = move.source.line;
    }
    return before;
  }

  const Compilation& program_;
  const Compilation& against_;
  const Toolpath& written_;
  const Toolpath begun_;  ///< the exact path as the control begins it
  const Toolpath& exact_;
  std::vector<bool> offset_by_control_;  ///< moves of the exact path
  PathMatch match_;
  Certificate proof_;
};

}  // namespace

VerifyLimits limits_of(const Dialect& dialect) {
  return {dialect.unit, dialect.radius_mismatch, kDeviationUnits * dialect.unit};
}

const char* name_of(VerifyFault::Kind kind) {
  switch (kind) {
    case Kind::Start:
      return "start";
    case Kind::Displaced:
      return "displaced";
    case Kind::Deviates:
      return "deviates";
    case Kind::WrongKind:
      return "wrong-kind";
    case Kind::Lost:
      return "lost";
    case Kind::Ended:
      return "ended";
    case Kind::Surplus:
      return "surplus";
    case Kind::Height:
      return "height";
    case Kind::Open:
      return "open";
    case Kind::Gouge:
      return "gouge";
    case Kind::RadiusMismatch:
      return "radius-mismatch";
    case Kind::EndOpen:
      break;
  }
  return "end-open";
}

Certificate verify(const Compilation& program, const Compilation& against,
                   const std::string& dialect, const VerifyLimits& limits,
                   const OnProgress& on_progress, KerfLead lead) {
  return Verifier(program, against, dialect, limits, lead).run(on_progress);
}

}  // namespace dgt
