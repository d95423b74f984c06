// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/raw_passings.h"

namespace dgt {

/// The winding numbers on the left of raw curves, carried along them from passing to passing: a
/// strand that comes from the right has its own left, with a number higher by one, behind it. Where
/// each loop begins, a ray tells. Internal to the kernel.
class WindingNumbers {
 public:
  /// The curve from one event to the next on the same loop.
  struct Between {
    int left;           ///< the winding number to the left of it
    std::uint32_t end;  ///< the rank of the event where it ends
  };

  WindingNumbers(const OffsetSource& source, const RawCurve& curve, const RawPassings& passings,
                 OffsetCounts& counts)
      : source_(source), curve_(curve), passings_(passings), counts_(counts) {}

  /// False when double-doubles leave something open. `tree` holds the boxes of the curve, all of
  /// which lie left of x = `right`.
  [[nodiscard]] bool carry(const BoxTree& tree, double right);

  /// Behind the event of a rank.
  [[nodiscard]] const Between& behind(std::uint32_t rank) const { return behind_[rank]; }
  /// To the left of a loop that nothing crosses.
  [[nodiscard]] int of_loop(std::size_t loop) const { return of_loop_[loop]; }

 private:
  struct Number {
    std::uint32_t strand;
    int left;
  };
  std::optional<Number> number_on(std::size_t loop);
  [[nodiscard]] std::optional<std::uint32_t> first_behind_middle(std::uint32_t strand) const;
  template <class Real>
  [[nodiscard]] std::optional<int> number_left_of(std::uint32_t probe) const;
  template <class Real>
  [[nodiscard]] Strand<Real> strand_in(std::uint32_t s) const;

  const OffsetSource& source_;
  const RawCurve& curve_;
  const RawPassings& passings_;
  OffsetCounts& counts_;
  const BoxTree* tree_ = nullptr;
  double right_ = 0;
  std::vector<Between> behind_;
  std::vector<int> of_loop_;
};

}  // namespace dgt
