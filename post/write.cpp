// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/write.h"

#include "post/control_offset.h"
#include "post/essi.h"
#include "post/gcode.h"
#include "post/plan.h"
#include "post/three_b.h"

namespace dgt {
namespace {

std::string spelled(const Plan& plan, const Toolpath& path, const Dialect& dialect,
                    std::vector<WriteFault>& faults) {
  switch (dialect.form) {
    case Form::Essi:
      return essi_text(plan, path, dialect, faults);
    case Form::ThreeB:
      return three_b_text(plan, dialect, faults);
    case Form::Gcode:
      break;
  }
  return gcode_text(plan, path, dialect, faults);
}

WriteResult write_planned(Plan planned, const Toolpath& path, const Dialect& dialect) {
  WriteResult result;
  result.faults = std::move(planned.faults);
  if (result.faults.empty()) {
    result.text = spelled(planned, path, dialect, result.faults);
    for (WriteFault& fault : result.faults)
      if (fault.move < path.moves.size()) fault.place = path.moves[fault.move].source;
    if (!result.faults.empty()) result.text.clear();
  }
  result.report = std::move(planned.report);
  return result;
}

}  // namespace

WriteResult write(const Toolpath& path, const Dialect& dialect, const OnProgress& on_progress) {
  if (dialect.compensation == Compensation::Computed)
    return write_planned(plan(path, dialect, {}, on_progress), path, dialect);
  ControlledPath controlled = offset_by_control(path, dialect);
  WriteResult result = write_planned(plan(controlled.path, dialect, controlled.words, on_progress),
                                     controlled.path, dialect);
  if (controlled.faults.empty()) return result;
  result.text.clear();
  result.faults.insert(result.faults.begin(), controlled.faults.begin(), controlled.faults.end());
  return result;
}

}  // namespace dgt
