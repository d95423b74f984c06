// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/cgal/one_root_order.h"

#include "kernel/cgal/types.h"

namespace dgt::cgal {

int sign(const OneRoot& x) { return static_cast<int>(CGAL::sign(to_cgal(x))); }

int compare(const OneRoot& x, const OneRoot& y) {
  return static_cast<int>(CGAL::compare(to_cgal(x), to_cgal(y)));
}

}  // namespace dgt::cgal
