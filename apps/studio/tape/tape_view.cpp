// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studio/tape/tape_view.h"

#include <QHelpEvent>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>

#include "apps/studio/window/theme.h"
#include "device/drawing.h"

namespace dgt::studio {
namespace {

constexpr double kRowLetters = 1.0;  // a row is as wide as a digit
constexpr double kMarginMm = 3;
constexpr double kLabelLines = 1.1;  // above a strip: where it begins
constexpr double kNameLines = 1.2;   // below it: what the rows say

QColor paper(bool is_dark) { return is_dark ? QColor(0xC9BE98) : QColor(0xE9DFC0); }

bool is_dark() { return Appearance::of_program().theme() == Theme::Dark; }

}  // namespace

TapeView::TapeView(QWidget* parent) : QAbstractScrollArea(parent) {
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::StrongFocus);
  connect(&Appearance::of_program(), &Appearance::changed, viewport(),
          qOverload<>(&QWidget::update));
  measure();
}

void TapeView::show_tape(Tape tape) {
  tape_ = std::move(tape);
  damaged_.clear();
  done_ = 0;
  measure();
  verticalScrollBar()->setValue(0);
}

void TapeView::mark(std::set<std::size_t> damaged) {
  damaged_ = std::move(damaged);
  if (!damaged_.empty()) go_to_row(*damaged_.begin());
  viewport()->update();
}

void TapeView::show_progress(std::size_t rows) {
  done_ = rows;
  if (rows > 0) go_to_row(rows - 1);
  viewport()->update();
}

double TapeView::strip_height() const {
  const double letters = fontMetrics().height() * (kLabelLines + kNameLines);
  return kTapeWidth * scale_ + letters + kMarginMm * scale_;
}

void TapeView::measure() {
  scale_ = fontMetrics().horizontalAdvance(u'0') * kRowLetters / kPitch;
  const double room = viewport()->width() - 2 * kMarginMm * scale_;
  per_strip_ = static_cast<std::size_t>(std::clamp(room / (kPitch * scale_), 10.0, 100.0));
  const std::size_t strips = (tape_.rows.size() + per_strip_ - 1) / per_strip_;
  const double height = static_cast<double>(strips) * strip_height() + kMarginMm * scale_;
  verticalScrollBar()->setRange(0, std::max(0, static_cast<int>(height) - viewport()->height()));
  verticalScrollBar()->setPageStep(viewport()->height());
  verticalScrollBar()->setSingleStep(static_cast<int>(strip_height() / 4));
  viewport()->update();
}

void TapeView::go_to_row(std::size_t row) {
  const double top = static_cast<double>(row / per_strip_) * strip_height();
  QScrollBar* const bar = verticalScrollBar();
  const bool is_seen =
      top >= bar->value() && top + strip_height() <= bar->value() + viewport()->height();
  if (!is_seen) bar->setValue(static_cast<int>(top));
}

void TapeView::paintEvent(QPaintEvent*) {
  QPainter painter(viewport());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(viewport()->rect(), colours().sheet);
  const double height = strip_height();
  const int scrolled = verticalScrollBar()->value();
  const auto from = static_cast<std::size_t>(scrolled / height);
  for (std::size_t strip = from; strip * per_strip_ < tape_.rows.size(); ++strip) {
    const double top = static_cast<double>(strip) * height - scrolled;
    if (top > viewport()->height()) break;
    paint_strip(painter, strip * per_strip_, top);
  }
}

void TapeView::paint_strip(QPainter& painter, std::size_t first, double top) const {
  const std::size_t last = std::min(first + per_strip_, tape_.rows.size());
  const TapeDrawing drawing = draw_tape(tape_, {first, last});
  const DrawnStrip& strip = drawing.strips.front();
  const double line = fontMetrics().height();
  const double left = kMarginMm * scale_;
  const double above = top + line * kLabelLines;
  painter.setPen(colours().line_numbers);
  painter.drawText(
      QPointF(left, above - line * 0.25),
      tr("%1 · %2 mm").arg(first + 1).arg(QString::fromStdString(millimetres_to(first))));
  painter.setPen(Qt::NoPen);
  painter.setBrush(paper(is_dark()));
  painter.drawRect(QRectF(left, above, strip.length * scale_, kTapeWidth * scale_));
  const double pitch = kPitch * scale_;
  const double below = above + kTapeWidth * scale_ + line;
  for (std::size_t row = first; row < last; ++row) {
    const double x = left + static_cast<double>(row - first) * pitch;
    const bool is_damaged = damaged_.contains(row);
    if (row < done_ || is_damaged) {
      QColor tint = is_damaged ? colours().error : colours().programmed;
      tint.setAlphaF(0.45F);
      painter.fillRect(QRectF(x, above, pitch, kTapeWidth * scale_), tint);
    }
    const std::string name = name_of(tape_.rows[row]);
    if (name.size() != 1 || (name == "?" && !is_damaged && !has_even_parity(tape_.rows[row])))
      continue;  // rows of lettering say nothing
    painter.setPen(is_damaged ? colours().error : colours().text);
    painter.drawText(QRectF(x - pitch, below - line, 3 * pitch, line), Qt::AlignCenter,
                     QString::fromStdString(name));
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(is_dark() ? QColor(Qt::black) : QColor(0x30, 0x30, 0x30));
  const auto place = [&](const DrawnHole& hole) {
    return QPointF(left + (hole.x - strip.x) * scale_, above + (hole.y - strip.y) * scale_);
  };
  for (const DrawnHole& hole : strip.feed)
    painter.drawEllipse(place(hole), kFeedHole / 2 * scale_, kFeedHole / 2 * scale_);
  for (const DrawnHole& hole : strip.code)
    painter.drawEllipse(place(hole), kCodeHole / 2 * scale_, kCodeHole / 2 * scale_);
}

std::size_t TapeView::row_at(const QPoint& at) const {
  const double y = at.y() + verticalScrollBar()->value();
  const double x = (at.x() - kMarginMm * scale_) / (kPitch * scale_);
  if (y < 0 || x < 0 || x >= static_cast<double>(per_strip_)) return tape_.rows.size();
  return static_cast<std::size_t>(y / strip_height()) * per_strip_ + static_cast<std::size_t>(x);
}

bool TapeView::viewportEvent(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QAbstractScrollArea::viewportEvent(event);
  const auto* const help = static_cast<QHelpEvent*>(event);
  const std::size_t row = row_at(help->pos());
  if (row >= tape_.rows.size()) {
    QToolTip::hideText();
    return true;
  }
  const QString holes = QString::fromStdString(holes_of(tape_.rows[row]));
  QToolTip::showText(help->globalPos(), tr("Row %1, %2 mm: %3\nHoles in tracks: %4")
                                            .arg(row + 1)
                                            .arg(QString::fromStdString(millimetres_to(row)),
                                                 QString::fromStdString(name_of(tape_.rows[row])),
                                                 holes.isEmpty() ? QStringLiteral("–") : holes));
  return true;
}

void TapeView::resizeEvent(QResizeEvent* event) {
  QAbstractScrollArea::resizeEvent(event);
  measure();
}

void TapeView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::FontChange) measure();
  QAbstractScrollArea::changeEvent(event);
}

}  // namespace dgt::studio
