// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "kernel/element.h"
#include "lang/essi/messages.h"
#include "lang/essi/reader.h"
#include "lang/nc/length.h"

namespace dgt::essi {

/// What increments count.
class Unit {
 public:
  explicit Unit(const Rational& width) : width_(width), length_(width) {}

  /// In mm.
  [[nodiscard]] const Rational& width() const { return width_; }
  /// A number of units.
  [[nodiscard]] Length length(std::int64_t units) const;
  /// The way of two fields.
  [[nodiscard]] Spot way(const Block& block, std::size_t first) const {
    return {length(block.fields.at(first).value), length(block.fields.at(first + 1).value)};
  }

 private:
  Rational width_;
  Length length_;
};

/// The arc of a block, seen from its beginning.
struct Arc {
  Spot chord;
  Spot centre;  ///< of Iso
  Length radius;
  bool is_by_radius = true;
  bool is_half_turn = false;
  bool major = false;
  bool counter_clockwise = true;
};

/// Of a block of five fields; nothing when there is no such arc, which is told. `chord`: the way to
/// its end.
[[nodiscard]] std::optional<Arc> read_arc(const Block& block, const Spot& chord, const Unit& unit,
                                          const EssiOptions& options, Messages& messages,
                                          ArcSummary& summary);

/// The circle of an arc that begins at `from`.
[[nodiscard]] ElementPtr curve_of(const Arc& arc, const Spot& from);

}  // namespace dgt::essi
