// SPDX-License-Identifier: GPL-3.0-or-later
// The quick look at loops against the arrangement that decides what it leaves open.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "kernel/cgal/arrangement.h"
#include "kernel/loop_fault.h"

namespace dgt {
namespace {

/// Few places and few bulges: vertices on edges, overlaps and tangents are ordinary.
std::optional<Chain> any_loop(int reach) {
  std::vector<BulgeVertex> vertices;
  const int n = *rc::gen::inRange(2, 9);
  for (int i = 0; i < n; ++i) {
    const Rational x = *rc::gen::inRange(-reach, reach + 1);
    const Rational y = *rc::gen::inRange(-reach, reach + 1);
    const Rational bulge(*rc::gen::inRange(-4, 5), 4);
    vertices.push_back({{x, y}, *rc::gen::inRange(0, 2) == 0 ? Rational(0) : bulge});
  }
  return chain_of(vertices, true);
}

bool is_odd(const std::vector<Chain>& loops) {
  return cgal::find_odd_face(raw_curve(loops, 0, {}), number_of_region(loops)).has_value();
}

void agree(int reach, std::size_t most) {
  std::vector<Chain> loops;
  for (std::size_t i = *rc::gen::inRange<std::size_t>(1, most + 1); i > 0; --i) {
    auto loop = any_loop(reach);
    RC_PRE(loop.has_value());
    loops.push_back(*std::move(loop));
  }
  const bool odd = is_odd(loops);
  RC_CLASSIFY(odd, "crossing");
  RC_ASSERT(find_loop_fault(loops).has_value() == odd);
}

RC_GTEST_PROP(LoopFaults, OneLoopIsFoundFaultyExactlyWhenItsArrangementIs, ()) { agree(4, 1); }
RC_GTEST_PROP(LoopFaults, SparseLoopsToo, ()) { agree(40, 1); }
RC_GTEST_PROP(LoopFaults, SeveralLoopsToo, ()) { agree(12, 3); }

}  // namespace
}  // namespace dgt
