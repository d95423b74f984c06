// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/drawing/drawing_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "apps/studio/drawing/elided_label.h"
#include "apps/studio/drawing/glyphs.h"
#include "apps/studio/drawing/readout.h"
#include "apps/studio/drawing/scene_painter.h"
#include "apps/studio/drawing/transport_bar.h"
#include "apps/studio/language.h"

namespace dgt::studio {
namespace {

constexpr double kButtonFactor = 1.5;
constexpr std::size_t kLarge = 20000;  // moves: more take a moment that can be felt
QToolButton* button(QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setAutoRaise(true);
  return button;
}

void name(QToolButton* button, const QString& name, const QString& key) {
  button->setAccessibleName(name);
  button->setToolTip(key.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, key));
}

}  // namespace

DrawingPanel::DrawingPanel(QWidget* parent)
    : QWidget(parent),
      canvas_(new Canvas(tool_, this)),
      readout_(new Readout(this)),
      transport_(new TransportBar(tool_, this)),
      banner_(new QLabel(canvas_)),
      hint_(new ElidedLabel(this)) {
  make_controls();
  make_show_menu();

  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(4, 0, 4, 0);
  buttons->setSpacing(2);
  for (QWidget* widget : {fit_button_, in_button_, out_button_, show_button_, measure_button_})
    buttons->addWidget(widget);
  buttons->addStretch(1);
  buttons->addWidget(save_button_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(readout_);
  column->addLayout(buttons);
  column->addWidget(canvas_, 1);
  column->addWidget(transport_);
  column->addWidget(hint_);

  banner_->setWordWrap(true);
  banner_->setTextFormat(Qt::PlainText);
  banner_->setContentsMargins(6, 4, 6, 4);
  banner_->setAutoFillBackground(true);
  // Over the drawing and not above it: while a person types it comes and goes, and nothing jumps.
  banner_->setAttribute(Qt::WA_TransparentForMouseEvents);
  auto* over = new QVBoxLayout(canvas_);
  over->setContentsMargins(0, 0, 0, 0);
  over->addWidget(banner_);
  over->addStretch(1);
  banner_->hide();
  hint_->setContentsMargins(4, 0, 4, 2);
  setFocusProxy(canvas_);

  connect(canvas_, &Canvas::pointed_at, readout_, &Readout::show_pointer);
  connect(canvas_, &Canvas::pointed_away, readout_, &Readout::show_no_pointer);
  connect(canvas_, &Canvas::hint_changed, this, &DrawingPanel::show_hint);
  connect(&scenes_, &Background::busy_changed, this, &DrawingPanel::show_hint);
  for (const Background* work : {&scenes_, &lengths_, &files_})
    connect(work, &Background::failed, hint_, &QLabel::setText);
  connect(canvas_, &Canvas::place_chosen, this, &DrawingPanel::place_chosen);
  connect(canvas_, &Canvas::measuring_left, this, [this] { set_measuring(false); });
  connect(canvas_, &Canvas::settled, this, [this] {
    if (is_settled()) emit settled();
  });
  canvas_->set_factor(readout_->factor());
  connect(readout_, &Readout::factor_changed, canvas_, &Canvas::set_factor);
  connect(&Appearance::of_program(), &Appearance::changed, this, &DrawingPanel::show_banner);
  retranslate();
}

DrawingPanel::~DrawingPanel() {
  if (given_up_) *given_up_ = true;
}

void DrawingPanel::make_controls() {
  fit_button_ = button(this);
  fit_button_->setIcon(icon_of(Glyph::Fit));
  in_button_ = button(this);
  in_button_->setIcon(icon_of(Glyph::ZoomIn));
  out_button_ = button(this);
  out_button_->setIcon(icon_of(Glyph::ZoomOut));
  measure_button_ = button(this);
  measure_button_->setIcon(icon_of(Glyph::Measure));
  measure_button_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  measure_button_->setCheckable(true);
  show_button_ = button(this);
  show_button_->setPopupMode(QToolButton::InstantPopup);
  save_button_ = button(this);
  connect(fit_button_, &QToolButton::clicked, this, &DrawingPanel::fit);
  connect(in_button_, &QToolButton::clicked, canvas_, [this] { canvas_->zoom(kButtonFactor); });
  connect(out_button_, &QToolButton::clicked, canvas_,
          [this] { canvas_->zoom(1 / kButtonFactor); });
  connect(measure_button_, &QToolButton::toggled, this, &DrawingPanel::set_measuring);
  connect(save_button_, &QToolButton::clicked, this, &DrawingPanel::save_picture);
}

void DrawingPanel::set_measuring(bool measuring) {
  measure_button_->setChecked(measuring);
  if (canvas_->is_measuring() != measuring) canvas_->set_measuring(measuring);
}

void DrawingPanel::fit() { canvas_->fit(); }

void DrawingPanel::light_line(int file, int line, bool bring_into_view) {
  const auto number = [](int value) { return static_cast<std::uint32_t>(std::max(value, 0)); };
  canvas_->light({number(file), number(line)}, bring_into_view);
}

void DrawingPanel::light_point(int number) {
  canvas_->light_point(static_cast<std::size_t>(std::max(number, 0)));
}

bool DrawingPanel::is_settled() const { return !scenes_.is_busy() && canvas_->is_settled(); }

void DrawingPanel::show_part(PartPtr part) {
  if (given_up_) *given_up_ = true;
  scenes_.forget();
  part_ = std::move(part);
  const bool is_good = part_ && part_->path() != nullptr;
  canvas_->set_stale(!is_good);
  show_banner();
  if (!is_good) return;
  apply_decimals();
  given_up_ = std::make_shared<std::atomic<bool>>(false);
  scenes_.ask([this, wanted = part_, given_up = given_up_]() -> Background::Outcome {
    const auto scene = make_scene(wanted, [given_up] { return given_up->load(); });
    if (!scene) return {};
    return [this, made = *scene] { take_scene(made); };
  });
}

void DrawingPanel::take_scene(ScenePtr scene) {
  scene_ = std::move(scene);
  tool_.show_scene(scene_);
  canvas_->show_scene(scene_);
  transport_->show_scene(scene_);
  readout_->show_scene(scene_);
  lengths_.forget();
  if (scene_->lengths) return;
  lengths_.ask([this, drawn = scene_]() -> Background::Outcome {
    return [this, lengths = way_lengths(*drawn->part->path())] { readout_->show_lengths(lengths); };
  });
}

void DrawingPanel::paint(QPainter& painter, const QRect& where) {
  if (!scene_) return;
  constexpr double kScreen = 96;  // pixels an inch, for which widths are given
  constexpr double kMargin = 0.04;
  Look look;
  look.colours = standard_colours(Theme::Light);
  look.colours.sheet = Qt::white;
  look.font = font();
  look.shown = canvas_->shown();
  look.shown.kerf = false;
  look.decimals = readout_->decimals();
  look.pixel = painter.device()->logicalDpiX() / kScreen;
  painter.save();
  painter.translate(where.topLeft());
  painter.setClipRect(QRect({0, 0}, where.size()));
  paint_scene(painter, *scene_,
              SheetView::fitting(scene_->path.box(), QSizeF(where.size()), kMargin), look);
  painter.restore();
}

void DrawingPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void DrawingPanel::retranslate() {
  name(fit_button_, tr("The whole part"), QStringLiteral("0"));
  name(in_button_, tr("Zoom in"), QStringLiteral("+"));
  name(out_button_, tr("Zoom out"), QStringLiteral("−"));
  show_button_->setText(tr("&Show"));
  show_button_->setToolTip(tr("What is drawn"));
  measure_button_->setText(tr("&Measure"));
  measure_button_->setToolTip(
      tr("Distance, angle and radius between ends, middles, centres, tangents"));
  save_button_->setText(tr("Save &picture…"));
  save_button_->setToolTip(tr("The drawing as PNG, SVG, PDF or DXF"));
  canvas_->setAccessibleName(tr("Drawing of the part"));
  canvas_->setAccessibleDescription(
      tr("Space steps the tool, Shift+Space steps back, Enter runs it, plus and minus zoom, the "
         "arrows move the drawing, 0 shows the whole part."));
  retranslate_menu();
  show_hint();
  show_banner();
}

void DrawingPanel::show_hint() {
  const bool is_large = part_ && part_->path() && part_->path()->moves.size() > kLarge;
  hint_->setText(scenes_.is_busy() && is_large ? tr("The drawing is being prepared…")
                                               : canvas_->hint());
}

void DrawingPanel::show_banner() {
  const bool has_errors = part_ && part_->path() == nullptr;
  banner_->setVisible(has_errors);
  if (!has_errors) return;
  QPalette palette = banner_->palette();
  palette.setColor(QPalette::Window, colours().error);
  palette.setColor(QPalette::WindowText, colours().sheet);
  banner_->setPalette(palette);
  const QString why = first_error();
  banner_->setText(scene_ ? tr("The drawing is of an earlier text. %1").arg(why)
                          : tr("There is no drawing. %1").arg(why));
}

QString DrawingPanel::first_error() const {
  const auto& all = part_->compilation.bag.all();
  const auto is_error = [](const Diagnostic& d) { return d.severity() == Severity::Error; };
  const auto found = std::ranges::find_if(all, is_error);
  if (found == all.end()) return {};
  const QString said =
      QString::fromStdString(text(found->message, found->arguments, message_language()));
  const std::uint32_t line = found->range.place().line;
  if (found->range.file == part_->compilation.file.get())
    return tr("Line %1: %2").arg(line).arg(said);
  return tr("%1, line %2: %3")
      .arg(QString::fromStdString(found->range.file->name()))
      .arg(line)
      .arg(said);
}

}  // namespace dgt::studio
