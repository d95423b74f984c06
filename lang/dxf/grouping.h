// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "kernel/point.h"

namespace dgt {

/// Ends this near are one place: drawing programs keep six to sixteen digits, and nothing that is
/// drawn on purpose is so small. Unit: mm.
[[nodiscard]] const Rational& dxf_one_place();

/// Two coordinates as doubles: what is told to a person, and what sorts.
struct Spotted {
  double x = 0;
  double y = 0;
};
[[nodiscard]] Spotted spotted(const RationalPoint& p);
/// Whether two places are at most `distance` mm apart, exactly.
[[nodiscard]] bool are_within(const RationalPoint& a, const RationalPoint& b,
                              const Rational& distance);
[[nodiscard]] double distance_between(const RationalPoint& a, const RationalPoint& b);

/// Members in groups; each is called by its smallest.
class Groups {
 public:
  explicit Groups(std::size_t count);
  [[nodiscard]] std::size_t of(std::size_t i);
  void unite(std::size_t i, std::size_t j);

 private:
  std::vector<std::size_t> parent_;
};

/// Groups those of the places that `members` names: each lies within the distance of another of
/// its group.
[[nodiscard]] Groups grouped(const std::vector<RationalPoint>& places,
                             const std::vector<std::size_t>& members, const Rational& distance);

}  // namespace dgt
