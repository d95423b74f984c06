// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QPainter>
#include <QString>
#include <optional>

#include "apps/driver/snapping.h"
#include "apps/studio/drawing/look.h"
#include "apps/studio/drawing/view.h"

namespace dgt::studio {

/// The measure: from one place to another, each caught by what lies near.
class Measuring {
  Q_DECLARE_TR_FUNCTIONS(Measuring)

 public:
  /// The pointer moved.
  void point(const std::vector<const DrawnLayer*>& layers, DrawnPlace pointer, double reach);
  /// The place pointed at is taken: as the first, as the second, or as the first of the next.
  void take();
  void clear();
  void leave() { pointed_.reset(); }  ///< the pointer is elsewhere

  [[nodiscard]] bool has_first() const { return first_.has_value(); }
  [[nodiscard]] bool is_empty() const { return !first_ && !pointed_; }
  [[nodiscard]] std::optional<Measurement> measurement() const;
  /// What is measured, and what it is that the pointer was caught by, for a person.
  [[nodiscard]] QString text(int decimals) const;
  void paint(QPainter& painter, const SheetView& view, const Look& look) const;

 private:
  [[nodiscard]] std::optional<Snap> end() const { return second_ ? second_ : pointed_; }

  std::optional<Snap> first_;
  std::optional<Snap> second_;
  std::optional<Snap> pointed_;
};

}  // namespace dgt::studio
