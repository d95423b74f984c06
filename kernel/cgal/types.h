// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/cgal/pch.h"
#include "kernel/number.h"

/// CGAL's kernels over the very rationals our public headers carry: nothing is converted.
namespace dgt::cgal {

using LinearKernel = CGAL::Cartesian<Rational>;
using AlgebraicKernel = CGAL::Algebraic_kernel_for_circles_2_2<Rational>;
using CircularKernel = CGAL::Circular_kernel_2<LinearKernel, AlgebraicKernel>;
using RootOf2 = CircularKernel::Root_of_2;

[[nodiscard]] inline RootOf2 to_cgal(const OneRoot& x) {
  return x.is_rational() ? RootOf2(x.a) : RootOf2(x.a, x.b, x.c);
}

[[nodiscard]] inline OneRoot from_cgal(const RootOf2& x) {
  return x.is_extended() ? OneRoot(x.a0(), x.a1(), x.root()) : OneRoot(x.a0());
}

}  // namespace dgt::cgal
