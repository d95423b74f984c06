// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "apps/driver/drawn_path.h"
#include "apps/driver/summary.h"
#include "apps/studio/part.h"
#include "post/svg_names.h"

namespace dgt::studio {

/// A part ready to be drawn. Made in the background, never changed.
struct Scene {
  PartPtr part;  ///< has a path
  DrawnPath path;
  std::vector<NamedShape> names;
  std::optional<WayLengths> lengths;  ///< of a large part they take longer, and come later

  [[nodiscard]] std::size_t curves() const { return path.steps() + path.programmed().size(); }
};
using ScenePtr = std::shared_ptr<const Scene>;

/// Nothing when given up. Precondition: the part has a path.
[[nodiscard]] std::optional<ScenePtr> make_scene(PartPtr part,
                                                 const std::function<bool()>& given_up);

}  // namespace dgt::studio
