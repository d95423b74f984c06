// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "apps/driver/path_match.h"
#include "apps/driver/pipeline.h"
#include "post/dialect.h"

/// The independent proof of an NC program: its text, read back, against the exact path. Nothing of
/// the writers is used; of the dialect only what the control is: its unit and its limit for the
/// radii of an arc.
namespace dgt {

struct VerifyLimits {
  Rational unit;             ///< mm
  Rational radius_mismatch;  ///< the two radii of an arc may differ by this, mm
  Rational deviation;        ///< how far the curves may run apart, mm
};
/// A curve may run this many units beside the exact one, if nobody says otherwise: half a unit on
/// both axes at the ends, 0.71 together, and what a whole-number radius adds in the middle of an
/// arc.
inline constexpr int kDeviationUnits = 2;
[[nodiscard]] VerifyLimits limits_of(const Dialect& dialect);

/// What is wrong, with the blocks that are to blame: the lines first_line to last_line of the
/// program, one as a rule. Line 0: none.
struct VerifyFault {
  enum class Kind : std::uint8_t {
    Start,  ///< dx, dy
    Displaced,
    Deviates,
    WrongKind,
    Lost,
    Ended,
    Surplus,
    Height,          ///< dx: by how much, mm
    Open,            ///< a closed contour is not closed: dx, dy between its ends
    Gouge,           ///< the exact tool cuts into its own contour
    RadiusMismatch,  ///< measure: the difference of the radii, mm
    EndOpen,         ///< measure: how far apart controls end a block that counts steps, mm
  };
  Kind kind;
  std::uint32_t first_line = 0;
  std::uint32_t last_line = 0;
  SourcePlace source;  ///< of the exact move, in its own file; line 0: none
  double dx = 0;       ///< mm
  double dy = 0;
  double measure = 0;
  unsigned contour = 0;  ///< of Open: its number
};
[[nodiscard]] const char* name_of(VerifyFault::Kind kind);

/// A largest value and where it is met.
struct Peak {
  double value = 0;  ///< mm, an upper bound
  std::uint32_t line = 0;
};

struct Certificate {
  std::string program;
  std::string against;
  std::string dialect;
  VerifyLimits limits;
  std::vector<std::string> files;  ///< of the exact path

  bool is_complete = false;  ///< every move of both was compared
  Peak deviation;            ///< both ways
  Peak error_x;
  Peak error_y;
  double drift_x = 0;  ///< the distance at the last stop, an upper bound, mm
  double drift_y = 0;
  std::size_t moves = 0;        ///< of the exact path, that travel
  std::size_t omitted = 0;      ///< too small for the unit
  std::size_t closed = 0;       ///< closed contours, all of which have to close exactly
  std::size_t guarded = 0;      ///< contours with an offset, in none of which the tool may cut
  std::size_t by_control = 0;   ///< of these, offset by the control
  std::vector<KerfLead> leads;  ///< the ways in which the control may come to its offset
  Peak control_error;           ///< of their stops, on either axis, mm
  std::size_t arcs = 0;         ///< of the program
  Peak mismatch;

  struct Row {
    SourcePlace source;
    std::uint32_t first_line = 0;  ///< 0: left out
    std::uint32_t last_line = 0;
    double deviation = 0;
    double error_x = 0;
    double error_y = 0;
  };
  std::vector<Row> rows;  ///< one a move of the exact path
  std::vector<VerifyFault> faults;

  [[nodiscard]] bool holds() const { return is_complete && faults.empty(); }
};

/// `on_progress`: of the exact path's moves. Precondition: both have a tool path.
///
/// Where the program has the control offset its contours, its path is what a control makes of it
/// (lang/nc/kerf.h), and stops of such contours may be off by the deviation: their corners amplify
/// the rounding of the contour. `lead`: how the program was read.
[[nodiscard]] Certificate verify(const Compilation& program, const Compilation& against,
                                 const std::string& dialect, const VerifyLimits& limits,
                                 const OnProgress& on_progress = {},
                                 KerfLead lead = KerfLead::Moved);

}  // namespace dgt
