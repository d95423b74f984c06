// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <memory>
#include <string>

#include "apps/studio/drawing/drawing_panel.h"
#include "tests/support/command.h"

namespace dgt::studio {

[[nodiscard]] inline PartPtr part_of(const std::string& text, const std::string& name = "part.bgt",
                                     const Settings& settings = {}) {
  auto part = std::make_shared<Part>();
  part->name = name;
  part->settings = settings;
  part->compilation = compile_bytes(name, text, settings.source);
  return part;
}

[[nodiscard]] inline PartPtr corpus_part(const std::string& file) {
  return part_of(support::read_text(support::corpus(file)), support::corpus(file));
}

/// A rectangle from (0, 0) to (40, 20), cut from (0, 0) to the right, without equidistant.
inline constexpr const char* kRectangle =
    "L1=Y0\nL2=X40\nL3=Y20\nL4=X0\nP1=L4 L1\nG54P1\nK1 P1 L1 L2 L3 L4 P1\n";

/// Moves to and fro as a ruled field has them: `count` cuts, all in line 3.
[[nodiscard]] inline PartPtr many_moves(int count) {
  std::string text = "%\nG90 G21\n";
  for (int i = 0; i < count; ++i) {
    const int row = i / 500;
    const int column = row % 2 == 0 ? i % 500 : 499 - i % 500;
    text += "G1 X" + std::to_string(column) + " Y" + std::to_string(row) + "." +
            std::to_string(i % 7) + " F100\n";
  }
  return part_of(text + "M30\n%\n", "field.nc");
}

[[nodiscard]] inline bool settle(DrawingPanel& panel) {
  return QTest::qWaitFor([&] { return panel.is_settled(); }, 60000);
}

/// A panel that shows a part and stands still.
class ShownPanel {
 public:
  explicit ShownPanel(const PartPtr& part) {
    panel.resize(900, 700);
    panel.show();
    panel.show_part(part);
    settled = settle(panel);
  }
  [[nodiscard]] Canvas& canvas() { return panel.canvas(); }
  [[nodiscard]] QPoint pixel(double x, double y) { return canvas().view().pixel({x, y}).toPoint(); }

  DrawingPanel panel;
  bool settled = false;
};

}  // namespace dgt::studio
