// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QObject>
#include <optional>

#include "apps/studio/background.h"
#include "apps/studio/drawing/look.h"
#include "apps/studio/drawing/scene.h"
#include "apps/studio/drawing/view.h"

namespace dgt::studio {

/// A scene painted on a transparent ground.
struct ScenePicture {
  QImage image;
  SheetView view;  ///< its pixels are those of the image
  Look look;
  ScenePtr scene;
};
[[nodiscard]] ScenePicture paint_picture(ScenePtr scene, const SheetView& view, const Look& look);

/// Keeps the picture that a window needs: small scenes are painted at once, large ones in the
/// background and a border wider than the window, so that they can be moved at once. Until it is
/// there the last picture is shown, moved and stretched.
class PictureStore : public QObject {
  Q_OBJECT

 public:
  explicit PictureStore(QObject* parent = nullptr);

  /// Paints what there is of the scene as seen in `view`, and sees to it that `changed` follows
  /// when there is something better.
  void paint(QPainter& painter, const ScenePtr& scene, const SheetView& view, const Look& look);
  /// Whether the last picture painted was the one wanted.
  [[nodiscard]] bool is_settled() const { return settled_; }
  /// The first move that the last picture shows as still to come.
  [[nodiscard]] std::optional<std::uint32_t> run_to(const ScenePtr& scene) const;

 signals:
  void changed();

 private:
  [[nodiscard]] bool fits(const SheetView& view) const;
  [[nodiscard]] bool is_of(const ScenePtr& scene, const Look& look) const;
  void ask(const ScenePtr& scene, const SheetView& view, const Look& look);

  ScenePicture picture_;
  ScenePtr asked_;  ///< of which a picture is being painted
  bool settled_ = true;
  Background work_{this};
};

}  // namespace dgt::studio
