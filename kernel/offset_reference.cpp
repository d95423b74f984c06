// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/cgal/arrangement.h"
#include "kernel/offset.h"
#include "kernel/offset_raw.h"

namespace dgt {
std::vector<OffsetLoop> shrunk_by_reference(const std::vector<Chain>& loops,
                                            const Rational& distance, int number,
                                            const OffsetOptions& options) {
  std::vector<OffsetLoop> result =
      cgal::faces_with_winding_number(raw_curve(loops, distance, options), number);
  drop_void_loops(result, loops, distance);
  return result;
}

std::vector<OffsetLoop> reference_offset(const std::vector<Chain>& loops, const Rational& distance,
                                         const OffsetOptions& options) {
  if (loops.empty()) return {};
  const bool grows = sgn(distance) < 0;  // growing the region is shrinking what lies beyond it
  const std::vector<Chain> shrunk = grows ? reversed(loops) : loops;
  std::vector<OffsetLoop> result =
      shrunk_by_reference(shrunk, abs(distance), number_of_region(shrunk), options);
  if (grows) reverse_loops(result);
  for (OffsetLoop& loop : result) tidy(loop);
  return result;
}

}  // namespace dgt
