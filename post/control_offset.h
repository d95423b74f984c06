// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "post/write.h"

/// A program for a control that offsets the contours itself.
///
/// The control is told the programmed contour, the side and the offset. The words stand before the
/// straight cut that leads to the contour, on which it comes to its offset, and the words that end
/// it behind the contour's last cut, before what leads away. Inside the contour a control runs
/// where the equidistant runs that was computed, and where that is free of gouges, so is this. At
/// its ends the programmed contour is prolonged or cut short so that the control begins and ends
/// where the equidistant does: control_entry.h, and the foot of its end on the last element.
/// Contours that a control would run otherwise are refused.
namespace dgt {

struct ControlledPath {
  Toolpath path;                                          ///< contours as programmed
  std::map<std::size_t, std::vector<std::string>> words;  ///< before the move
  std::vector<WriteFault> faults;  ///< `move` counts into the path that came in
};

[[nodiscard]] ControlledPath offset_by_control(const Toolpath& path, const Dialect& dialect);

}  // namespace dgt
