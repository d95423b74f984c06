// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/cgal/arrangement.h"
#include "kernel/offset.h"
#include "kernel/offset_raw.h"

namespace dgt {
std::vector<OffsetLoop> reference_offset(const std::vector<Chain>& loops,
                                         const Rational& distance) {
  if (loops.empty()) return {};
  if (sgn(distance) < 0) {  // growing the region is shrinking what lies beyond it
    std::vector<OffsetLoop> result = reference_offset(reversed(loops), -distance);
    reverse_loops(result);
    return result;
  }
  std::vector<OffsetLoop> result =
      cgal::faces_with_winding_number(raw_curve(loops, distance), number_of_region(loops));
  drop_void_loops(result, loops, distance);
  for (OffsetLoop& loop : result) tidy(loop);
  return result;
}

}  // namespace dgt
