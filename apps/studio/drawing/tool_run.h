// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "apps/studio/drawing/scene.h"

namespace dgt::studio {

/// Where the tool stands on its way, and how it runs along it.
class ToolRun : public QObject {
  Q_OBJECT

 public:
  explicit ToolRun(QObject* parent = nullptr);

  /// A tool that stood at the end stands at the end of the new path, else after as many steps.
  void show_scene(ScenePtr scene);

  [[nodiscard]] const ScenePtr& scene() const { return scene_; }  ///< that place() is in
  [[nodiscard]] ToolPlace place() const { return place_; }
  [[nodiscard]] std::size_t steps() const { return scene_ ? scene_->path.steps() : 0; }
  [[nodiscard]] bool is_at_end() const { return place_.steps == steps(); }
  [[nodiscard]] bool is_running() const { return timer_.isActive(); }
  /// Of the way, 0…1; 1 when there is none.
  [[nodiscard]] double progress() const;
  [[nodiscard]] double speed() const { return speed_; }  ///< mm/s

 public slots:
  /// To the end of the move; from the end of the way, along the first move again.
  void step();
  /// To the beginning of the move, and from there of the move before.
  void step_back();
  void to_start();
  void to_end();
  void go_to(double progress);  ///< 0…1
  /// Runs at constant speed along lines and arcs until the end, and from the end from the start.
  void run(bool running);
  void set_speed(double millimetres_per_second);

 signals:
  void moved();
  void running_changed(bool running);

 private:
  void put(ToolPlace place);
  void advance();

  ScenePtr scene_;
  ToolPlace place_;
  double speed_ = 10;
  QTimer timer_;
  QElapsedTimer clock_;
};

}  // namespace dgt::studio
