// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/transport_bar.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QStringList>
#include <QToolButton>
#include <cmath>
#include <utility>

#include "apps/studio/drawing/glyphs.h"

namespace dgt::studio {
namespace {

constexpr int kWhole = 100000;  // of the slider

QToolButton* button(Glyph glyph, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setIcon(icon_of(glyph));
  button->setAutoRaise(true);
  return button;
}

void name(QToolButton* button, const QString& name, const QString& key) {
  button->setToolTip(key.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, key));
  button->setAccessibleName(name);
}

/// Two digits are enough of a speed that nobody asked for.
double rounded(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return std::round(value / unit) * unit;
}

/// Codes and pauses between the last move done and the next.
QString codes_at(const Toolpath& path, std::size_t first, std::size_t last) {
  constexpr qsizetype kMost = 4;
  QStringList codes;
  for (std::size_t i = first; i < last; ++i) {
    const Move& move = path.moves[i];
    if (move.kind == MoveKind::Code) codes << QString::fromStdString(move.code);
    if (move.kind == MoveKind::Dwell)
      codes << TransportBar::tr("pause %1 s").arg(nearest_double(*move.seconds));
  }
  if (codes.size() > kMost) codes = codes.mid(0, kMost) << QStringLiteral("…");
  return codes.join(QStringLiteral(", "));
}

}  // namespace

TransportBar::TransportBar(ToolRun& tool, QWidget* parent)
    : QWidget(parent),
      tool_(tool),
      start_(button(Glyph::Start, this)),
      back_(button(Glyph::Back, this)),
      run_(button(Glyph::Run, this)),
      step_(button(Glyph::Step, this)),
      end_(button(Glyph::End, this)),
      way_(new QSlider(Qt::Horizontal, this)),
      text_(new QLabel(this)),
      speed_(new QDoubleSpinBox(this)) {
  way_->setRange(0, kWhole);
  way_->setPageStep(kWhole / 20);
  way_->setSingleStep(kWhole / 200);
  speed_->setRange(0.01, 100000);
  speed_->setDecimals(2);
  speed_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  speed_->setValue(tool_.speed());

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  for (QWidget* widget : {start_, back_, run_, step_, end_}) row->addWidget(widget);
  row->addWidget(way_, 1);
  row->addWidget(text_);
  row->addWidget(speed_);

  connect(start_, &QToolButton::clicked, &tool_, &ToolRun::to_start);
  connect(back_, &QToolButton::clicked, &tool_, &ToolRun::step_back);
  connect(run_, &QToolButton::clicked, this, [this] { tool_.run(!tool_.is_running()); });
  connect(step_, &QToolButton::clicked, &tool_, &ToolRun::step);
  connect(end_, &QToolButton::clicked, &tool_, &ToolRun::to_end);
  connect(way_, &QSlider::valueChanged, &tool_,
          [this](int value) { tool_.go_to(double(value) / kWhole); });
  connect(speed_, &QDoubleSpinBox::valueChanged, this, [this](double speed) {
    speed_is_chosen_ = true;
    tool_.set_speed(speed);
  });
  connect(&tool_, &ToolRun::moved, this, &TransportBar::refresh);
  connect(&tool_, &ToolRun::running_changed, this, &TransportBar::retranslate);
  retranslate();
}

void TransportBar::show_scene(const ScenePtr& scene) {
  constexpr double kSeconds = 20;
  if (!speed_is_chosen_ && scene && scene->path.travel() > 0) {
    const QSignalBlocker quiet(speed_);
    speed_->setValue(rounded(scene->path.travel() / kSeconds));
    tool_.set_speed(speed_->value());
  }
  refresh();
}

void TransportBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void TransportBar::retranslate() {
  name(start_, tr("To the start"), tr("Home"));
  name(back_, tr("A step back"), tr("Shift+Space"));
  name(step_, tr("A step"), tr("Space"));
  name(end_, tr("To the end"), tr("End"));
  const bool running = tool_.is_running();
  name(run_, running ? tr("Pause") : tr("Run"), tr("Enter"));
  run_->setIcon(icon_of(running ? Glyph::Pause : Glyph::Run));
  way_->setAccessibleName(tr("Place of the tool on its way"));
  way_->setToolTip(way_->accessibleName());
  speed_->setAccessibleName(tr("Speed of the run"));
  speed_->setToolTip(speed_->accessibleName());
  speed_->setSuffix(tr(" mm/s"));
  refresh();
}

void TransportBar::refresh() {
  const QSignalBlocker quiet(way_);
  way_->setValue(static_cast<int>(std::lround(tool_.progress() * kWhole)));
  setEnabled(tool_.steps() > 0);
  text_->setText(step_text());
}

QString TransportBar::step_text() const {
  const std::size_t now = tool_.place().steps + (tool_.place().part > 0 ? 1 : 0);
  const ScenePtr& scene = tool_.scene();
  QString text = tr("Step %1 of %2").arg(now).arg(tool_.steps());
  if (!scene || tool_.place().part > 0 || tool_.steps() == 0) return text;
  const Toolpath& path = *scene->part->path();
  const std::size_t first = now == 0 ? 0 : scene->path.move(now - 1) + 1;
  const std::size_t last = now == tool_.steps() ? path.moves.size() : scene->path.move(now);
  const QString codes = codes_at(path, first, last);
  return codes.isEmpty() ? text : text + QStringLiteral("  ") + codes;
}

}  // namespace dgt::studio
