// SPDX-License-Identifier: GPL-3.0-or-later
// Precompiled for the sources of this folder alone: CGAL's headers cost more than all our own.
#pragma once

// Root_of_traits first: the circular algebraic kernel looks make_root_of_2 up before its own
// includes have declared it.
#include <CGAL/Algebraic_kernel_for_circles_2_2.h>
#include <CGAL/Cartesian.h>
#include <CGAL/Circular_kernel_2.h>
#include <CGAL/Circular_kernel_intersections.h>
#include <CGAL/Root_of_traits.h>
#include <CGAL/gmpxx.h>
