// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "kernel/contour.h"
#include "lang/nc/kerf_messages.h"
#include "lang/nc/program.h"

namespace dgt {

/// One run of cuts under one kerf.
struct KerfRun {
  std::vector<Move> programmed;  ///< with the dwells and codes among them; cuts that are no part
                                 ///< of the contour get the roles of leads
  std::size_t first = 0;         ///< the first of them among the moves of the program
  const KerfSwitch* kerf = nullptr;
  Point at;                   ///< where the tool stands before
  std::optional<Move> rapid;  ///< that leads there, if the kerf is on already
};

/// The equidistant of a run; nothing with a fault, which is told.
///  (1) KerfLead::Moved: of all of it. A gouge into one of the first or last cuts of a run that
///  does
///      not close, by a tool that stands on its far side or goes across,
///      tells that it is a lead: such cuts are
///      told as warnings, and what the tool does to them is no fault.
///  (2) Else the first cut, or `rapid`, leads straight from `at` to it. Of a rapid the moves are
///      those behind it.
class KerfEquidistant {
 public:
  KerfEquidistant(const ContourOptions& options, KerfMessages& messages)
      : options_(options), messages_(messages) {}

  [[nodiscard]] std::optional<BuiltContour> moved(KerfRun& run);
  [[nodiscard]] std::optional<BuiltContour> led(KerfRun& run, KerfLead way);

 private:
  struct Begun;
  [[nodiscard]] std::optional<BuiltContour> told(const BuiltContour& built, std::size_t first);
  [[nodiscard]] bool check_lead(const KerfRun& run, const Move& lead, std::size_t place,
                                std::size_t next);
  [[nodiscard]] std::optional<Begun> meeting(const KerfRun& run, const Move& lead,
                                             std::size_t place, std::size_t next);

  const ContourOptions& options_;
  KerfMessages& messages_;
};

}  // namespace dgt
