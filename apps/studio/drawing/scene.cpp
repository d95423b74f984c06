// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/scene.h"

#include <utility>

#include "apps/driver/names.h"

namespace dgt::studio {

std::optional<ScenePtr> make_scene(PartPtr part, const std::function<bool()>& given_up) {
  // A drawing of more is black with names, and lengths take time that is felt while typing.
  constexpr std::size_t kSmall = 5000;
  auto path = DrawnPath::of(*part->path(), given_up);
  if (!path) return std::nullopt;
  auto scene = std::make_shared<Scene>();
  scene->path = std::move(*path);
  if (scene->curves() <= kSmall) {
    scene->names = names_of(part->compilation);
    scene->lengths = way_lengths(*part->path());
  }
  scene->part = std::move(part);
  return scene;
}

}  // namespace dgt::studio
