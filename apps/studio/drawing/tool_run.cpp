// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/tool_run.h"

#include <algorithm>
#include <utility>

namespace dgt::studio {

ToolRun::ToolRun(QObject* parent) : QObject(parent) {
  constexpr int kFrame = 16;  // ms
  timer_.setInterval(kFrame);
  connect(&timer_, &QTimer::timeout, this, &ToolRun::advance);
}

void ToolRun::show_scene(ScenePtr scene) {
  const bool was_at_end = is_at_end();
  scene_ = std::move(scene);
  if (was_at_end) {
    place_ = {steps(), 0};
  } else if (place_.steps >= steps()) {
    place_ = {steps(), 0};
  }
  if (is_at_end()) run(false);
  emit moved();
}

double ToolRun::progress() const {
  const double travel = scene_ ? scene_->path.travel() : 0;
  return travel > 0 ? scene_->path.travelled(place_) / travel : 1;
}

void ToolRun::step() {
  run(false);
  put(is_at_end() ? ToolPlace{std::min<std::size_t>(1, steps()), 0}
                  : ToolPlace{place_.steps + 1, 0});
}

void ToolRun::step_back() {
  run(false);
  if (place_.part > 0) {
    put({place_.steps, 0});
  } else if (place_.steps > 0) {
    put({place_.steps - 1, 0});
  }
}

void ToolRun::to_start() {
  run(false);
  put({0, 0});
}

void ToolRun::to_end() {
  run(false);
  put({steps(), 0});
}

void ToolRun::go_to(double progress) {
  run(false);
  if (!scene_) return;
  put(progress >= 1 ? ToolPlace{steps(), 0}
                    : scene_->path.tool_after(progress * scene_->path.travel()));
}

void ToolRun::run(bool running) {
  if (running == is_running() || (running && steps() == 0)) return;
  if (running) {
    if (is_at_end()) put({0, 0});
    clock_.start();
    timer_.start();
  } else {
    timer_.stop();
  }
  emit running_changed(running);
}

void ToolRun::set_speed(double millimetres_per_second) { speed_ = millimetres_per_second; }

void ToolRun::put(ToolPlace place) {
  if (place == place_) return;
  place_ = place;
  emit moved();
}

void ToolRun::advance() {
  const double seconds = static_cast<double>(clock_.restart()) / 1000;
  const DrawnPath& path = scene_->path;
  put(path.tool_after(path.travelled(place_) + seconds * speed_));
  if (is_at_end()) run(false);
}

}  // namespace dgt::studio
