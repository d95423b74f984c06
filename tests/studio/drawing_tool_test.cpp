// SPDX-License-Identifier: GPL-3.0-or-later
// Stepping and running the tool.
#include <gmock/gmock.h>

#include <QLabel>
#include <QSignalSpy>
#include <QSlider>

#include "tests/studio/drawing_parts.h"

namespace dgt::studio {
namespace {

ScenePtr scene_of(const PartPtr& part) { return make_scene(part, {}).value(); }

TEST(ToolRun, StandsAtTheEndUntilAPersonSteps) {
  ToolRun tool;
  tool.show_scene(scene_of(part_of(kRectangle)));
  EXPECT_TRUE(tool.is_at_end());
  EXPECT_EQ(tool.steps(), 4U);
  tool.step();
  EXPECT_EQ(tool.place(), (ToolPlace{1, 0})) << "from the end it begins again";
}

TEST(ToolRun, StepsBackToTheBeginningOfTheMoveInHand) {
  ToolRun tool;
  tool.show_scene(scene_of(part_of(kRectangle)));
  tool.go_to(50.0 / 120);  // half-way up the second side
  EXPECT_EQ(tool.place(), (ToolPlace{1, 0.5}));
  tool.step_back();
  EXPECT_EQ(tool.place(), (ToolPlace{1, 0}));
  tool.step_back();
  tool.step_back();
  EXPECT_EQ(tool.place(), (ToolPlace{0, 0}));
}

TEST(ToolRun, RunsAtItsSpeedToTheEnd) {
  ToolRun tool;
  tool.show_scene(scene_of(part_of(kRectangle)));
  tool.set_speed(400);
  QSignalSpy moved(&tool, &ToolRun::moved);
  QElapsedTimer clock;
  clock.start();
  tool.run(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !tool.is_running(); }));
  EXPECT_TRUE(tool.is_at_end());
  EXPECT_GE(clock.elapsed(), 290) << "120 mm at 400 mm/s";
  EXPECT_GT(moved.count(), 3) << "it is seen under way";
}

TEST(ToolRun, ANewPartKeepsTheStep) {
  ToolRun tool;
  const ScenePtr scene = scene_of(part_of(kRectangle));
  tool.show_scene(scene);
  tool.to_start();
  tool.step();
  tool.step();
  tool.show_scene(scene_of(part_of(kRectangle)));
  EXPECT_EQ(tool.place().steps, 2U);
  tool.show_scene(scene_of(part_of("L1=X0\nL2=Y0\nP1=L1 L2\nG54P1\n")));
  EXPECT_EQ(tool.place(), ToolPlace{}) << "the new one is shorter";
}

TEST(Stepping, TheSpaceBarStepsAndTheReadoutCounts) {
  ShownPanel shown_panel(corpus_part("4P.bgt"));
  Canvas& canvas = shown_panel.canvas();
  const std::size_t steps = shown_panel.panel.tool().steps();
  const auto says = [&](std::size_t step) {
    const QString wanted = QStringLiteral("Step %1 of %2").arg(step).arg(steps);
    for (const auto* label : shown_panel.panel.findChildren<QLabel*>()) {
      if (label->text().startsWith(wanted)) return true;
    }
    return false;
  };
  EXPECT_TRUE(says(steps));
  QTest::keyClick(&canvas, Qt::Key_Home);
  EXPECT_TRUE(says(0));
  for (std::size_t step = 1; step <= steps; ++step) {
    QTest::keyClick(&canvas, Qt::Key_Space);
    EXPECT_TRUE(says(step));
  }
  EXPECT_TRUE(shown_panel.panel.tool().is_at_end());
  QTest::keyClick(&canvas, Qt::Key_Space, Qt::ShiftModifier);
  EXPECT_TRUE(says(steps - 1));
  QTest::keyClick(&canvas, Qt::Key_Backspace);
  EXPECT_TRUE(says(steps - 2));
  QTest::keyClick(&canvas, Qt::Key_End);
  EXPECT_TRUE(says(steps));
}

TEST(Stepping, WhatIsToComeIsDimAndWhatIsDoneIsNot) {
  ShownPanel shown_panel(part_of(kRectangle));
  Canvas& canvas = shown_panel.canvas();
  shown_panel.panel.show_programmed(false);
  QTest::keyClick(&canvas, Qt::Key_Home);
  QTest::keyClick(&canvas, Qt::Key_Space);
  const QImage image = canvas.grab().toImage();
  const QColor done = image.pixelColor(shown_panel.pixel(20, 0));
  const QColor to_come = image.pixelColor(shown_panel.pixel(20, 20));
  EXPECT_NE(done, to_come);
  EXPECT_EQ(done, image.pixelColor(shown_panel.pixel(30, 0)));
}

TEST(Stepping, TheSliderMovesTheToolAndFollowsIt) {
  ShownPanel shown_panel(part_of(kRectangle));
  auto* slider = shown_panel.panel.findChild<QSlider*>();
  slider->setValue(slider->maximum() / 2);
  EXPECT_EQ(shown_panel.panel.tool().place(), (ToolPlace{2, 0}));
  QTest::keyClick(&shown_panel.canvas(), Qt::Key_Home);
  EXPECT_EQ(slider->value(), 0);
}

TEST(Stepping, EnterRunsAndPauses) {
  ShownPanel shown_panel(part_of(kRectangle));
  ToolRun& tool = shown_panel.panel.tool();
  QTest::keyClick(&shown_panel.canvas(), Qt::Key_Return);
  EXPECT_TRUE(tool.is_running());
  ASSERT_TRUE(QTest::qWaitFor([&] { return tool.progress() > 0 && tool.progress() < 1; }));
  QTest::keyClick(&shown_panel.canvas(), Qt::Key_Return);
  EXPECT_FALSE(tool.is_running());
  EXPECT_FALSE(tool.is_at_end());
}

}  // namespace
}  // namespace dgt::studio
