// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/compare.h"

#include <algorithm>

namespace dgt {
namespace {

using Kind = RowDifference::Kind;

/// The rows between the blank ones at both ends.
struct Punched {
  std::span<const Row> rows;
  std::size_t first = 0;  // of them, on the tape
};

Punched punched(std::span<const Row> rows) {
  const auto is_punched = [](Row row) { return row != kBlankRow; };
  const auto first = std::ranges::find_if(rows, is_punched);
  const auto last = std::find_if(rows.rbegin(), std::make_reverse_iterator(first), is_punched);
  return {{first, last.base()}, static_cast<std::size_t>(first - rows.begin())};
}

class Comparison {
 public:
  Comparison(std::span<const Row> wanted, std::span<const Row> found)
      : wanted_(punched(wanted)), found_(punched(found)) {}

  TapeDifferences compare() {
    for (;;) {
      skip_equal();
      const std::size_t wanted = wanted_.rows.size() - i_;
      const std::size_t found = found_.rows.size() - j_;
      if (wanted == 0 && found == 0) return std::move(differences_);
      const Shift shift = shift_here(wanted, found);
      for (std::size_t n = 0; n < shift.missing; ++n, ++i_) add(Kind::Missing);
      for (std::size_t n = 0; n < shift.extra; ++n, ++j_) add(Kind::Extra);
      if (shift.missing + shift.extra > 0) continue;
      add(Kind::Changed);
      ++i_;
      ++j_;
    }
  }

 private:
  /// So many rows are missing, or too many; neither: one is changed.
  struct Shift {
    std::size_t missing = 0;
    std::size_t extra = 0;
  };
  [[nodiscard]] Shift shift_here(std::size_t wanted, std::size_t found) const {
    if (wanted == 0 || found == 0) return {wanted, found};
    const bool is_hopeless = differences_.count > TapeDifferences::kMost;
    if (is_hopeless || in_step(i_ + 1, j_ + 1)) return {};
    for (std::size_t n = 1; n <= kMostShift; ++n) {
      if (n <= wanted && in_step(i_ + n, j_)) return {n, 0};
      if (n <= found && in_step(i_, j_ + n)) return {0, n};
    }
    return {};
  }
  void skip_equal() {
    while (i_ < wanted_.rows.size() && j_ < found_.rows.size() &&
           wanted_.rows[i_] == found_.rows[j_]) {
      ++i_;
      ++j_;
    }
  }
  /// Whether the next rows agree, up to the end of either tape.
  [[nodiscard]] bool in_step(std::size_t i, std::size_t j) const {
    const auto a = wanted_.rows.subspan(std::min(i, wanted_.rows.size()));
    const auto b = found_.rows.subspan(std::min(j, found_.rows.size()));
    if (a.size() < kInStep || b.size() < kInStep) return std::ranges::equal(a, b);
    return std::ranges::equal(a.first(kInStep), b.first(kInStep));
  }
  void add(Kind kind) {
    ++differences_.count;
    if (differences_.rows.size() == TapeDifferences::kMost) return;
    differences_.rows.push_back({kind, wanted_.first + i_, found_.first + j_,
                                 kind == Kind::Extra ? kBlankRow : wanted_.rows[i_],
                                 kind == Kind::Missing ? kBlankRow : found_.rows[j_]});
  }

  Punched wanted_;
  Punched found_;
  std::size_t i_ = 0;
  std::size_t j_ = 0;
  TapeDifferences differences_;
};

}  // namespace

TapeDifferences compare_rows(std::span<const Row> wanted, std::span<const Row> found) {
  return Comparison(wanted, found).compare();
}

}  // namespace dgt
