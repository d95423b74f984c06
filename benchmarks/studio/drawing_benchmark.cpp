// SPDX-License-Identifier: GPL-3.0-or-later
// How long frames of large drawings take, on a picture of 1000 × 800 pixels.
#include <benchmark/benchmark.h>

#include <QGuiApplication>
#include <QPainter>
#include <map>
#include <string>

#include "apps/driver/summary.h"
#include "apps/studio/drawing/picture.h"

namespace dgt::studio {
namespace {

/// Rows of a field, to and fro: each move a line or an arc of about half a millimetre, as
/// engravings have them.
PartPtr field(int moves) {
  const int across = 1000;
  std::string text = "%\nG90 G21\nG1 X0 Y0 F1000\n";
  for (int i = 0; i < moves; ++i) {
    const int row = i / across;
    const int place = i % across;
    const int column = row % 2 == 0 ? place + 1 : across - place - 1;
    const bool arc = i % 3 == 0 && place != across - 1;
    const std::string x = std::to_string(column / 2) + (column % 2 == 0 ? ".0" : ".5");
    const std::string y = std::to_string(row + (place == across - 1 ? 1 : 0));
    text += arc ? (i % 2 == 0 ? "G2 X" : "G3 X") + x + " Y" + y + " R0.3\n"
                : "G1 X" + x + " Y" + y + "\n";
  }
  auto part = std::make_shared<Part>();
  part->name = "field.nc";
  part->compilation = compile_bytes(part->name, text + "M30\n%\n", part->settings.source);
  return part;
}

ScenePtr scene_of(int moves) {
  static std::map<int, ScenePtr> made;
  ScenePtr& scene = made[moves];
  if (!scene) scene = make_scene(field(moves), {}).value();
  return scene;
}

Look look() {
  Look look;
  look.colours = standard_colours(Theme::Dark);
  return look;
}

void prepare(benchmark::State& state) {
  const ScenePtr scene = scene_of(static_cast<int>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(make_scene(scene->part, {}));
}

void measure(benchmark::State& state) {
  const ScenePtr scene = scene_of(static_cast<int>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(way_lengths(*scene->part->path()));
}

/// The whole, or magnified so many times about the middle.
void frame(benchmark::State& state) {
  const ScenePtr scene = scene_of(static_cast<int>(state.range(0)));
  SheetView view = SheetView::fitting(scene->path.box(), {1000, 800}, 0.05);
  view = view.zoomed(static_cast<double>(state.range(1)), {500, 400});
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(paint_picture(scene, view, look()));
}

/// A picture that is there already, moved by a pixel: what a window paints while it is panned.
void pan(benchmark::State& state) {
  const ScenePtr scene = scene_of(static_cast<int>(state.range(0)));
  const SheetView view = SheetView::fitting(scene->path.box(), {1000, 800}, 0.05);
  const ScenePicture picture = paint_picture(scene, view.widened({250, 200}), look());
  QImage window(1000, 800, QImage::Format_ARGB32_Premultiplied);
  int shift = 0;
  for ([[maybe_unused]] auto _ : state) {
    QPainter painter(&window);
    painter.fillRect(window.rect(), Qt::black);
    painter.drawImage(QPoint(-(shift = (shift + 1) % 250), -200), picture.image);
  }
}

BENCHMARK(prepare)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(measure)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(frame)
    ->ArgsProduct({{100'000, 1'000'000}, {1, 10, 100, 1'000'000}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(pan)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace dgt::studio

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QGuiApplication application(argc, argv);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
