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
/// it behind the contour's last cut, before the straight cut that leads away. Inside the contour a
/// control runs where the equidistant runs that was computed, and where that is free of gouges, so
/// is this. What is its own are beginning and end:
///
///  * Where the lead turns into the contour towards the side of the tool, by an angle φ, a control
///    that looks ahead (LinuxCNC) meets the first element at offset·tan(φ/2) behind its beginning;
///    one that does not (Fanuc) at its beginning. A closed contour is therefore cut on by so much
///    along its first element, which must be a line of that length.
///  * A contour that begins in an inside corner would be cut into there by one or the other of its
///    ends, and is refused.
namespace dgt {

struct ControlledPath {
  Toolpath path;                                          ///< contours as programmed
  std::map<std::size_t, std::vector<std::string>> words;  ///< before the move
  std::vector<WriteFault> faults;  ///< `move` counts into the path that came in
};

[[nodiscard]] ControlledPath offset_by_control(const Toolpath& path, const Dialect& dialect);

}  // namespace dgt
