// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "apps/driver/summary.h"
#include "apps/studio/drawing/scene.h"

class QDoubleSpinBox;
class QLabel;

namespace dgt::studio {

/// The upper edge of the drawing, as in the guide: where the pointer is in the part's scale, how
/// long the part's lines are, and at the right the factor by which a click magnifies.
class Readout : public QWidget {
  Q_OBJECT

 public:
  explicit Readout(QWidget* parent = nullptr);

  void show_scene(const ScenePtr& scene);
  /// They take longer than a drawing, and come after it.
  void show_lengths(const std::optional<WayLengths>& lengths);
  void set_decimals(int decimals);
  [[nodiscard]] double factor() const;
  [[nodiscard]] int decimals() const { return decimals_; }

 public slots:
  void show_pointer(double x, double y);
  void show_no_pointer();

 signals:
  void factor_changed(double factor);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();
  void refresh();
  [[nodiscard]] QString lengths_text() const;

  std::optional<DrawnPlace> pointer_;
  std::optional<WayLengths> lengths_;
  Box part_;
  Box all_;
  int decimals_ = 3;
  QLabel* x_;
  QLabel* y_;
  QLabel* factor_name_;
  QDoubleSpinBox* factor_;
  QLabel* told_;
};

}  // namespace dgt::studio
