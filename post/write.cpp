// SPDX-License-Identifier: GPL-3.0-or-later
#include "post/write.h"

#include "post/essi.h"
#include "post/gcode.h"
#include "post/plan.h"

namespace dgt {

WriteResult write(const Toolpath& path, const Dialect& dialect) {
  Plan planned = plan(path, dialect);
  WriteResult result;
  if (planned.faults.empty()) {
    result.text = dialect.form == Form::Essi ? essi_text(planned, dialect)
                                             : gcode_text(planned, path, dialect);
  }
  result.report = std::move(planned.report);
  result.faults = std::move(planned.faults);
  return result;
}

}  // namespace dgt
