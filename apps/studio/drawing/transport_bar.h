// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "apps/studio/drawing/tool_run.h"

class QDoubleSpinBox;
class QLabel;
class QSlider;
class QToolButton;

namespace dgt::studio {

/// The buttons that step and run the tool, its speed, and the slider of its way.
class TransportBar : public QWidget {
  Q_OBJECT

 public:
  explicit TransportBar(ToolRun& tool, QWidget* parent = nullptr);

  /// The speed at which the whole way takes a while, until a person has set one.
  void show_scene(const ScenePtr& scene);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();
  void refresh();
  [[nodiscard]] QString step_text() const;

  ToolRun& tool_;
  bool speed_is_chosen_ = false;
  QToolButton* start_;
  QToolButton* back_;
  QToolButton* run_;
  QToolButton* step_;
  QToolButton* end_;
  QSlider* way_;
  QLabel* text_;
  QDoubleSpinBox* speed_;
};

}  // namespace dgt::studio
